//! `ACR029`: the text of a program where no program is chosen.

use acrc_analysis::{SectionIndex, compile_codes};
use acrc_diagnostics::{Severity, Span};
use acrc_syntax::units::{Level, SectionKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: compile_codes::NO_PROGRAM,
        group: Group::Compile,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "The text of a program stands where no program is chosen.",
        why: "Programs are stored at the prompt of a program; at the SYS prompt there is nothing to store them in.",
        bad: "PROGRAM\nSET 32\nENDP",
        good: "PROG0\nPROGRAM\nSET 32\nENDP",
        guide: "Programming Basics / Programs and Commands",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let SectionIndex { section, .. } = section;
    // A lone piece of code may belong to any program.
    if section.kind != SectionKind::Stored || section.level != Level::System || context.environment().fragment {
        return;
    }
    let first = section.opener.unwrap_or(section.statements.start);
    let span: Span = context.statement_span(first);
    let diagnostic = RULE.at(span, "the text of a program stands where no program is chosen");
    context.report(diagnostic.with_label("entered at the SYS prompt").with_help(
        "write `PROG0` before it, or name the file after its program: `Prog0.8K` to `Prog15.8K`, `PLC0.8K` to `PLC7.8K`",
    ));
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, lines_of, spans_of};

    const SETUP: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n";

    #[test]
    fn a_text_needs_a_program() {
        let files = [("Setup.8K", SETUP), ("Prog16.8K", "PROGRAM\nSET 32\nENDP\n"), ("Prog0.8K", "SET 32\n")];
        assert_eq!(lines_of("ACR029", &files), [vec![], vec![1], vec![]]);
        assert_eq!(spans_of("ACR029", &format!("{SETUP}SYS\n10 SET 32\n20 SET 33\nCLR 32\n")), ["SET 32"]);
    }

    #[test]
    fn a_lone_piece_of_code_may_belong_to_any() {
        assert_eq!(codes("PROGRAM\nSET 32\nENDP\n"), []);
    }
}
