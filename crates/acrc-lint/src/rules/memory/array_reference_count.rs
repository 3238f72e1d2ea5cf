//! `ACR412`: elements for an array that has no reference.

use acrc_analysis::memory::IssueKind;
use acrc_catalog::OperandClass;
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};

use super::sites;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR412", name: "array-reference-count" },
        group: Group::Memory,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "An array is given its elements (DIM LA0(500)) without a reference for it: DIM LA(n) comes first, and makes \
               room for the arrays LA0 to LA(n-1).",
        why: "The controller refuses the DIM, and the program stops at the first element that it uses.",
        bad: "PROG0\nPROGRAM\nCLEAR\nDIM LA(1)\nDIM LA1(500)\nENDP",
        good: "PROG0\nPROGRAM\nCLEAR\nDIM LA(2)\nDIM LA1(500)\nENDP",
        guide: "System Configuration / Memory Allocations / How Much Memory?",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for (site, kind) in sites::issues(context) {
        if let IssueKind::NoReference { class, array, references } = kind {
            context.report(finding(sites::span(context, site), class, array, references));
        }
    }
}

fn finding(span: Span, class: OperandClass, array: u32, references: Option<u64>) -> Diagnostic {
    let more = u64::from(array) + 1;
    match references {
        Some(count) => RULE
            .at(
                span,
                format!(
                    "{class}{array} has no reference: DIM {class}({count}) makes room for {}",
                    arrays(class, count)
                ),
            )
            .with_help(format!("DIM {class}({more})")),
        None => RULE
            .at(span, format!("{class}{array} has no reference: no DIM {class}(n) comes before its elements"))
            .with_help(format!("DIM {class}({more}) before it")),
    }
}

fn arrays(class: OperandClass, count: u64) -> String {
    match count {
        0 => "no array".to_owned(),
        1 => format!("{class}0"),
        count => format!("{class}0 to {class}{}", count - 1),
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn references_come_first() {
        assert_eq!(codes("PROG0\nDIM LA0(10)\nDIM LA(1)\n"), [(2, "ACR412")]);
        assert_eq!(codes("PROG0\nDIM LA(1)\nDIM LA0(10)\nDIM LA1(10)\n"), [(4, "ACR412")]);
        assert_eq!(codes("PROG0\nDIM LA(1)\nPROGRAM\nDIM LA0(10)\nENDP\n"), []);
        assert_eq!(codes("PROG0\nDIM LA(1)\nPROGRAM\nCLEAR\nDIM LA0(10)\nENDP\n"), [(5, "ACR412")]);
    }

    #[test]
    fn in_a_subroutine_any_reference_counts() {
        let text =
            |dim: &str| format!("PROG0\nPROGRAM\nCLEAR\n{dim}GOSUB Teach\nEND\n_Teach\nDIM DA0(LV1)\nRETURN\nENDP\n");
        assert_eq!(codes(&text("DIM LV(2)\nDIM DA(1)\n")), []);
        assert_eq!(codes(&text("DIM LV(2)\n")), [(8, "ACR412")]);
    }
}
