//! `ACR216`: two aliases for the same parameter, bit or variable.

use acrc_diagnostics::{Code, Severity};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR216", name: "alias-synonym" },
        group: Group::Names,
        severity: Severity::Advice,
        enabled: false,
        mark: None,
        what: "Two aliases stand for the same parameter, bit or variable.",
        why: "Two parts of the machine seem to use two things and use one. Where that is meant, one name says it better; \
              where it is not, an address was copied and not changed.",
        bad: "#DEFINE Clamp BIT32\n#DEFINE Gripper BIT32",
        good: "#DEFINE Clamp BIT32\n#DEFINE Gripper BIT33",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for site in &context.index().defines {
        let name = context.slice(site.name);
        let synonym = context.environment().own_alias(name).and_then(|own| own.synonym.as_deref());
        if let Some(synonym) = synonym {
            let operand = context.slice(site.operand);
            context.report(RULE.at(site.name, format!("`{name}` is another alias for {operand}, beside `{synonym}`")));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    #[test]
    fn the_same_operand_in_any_spelling() {
        let text = "#DEFINE Clamp BIT32\n#DEFINE Gripper bit 32\n#DEFINE Speed P(12288+1)\n#DEFINE Target P12289\n";
        assert_eq!(spans_of("ACR216", text), ["Gripper", "Target"]);
    }

    #[test]
    fn constants_may_have_many_names() {
        let text = "#DEFINE On 1\n#DEFINE Once 1\n#DEFINE Lamp BIT32\n#DEFINE Lamp BIT32\n#DEFINE First LA0(1)\n#DEFINE Second LA0(2)\n";
        assert_eq!(spans_of("ACR216", text), [""; 0]);
    }
}
