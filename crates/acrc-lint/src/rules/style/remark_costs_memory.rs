//! `ACR602`: a `REM` line that an apostrophe would make free.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Edit, Fix, Severity, Span};
use acrc_syntax::ast::StatementKind;
use acrc_syntax::units::SectionKind;

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

/// What a command takes in a stored program, in bytes.
const COMMAND_BYTES: usize = 4;
/// What a text takes beside its characters, in bytes.
const TEXT_BYTES: usize = 4;

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR602", name: "remark-costs-memory" },
        group: Group::Style,
        severity: Severity::Advice,
        enabled: false,
        mark: None,
        what: "A line of a stored program holds nothing but a REM. The number of bytes is that of the stored form of acrc; \
               the guide does not print one for remarks.",
        why: "A REM is stored and passed by the controller each time: it takes memory and time. A comment with an \
              apostrophe is dropped by the download. LIST does not show it then, and the program gets there a little \
              sooner.",
        bad: "PROG0\nPROGRAM\nREM Lamp of the door\nSET 32\nENDP",
        good: "PROG0\nPROGRAM\n'Lamp of the door\nSET 32\nENDP",
        guide: "Programming Basics / Remarks",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, index: &SectionIndex) {
    if index.section.kind != SectionKind::Stored {
        return;
    }
    let tree = context.tree();
    let range = &index.section.statements;
    let from = tree.lines().partition_point(|line| line.statements.end <= range.start);
    for line in tree.lines().get(from..).unwrap_or_default() {
        if line.statements.start >= range.end {
            break;
        }
        let statement = tree.statements().get(line.statements.start as usize);
        let (1, None, Some(statement)) = (line.statements.len(), line.number, statement) else { continue };
        let StatementKind::Remark(text) = statement.kind else { continue };
        let bytes = stored_bytes(context.slice(text));
        let diagnostic = RULE.at(statement.span, format!("this remark takes {bytes} bytes of the program"));
        let keyword = Span::new(statement.span.start, text.start);
        let leading = context.slice(text);
        let blank = u32::from(leading.starts_with(' '));
        let edit = Edit::replace(Span::new(keyword.start, keyword.end + blank), "'");
        let fix = Fix::unsafe_("make it a comment that is not stored", vec![edit]);
        context.report(diagnostic.with_help("write an apostrophe in place of REM").with_fix(fix));
    }
}

/// What a remark with this text takes in a stored program. Its text begins directly behind the word; blanks at its end
/// are not stored, and an ellipsis is three points.
fn stored_bytes(text: &str) -> usize {
    let characters = |c: char| if c == '\u{2026}' { 3 } else { 1 };
    COMMAND_BYTES + TEXT_BYTES + text.trim_end().chars().map(characters).sum::<usize>()
}

#[cfg(test)]
mod tests {
    use crate::testing::{fixed, spans_of};

    fn found(body: &str) -> Vec<String> {
        let text = format!("PROG0\nPROGRAM\n{body}\nENDP\n");
        spans_of("ACR602", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn a_remark_alone_on_its_line() {
        assert_eq!(found("REM one\nSET 32 : REM two\n  REM three\n'four"), ["REM one", "REM three"]);
        assert_eq!(spans_of("ACR602", "PROG0\nREM at the prompt\n10 REM numbered\n"), [""; 0]);
    }

    #[test]
    fn command_text_and_characters_are_counted() {
        assert_eq!(super::stored_bytes(" Lamp  "), 4 + 4 + 5);
        assert_eq!(super::stored_bytes(""), 8);
    }

    #[test]
    fn the_word_becomes_an_apostrophe() {
        let text = "PROG0\nPROGRAM\n REM lamp\nREM\nREM--\nENDP\n";
        assert_eq!(fixed("ACR602", text), "PROG0\nPROGRAM\n 'lamp\n'\n'--\nENDP\n");
    }
}
