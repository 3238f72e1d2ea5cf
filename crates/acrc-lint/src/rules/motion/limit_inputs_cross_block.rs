//! `ACR510`: inputs of limits and home that do not lie in one block.

use acrc_catalog::command;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Expr, ExprKind, Statement, StatementKind};

use super::axis_values;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR510", name: "limit-inputs-cross-block" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "An HLBIT takes the last or the last but one input of a block of 32, so that the three inputs of the \
               axis (positive limit, negative limit, home) do not lie in one block.",
        why: "The controller does not go on in the next block: the inputs behind the end of the block are imaginary \
              and read 0. The axis passes that limit or that home switch as if it were not there.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLBIT X31",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLBIT X24",
        guide: "System Configuration / Dedicated I/O",
    },
    checks: &[Check::Statement(check)],
};

/// Inputs of a block.
const BLOCK: u64 = 32;

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(command) = &statement.kind else { return };
    if command.id != command::HLBIT {
        return;
    }
    for values in axis_values(command) {
        let [Expr { span, kind: ExprKind::Integer(first) }] = values else { continue };
        let missing = match first % BLOCK {
            30 => "home",
            31 => "negative limit and home",
            _ => continue,
        };
        let last = first - first % BLOCK + BLOCK - 1;
        let message = format!("input {first} leaves no place for {missing}: the block of 32 ends at input {last}");
        context.report(RULE.at(*span, message).with_help(format!(
            "take a first input of at most {}; the two behind it become negative limit and home",
            last - 2
        )));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    #[test]
    fn the_last_two_of_a_block() {
        let text = "HLBIT X29 Y30 Z31\nAXIS3 HLBIT 31\nHLBIT AXIS4 62\nHLBIT X63 Y(30)\n";
        assert_eq!(spans_of("ACR510", text), ["30", "31", "31", "62", "63"]);
    }

    #[test]
    fn other_inputs() {
        assert_eq!(spans_of("ACR510", "HLBIT X0 Y3\nHLBIT X32\nHLBIT X(P0)\nHLBIT X\nHLIM X3\n"), [""; 0]);
    }
}
