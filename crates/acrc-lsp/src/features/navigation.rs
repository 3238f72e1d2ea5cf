//! From a name to where it is declared and used.

use acrc_ide::{Access, Target};
use tower_lsp_server::ls_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, GotoDefinitionParams, GotoDefinitionResponse,
    Location, LocationLink, ReferenceParams,
};

use super::Answer;
use crate::snapshot::Snapshot;

pub(crate) fn definition(snapshot: &Snapshot, params: &GotoDefinitionParams) -> Answer<GotoDefinitionResponse> {
    let (position, lines) = snapshot.position(&params.text_document_position_params)?;
    let targets = acrc_ide::definition(&snapshot.db, position);
    if !snapshot.abilities.location_links {
        let locations = targets.iter().filter_map(|target| snapshot.location(target.file, target.name));
        return Some(GotoDefinitionResponse::Array(locations.collect()));
    }
    let origin = acrc_ide::at(&snapshot.db, position).map(|occurrence| lines.range(occurrence.span));
    let link = |target: &Target| {
        let lines = snapshot.lines(target.file);
        Some(LocationLink {
            origin_selection_range: origin,
            target_uri: snapshot.uri(target.file)?,
            target_range: lines.range(target.whole),
            target_selection_range: lines.range(target.name),
        })
    };
    Some(GotoDefinitionResponse::Link(targets.iter().filter_map(link).collect()))
}

pub(crate) fn references(snapshot: &Snapshot, params: &ReferenceParams) -> Answer<Vec<Location>> {
    let (position, _) = snapshot.position(&params.text_document_position)?;
    let found = acrc_ide::references(&snapshot.db, position, params.context.include_declaration);
    Some(found.iter().filter_map(|range| snapshot.location(range.file, range.span)).collect())
}

pub(crate) fn highlights(snapshot: &Snapshot, params: &DocumentHighlightParams) -> Answer<Vec<DocumentHighlight>> {
    let (position, lines) = snapshot.position(&params.text_document_position_params)?;
    let found = acrc_ide::highlights(&snapshot.db, position).into_iter();
    let highlight = |(span, access)| DocumentHighlight {
        range: lines.range(span),
        kind: Some(match access {
            Access::Text => DocumentHighlightKind::TEXT,
            Access::Read => DocumentHighlightKind::READ,
            Access::Write => DocumentHighlightKind::WRITE,
        }),
    };
    Some(found.map(highlight).collect())
}
