//! `ACR303`: a constant that a parameter or bit can't hold.

use acrc_analysis::walk;
use acrc_catalog::{Confidence, OperandClass};
use acrc_diagnostics::{Code, Diagnostic, Severity};
use acrc_syntax::ast::{Assign, Statement, StatementKind};

use crate::Context;
use crate::references::meaning;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR303", name: "value-out-of-range" },
        group: Group::Parameters,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A constant is assigned to a parameter beyond the range that a document gives it, or a number other than \
               0, 1 and -1 to a bit.",
        why: "The controller refuses the value or cuts it, so that a network does not start or a node keeps another \
              address. A bit holds one of two states only.",
        bad: "PROG0\nPROGRAM\nP32768 = 200\nENDP",
        good: "PROG0\nPROGRAM\nP32768 = 20\nENDP",
        guide: "CANopen / Parameters; Programming Basics / Setting Binary Bits",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Assign(assign) = &statement.kind else { return };
    let Some(value) = walk::literal(&assign.value) else { return };
    let Some((class, number)) = meaning(context, &assign.target) else { return };
    match class {
        OperandClass::Bit if ![0.0, 1.0, -1.0].contains(&value) => {
            let message = format!("bit {number} is given {value}; a bit holds 0 or 1");
            context.report(RULE.at(assign.value.span, message).with_help("SET sets it, CLR clears it"));
        }
        OperandClass::Parameter => judge(context, assign, number, value),
        _ => {}
    }
}

fn judge(context: &mut Context<'_>, assign: &Assign, number: u64, value: f64) {
    let Ok(number) = u32::try_from(number) else { return };
    let info = acrc_catalog::parameter(number);
    let Some((least, most)) = info.row.and_then(|row| row.range) else { return };
    let (least, most) = (f64::from(least), f64::from(most));
    if (least..=most).contains(&value) {
        return;
    }
    let message = format!("P{number} ({}) is given {value}; it takes {least} to {most}", info.title);
    let finding: Diagnostic = RULE.at(assign.value.span, message);
    context.report(if info.confidence == Confidence::High { finding } else { finding.unconfirmed() });
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    #[test]
    fn bits_hold_two_states() {
        assert_eq!(spans_of("ACR303", "BIT 32 = 2\nBIT32=1 : BIT33=0\nBIT 34 = -1\nBIT 35 = P0\n"), ["2"]);
        assert_eq!(spans_of("ACR303", "#DEFINE Lamp BIT32\nLamp = (-5)\n"), ["(-5)"]);
    }

    #[test]
    fn parameters_with_a_documented_range() {
        let text = "P32768 = 127\nP32768 = 0\nP(32768) = 128\nP32770 = 4\nP32770 = 5\nP0 = 1000000\n";
        assert_eq!(spans_of("ACR303", text), ["0", "128", "5"]);
    }
}
