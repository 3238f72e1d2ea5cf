//! Edits of several files.

use std::collections::HashMap;

use acrc_ide::FileEdits;
use tower_lsp_server::ls_types::{
    DocumentChanges, OneOf, OptionalVersionedTextDocumentIdentifier, TextDocumentEdit, TextEdit, Uri, WorkspaceEdit,
};

use crate::snapshot::Snapshot;

/// Edits for the client. With the versions of the documents they are about, when it can compare these.
pub(super) fn workspace_edit(snapshot: &Snapshot, edits: &[FileEdits]) -> WorkspaceEdit {
    if snapshot.abilities.document_changes {
        let documents = edits.iter().filter_map(|edits| {
            let uri = snapshot.uri(edits.0)?;
            let version = snapshot.document(edits.0).map(|document| document.version);
            Some(TextDocumentEdit {
                text_document: OptionalVersionedTextDocumentIdentifier { uri, version },
                edits: text_edits(snapshot, edits).into_iter().map(OneOf::Left).collect(),
            })
        });
        let document_changes = Some(DocumentChanges::Edits(documents.collect()));
        return WorkspaceEdit { document_changes, ..WorkspaceEdit::default() };
    }
    let mut changes: HashMap<Uri, Vec<TextEdit>> = HashMap::new();
    for edits in edits {
        if let Some(uri) = snapshot.uri(edits.0) {
            changes.entry(uri).or_default().extend(text_edits(snapshot, edits));
        }
    }
    WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }
}

/// Edits of one file for the client.
pub(super) fn text_edits(snapshot: &Snapshot, (file, edits): &FileEdits) -> Vec<TextEdit> {
    let lines = snapshot.lines(*file);
    edits.iter().map(|edit| TextEdit::new(lines.range(edit.span), edit.text.clone())).collect()
}
