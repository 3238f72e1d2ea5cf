//! `ACR401`: a program that does not fit the memory that it is given.

use acrc_analysis::memory::{Calls, IssueKind, Site, Space};
use acrc_diagnostics::{Code, Diagnostic, Severity};
use acrc_syntax::units::Level;

use super::sites;
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR401", name: "program-too-large" },
        group: Group::Memory,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A program needs more memory than its DIM PROG or DIM PLC gives it, or than its share of the factory \
               settings. Its stored text, its variables and its move buffer lie in that memory, and 4 bytes for each \
               level of subroutines while it runs. When only a deep call may not fit, it is a warning.",
        why: "What does not fit is not stored: the download ends in the middle of the program, or the program stops with \
              an error at its first DIM.",
        bad: "SYS\nCLEAR\nDIM PROG0(32)\nPROG0\nPROGRAM\nSET 32\nDWL 0.5\nCLR 32\nPRINT \"done\"\nENDP",
        good: "SYS\nCLEAR\nDIM PROG0(64)\nPROG0\nPROGRAM\nSET 32\nDWL 0.5\nCLR 32\nPRINT \"done\"\nENDP",
        guide: "System Configuration / Memory Allocations / How Much Memory?",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for (site, kind) in sites::issues(context) {
        if let IssueKind::TooLarge { level, text, variables, calls, certain, space } = kind {
            let need = Need { level, text, variables, calls, certain, space };
            let diagnostic = finding(context, site, need);
            context.report(diagnostic);
        }
    }
}

#[derive(Clone, Copy)]
struct Need {
    level: Level,
    text: u64,
    variables: u64,
    calls: Calls,
    certain: bool,
    space: Space,
}

impl Need {
    /// With all levels of calls.
    fn total(self) -> u64 {
        self.text + self.variables + self.calls.bytes()
    }

    fn message(self) -> String {
        let (program, word) = (level_name(self.level), self.level);
        let (verb, needed) =
            if self.certain { ("needs", self.text + self.variables) } else { ("may need", self.total()) };
        let needed = sites::counted(needed, "byte");
        match self.space {
            Space::Dim(bytes) => {
                format!("{program} {verb} {needed} but DIM {word}({bytes}) gives {}", sites::number(bytes))
            }
            Space::Factory(bytes) => format!(
                "{program} {verb} {needed} but the factory settings, which nothing changes here, give {}",
                sites::number(bytes)
            ),
            Space::None => format!("{program} {verb} {needed} but no DIM {word} gives it any"),
        }
    }

    /// What the bytes go to.
    fn parts(self) -> String {
        let text = format!("its text takes {}", sites::counted(self.text, "byte"));
        let variables = match self.variables {
            0 => String::new(),
            bytes => format!(", its variables {}", sites::number(bytes)),
        };
        let calls = match self.calls {
            Calls::Depth(0) => String::new(),
            Calls::Depth(depth) => {
                let levels = sites::counted(depth.into(), "level");
                format!(", {levels} of subroutines {} while it runs", sites::number(self.calls.bytes()))
            }
            Calls::Recursive => ", and a subroutine that calls itself 4 for each level".to_owned(),
        };
        format!("{text}{variables}{calls}")
    }
}

fn finding(context: &Context<'_>, site: Site, need: Need) -> Diagnostic {
    let span = sites::span(context, site);
    let diagnostic = RULE.at(span, need.message()).with_note(need.parts());
    let diagnostic = if need.certain { diagnostic } else { Diagnostic { severity: Severity::Warning, ..diagnostic } };
    let dim = sites::dim(context, site).filter(|dim| dim.id.info().levels.sys());
    let (word, total) = (need.level, need.total());
    match dim.and_then(|dim| sites::resize(dim, total)) {
        Some(fix) => diagnostic.with_help(format!("DIM {word}({total}) is just enough for this")).with_fix(fix),
        None => {
            let label = match site {
                Site::Text { .. } => "the first statement that no longer fits",
                _ => "with this it no longer fits",
            };
            diagnostic
                .with_label(label)
                .with_help(format!("DIM {word}({total}) at the SYS prompt is just enough for this"))
        }
    }
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::{Severity, apply};

    use crate::testing::{codes, codes_in, lint};

    /// 8 + 8 bytes of text: two commands with a long constant each.
    const TWO: &str = "PROGRAM\nSET 32\nCLR 32\nENDP\n";

    #[test]
    fn a_text_fits_to_the_byte() {
        let setup = |size: u32| format!("SYS\nCLEAR\nDIM PROG0({size})\nPROG0\n{TWO}");
        assert_eq!(codes(&setup(16)), []);
        assert_eq!(codes(&setup(15)), [(3, "ACR401"), (7, "ACR401")]);
        assert_eq!(codes(&setup(7)), [(3, "ACR401"), (6, "ACR401")]);
    }

    #[test]
    fn both_places_are_in_their_own_files() {
        let (setup, program) = ("SYS\nCLEAR\nDIM PROG0(12)\n", TWO);
        let found = lint(&[("Setup.8K", setup), ("Prog0.8K", program)]);
        assert_eq!(codes_in(setup, &found[0]), [(3, "ACR401")]);
        assert_eq!(codes_in(program, &found[1]), [(3, "ACR401")]);
        assert_eq!(found[0][0].message, "program 0 needs 16 bytes but DIM PROG0(12) gives 12");
        let fixed = apply(setup, &[&found[0][0].fixes[0]]).expect("a fix of one edit");
        assert_eq!(lint(&[("Setup.8K", &fixed), ("Prog0.8K", program)]).concat(), []);
    }

    #[test]
    fn variables_lie_in_the_same_memory() {
        // DIM LV(3): command, constant; 16 for CLEAR and SET 32 with its number.
        let text =
            |size: u32| format!("SYS\nCLEAR\nDIM PROG0({size})\nPROG0\nPROGRAM\nCLEAR\nDIM LV(3)\nSET 32\nENDP\n");
        // CLEAR 4, DIM LV(3) 8, SET 32 8: 20 of text, and 3 variables of 4.
        assert_eq!(codes(&text(32)), []);
        assert_eq!(codes(&text(31)), [(3, "ACR401"), (7, "ACR401")]);
        let found = lint(&[("test.8K", &text(31))]).concat();
        assert_eq!(found[0].note.as_deref(), Some("its text takes 20 bytes, its variables 12"));
    }

    #[test]
    fn calls_that_may_not_fit_are_a_warning() {
        // GOSUB A 8, END 4, _A 4 + 4 + 1, RETURN 4: 25, and 4 for the level.
        let text =
            |size: u32| format!("SYS\nCLEAR\nDIM PROG0({size})\nPROG0\nPROGRAM\nGOSUB A\nEND\n_A\nRETURN\nENDP\n");
        assert_eq!(codes(&text(29)), []);
        let found = lint(&[("test.8K", &text(28))]).concat();
        assert_eq!(found.len(), 1, "{found:#?}");
        assert_eq!(found[0].severity, Severity::Warning);
        assert_eq!(found[0].message, "program 0 may need 29 bytes but DIM PROG0(28) gives 28");
    }

    #[test]
    fn a_program_without_memory() {
        assert_eq!(codes(&format!("SYS\nCLEAR\nDIM PROG0(100)\nPROG9\n{TWO}")), [(6, "ACR401")]);
        assert_eq!(codes(&format!("SYS\nDIM P(5)\nPROG0\n{TWO}")), [], "factory settings");
    }

    #[test]
    fn without_a_setup_nothing_is_known() {
        assert_eq!(codes(&format!("PROG9\n{TWO}")), []);
        assert_eq!(codes(&format!("SYS\nCLEAR\nDIM PROG0(P0)\nDIM P(1)\nPROG0\n{TWO}")), [], "a computed size");
    }
}
