//! `ACR212`: an alias whose name breaks the rules for names.

use acrc_catalog::{AliasNameError, check_alias_name};
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::{Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR212", name: "alias-name" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A #DEFINE names an alias with more than 24 letters, with something other than letters, or with a word of \
               the language.",
        why: "The controller refuses the definition, and with it every line that uses the alias. A name that is a \
              command reads as the command. The lines that use such a name are not reported again.",
        bad: "#DEFINE Clamp1 BIT32",
        good: "#DEFINE ClampA BIT32",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Define(define) = &statement.kind else { return };
    if let Some(diagnostic) = judge(context, define.name) {
        context.report(diagnostic);
    }
}

fn judge(context: &Context<'_>, span: Span) -> Option<Diagnostic> {
    let name = context.slice(span);
    let problem = check_alias_name(name, context.model()).err()?;
    let finding = RULE.at(span, format!("the alias `{name}` {problem}"));
    Some(match problem {
        AliasNameError::Word => finding.with_help("it reads as that word: take another name"),
        AliasNameError::Character(_) | AliasNameError::Letters(_) => finding,
    })
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, codes_in, lint_as};

    #[test]
    fn up_to_twenty_four_letters() {
        let name = |count: usize| "A".repeat(count);
        assert_eq!(codes(&format!("#DEFINE {} P1\n", name(24))), []);
        assert_eq!(codes(&format!("#DEFINE {} P1\n", name(25))), [(1, "ACR212")]);
    }

    #[test]
    fn words_of_the_language_are_taken() {
        for word in ["Vel", "Enc", "Slave", "Then", "Clock", "Not", "Mod", "Sin"] {
            assert_eq!(codes(&format!("#DEFINE {word} P1\n")), [(1, "ACR212")], "{word}");
        }
        assert_eq!(codes("#DEFINE Home BIT40\nSET Home\n"), []);
    }

    #[test]
    fn letters_only() {
        assert_eq!(codes("#DEFINE Clamp_A P1\n#DEFINE ClampA P1\n#DEFINE Clamp1 P2\n"), [(1, "ACR212"), (3, "ACR212")]);
        let later = "#DEFINE Clamp1 P2\n";
        assert_eq!(codes_in(later, &lint_as("ACR7000", later)), []);
    }
}
