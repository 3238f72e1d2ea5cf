//! `ACR116`: a `GOTO` that leaves a block `IF` or a `WHILE`.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::blocks::{Block, BlockKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR116", name: "goto-out-of-block" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        what: "A GOTO inside a block IF or a WHILE goes to a label outside of it.",
        why: "The controller keeps four bytes for every open block, and nothing closes this one: each pass leaves \
              another block open. Leave a WHILE with BREAK, and put the jump behind the block.",
        bad: "PROG0\nPROGRAM\n_Again\nWHILE (NOT BIT 24)\nIF (BIT 25) THEN GOTO Again\nWEND\nENDP",
        good: "PROG0\nPROGRAM\n_Again\nWHILE (NOT BIT 24)\nIF (BIT 25) THEN BREAK\nWEND\nIF (BIT 25) THEN GOTO Again\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    for jump in section.jumps.iter().filter(|jump| !jump.call) {
        let Some(target) = jump.to else { continue };
        if let Some(block) = left_block(section, jump.statement, target) {
            let word = block.kind.opener();
            let name = context.slice(jump.target.span());
            let span = context.statement_span(jump.statement);
            let diagnostic = RULE.at(span, format!("GOTO {name} leaves the {word} that it stands in"));
            let opener = context.statement_span(block.opener);
            let help = match block.kind {
                BlockKind::While => "leave the loop with BREAK and jump behind WEND, or make it a GOSUB",
                _ => "make it a GOSUB, or jump behind ENDIF",
            };
            context.report(diagnostic.with_related(opener, format!("this {word} stays open")).with_help(help));
        }
    }
}

/// The innermost block that a jump from one statement to another leaves. Whether leaving a FOR matters is not
/// documented.
fn left_block(section: &SectionIndex, from: u32, to: u32) -> Option<&Block> {
    let mut around = section.blocks.enclosing(from);
    while let Some(block) = around {
        let closer = block.closer?;
        if block.kind != BlockKind::For && !(block.opener..=closer).contains(&to) {
            return Some(block);
        }
        around = section.blocks.parent(block);
    }
    None
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn a_jump_within_a_block_or_out_of_a_for_is_left_alone() {
        assert_eq!(codes("WHILE (BIT 1)\n_A\nIF (BIT 2) THEN GOTO A\nWEND\n"), []);
        assert_eq!(codes("_A\nFOR LV0 = 0 TO 3\nIF (BIT 2) THEN GOTO A\nNEXT\n"), []);
    }

    #[test]
    fn gosub_comes_back() {
        assert_eq!(codes("IF (BIT 1)\nGOSUB A\nENDIF\nEND\n_A\nRETURN\n"), []);
    }

    #[test]
    fn a_for_around_does_not_hide_the_block() {
        assert_eq!(codes("_A\nIF (BIT 1)\nFOR LV0 = 0 TO 3\nGOTO A\nNEXT\nENDIF\n"), [(4, "ACR116")]);
    }
}
