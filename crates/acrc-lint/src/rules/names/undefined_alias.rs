//! `ACR210`: a name in an expression that no `#DEFINE` gives.

use acrc_analysis::AliasFact;
use acrc_diagnostics::{Code, Diagnostic, Edit, Fix, Severity};
use acrc_syntax::ast::{Expr, ExprKind, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR210", name: "undefined-alias" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        what: "A name stands where a value is expected, and no #DEFINE of the project defines it.",
        why: "The controller does not know the name and refuses the line; what is left of the program runs without it.",
        bad: "#DEFINE Clamp BIT32\nPROG0\nPROGRAM\nSET clamp\nENDP",
        good: "#DEFINE Clamp BIT32\nPROG0\nPROGRAM\nSET Clamp\nENDP",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::Expression(On::Alias, check)],
};

fn check(context: &mut Context<'_>, expr: &Expr) {
    if !matches!(expr.kind, ExprKind::Alias) || context.environment().excerpt || defines_alias(context) {
        return;
    }
    if let Some(AliasFact::Undefined { near }) = context.alias(expr.span) {
        context.report(finding(context, expr, near.as_deref()));
    }
}

/// That an alias stands for another name is wrong whatever the other one is, and is said by the rule for that.
fn defines_alias(context: &Context<'_>) -> bool {
    let statement = context.tree().statements().get(context.statement() as usize);
    statement.is_some_and(|statement| matches!(statement.kind, StatementKind::Define(_)))
}

fn finding(context: &Context<'_>, expr: &Expr, near: Option<&str>) -> Diagnostic {
    let name = context.slice(expr.span);
    if context.environment().axes_at(context.level()).is_some_and(|axes| axes.has(name)) {
        return RULE
            .at(expr.span, format!("`{name}` is an axis, which has no value of its own"))
            .with_help("read a parameter of the axis, such as its actual position P12290 (axis 0)");
    }
    let diagnostic = RULE.at(expr.span, format!("`{name}` is not defined"));
    match near {
        Some(near) => diagnostic
            .with_help(format!("did you mean `{near}`? Aliases are case-sensitive"))
            .with_fix(Fix::unsafe_(format!("write `{near}`"), vec![Edit::replace(expr.span, near)])),
        None if name.bytes().all(|byte| byte.is_ascii_alphabetic()) => diagnostic
            .with_help(format!("define it: #DEFINE {name} followed by a parameter, bit, variable or constant")),
        None => diagnostic.with_help("an alias has letters only: take another name and define it with #DEFINE"),
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, lint};

    #[test]
    fn aliases_are_global_and_may_be_defined_later() {
        let found = lint(&[("Prog0.8K", "PROGRAM\nSET Clamp\nENDP\n"), ("Setup.8K", "#DEFINE Clamp BIT32\n")]);
        assert_eq!(found.concat(), []);
    }

    #[test]
    fn a_piece_of_code_may_use_names_that_it_does_not_define() {
        assert_eq!(codes("VEL (Speed)\nSET Clamp\n"), []);
        assert_eq!(codes("PROGRAM\nVEL (Speed)\nENDP\n"), [(2, "ACR210")]);
    }

    #[test]
    fn an_axis_is_no_value() {
        let text = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPRINT X\n";
        assert_eq!(codes(text), [(4, "ACR210")]);
        assert_eq!(lint(&[("test.8K", text)])[0][0].message, "`X` is an axis, which has no value of its own");
    }
}
