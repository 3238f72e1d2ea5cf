//! `ACR217`: an alias of a local variable that several programs use.

use acrc_analysis::AliasFact;
use acrc_analysis::index::AliasTarget;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::units::Level;

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR217", name: "alias-of-local" },
        group: Group::Names,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "More than one program uses an alias that stands for a local variable (LV, SV, DV, $V or an array).",
        why: "The alias is global, the variable is not: each program reads and writes its own one. A count that one \
              program keeps is not seen by the other.",
        bad: "#DEFINE Count LV0\nPROG0\nPROGRAM\nDIM LV(1)\nCount = Count + 1\nENDP\nPROG1\nPROGRAM\nDIM LV(1)\nPRINT Count\nENDP",
        good: "#DEFINE Count P0\nPROG0\nPROGRAM\nCount = Count + 1\nENDP\nPROG1\nPROGRAM\nPRINT Count\nENDP",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for site in &context.index().defines {
        let name = context.slice(site.name);
        let Some(own) = context.environment().own_alias(name) else { continue };
        let Some(AliasFact::Defined { operand, .. }) = context.environment().alias(name) else { continue };
        let AliasTarget::Operand(class, _) = operand.target else { continue };
        if !class.is_local() {
            continue;
        }
        let programs: Vec<String> =
            own.used_at.iter().filter(|level| **level != Level::System).map(|level| level_name(*level)).collect();
        if let [first @ .., last] = programs.as_slice()
            && !first.is_empty()
        {
            let (operand, first) = (&operand.text, first.join(", "));
            let message = format!("the alias `{name}` stands for {operand}, of which {first} and {last} have one each");
            let help = "take a user parameter (P0 to P4095) for what they share, or an alias for each program";
            context.report(RULE.at(site.name, message).with_help(help));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{found_by, lines_of, spans_of};

    #[test]
    fn two_programs_that_use_it() {
        let text = "#DEFINE Count LV0\n#DEFINE Name $V1\nPROG0\nCount = 1 : $V1 = \"a\"\nPROG2\nPRINT Count, Name\nPLC1\nPRINT Count\n";
        assert_eq!(spans_of("ACR217", text), ["Count"]);
        let message = "the alias `Count` stands for LV0, of which program 0, program 2 and PLC program 1 have one each";
        assert_eq!(found_by("ACR217", text)[0].message, message);
    }

    #[test]
    fn one_program_or_something_global() {
        let files = [
            ("Setup.8K", "#DEFINE Count LV0\n#DEFINE Total P0\n"),
            ("Prog0.8K", "PRINT Count, Total\n"),
            ("Prog1.8K", "PRINT Total\n"),
        ];
        assert_eq!(lines_of("ACR217", &files), [vec![], vec![], vec![]] as [Vec<u32>; 3]);
    }
}
