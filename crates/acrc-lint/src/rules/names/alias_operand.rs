//! `ACR030`: an alias for something that can have none. The compiler reports it under the same code.

use acrc_analysis::{compile_codes, walk};
use acrc_diagnostics::Severity;
use acrc_syntax::ast::{Expr, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: compile_codes::ALIAS_OPERAND,
        group: Group::Compile,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "An alias is defined for an expression or for another alias.",
        why: "An alias stands for a parameter, a bit, a variable or a constant.",
        bad: "#DEFINE Speed (P1 * 2)",
        good: "#DEFINE Speed P1",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Define(define) = &statement.kind else { return };
    let name = context.slice(define.name);
    let mut inner = None;
    walk::each(&define.operand, &mut |expr| {
        if matches!(expr.kind, ExprKind::Alias) {
            inner.get_or_insert(expr.span);
        }
    });
    let diagnostic = match inner {
        Some(inner) => {
            let written = context.slice(inner);
            RULE.at(inner, format!("the alias `{name}` stands for another name, `{written}`"))
                .with_help(format!("write what `{written}` stands for"))
        }
        None if has_place(&define.operand) => return,
        None => RULE
            .at(define.operand.span, format!("the alias `{name}` stands for an expression"))
            .with_help("an alias stands for a constant, a parameter, a flag or a variable"),
    };
    context.report(diagnostic);
}

/// Whether an alias can stand for it: a constant, or something that is stored at one place.
fn has_place(operand: &Expr) -> bool {
    match &operand.kind {
        ExprKind::String(_) | ExprKind::Operand(_) => true,
        ExprKind::Paren(inner) => has_place(inner),
        _ => walk::literal(operand).is_some(),
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn an_alias_of_an_alias_is_refused_once() {
        assert_eq!(codes("#DEFINE A B\n#DEFINE B A\n"), [(1, "ACR030"), (2, "ACR030")]);
        assert_eq!(codes("#DEFINE A Nothing\n"), [(1, "ACR030")]);
        assert_eq!(codes("#DEFINE A P(Index)\n"), [(1, "ACR030")]);
    }

    #[test]
    fn constants_and_places_have_aliases() {
        let operands = ["P1", "BIT32", "-5", "2.5", "\"text\"", "$V0", "LA0(3)", "P(12288+256)", "(P1)"];
        for operand in operands {
            assert_eq!(codes(&format!("#DEFINE A {operand}\n")), [], "{operand}");
        }
    }
}
