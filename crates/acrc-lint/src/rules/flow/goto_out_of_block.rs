//! `ACR116`: a `GOTO` that leaves a `WHILE` or a block `IF`.

use std::collections::BTreeMap;

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Diagnostic, Severity};
use acrc_syntax::blocks::{Block, BlockKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR116", name: "goto-out-of-block" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A GOTO inside a WHILE or a block IF goes to a label outside of it. For a WHILE it is a warning at each \
               GOTO. For an IF it is advice, once for a label of a program: machines run with such jumps.",
        why: "The guide asks for no GOTO in either block: it leaves the block, and nothing leads back inside. What the \
              controller keeps of a loop that is left is not documented; BREAK is the documented way out of a WHILE.",
        bad: "PROG0\nPROGRAM\n_Again\nWHILE (NOT BIT 24)\nIF (BIT 25) THEN GOTO Again\nWEND\nENDP",
        good: "PROG0\nPROGRAM\n_Again\nWHILE (NOT BIT 24)\nIF (BIT 25) THEN BREAK\nWEND\nIF (BIT 25) THEN GOTO Again\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

/// The GOTOs to one label that leave an IF.
struct Exits {
    /// The first one: its statement, and that which opens its block.
    first: (u32, u32),
    count: u32,
}

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let mut exits: BTreeMap<u32, Exits> = BTreeMap::new();
    for jump in section.jumps.iter().filter(|jump| !jump.call) {
        let Some(target) = jump.to else { continue };
        let Some(block) = left_block(section, jump.statement, target) else { continue };
        if block.kind == BlockKind::While {
            let finding = finding(context, jump.statement, block.opener, "WHILE", "");
            context.report(finding.with_help("leave the loop with BREAK and jump behind WEND, or make it a GOSUB"));
            continue;
        }
        let new = || Exits { first: (jump.statement, block.opener), count: 0 };
        exits.entry(target).or_insert_with(new).count += 1;
    }
    let mut exits: Vec<Exits> = exits.into_values().collect();
    exits.sort_unstable_by_key(|exits| exits.first);
    for Exits { first: (statement, opener), count } in exits {
        let others = match count {
            1 => String::new(),
            _ => format!(", and {} more to this label do so", count - 1),
        };
        let finding = finding(context, statement, opener, "IF", &others);
        let finding = Diagnostic { severity: Severity::Advice, ..finding };
        context.report(finding.with_help("make it a GOSUB, or jump behind ENDIF"));
    }
}

fn finding(context: &Context<'_>, jump: u32, opener: u32, word: &str, others: &str) -> Diagnostic {
    let span = context.statement_span(jump);
    let written = context.slice(span);
    RULE.at(span, format!("`{written}` leaves the {word} that it stands in{others}"))
        .with_related(context.statement_span(opener), format!("this {word} is left"))
}

/// The innermost WHILE that a jump from one statement to another leaves; the innermost IF, if it leaves no WHILE.
/// Whether leaving a FOR matters is not documented.
fn left_block(section: &SectionIndex, from: u32, to: u32) -> Option<&Block> {
    let mut around = section.blocks.enclosing(from);
    let mut branch = None;
    while let Some(block) = around {
        // What holds the target holds all that is around it.
        if (block.opener..=block.closer?).contains(&to) {
            break;
        }
        match block.kind {
            BlockKind::While => return Some(block),
            BlockKind::If if branch.is_none() => branch = Some(block),
            _ => {}
        }
        around = section.blocks.parent(block);
    }
    branch
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{found_by, spans_of};

    fn found(text: &str) -> Vec<(String, Severity)> {
        found_by("ACR116", text).into_iter().map(|found| (found.message, found.severity)).collect()
    }

    fn messages(text: &str) -> Vec<String> {
        found(text).into_iter().map(|(message, _)| message).collect()
    }

    #[test]
    fn a_jump_within_a_block_or_out_of_a_for_is_left_alone() {
        assert_eq!(messages("WHILE (BIT 1)\n_A\nIF (BIT 2) THEN GOTO A\nWEND\n"), [""; 0]);
        assert_eq!(messages("_A\nFOR LV0 = 0 TO 3\nIF (BIT 2) THEN GOTO A\nNEXT\n"), [""; 0]);
    }

    #[test]
    fn gosub_comes_back() {
        assert_eq!(messages("IF (BIT 1)\nGOSUB A\nENDIF\nEND\n_A\nRETURN\n"), [""; 0]);
    }

    #[test]
    fn a_for_around_does_not_hide_the_block() {
        let text = "_A\nIF (BIT 1)\nFOR LV0 = 0 TO 3\nGOTO A\nNEXT\nENDIF\n";
        assert_eq!(found(text), [("`GOTO A` leaves the IF that it stands in".to_owned(), Severity::Advice)]);
    }

    #[test]
    fn jumps_out_of_if_are_one_finding_for_a_label() {
        let text =
            "_A\nIF (BIT 1)\nGOTO A\nELSE\nGOTO A\nENDIF\nIF (BIT 2)\nGOTO B\nENDIF\nIF (BIT 3)\nGOTO A\nENDIF\n_B\n";
        let wanted = [
            "`GOTO A` leaves the IF that it stands in, and 2 more to this label do so",
            "`GOTO B` leaves the IF that it stands in",
        ];
        assert_eq!(messages(text), wanted);
        assert_eq!(spans_of("ACR116", text), ["GOTO A", "GOTO B"]);
    }

    #[test]
    fn each_jump_out_of_a_while_is_a_finding() {
        let text = "_A\nWHILE (BIT 1)\nIF (BIT 2)\nGOTO A\nENDIF\nIF (BIT 3) THEN GOTO A\nWEND\n";
        let wanted = || ("`GOTO A` leaves the WHILE that it stands in".to_owned(), Severity::Warning);
        assert_eq!(found(text), [wanted(), wanted()], "the IF within it is not the point");
    }
}
