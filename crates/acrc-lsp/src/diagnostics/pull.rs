//! Findings when the client asks for them.

use std::collections::HashMap;
use std::hash::{Hash, Hasher};

use acrc_analysis::SourceFile;
use camino::Utf8Path;
use rustc_hash::FxHasher;
use tower_lsp_server::jsonrpc::{Error, ErrorCode};
use tower_lsp_server::ls_types::{
    Diagnostic, DocumentDiagnosticParams, DocumentDiagnosticReport, DocumentDiagnosticReportKind,
    DocumentDiagnosticReportResult, FullDocumentDiagnosticReport, RelatedFullDocumentDiagnosticReport,
    RelatedUnchangedDocumentDiagnosticReport, UnchangedDocumentDiagnosticReport, Uri, WorkspaceDiagnosticParams,
    WorkspaceDiagnosticReport, WorkspaceDocumentDiagnosticReport, WorkspaceFullDocumentDiagnosticReport,
    WorkspaceUnchangedDocumentDiagnosticReport,
};

use super::of_file;
use crate::snapshot::{Place, Snapshot};

/// The protocol's code for a question that the server gave up.
const SERVER_CANCELLED: i64 = -32802;

/// The findings of a file, and of open files that hang on it when the client takes them.
pub(crate) fn document(snapshot: &Snapshot, params: &DocumentDiagnosticParams) -> DocumentDiagnosticReportResult {
    let Some(place) = snapshot.place(&params.text_document.uri) else {
        return report(full(Vec::new()), None);
    };
    let own = one(snapshot, place, params.previous_result_id.as_deref());
    let related = snapshot.abilities.related_documents.then(|| related(snapshot, place)).filter(|all| !all.is_empty());
    report(own, related)
}

/// The findings of all files, as far as the client does not know them; `None` when it knows them all.
pub(crate) fn workspace(snapshot: &Snapshot, params: &WorkspaceDiagnosticParams) -> Option<WorkspaceDiagnosticReport> {
    let known: HashMap<&str, &str> =
        params.previous_result_ids.iter().map(|known| (known.uri.as_str(), known.value.as_str())).collect();
    let mut items = Vec::new();
    let mut news = false;
    let mut seen = 0;
    for (file, place) in snapshot.files.by_path.values().map(|place| (place.file, *place)) {
        let Some(uri) = snapshot.uri(file) else { continue };
        let previous = known.get(uri.as_str()).copied();
        seen += usize::from(previous.is_some());
        let version = snapshot.document(file).map(|document| i64::from(document.version));
        items.push(match one(snapshot, place, previous) {
            DocumentDiagnosticReportKind::Unchanged(unchanged) => {
                WorkspaceDocumentDiagnosticReport::Unchanged(WorkspaceUnchangedDocumentDiagnosticReport {
                    uri,
                    version,
                    unchanged_document_diagnostic_report: unchanged,
                })
            }
            DocumentDiagnosticReportKind::Full(full) => {
                // A file without findings is no news to a client that knows nothing of it.
                news |= previous.is_some() || !full.items.is_empty();
                item(uri, version, full)
            }
        });
    }
    if seen < known.len() {
        news = true;
        items.extend(gone(snapshot, &known));
    }
    news.then_some(WorkspaceDiagnosticReport { items })
}

/// Empty reports for files that are no longer there.
fn gone(snapshot: &Snapshot, known: &HashMap<&str, &str>) -> Vec<WorkspaceDocumentDiagnosticReport> {
    let mut uris: Vec<Uri> = known.keys().filter_map(|uri| uri.parse().ok()).collect();
    uris.retain(|uri| snapshot.place(uri).is_none());
    uris.sort();
    let empty = |uri| item(uri, None, FullDocumentDiagnosticReport { result_id: None, items: Vec::new() });
    uris.into_iter().map(empty).collect()
}

fn item(uri: Uri, version: Option<i64>, full: FullDocumentDiagnosticReport) -> WorkspaceDocumentDiagnosticReport {
    let full_document_diagnostic_report = full;
    WorkspaceDocumentDiagnosticReport::Full(WorkspaceFullDocumentDiagnosticReport {
        uri,
        version,
        full_document_diagnostic_report,
    })
}

/// A question that an edit has overtaken shall be asked again.
pub(crate) fn overtaken(error: Error) -> Error {
    if error.code != ErrorCode::ContentModified {
        return error;
    }
    Error {
        code: ErrorCode::ServerError(SERVER_CANCELLED),
        message: "an edit has overtaken the question".into(),
        data: Some(serde_json::json!({ "retriggerRequest": true })),
    }
}

fn related(snapshot: &Snapshot, asked: Place) -> HashMap<Uri, DocumentDiagnosticReportKind> {
    let same_project = snapshot.files.by_path.values().filter(|place| place.project == asked.project);
    let others = same_project.filter(|place| place.file != asked.file && snapshot.document(place.file).is_some());
    others.filter_map(|place| Some((snapshot.uri(place.file)?, one(snapshot, *place, None)))).collect()
}

fn one(snapshot: &Snapshot, place: Place, previous: Option<&str>) -> DocumentDiagnosticReportKind {
    let items = of_file(snapshot, place.project, place.file);
    let id = id_of(snapshot, place.file, &items);
    if previous == Some(id.as_str()) {
        return DocumentDiagnosticReportKind::Unchanged(UnchangedDocumentDiagnosticReport { result_id: id });
    }
    DocumentDiagnosticReportKind::Full(FullDocumentDiagnosticReport { result_id: Some(id), items })
}

/// A name of these findings, which the client gives back when it asks again.
fn id_of(snapshot: &Snapshot, file: SourceFile, items: &[Diagnostic]) -> String {
    let mut hasher = FxHasher::default();
    snapshot.path(file).map(Utf8Path::as_str).hash(&mut hasher);
    // Findings are compared as they are sent.
    serde_json::to_string(items).unwrap_or_default().hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}

fn full(items: Vec<Diagnostic>) -> DocumentDiagnosticReportKind {
    DocumentDiagnosticReportKind::Full(FullDocumentDiagnosticReport { result_id: None, items })
}

fn report(
    own: DocumentDiagnosticReportKind,
    related_documents: Option<HashMap<Uri, DocumentDiagnosticReportKind>>,
) -> DocumentDiagnosticReportResult {
    let report = match own {
        DocumentDiagnosticReportKind::Full(full_document_diagnostic_report) => {
            let report = RelatedFullDocumentDiagnosticReport { related_documents, full_document_diagnostic_report };
            DocumentDiagnosticReport::Full(report)
        }
        DocumentDiagnosticReportKind::Unchanged(unchanged_document_diagnostic_report) => {
            let report =
                RelatedUnchangedDocumentDiagnosticReport { related_documents, unchanged_document_diagnostic_report };
            DocumentDiagnosticReport::Unchanged(report)
        }
    };
    report.into()
}
