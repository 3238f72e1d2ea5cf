//! `ACR407`: more aliases than there is room for.

use acrc_analysis::memory::IssueKind;
use acrc_diagnostics::{Code, Severity};

use super::sites;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR407", name: "too-many-aliases" },
        group: Group::Memory,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "The project defines more aliases than DIM DEF makes room for, or gives and clears memory without a DIM \
               DEF. Aliases of all files count together; an alias that is defined twice counts once.",
        why: "The controller refuses the #DEFINE, and then every line that uses the name.",
        bad: "SYS\nCLEAR\nDIM DEF(1)\n#DEFINE Clamp BIT32\n#DEFINE Lamp BIT33",
        good: "SYS\nCLEAR\nDIM DEF(2)\n#DEFINE Clamp BIT32\n#DEFINE Lamp BIT33",
        guide: "System Configuration / Memory Allocations",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for (site, kind) in sites::issues(context) {
        let IssueKind::TooManyAliases { aliases, room } = kind else { continue };
        let defined = sites::counted(aliases, "alias").replace("aliass", "aliases");
        let message = match room {
            Some(room) => format!("the project defines {defined} but DIM DEF({room}) holds {}", sites::number(room)),
            None => {
                let them = if aliases == 1 { "it" } else { "them" };
                format!("the project defines {defined} but no DIM DEF makes room for {them}")
            }
        };
        let diagnostic = RULE
            .at(sites::span(context, site), message)
            .with_label("the first one without room")
            .with_help(format!("DIM DEF({aliases}) at the SYS prompt, before the first #DEFINE"));
        context.report(diagnostic);
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, codes_in, lint};

    #[test]
    fn aliases_of_all_files_count_together() {
        let (setup, more) = ("SYS\nDIM DEF(2)\n#DEFINE A BIT1\n#DEFINE B BIT2\n", "#DEFINE B BIT2\n#DEFINE C BIT3\n");
        let found = lint(&[("Setup.8K", setup), ("more.8K", more)]);
        assert_eq!(codes_in(setup, &found[0]), []);
        assert_eq!(codes_in(more, &found[1]), [(2, "ACR407")]);
        let own = found[1].iter().find(|found| found.code.id == "ACR407").expect("it was found");
        assert_eq!(own.message, "the project defines 3 aliases but DIM DEF(2) holds 2");
    }

    #[test]
    fn a_setup_without_room() {
        let found = lint(&[("Setup.8K", "SYS\nCLEAR\n#DEFINE A BIT1\n")]);
        let own = found[0].iter().find(|found| found.code.id == "ACR407").expect("it was found");
        assert_eq!(own.message, "the project defines 1 alias but no DIM DEF makes room for it");
        assert_eq!(codes("PROG0\n#DEFINE A BIT1\n"), [], "the memory is given elsewhere");
        assert_eq!(codes("SYS\nDIM DEF(P0)\nDIM P(1)\n#DEFINE A BIT1\n"), [], "a computed size");
    }
}
