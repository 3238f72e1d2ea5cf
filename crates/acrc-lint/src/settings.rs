//! Which rules are heard in a file.

use acrc_analysis::project::LintConfig;
use acrc_diagnostics::Diagnostic;

use crate::registry::RULES;
use crate::rule::RuleDoc;

/// The selector that means every rule.
const ALL: &str = "ALL";

/// The rules that are heard in a file.
pub(crate) struct Settings {
    /// By the place of the rule in the registry.
    enabled: Vec<bool>,
}

impl Settings {
    /// What a configuration says.
    pub(crate) fn new(config: &LintConfig) -> Self {
        let is_enabled = |doc: &RuleDoc| match &config.select {
            Some(selectors) => selectors.iter().any(|selector| selects(selector, doc)),
            None => doc.enabled,
        };
        Self { enabled: RULES.iter().map(|rule| is_enabled(&rule.doc)).collect() }
    }

    /// Whether a finding is heard. One of an unknown code is.
    pub(crate) fn hear(&self, finding: &Diagnostic) -> bool {
        let place = RULES.binary_search_by_key(&finding.code.id, |rule| rule.doc.code.id).ok();
        place.and_then(|place| self.enabled.get(place)).copied().unwrap_or(true)
    }
}

/// Whether a selector means a rule: `ALL`, a group, a name, a code or the beginning of one.
fn selects(selector: &str, doc: &RuleDoc) -> bool {
    let code = doc.code.id;
    selector.eq_ignore_ascii_case(ALL)
        || selector.eq_ignore_ascii_case(doc.group.as_str())
        || selector.eq_ignore_ascii_case(doc.code.name)
        || code.get(..selector.len()).is_some_and(|start| start.eq_ignore_ascii_case(selector))
}
