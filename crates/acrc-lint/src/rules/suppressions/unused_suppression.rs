//! `ACR901`: a comment that suppresses nothing.

use acrc_diagnostics::{Code, Diagnostic, Fix, Severity, Span};

use crate::rule::{Group, Mark, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR901", name: "unused-suppression" },
        group: Group::Suppressions,
        severity: Severity::Advice,
        enabled: true,
        mark: Some(Mark::Unnecessary),
        what: "A comment allows a rule that finds nothing in the lines that the comment is about. Only rules that are on \
               count.",
        why: "The comment is left over from a mistake that is repaired, or stands at the wrong line. It would hide the \
              next mistake of that kind.",
        bad: "PROG0\nPROGRAM\n_Cycle\nSET 32\n' acrc: allow(undefined-label)\nGOTO Cycle\nENDP",
        good: "PROG0\nPROGRAM\n_Cycle\nSET 32\nGOTO Cycle\nENDP",
        guide: "says nothing of tools; the comment is one of acrc",
    },
    // Found when all others have looked at the file.
    checks: &[],
};

/// The finding for some names of a comment.
pub(crate) fn finding<'t>(
    span: Span,
    names: impl Iterator<Item = &'t str>,
    in_file: bool,
    fix: Option<Fix>,
) -> Diagnostic {
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    let place = if in_file { "in this file" } else { "here" };
    let verb = if names.len() == 1 { "finds" } else { "find" };
    let finding = RULE.at(span, format!("{} {verb} nothing {place} to suppress", names.join(" and ")));
    match fix {
        Some(fix) => finding.with_fix(fix),
        None => finding,
    }
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::{Applicability, apply};

    use crate::testing::lint;

    /// The text after the fix of the first finding of the rule, and whether it may be applied unseen.
    fn fixed(text: &str) -> (String, Applicability) {
        let found = lint(&[("test.8K", text)]).concat();
        let finding = found.iter().find(|finding| finding.code.id == "ACR901").expect("an unused comment");
        let fix = finding.fixes.first().expect("a fix");
        (apply(text, &[fix]).expect("a fix that fits"), fix.applicability)
    }

    #[test]
    fn a_comment_that_nothing_needs_goes() {
        for (text, expected, applicability) in [
            ("SET 32\r\n  ' acrc: allow(ACR101)\r\nSET 33\r\n", "SET 32\r\nSET 33\r\n", Applicability::Safe),
            ("' acrc: allow(ACR101)", "", Applicability::Safe),
            ("SET 32\n' acrc: allow-file(ACR101)", "SET 32", Applicability::Safe),
            ("SET 32 : REM acrc: allow(ACR101) -- why\n", "SET 32\n", Applicability::Safe),
            ("REM acrc: allow(ACR101)\nSET 32\n", "SET 32\n", Applicability::Unsafe),
            ("PROG0\n10 REM acrc: allow(ACR101)\n20 SET 32\n", "PROG0\n10 REM\n20 SET 32\n", Applicability::Safe),
            ("IF (BIT 1) THEN REM acrc: allow(ACR101)\nSET 32\n", "IF (BIT 1) THEN REM\nSET 32\n", Applicability::Safe),
            ("GOTO A : REM acrc: allow(ACR102, ACR101)\n", "GOTO A : REM acrc: allow(ACR101)\n", Applicability::Safe),
        ] {
            assert_eq!(fixed(text), (expected.to_owned(), applicability), "{text}");
        }
    }
}
