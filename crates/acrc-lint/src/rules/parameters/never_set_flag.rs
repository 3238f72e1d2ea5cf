//! `ACR313`: a wait for a user flag that no code sets.

use acrc_catalog::{BitKind, OperandClass};
use acrc_diagnostics::{Code, Severity};

use crate::Context;
use crate::references::{Reference, Usage};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR313", name: "never-set-flag" },
        group: Group::Parameters,
        severity: Severity::Advice,
        enabled: false,
        mark: None,
        what: "A program waits with INH until a user flag is set that no code of the project sets. An operator panel or a \
               host may set it, so this is off by itself.",
        why: "If nothing outside sets the flag either, the program waits for ever, and the machine seems to be dead.",
        bad: "PROG0\nATTACH MASTER0\nPROGRAM\nINH 150\nENDP",
        good: "PROG0\nATTACH MASTER0\nPROGRAM\nINH 150\nENDP\nPROG1\nPROGRAM\nSET 150\nENDP",
        guide: "Programming Basics / INH",
    },
    checks: &[Check::Reference(check)],
};

fn check(context: &mut Context<'_>, reference: &Reference) {
    if reference.usage != (Usage::Wait { set: true }) || reference.class != OperandClass::Bit {
        return;
    }
    let Some(number) = reference.small() else { return };
    let is_user = acrc_catalog::bit(number).kind == Some(BitKind::User);
    if is_user && !context.environment().fragment && !context.questions().may_set_flag(number) {
        let message = format!("no code of the project sets {}, which this waits for", reference.name());
        context.report(reference.labelled(RULE.at(reference.span, message)));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{lines_of, spans_of};

    #[test]
    fn flags_that_nobody_sets() {
        let setup = "PROG0\nATTACH MASTER0\nPROGRAM\nINH 150\nINH -151\nINH 24\nINH 152\nENDP\n";
        assert_eq!(lines_of("ACR313", &[("a.8K", setup), ("b.8K", "#DEFINE Go BIT152\nSET Go\n")]), [vec![4], vec![]]);
    }

    #[test]
    fn a_flag_that_may_be_any_is_believed_to_be_this_one() {
        let text = "PROG0\nPROGRAM\nINH 150\nSET (P5)\nENDP\n";
        assert_eq!(spans_of("ACR313", text), [""; 0]);
        assert_eq!(spans_of("ACR313", "PROG0\nPROGRAM\nINH 150\nP4100 = 5\nENDP\n"), [""; 0], "a whole word");
        assert_eq!(spans_of("ACR313", "PROG0\nPROGRAM\nINH 150\nENDP\nPLC0\nPROGRAM\nLD 5\nOUT 150\nENDP\n"), [""; 0]);
    }
}
