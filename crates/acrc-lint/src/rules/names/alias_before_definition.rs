//! `ACR218`: an alias that is used before it is defined.

use acrc_analysis::{AliasFact, DefinedIn};
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Expr, ExprKind, StatementKind};
use acrc_syntax::units::SectionKind;

use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR218", name: "alias-before-definition" },
        group: Group::Names,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A statement that is executed while the files are sent uses an alias whose #DEFINE is sent later. The text \
               of stored programs is left alone.",
        why: "A new controller does not know the alias yet and refuses the statement. On the bench nobody notices, since \
              the controller there keeps the alias of the last download.",
        bad: "SYS\nSET Clamp\n#DEFINE Clamp BIT32",
        good: "SYS\n#DEFINE Clamp BIT32\nSET Clamp",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::Expression(On::Alias, check)],
};

fn check(context: &mut Context<'_>, expr: &Expr) {
    let is_immediate = context.section().is_some_and(|section| section.section.kind == SectionKind::Immediate);
    if !matches!(expr.kind, ExprKind::Alias) || !is_immediate || defines(context) {
        return;
    }
    let Some(AliasFact::Defined { first, later, .. }) = context.alias(expr.span) else { return };
    let name = context.slice(expr.span);
    let finding = RULE.at(expr.span, format!("the alias `{name}` is not defined yet when this is sent"));
    match first {
        DefinedIn::This(place) => {
            let define = context.index().defines.get(*place as usize).map(|site| site.name);
            if let Some(define) = define.filter(|define| define.start > expr.span.start) {
                context.report(finding.with_related(define, "defined here"));
            }
        }
        DefinedIn::Other(file) if *later => {
            context.report(finding.with_help(format!("{file}, which defines it, is sent after this file")));
        }
        DefinedIn::Other(_) => {}
    }
}

fn defines(context: &Context<'_>) -> bool {
    let statement = context.tree().statements().get(context.statement() as usize);
    statement.is_some_and(|statement| matches!(statement.kind, StatementKind::Define(_)))
}

#[cfg(test)]
mod tests {
    use crate::testing::{lines_of, spans_of};

    #[test]
    fn statements_that_are_executed_as_they_arrive() {
        let text = "SYS\nSET Clamp\nP0 = Speed\n#DEFINE Clamp BIT32\nSET Clamp\n#DEFINE Speed P1\n";
        assert_eq!(spans_of("ACR218", text), ["Clamp", "Speed"]);
    }

    #[test]
    fn files_are_sent_in_their_order() {
        let files =
            [("Setup.8K", "SET Clamp\nSET Lamp\n"), ("more.8K", "#DEFINE Clamp BIT32\n"), ("last.8K", "SET Clamp\n")];
        assert_eq!(lines_of("ACR218", &files), [vec![1], vec![], vec![]]);
    }

    #[test]
    fn stored_text_is_left_alone() {
        assert_eq!(spans_of("ACR218", "PROG0\nPROGRAM\nSET Clamp\nENDP\n#DEFINE Clamp BIT32\n"), [""; 0]);
    }
}
