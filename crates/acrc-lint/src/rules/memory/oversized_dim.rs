//! `ACR411`: much more memory than is needed.

use acrc_analysis::memory::SystemBlock;
use acrc_diagnostics::{Code, Severity};

use super::sites;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR411", name: "oversized-dim" },
        group: Group::Memory,
        severity: Severity::Advice,
        enabled: false,
        mark: None,
        what: "A DIM gives a program or the alias table more than four times of what it surely needs, and more than a \
               kilobyte of it is left. How much a program really takes is shown by `acrc mem`.",
        why: "Memory is shared: what one program has and does not use, another one may lack. Room to grow is no mistake, so \
              the rule is off unless it is selected.",
        bad: "SYS\nCLEAR\nDIM PROG0(65536)\nPROG0\nPROGRAM\nSET 32\nENDP",
        good: "SYS\nCLEAR\nDIM PROG0(1000)\nPROG0\nPROGRAM\nSET 32\nENDP",
        guide: "System Configuration / Memory Allocations / How Much Memory?",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    if context.environment().fragment {
        return;
    }
    for spare in &context.memory().spare {
        let (given, needed) = (sites::number(spare.given), sites::number(spare.needed));
        let message = match spare.block {
            SystemBlock::Aliases => {
                format!("DIM DEF({}) has room for {given} aliases, {needed} are defined", spare.given)
            }
            block => format!("{block} has {given} bytes and needs {needed} at most"),
        };
        let help = match spare.block {
            SystemBlock::Aliases => format!("DIM DEF({})", spare.needed),
            _ => "acrc mem shows the exact DIM".to_owned(),
        };
        context.report(RULE.at(sites::span(context, spare.site), message).with_help(help));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    #[test]
    fn much_more_than_is_needed() {
        let setup = |size: u32| format!("SYS\nCLEAR\nDIM PROG0({size})\nPROG0\nPROGRAM\nSET 32\nCLR 32\nENDP\n");
        assert_eq!(spans_of("ACR411", &setup(65_536)), ["DIM PROG0(65536)"]);
        assert_eq!(spans_of("ACR411", &setup(1000)), [""; 0], "a kilobyte is not much");
    }

    #[test]
    fn aliases() {
        let text = "SYS\nDIM DEF(100)\n#DEFINE A BIT1\n";
        assert_eq!(spans_of("ACR411", text), ["DIM DEF(100)"]);
        assert_eq!(spans_of("ACR411", "SYS\nDIM DEF(10)\n#DEFINE A BIT1\n"), [""; 0]);
    }

    #[test]
    fn a_program_that_is_not_there_may_come_later() {
        assert_eq!(spans_of("ACR411", "SYS\nCLEAR\nDIM PROG0(65536)\n"), [""; 0]);
    }
}
