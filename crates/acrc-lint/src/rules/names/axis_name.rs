//! `ACR205`: an axis name that breaks the rules for names.

use acrc_catalog::{AxisNameError, check_axis_name, command};
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::{Argument, Expr, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR205", name: "axis-name" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "ATTACH SLAVE gives a name that is not one to four letters, or is P or F.",
        why: "P is a parameter and F a feedrate: `F 100` would never reach an axis of that name. Other names that are \
              words of the language read as those words, so that moves of the axis do something else.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"F\"",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"FEED\"",
        guide: "System Configuration / Attachments",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(attach) = &statement.kind else { return };
    if attach.id != command::ATTACH_SLAVE {
        return;
    }
    for argument in &attach.arguments {
        if let Argument::Value(Expr { span, kind: ExprKind::String(inner) }) = argument
            && let Some(diagnostic) = judge(*span, context.slice(*inner))
        {
            context.report(diagnostic);
        }
    }
}

fn judge(span: Span, name: &str) -> Option<Diagnostic> {
    let problem = check_axis_name(name).err()?;
    let message = match problem {
        AxisNameError::Empty => "an axis needs a name".to_owned(),
        AxisNameError::Parameter | AxisNameError::Feedrate => {
            let meaning = if problem == AxisNameError::Parameter { "a parameter" } else { "the feedrate" };
            format!("`{name}` can't be an axis name: it is {meaning}")
        }
        _ => format!("the axis name `{name}` {problem}"),
    };
    let finding = RULE.at(span, message);
    Some(match problem {
        AxisNameError::Word => {
            finding.with_help("moves of this axis would read as that word: take another name").unconfirmed()
        }
        _ => finding.with_help("take one to four letters, not P or F"),
    })
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{codes, lint};

    fn attach(name: &str) -> Vec<(u32, &'static str)> {
        codes(&format!("PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"{name}\"\n"))
    }

    #[test]
    fn one_to_four_letters() {
        for good in ["X", "x", "ROT", "FEED"] {
            assert_eq!(attach(good), [], "{good}");
        }
        for bad in ["", "TABLE", "X1", "A B", "P", "f", "\u{c4}"] {
            assert_eq!(attach(bad), [(3, "ACR205")], "{bad}");
        }
    }

    #[test]
    fn words_of_the_language_are_only_warned_of() {
        let found = lint(&[("test.8K", "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"VEL\"\n")]).concat();
        assert!(found.iter().all(|diagnostic| diagnostic.unconfirmed && diagnostic.severity == Severity::Warning));
        assert_eq!(found.len(), 1);
    }
}
