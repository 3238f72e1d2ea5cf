//! `ACR133`: a jump into a block from outside.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::blocks::{Block, BlockKind};

use crate::Context;
use crate::flow::NESTING;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR133", name: "goto-into-block" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A GOTO or GOSUB goes to a label inside of a block IF, FOR or WHILE that it does not stand in itself.",
        why: "The block was never opened: its NEXT counts up to no end that was set, its WEND goes back to a condition \
              that was not tested, its ENDIF closes another IF or none.",
        bad: "PROG0\nPROGRAM\nIF (BIT 24) THEN GOTO Again\nFOR P0 = 1 TO 3\n_Again\nSET 32\nDWL 1\nCLR 32\nNEXT\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 24) THEN DWL 1\nFOR P0 = 1 TO 3\nSET 32\nDWL 1\nCLR 32\nNEXT\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    for jump in &section.jumps {
        let Some(target) = jump.to else { continue };
        let Some(block) = entered_block(section, jump.statement, target) else { continue };
        let word = block.kind.opener();
        let what = if jump.call { "GOSUB" } else { "GOTO" };
        let name = context.slice(jump.target.span());
        let message = format!("{what} {name} goes into the middle of a {word}");
        let diagnostic = RULE.at(context.statement_span(jump.statement), message);
        let diagnostic = diagnostic
            .with_related(context.statement_span(block.opener), format!("this {word} is not passed"))
            .with_related(context.statement_span(target), "to here");
        let help = match block.kind {
            BlockKind::If => "put the label before the IF, or make what both need a subroutine",
            BlockKind::For | BlockKind::While => "put the label before the loop, or make what both need a subroutine",
        };
        context.report(diagnostic.with_help(help));
    }
}

/// The outermost block that a jump from one statement to another enters.
fn entered_block(section: &SectionIndex, from: u32, to: u32) -> Option<&Block> {
    let blocks = &section.blocks;
    let around = std::iter::successors(blocks.enclosing(to), |block| blocks.parent(block));
    let enters = |block: &&Block| block.closer.is_some_and(|closer| !(block.opener..=closer).contains(&from));
    around.take(NESTING).take_while(enters).last()
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR133", text)
    }

    #[test]
    fn the_jump_is_marked() {
        assert_eq!(found("GOTO A\nWHILE (BIT 1)\n_A\nWEND\n"), ["GOTO A"]);
        assert_eq!(found("IF (BIT 1)\n_A\nENDIF\nIF (BIT 2) THEN GOTO A\n"), ["GOTO A"]);
        assert_eq!(found("IF (BIT 1)\nFOR LV0 = 1 TO 3\n_A\nNEXT\nGOSUB A\nENDIF\n"), ["GOSUB A"]);
    }

    #[test]
    fn within_a_block_and_out_of_it_is_another_matter() {
        assert_eq!(found("WHILE (BIT 1)\n_A\nIF (BIT 2) THEN GOTO A\nWEND\n"), [""; 0]);
        assert_eq!(found("_A\nWHILE (BIT 1)\nIF (BIT 2)\nGOTO A\nENDIF\nWEND\n"), [""; 0]);
        assert_eq!(found("IF (BIT 1)\nGOTO A\nELSE\n_A\nENDIF\n"), [""; 0], "the block is open");
    }
}
