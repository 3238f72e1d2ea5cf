//! Which statement closes, branches and encloses which.

mod support;

use acrc_syntax::blocks::{Block, BlockErrorKind, BlockKind, Blocks, match_blocks};

/// Matches the blocks of a program with one statement a line, so that statement numbers are line numbers from 0.
fn blocks(source: &str) -> Blocks {
    let tree = support::checked(source);
    match_blocks(&tree, 0..tree.statements().len() as u32)
}

fn opener(block: Option<&Block>) -> Option<u32> {
    block.map(|block| block.opener)
}

#[test]
fn a_chain_shares_one_endif() {
    let found = blocks("IF (P0)\nSET 1\nELSEIF (P1)\nSET 2\nELSE IF (P2)\nSET 3\nELSE\nSET 4\nENDIF");
    let [block] = found.all() else { panic!("one block: {found:?}") };
    assert_eq!((block.kind, block.opener, block.closer), (BlockKind::If, 0, Some(8)));
    assert_eq!(block.branches, [2, 4, 6]);
    assert!(found.errors().is_empty());
    for part in [0, 2, 4, 6, 8] {
        assert_eq!(opener(found.block_of(part)), Some(0), "statement {part} is a part");
    }
    for inner in [1, 3, 5, 7] {
        assert_eq!(found.block_of(inner), None);
        assert_eq!(opener(found.enclosing(inner)), Some(0));
    }
}

#[test]
fn a_colon_between_else_and_if_opens_a_block() {
    let found = blocks("IF (P0)\nELSE : IF (P1)\nSET 1\nENDIF\nENDIF");
    assert_eq!(found.all().len(), 2);
    assert!(found.errors().is_empty());
}

#[test]
fn an_if_with_then_opens_none() {
    let found = blocks("IF (P0) THEN SET 1\nIF (P0) THEN IF (P1) THEN SET 2\nENDIF");
    assert!(found.all().is_empty());
    let [error] = found.errors() else { panic!("one error: {found:?}") };
    assert_eq!(error.kind, BlockErrorKind::Unopened("ENDIF"));
}

#[test]
fn an_if_with_a_lone_then_was_meant_to_open_one() {
    let found = blocks("IF (P0) THEN\nSET 1\nENDIF");
    assert_eq!(found.all().len(), 1);
    assert!(found.errors().is_empty());
}

#[test]
fn blocks_stand_inside_each_other() {
    let found = blocks("FOR LV0 = 0 TO 9\nWHILE (P0)\nIF (P1)\nBREAK\nENDIF\nWEND\nBREAK\nNEXT\nBREAK");
    assert!(found.errors().is_empty());
    let depths: Vec<u32> = found.all().iter().map(|block| block.depth).collect();
    assert_eq!(depths, [0, 1, 2]);
    assert_eq!(opener(found.enclosing_loop(3)), Some(1), "BREAK in a block IF leaves the WHILE");
    assert_eq!(opener(found.enclosing_loop(6)), Some(0));
    assert_eq!(found.enclosing_loop(8), None);
    assert_eq!(opener(found.enclosing(2)), Some(1), "the IF stands in the WHILE");
    assert_eq!(opener(found.enclosing(4)), Some(1), "and so does its ENDIF");
}

#[test]
fn what_is_not_closed_is_told_at_its_opener() {
    let found = blocks("FOR LV0 = 0 TO 9\nIF (P0)\nSET 1");
    let kinds: Vec<_> = found.errors().iter().map(|error| (error.statement, error.kind)).collect();
    assert_eq!(kinds, [(0, BlockErrorKind::Unclosed(BlockKind::For)), (1, BlockErrorKind::Unclosed(BlockKind::If))]);
}

#[test]
fn crossed_blocks_are_told_once() {
    let found = blocks("FOR LV0 = 0 TO 9\nIF (P0)\nNEXT\nENDIF\nSET 1");
    let [error] = found.errors() else { panic!("one error: {found:?}") };
    assert_eq!(error.statement, 2);
    let crossed = BlockErrorKind::Crossed { closes: BlockKind::For, open: 1, open_kind: BlockKind::If };
    assert_eq!(error.kind, crossed);
    assert_eq!(found.enclosing(4), None);
}

#[test]
fn branches_behind_the_else_are_told() {
    let found = blocks("IF (P0)\nELSE\nELSEIF (P1)\nELSE\nENDIF\nELSE");
    let kinds: Vec<_> = found.errors().iter().map(|error| (error.statement, error.kind)).collect();
    let after = BlockErrorKind::ElseAfterElse { first: 1 };
    assert_eq!(kinds, [(2, after), (3, after), (5, BlockErrorKind::Unopened("ELSE"))]);
}

#[test]
fn a_statement_that_could_not_be_read_may_be_the_missing_half() {
    assert!(blocks("IF (P0 =\nSET 1\nENDIF").errors().is_empty());
    assert!(blocks("WHILE (P0)\nWENT 5 )\nSET 1").errors().is_empty());
    assert_eq!(blocks("IF (P0 =\nENDIF\nENDIF").errors().len(), 1);
}

#[test]
fn a_range_is_matched_on_its_own() {
    let tree = support::checked("IF (P0)\nPROGRAM\nWHILE (P0)\nWEND\nENDP\nENDIF");
    let found = match_blocks(&tree, 2..4);
    assert!(found.errors().is_empty());
    assert_eq!(opener(found.block_of(3)), Some(2));
    assert_eq!(found.block_of(0), None);
    assert_eq!(found.block_of(5), None);
    assert!(match_blocks(&tree, 4..900).errors().len() == 1, "a range may reach beyond the end");
}
