//! `ACR402`: `DIM` of something that has memory already.

use acrc_analysis::memory::{Block, IssueKind, Space};
use acrc_diagnostics::{Code, Severity};

use super::sites;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR402", name: "redimensioned-block" },
        group: Group::Memory,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A DIM gives memory to something that already has some, with no CLEAR in between. With factory settings \
               programs 0 to 7 have 65,536 bytes each, so a setup begins with CLEAR.",
        why: "The controller answers \"Re-dimensioned block\" and keeps the old size: a larger program is cut off, a \
              larger array has fewer elements than its loops run over.",
        bad: "SYS\nDIM PROG0(8192)",
        good: "SYS\nCLEAR\nDIM PROG0(8192)",
        guide: "System Configuration / Memory Allocations",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for (site, kind) in sites::issues(context) {
        let IssueKind::Redimensioned { block, space } = kind else { continue };
        let has = match space {
            Some(Space::Factory(bytes)) => {
                format!("already has {} with factory settings", sites::counted(bytes, "byte"))
            }
            Some(space) => format!("already has {}", sites::counted(space.bytes(), "byte")),
            None => "already has memory".to_owned(),
        };
        let help = match block {
            Block::System(_) => "CLEAR at the SYS prompt comes first; NEW ALL before it erases the programs",
            Block::Local(..) => "CLEAR before it frees the variables of the program",
        };
        let message = format!("Re-dimensioned block: {block} {has}");
        context.report(RULE.at(sites::span(context, site), message).with_help(help));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, codes_in, lint, spans_of};

    #[test]
    fn factory_settings_give_memory_to_the_first_eight_programs() {
        assert_eq!(codes("SYS\nDIM PROG7(100)\nDIM PROG8(100)\nDIM PLC0(100)\n"), [(2, "ACR402")]);
        assert_eq!(codes("SYS\nCLEAR\nDIM PROG7(100)\n"), []);
        let found = lint(&[("test.8K", "SYS\nDIM PROG7(100)\n")]).concat();
        assert_eq!(found[0].message, "Re-dimensioned block: PROG7 already has 65,536 bytes with factory settings");
    }

    #[test]
    fn a_block_is_given_memory_twice() {
        assert_eq!(codes("SYS\nDIM P(10)\nDIM P(20)\n"), [(3, "ACR402")]);
        assert_eq!(codes("SYS\nDIM P(10)\nCLEAR\nDIM P(20)\n"), []);
        let setup = "SYS\nCLEAR\nDIM PROG0(100)\n";
        let more = "SYS\nDIM PROG0(200)\n";
        let found = lint(&[("Setup.8K", setup), ("more.8K", more)]);
        assert_eq!(codes_in(more, &found[1]), [(2, "ACR402")]);
    }

    #[test]
    fn variables_of_a_program() {
        assert_eq!(codes("PROG0\nDIM LV(2)\nDIM LV(3)\nDIM DV(3)\n"), [(3, "ACR402")]);
        assert_eq!(codes("PROG0\nDIM LV(2)\nPROG1\nDIM LV(3)\nPROG0\nCLEAR\nDIM LV(3)\n"), []);
        assert_eq!(codes("PROG0\nDIM LV(2)\nPROGRAM\nDIM LV(3)\nENDP\n"), [(4, "ACR402")]);
        assert_eq!(codes("PROG0\nDIM LV(2)\nPROGRAM\nCLEAR\nDIM LV(3)\nENDP\n"), []);
        assert_eq!(codes("PROG0\nPROGRAM\nDIM LV(3)\nDIM LV(4)\nENDP\n"), [(4, "ACR402")]);
    }

    #[test]
    fn what_may_not_happen_proves_nothing() {
        assert_eq!(codes("PROG0\nPROGRAM\nIF (BIT 1)\nDIM LV(3)\nELSE\nDIM LV(4)\nENDIF\nENDP\n"), []);
        assert_eq!(spans_of("ACR402", "PROG0\nPROGRAM\nDIM LV(3)\nGOTO Other\nDIM LV(4)\n_Other\nENDP\n"), [""; 0]);
        assert_eq!(codes("SYS\nIF (BIT 1) THEN CLEAR\nDIM PROG0(100)\n"), []);
    }

    #[test]
    fn a_piece_of_code_is_not_judged() {
        assert_eq!(codes("DIM PROG0(8192)\nDIM PROG0(100)\n"), []);
    }
}
