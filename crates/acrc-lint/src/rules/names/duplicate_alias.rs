//! `ACR211`: an alias that is defined twice.

use acrc_analysis::{AliasFact, DefinedIn, index};
use acrc_diagnostics::{Code, Diagnostic, Severity};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR211", name: "duplicate-alias" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "The project defines an alias a second time. With another operand that is an error; with the same one it \
               is only superfluous.",
        why: "Aliases are global: every program sees the same one. Which operand counts depends on the order in which \
              the files are sent, so that a program may switch another output than it says.",
        bad: "#DEFINE Clamp BIT32\n#DEFINE Clamp BIT33",
        good: "#DEFINE Clamp BIT32\n#DEFINE Gripper BIT33",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for (place, site) in (0..).zip(&context.index().defines) {
        let name = context.slice(site.name);
        let Some(AliasFact::Defined { operand, first, .. }) = context.alias(site.name) else { continue };
        if *first == DefinedIn::This(place) {
            continue;
        }
        let here = index::operand_text(context.slice(site.operand));
        let diagnostic = if here == operand.text {
            let message = format!("the alias `{name}` is already defined in the same way");
            Diagnostic { severity: Severity::Advice, ..RULE.at(site.name, message) }
        } else {
            let known = &operand.text;
            RULE.at(site.name, format!("the alias `{name}` already stands for {known}"))
                .with_label(format!("and here for {here}"))
        };
        context.report(match first {
            DefinedIn::Other(file) => diagnostic.with_help(format!("the first definition is in {file}")),
            DefinedIn::This(first) => match context.index().defines.get(*first as usize) {
                Some(first) => diagnostic.with_related(first.name, "first defined here"),
                None => diagnostic,
            },
        });
    }
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{codes, lint};

    #[test]
    fn the_same_operand_again_is_only_superfluous() {
        let found = lint(&[("a.8K", "#DEFINE Clamp BIT32\n"), ("b.8K", "#DEFINE Clamp bit 32\n")]);
        assert_eq!(found[0], []);
        assert_eq!(
            found[1].iter().map(|d| (d.code.id, d.severity)).collect::<Vec<_>>(),
            [("ACR211", Severity::Advice)]
        );
    }

    #[test]
    fn aliases_of_different_case_are_different() {
        assert_eq!(codes("#DEFINE Clamp BIT32\n#DEFINE CLAMP BIT33\n"), []);
    }
}
