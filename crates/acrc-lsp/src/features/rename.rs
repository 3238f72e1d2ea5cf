//! Another name for something.

use acrc_ide::RenameError;
use tower_lsp_server::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp_server::ls_types::{PrepareRenameResponse, RenameParams, TextDocumentPositionParams, WorkspaceEdit};

use super::edits::workspace_edit;
use crate::snapshot::Snapshot;

/// The protocol's code for a question that is in order, and that has no answer.
const REQUEST_FAILED: i64 = -32803;

pub(crate) fn prepare(
    snapshot: &Snapshot,
    params: &TextDocumentPositionParams,
) -> Result<Option<PrepareRenameResponse>> {
    let Some((position, lines)) = snapshot.position(params) else { return Ok(None) };
    let span = acrc_ide::prepare_rename(&snapshot.db, position).map_err(|error| refusal(&error))?;
    let placeholder = position.file.text(&snapshot.db).get(span.range()).unwrap_or_default().to_owned();
    Ok(Some(PrepareRenameResponse::RangeWithPlaceholder { range: lines.range(span), placeholder }))
}

pub(crate) fn rename(snapshot: &Snapshot, params: &RenameParams) -> Result<Option<WorkspaceEdit>> {
    let Some((position, _)) = snapshot.position(&params.text_document_position) else { return Ok(None) };
    let edits = acrc_ide::rename(&snapshot.db, position, &params.new_name).map_err(|error| refusal(&error))?;
    Ok(Some(workspace_edit(snapshot, &edits)))
}

/// Why not, for the person to read.
fn refusal(error: &RenameError) -> Error {
    Error { code: ErrorCode::ServerError(REQUEST_FAILED), message: error.to_string().into(), data: None }
}
