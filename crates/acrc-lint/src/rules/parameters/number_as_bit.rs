//! `ACR306`: something that is no bit stands where a bit is expected.

use acrc_catalog::OperandClass;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{BitArgument, Expr, ExprKind, Statement};

use acrc_analysis::walk;

use crate::Context;
use crate::references::meaning;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR306", name: "number-as-bit" },
        group: Group::Parameters,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "SET, CLR or INH names a parameter, or an alias of one, without parentheses, or takes the state of a bit in \
               parentheses for its number.",
        why: "At best the bit is meant whose number the parameter holds: with 0 in it that is input 0. Mostly P was \
              written for BIT, and the statement acts on another bit than it says.",
        bad: "PROG0\nPROGRAM\nSET P32\nENDP",
        good: "PROG0\nPROGRAM\nSET BIT32\nENDP",
        guide: "Programming Basics / Using Parameters and Bits",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    for bit in walk::bits(statement) {
        judge(context, bit);
    }
}

fn judge(context: &mut Context<'_>, bit: &BitArgument) {
    let written = context.slice(bit.index.span);
    match class(context, &bit.index) {
        Some(OperandClass::Parameter) => {
            let message = format!("`{written}` is a parameter, and a bit is expected");
            let help = format!("write ({written}) for the bit whose number it holds");
            context.report(RULE.at(bit.index.span, message).with_help(help).unconfirmed());
        }
        // An alias without parentheses is the bit itself.
        Some(OperandClass::Bit) if !matches!(bit.index.kind, ExprKind::Alias) => {
            report_state(context, &bit.index, written);
        }
        None => {
            if let ExprKind::Paren(inner) = &bit.index.kind
                && class(context, inner) == Some(OperandClass::Bit)
            {
                report_state(context, inner, context.slice(inner.span));
            }
        }
        Some(_) => {}
    }
}

fn report_state(context: &mut Context<'_>, bit: &Expr, written: &str) {
    let message = format!("`{written}` is the state of a bit, -1 or 0, and the number of one is expected");
    context.report(RULE.at(bit.span, message).with_help("write it without the parentheses").unconfirmed());
}

fn class(context: &Context<'_>, expr: &Expr) -> Option<OperandClass> {
    match &expr.kind {
        ExprKind::Operand(operand) => Some(operand.class),
        _ => meaning(context, expr).map(|(class, _)| class),
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    #[test]
    fn parameters_without_parentheses() {
        assert_eq!(spans_of("ACR306", "SET P32\nCLR BIT P5\nINH -P516\n"), ["P32", "P5", "P516"]);
        assert_eq!(spans_of("ACR306", "#DEFINE Speed P1\nSET Speed\n"), ["Speed"]);
    }

    #[test]
    fn states_of_bits() {
        assert_eq!(spans_of("ACR306", "#DEFINE Ready BIT5\nINH (BIT 516)\nSET (Ready)\n"), ["BIT 516", "Ready"]);
    }

    #[test]
    fn bits_and_computed_numbers() {
        let text = "#DEFINE Lamp BIT32\n#DEFINE Number 40\nSET 32 CLR Bit33\nINH -Lamp\nSET BIT(32 + P0)\nSET (P5)\nCLR (516)\nSET Number\n";
        assert_eq!(spans_of("ACR306", text), [""; 0]);
    }
}
