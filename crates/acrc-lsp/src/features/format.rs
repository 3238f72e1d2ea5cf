//! The layout of a text: of a file, of a part, of what is being typed.

use acrc_diagnostics::Edit;
use tower_lsp_server::ls_types::{
    DocumentFormattingParams, DocumentOnTypeFormattingParams, DocumentRangeFormattingParams, TextEdit, Uri,
};

use super::Answer;
use super::edits::text_edits;
use crate::snapshot::{Place, Snapshot};

pub(crate) fn format(snapshot: &Snapshot, params: &DocumentFormattingParams) -> Answer<Vec<TextEdit>> {
    edits(snapshot, &params.text_document.uri, |Place { project, file }| {
        Some(acrc_ide::format_file(&snapshot.db, project, file))
    })
}

pub(crate) fn format_range(snapshot: &Snapshot, params: &DocumentRangeFormattingParams) -> Answer<Vec<TextEdit>> {
    edits(snapshot, &params.text_document.uri, |Place { project, file }| {
        let part = snapshot.lines(file).span(params.range)?;
        Some(acrc_ide::format_range(&snapshot.db, project, file, part))
    })
}

pub(crate) fn format_typed(snapshot: &Snapshot, params: &DocumentOnTypeFormattingParams) -> Answer<Vec<TextEdit>> {
    let at = &params.text_document_position;
    edits(snapshot, &at.text_document.uri, |Place { project, file }| {
        let offset = snapshot.lines(file).offset(at.position);
        Some(acrc_ide::format_typed(&snapshot.db, project, file, offset, params.ch.chars().next()?))
    })
}

fn edits(snapshot: &Snapshot, uri: &Uri, edits: impl FnOnce(Place) -> Option<Vec<Edit>>) -> Answer<Vec<TextEdit>> {
    let place = snapshot.place(uri);
    place.and_then(|place| Some(text_edits(snapshot, &(place.file, edits(place)?))))
}
