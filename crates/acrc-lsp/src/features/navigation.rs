//! From a name to where it is declared and used.

use acrc_ide::{Access, Target};
use tower_lsp_server::ls_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, GotoDefinitionParams, GotoDefinitionResponse,
    Location, LocationLink, ReferenceParams,
};

use super::Answer;
use crate::snapshot::Snapshot;

pub(crate) fn definition(snapshot: &Snapshot, params: &GotoDefinitionParams) -> Answer<GotoDefinitionResponse> {
    let Some((position, lines)) = snapshot.position(&params.text_document_position_params) else { return Ok(None) };
    let targets = acrc_ide::definition(&snapshot.db, position);
    if !snapshot.abilities.location_links {
        let locations = targets.iter().filter_map(|target| snapshot.location(target.file, target.name));
        return Ok(Some(GotoDefinitionResponse::Array(locations.collect())));
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
    Ok(Some(GotoDefinitionResponse::Link(targets.iter().filter_map(link).collect())))
}

pub(crate) fn references(snapshot: &Snapshot, params: &ReferenceParams) -> Answer<Vec<Location>> {
    let Some((position, _)) = snapshot.position(&params.text_document_position) else { return Ok(None) };
    let found = acrc_ide::references(&snapshot.db, position, params.context.include_declaration);
    Ok(Some(found.iter().filter_map(|range| snapshot.location(range.file, range.span)).collect()))
}

pub(crate) fn highlights(snapshot: &Snapshot, params: &DocumentHighlightParams) -> Answer<Vec<DocumentHighlight>> {
    let Some((position, lines)) = snapshot.position(&params.text_document_position_params) else { return Ok(None) };
    let found = acrc_ide::highlights(&snapshot.db, position).into_iter();
    let highlight = |(span, access)| DocumentHighlight {
        range: lines.range(span),
        kind: Some(match access {
            Access::Text => DocumentHighlightKind::TEXT,
            Access::Read => DocumentHighlightKind::READ,
            Access::Write => DocumentHighlightKind::WRITE,
        }),
    };
    Ok(Some(found.map(highlight).collect()))
}
