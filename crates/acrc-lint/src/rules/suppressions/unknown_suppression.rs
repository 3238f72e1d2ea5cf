//! `ACR902`: a comment for this tool that it does not understand.

use acrc_diagnostics::{Code, Diagnostic, Edit, Fix, Severity, Span};

use crate::rule::{Group, Rule, RuleDoc};
use crate::selector::{self, Selector};
use crate::suppress::Mistake;

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR902", name: "unknown-suppression" },
        group: Group::Suppressions,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A comment that begins with `acrc:`, or nearly so, is not understood, or names a rule that does not exist or \
               can't be suppressed.",
        why: "It looks as if a finding were suppressed or the formatter switched off, and nothing is.",
        bad: "PROG0\nPROGRAM\n' acrc: allow(undefined-lable)\nGOTO Recipe\nENDP",
        good: "PROG0\nPROGRAM\n' acrc: allow(undefined-label)\nGOTO Recipe\nENDP",
        guide: "says nothing of tools; the comment is one of acrc",
    },
    // Found when all others have looked at the file.
    checks: &[],
};

/// The finding for a name that is no rule. With `suggest`, a rule of a similar name is looked for.
pub(crate) fn unknown(span: Span, name: &str, suggest: bool) -> Diagnostic {
    let finding = RULE.at(span, format!("`{name}` is no rule that can be suppressed"));
    if crate::explain(name).is_some() {
        return finding.with_help("the compiler reports it, and does not build what it refuses");
    }
    if Selector::parse(name).is_some() {
        return finding.with_help("name each rule by its code or name: a comment suppresses no whole group");
    }
    let near = suggest.then(|| selector::near(name)).flatten();
    match near.filter(|near| crate::explain(near).is_some()) {
        Some(near) => finding
            .with_help(format!("did you mean `{near}`?"))
            .with_fix(Fix::unsafe_(format!("write `{near}`"), vec![Edit::replace(span, near)])),
        None => finding.with_help("`acrc lint --rules` lists all rules"),
    }
}

/// The finding for a rule whose findings are always heard.
pub(crate) fn locked(span: Span, name: &str) -> Diagnostic {
    RULE.at(span, format!("`{name}` can't be suppressed"))
        .with_help("the controller refuses what can't be read, whatever a comment says")
}

/// The finding for a comment that is not understood.
pub(crate) fn mistake(mistake: Mistake) -> Diagnostic {
    RULE.at(mistake.span, mistake.message).with_help(mistake.help)
}
