//! `ACR210`: a name in an expression that no `#DEFINE` gives.

use acrc_analysis::AliasFact;
use acrc_diagnostics::{Code, Diagnostic, Edit, Fix, Severity};
use acrc_syntax::ast::{Expr, ExprKind, StatementKind};
use acrc_syntax::units::SectionKind;

use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR210", name: "undefined-alias" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A name stands where a value is expected, and no #DEFINE of the project defines it. At the prompts of \
               a project that defines no name at all it is a warning: the controller may know the name from an earlier \
               download. So is a C or S with a number, which IPA and Aries-class drives know as a drive parameter.",
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
    if near.is_none() && is_drive_parameter(name) {
        let message = format!("`{name}` is a parameter of a drive (IPA, Aries class), which programs do not know");
        let finding = Diagnostic { severity: Severity::Warning, ..RULE.at(expr.span, message) };
        return finding.with_help("send it from a terminal to the product that has the drive");
    }
    let diagnostic = RULE.at(expr.span, format!("`{name}` is not defined"));
    if near.is_none() && may_be_on_controller(context) && is_name(name) {
        let diagnostic = Diagnostic { severity: Severity::Warning, ..diagnostic };
        return diagnostic.with_help("is it on the controller from before? If not, define it with #DEFINE");
    }
    match near {
        Some(near) => diagnostic
            .with_help(format!("did you mean `{near}`? Aliases are case-sensitive"))
            .with_fix(Fix::unsafe_(format!("write `{near}`"), vec![Edit::replace(expr.span, near)])),
        None if is_name(name) => diagnostic
            .with_help(format!("define it: #DEFINE {name} followed by a parameter, bit, variable or constant")),
        None => diagnostic.with_help("an alias has letters only: take another name and define it with #DEFINE"),
    }
}

/// Whether an alias may have this name: it has letters only.
fn is_name(name: &str) -> bool {
    name.bytes().all(|byte| byte.is_ascii_alphabetic())
}

/// `C20`, `S3`: configuration and status parameters of the drive in an IPA or one of the Aries class.
fn is_drive_parameter(name: &str) -> bool {
    let number = name.strip_prefix(['C', 'c', 'S', 's']).unwrap_or_default();
    !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
}

/// Whether a name is used at a prompt, and nothing in the project defines names: a session with a controller that has
/// been set up.
fn may_be_on_controller(context: &Context<'_>) -> bool {
    let is_immediate = context.section().is_some_and(|section| section.section.kind == SectionKind::Immediate);
    is_immediate && context.environment().nameless
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{codes, found_by, lint};

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
    #[test]
    fn drive_parameters_are_called_so() {
        for (text, severity) in [("PROG0\nC14 = 0.1\n", Severity::Warning), ("PROG0\n?S20\n", Severity::Warning)] {
            let found = found_by("ACR210", text);
            assert_eq!(found[0].severity, severity, "{text}");
            assert!(found[0].message.contains("is a parameter of a drive"), "{text}: {}", found[0].message);
        }
        let found = found_by("ACR210", "PROG0\nP0 = T14\n");
        assert_eq!((found[0].severity, found[0].message.as_str()), (Severity::Error, "`T14` is not defined"));
        assert_eq!(
            found[0].help.as_deref(),
            Some("an alias has letters only: take another name and define it with #DEFINE")
        );
    }

    #[test]
    fn a_session_may_use_names_of_the_controller() {
        let severity = |text: &str| found_by("ACR210", text)[0].severity;
        assert_eq!(severity("PROG0\nstarted = 1\n"), Severity::Warning);
        assert_eq!(severity("PROG0\nPROGRAM\nstarted = 1\nENDP\n"), Severity::Error, "a program");
        assert_eq!(severity("#DEFINE Clamp BIT32\nPROG0\nstarted = 1\n"), Severity::Error, "it defines names");
    }
}
