//! Findings: told when they change, and given when they are asked for.

mod convert;
mod publish;
mod pull;
mod tags;

use acrc_analysis::{Project, SourceFile};
use tower_lsp_server::ls_types::Diagnostic;

use crate::snapshot::Snapshot;

pub(crate) use convert::of_trouble;
pub(crate) use publish::{Publisher, Round};
pub(crate) use pull::{document, overtaken, workspace};

/// What is found in a file, as the client gets it.
pub(crate) fn of_file(snapshot: &Snapshot, project: Project, file: SourceFile) -> Vec<Diagnostic> {
    if !snapshot.settings.lint.enable {
        return Vec::new();
    }
    let found = acrc_analysis::diagnostics(&snapshot.db, project, file, acrc_lint::CHECKER);
    if found.is_empty() {
        return Vec::new();
    }
    let lines = snapshot.lines(file);
    let uri = snapshot.uri(file);
    found.iter().map(|finding| convert::diagnostic(snapshot, finding, &lines, uri.as_ref())).collect()
}
