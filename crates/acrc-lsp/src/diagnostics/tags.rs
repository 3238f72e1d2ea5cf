//! Findings that editors show in a way of their own.

use tower_lsp_server::ls_types::DiagnosticTag;

/// Rules about code that could be left out: editors show it faded.
const UNNECESSARY: &[&str] = &[
    "empty-block",
    "unreachable-code",
    "unused-alias",
    "unused-label",
    "unused-local-memory",
    "unused-suppression",
    "unused-variable",
];

/// The tag of a rule, by its code.
pub(super) fn of(code: &str) -> Option<DiagnosticTag> {
    let name = acrc_lint::explain(code)?.code.name;
    UNNECESSARY.contains(&name).then_some(DiagnosticTag::UNNECESSARY)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_tag_is_of_a_rule() {
        for name in UNNECESSARY {
            assert!(acrc_lint::rules().any(|rule| rule.code.name == *name), "{name}");
        }
    }
}
