//! The blocks of the tree are those of the compiler, and they are what an editor folds.

use crate::programs::{Program, parse, programs, visit};
use acrc_syntax::blocks::{BlockKind, match_blocks};
use tree_sitter::{Query, QueryCursor, StreamingIterator as _};

/// Kind, first byte, and whether it is closed.
type Block = (BlockKind, usize, bool);

fn of_tree(text: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    visit(parse(text).root_node(), &mut |node| {
        let kind = match node.kind() {
            "if_block" => BlockKind::If,
            "for_block" => BlockKind::For,
            "while_block" => BlockKind::While,
            _ => return,
        };
        let last = node.child(node.child_count().saturating_sub(1));
        blocks.push((kind, node.start_byte(), last.is_some_and(|last| last.kind() == kind.closer())));
    });
    blocks.sort_by_key(|(_, start, _)| *start);
    blocks
}

fn of_compiler(text: &str) -> Option<Vec<Block>> {
    let tree = acrc_syntax::parse(text);
    let all = match_blocks(&tree, 0..tree.statements().len() as u32);
    // Where they don't match, an editor and a compiler may think differently.
    let is_clean = all.errors().is_empty();
    let start = |statement: u32| tree.statements()[statement as usize].span.start as usize;
    is_clean.then(|| all.all().iter().map(|block| (block.kind, start(block.opener), block.closer.is_some())).collect())
}

#[test]
fn blocks_are_those_of_the_compiler() {
    let mut compared = 0;
    for Program { name, text } in programs() {
        let Some(expected) = of_compiler(&text) else { continue };
        compared += expected.len();
        assert_eq!(of_tree(&text), expected, "{name}");
    }
    assert!(compared > 50, "only {compared} blocks were compared");
}

#[test]
fn blocks_branches_and_programs_fold() {
    let text = "PROGRAM\nIF (P0)\nX5\nELSEIF (P1)\nX6\nELSE\nX7\nENDIF\nFOR P0=1 TO 2\nNEXT\nWHILE (P0)\nWEND\nENDP\n";
    let query =
        Query::new(&tree_sitter_acrobasic::LANGUAGE.into(), tree_sitter_acrobasic::FOLDS_QUERY).expect("a query");
    let tree = parse(text);
    let mut cursor = QueryCursor::new();
    let mut matches = cursor.matches(&query, tree.root_node(), text.as_bytes());
    let mut folds = Vec::new();
    while let Some(found) = matches.next() {
        folds
            .extend(found.captures().iter().map(|fold| (fold.node.start_position().row, fold.node.end_position().row)));
    }
    folds.sort_unstable();
    assert_eq!(folds, [(0, 12), (1, 7), (3, 5), (5, 7), (8, 9), (10, 11)]);
}

#[test]
fn an_open_block_ends_with_its_program() {
    let text = "PROGRAM\nIF (P0)\nWHILE (P1)\nENDP\nPROG1\nPROGRAM\nNEXT\nENDP\n";
    assert_eq!(of_tree(text), [(BlockKind::If, 8, false), (BlockKind::While, 16, false)]);
    assert!(!parse(text).root_node().has_error());
}
