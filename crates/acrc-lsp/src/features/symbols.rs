//! The outline of a file, and names in all projects.

use acrc_analysis::Project;
use acrc_ide::{Symbol, SymbolKind as Kind};
use tower_lsp_server::ls_types::{
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, SymbolInformation, SymbolKind, Uri,
    WorkspaceSymbolParams, WorkspaceSymbolResponse,
};

use super::Answer;
use crate::lines::Lines;
use crate::snapshot::Snapshot;

/// More names than this nobody reads.
const MOST_SYMBOLS: usize = 256;

pub(crate) fn of_document(snapshot: &Snapshot, params: &DocumentSymbolParams) -> Answer<DocumentSymbolResponse> {
    let place = snapshot.place(&params.text_document.uri)?;
    let lines = snapshot.lines(place.file);
    let symbols = acrc_ide::document_symbols(&snapshot.db, place.file);
    if snapshot.abilities.nested_symbols {
        let nested = symbols.into_iter().map(|symbol| nested(symbol, &lines));
        return Some(DocumentSymbolResponse::Nested(nested.collect()));
    }
    let mut flat = Vec::new();
    for symbol in symbols {
        flatten(symbol, None, &params.text_document.uri, &lines, &mut flat);
    }
    Some(DocumentSymbolResponse::Flat(flat))
}

#[expect(deprecated, reason = "the field has to be there")]
fn nested(symbol: Symbol, lines: &Lines) -> DocumentSymbol {
    let children: Vec<_> = symbol.children.into_iter().map(|child| nested(child, lines)).collect();
    DocumentSymbol {
        name: symbol.name,
        detail: (!symbol.detail.is_empty()).then_some(symbol.detail),
        kind: kind(symbol.kind),
        tags: None,
        deprecated: None,
        range: lines.range(symbol.whole),
        selection_range: lines.range(symbol.place),
        children: (!children.is_empty()).then_some(children),
    }
}

#[expect(deprecated, reason = "the field has to be there")]
fn flatten(symbol: Symbol, container: Option<&str>, uri: &Uri, lines: &Lines, flat: &mut Vec<SymbolInformation>) {
    flat.push(SymbolInformation {
        name: symbol.name.clone(),
        kind: kind(symbol.kind),
        tags: None,
        deprecated: None,
        location: tower_lsp_server::ls_types::Location::new(uri.clone(), lines.range(symbol.place)),
        container_name: container.map(str::to_owned),
    });
    for child in symbol.children {
        flatten(child, Some(&symbol.name), uri, lines, flat);
    }
}

#[expect(deprecated, reason = "the field has to be there")]
pub(crate) fn of_workspace(snapshot: &Snapshot, params: &WorkspaceSymbolParams) -> WorkspaceSymbolResponse {
    let mut projects: Vec<Project> = Vec::new();
    for place in snapshot.files.by_path.values() {
        if !projects.contains(&place.project) {
            projects.push(place.project);
        }
    }
    let mut symbols = Vec::new();
    for project in projects {
        let left = MOST_SYMBOLS.saturating_sub(symbols.len());
        let found = acrc_ide::workspace_symbols(&snapshot.db, project, &params.query, left);
        symbols.extend(found.into_iter().filter_map(|symbol| {
            Some(SymbolInformation {
                location: snapshot.location(symbol.target.file, symbol.target.name)?,
                name: symbol.name,
                kind: kind(symbol.kind),
                tags: None,
                deprecated: None,
                container_name: (!symbol.container.is_empty()).then_some(symbol.container),
            })
        }));
    }
    WorkspaceSymbolResponse::Flat(symbols)
}

fn kind(kind: Kind) -> SymbolKind {
    match kind {
        Kind::Prompt => SymbolKind::NAMESPACE,
        Kind::Program => SymbolKind::MODULE,
        Kind::Subroutine => SymbolKind::FUNCTION,
        Kind::Label => SymbolKind::KEY,
        Kind::Alias => SymbolKind::CONSTANT,
        Kind::Axis => SymbolKind::FIELD,
        Kind::Variable => SymbolKind::VARIABLE,
    }
}
