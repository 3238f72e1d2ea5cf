//! `ACR603`: numbers of bits and parameters that come up again and again.

use acrc_analysis::walk;
use acrc_catalog::OperandClass;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Argument, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::operands::Variable;
use crate::rule::{Check, Group, Rule, RuleDoc};

/// From how many uses on a number should have a name.
const USES: usize = 3;

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR603", name: "magic-bit-number" },
        group: Group::Style,
        severity: Severity::Advice,
        enabled: false,
        mark: None,
        what: "A file uses a bit, or a parameter of the system, three times or more by its number.",
        why: "A number says nothing, one wrong digit in it is another flag that works as well, and rewiring an input means \
              finding them all. An alias says what it is, in one place.",
        bad: "PROG0\nPROGRAM\nSET 34\nDWL 1\nCLR 34\nDWL 1\nSET 34\nENDP",
        good: "SYS\nDIM DEF(10)\n#DEFINE Camera BIT34\nPROG0\nPROGRAM\nSET Camera\nDWL 1\nCLR Camera\nDWL 1\nSET Camera\nENDP",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let mut uses = Vec::new();
    for statement in context.tree().statements() {
        collect(context, statement, &mut uses);
    }
    uses.sort_by_key(|(variable, span)| (*variable, span.start));
    for uses in uses.chunk_by(|(a, _), (b, _)| a == b) {
        let Some((variable, first)) = uses.first().filter(|_| uses.len() >= USES) else { continue };
        let (operand, title) = describe(*variable);
        let title = if title.is_empty() { String::new() } else { format!(" ({title})") };
        let message = format!("{operand}{title} is used {} times by its number", uses.len());
        context.report(RULE.at(*first, message).with_help(format!("give it a name with `#DEFINE name {operand}`")));
    }
}

/// The bits, and parameters of the system, that a statement uses by their numbers.
fn collect(context: &Context<'_>, statement: &Statement, uses: &mut Vec<(Variable, Span)>) {
    match &statement.kind {
        StatementKind::Define(_) => return,
        StatementKind::Command(command) => {
            for argument in &command.arguments {
                if let Argument::Bit(bit) = argument
                    && let ExprKind::Integer(number) = bit.index.kind
                {
                    uses.push((Variable { class: OperandClass::Bit, number }, bit.index.span));
                }
            }
        }
        _ => {}
    }
    walk::expressions(statement, &mut |expr| {
        if matches!(expr.kind, ExprKind::Operand(_))
            && let Some(variable) = Variable::of(context, expr)
            && !variable.is_user_parameter()
            && !variable.class.is_local()
        {
            uses.push((variable, expr.span));
        }
    });
}

/// A bit or parameter as an operand, and what it is.
fn describe(variable: Variable) -> (String, &'static str) {
    let number = u32::try_from(variable.number).unwrap_or(u32::MAX);
    match variable.class {
        OperandClass::Bit => (format!("BIT{}", variable.number), acrc_catalog::bit(number).title),
        _ => (format!("P{}", variable.number), acrc_catalog::parameter(number).title),
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{lines_of, spans_of};

    #[test]
    fn the_first_use_is_marked() {
        assert_eq!(spans_of("ACR603", "SET 34\nINH -BIT34\nIF (BIT 34) THEN CLR 35\n"), ["34"]);
        assert_eq!(lines_of("ACR603", &[("a.8K", "P0 = P12290\nP1 = P12290\nP2 = P12290/P12375\n")]), [[1]]);
    }

    #[test]
    fn user_parameters_and_definitions_do_not_count() {
        assert_eq!(spans_of("ACR603", "P0 = 1\nP0 = 2\nP0 = 3\n"), [""; 0]);
        assert_eq!(spans_of("ACR603", "#DEFINE Camera BIT34\nSET 34\nCLR 34\nSET Camera\nCLR Camera\n"), [""; 0]);
    }
}
