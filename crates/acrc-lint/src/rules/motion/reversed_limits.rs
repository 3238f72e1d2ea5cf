//! `ACR512`: a pair of limits the wrong way round.

use acrc_analysis::walk;
use acrc_catalog::{CommandId, command};
use acrc_diagnostics::{Code, Diagnostic, Edit, Fix, Severity, Span};
use acrc_syntax::ast::{Expr, Statement, StatementKind};

use super::axis_values;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR512", name: "reversed-limits" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A pair of limits gives the negative side first, or one value for both sides that is negative. The \
               positive side comes first: `SLM X(24,0)`; a single value stands for plus and minus that value.",
        why: "No position and no error lies between such limits. The axis counts as beyond both of them, and stops or \
              never gets into position, wherever it is.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nSLM X(0,24)",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nSLM X(24,0)",
        guide: "System Configuration / End-of-Travel Limits",
    },
    checks: &[Check::Statement(check)],
};

/// The commands with a positive and a negative side.
const PAIRS: [CommandId; 8] =
    [command::SLM, command::EXC, command::IPB, command::TLM, command::JLM, command::ITB, command::ALM, command::BLM];

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(command) = &statement.kind else { return };
    if !PAIRS.contains(&command.id) {
        return;
    }
    let row = command.id.info();
    for values in axis_values(command) {
        let diagnostic = match values {
            [single] => negative(row.name, single),
            [positive, negative] => reversed(context, row.name, positive, negative),
            _ => None,
        };
        if let Some(diagnostic) = diagnostic {
            context.report_by(row.confidence, diagnostic);
        }
    }
}

fn negative(name: &str, single: &Expr) -> Option<Diagnostic> {
    let value = walk::literal(single).filter(|value| *value < 0.0)?;
    let message = format!("{name} {value} makes {value} the positive side and {} the negative one", -value);
    Some(RULE.at(single.span, message).with_help("write the value of the positive side"))
}

fn reversed(context: &Context<'_>, name: &str, positive: &Expr, negative: &Expr) -> Option<Diagnostic> {
    let [first, second] = [walk::literal(positive)?, walk::literal(negative)?];
    if first >= second {
        return None;
    }
    let swap = vec![
        Edit::replace(positive.span, context.slice(negative.span)),
        Edit::replace(negative.span, context.slice(positive.span)),
    ];
    let message = format!("the positive side of {name} is {first}, which is below the negative side, {second}");
    let diagnostic = RULE.at(Span::cover(positive.span, negative.span), message);
    Some(diagnostic.with_fix(Fix::unsafe_("give the positive side first", swap)))
}

#[cfg(test)]
mod tests {
    use crate::testing::{lint, spans_of};

    #[test]
    fn pairs_the_wrong_way_round() {
        let text = "SLM X(0,24)\nAXIS0 EXC (-0.2, 0.2)\nIPB X0.05 Y(-3,-1)\nJLM AXIS0 (1,2)\n";
        assert_eq!(spans_of("ACR512", text), ["0,24", "-0.2, 0.2", "-3,-1", "1,2"]);
    }

    #[test]
    fn a_single_value_is_that_of_the_positive_side() {
        assert_eq!(spans_of("ACR512", "EXC X-0.5\nTLM X5\nTLM X0\n"), ["-0.5"]);
    }

    #[test]
    fn pairs_in_order_and_computed_ones() {
        assert_eq!(spans_of("ACR512", "SLM X(24,0) Y(0,0)\nSLM X(-1,-2)\nSLM X(P0,P1)\nSLM X(P0,5)\n"), [""; 0]);
    }

    #[test]
    fn the_fix_exchanges_them() {
        let text = "SLM X(0, 24)\n";
        let found = lint(&[("test.8K", text)]).concat();
        let fixes: Vec<_> = found.iter().flat_map(|found| &found.fixes).collect();
        assert_eq!(acrc_diagnostics::apply(text, &fixes).as_deref(), Ok("SLM X(24, 0)\n"));
    }
}
