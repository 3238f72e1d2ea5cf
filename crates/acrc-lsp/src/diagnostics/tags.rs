//! Findings that editors show in a way of their own.

use acrc_lint::Mark;
use tower_lsp_server::ls_types::DiagnosticTag;

/// The tag of a rule, by its code.
pub(super) fn of(code: &str) -> Option<DiagnosticTag> {
    acrc_lint::explain(code)?.mark.map(|mark| match mark {
        Mark::Unnecessary => DiagnosticTag::UNNECESSARY,
        Mark::Deprecated => DiagnosticTag::DEPRECATED,
    })
}
