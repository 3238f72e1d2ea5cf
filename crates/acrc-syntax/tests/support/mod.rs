//! What the tests of this crate share.
#![allow(dead_code, reason = "each test file uses a part of it")]

use acrc_diagnostics::{Diagnostic, FileReport, Severity, SourceFile, text};
use acrc_syntax::ast::{Statement, StatementKind};
use acrc_syntax::{Tree, parse};

/// Reads a text and checks what must hold for every text.
pub(crate) fn checked(source: &str) -> Tree {
    let tree = parse(source);
    check_invariants(&tree, source);
    tree
}

/// What holds for the tree of every text.
pub(crate) fn check_invariants(tree: &Tree, source: &str) {
    assert_eq!(tree.print(source), source, "the tree prints back to its text");
    let mut end = 0;
    for statement in tree.statements() {
        assert!(statement.span.start >= end, "statements are in order and disjoint: {statement:?} of {source:?}");
        assert!(!statement.span.is_empty(), "a statement has text: {statement:?} of {source:?}");
        assert!(source.get(statement.span.range()).is_some(), "spans lie on characters");
        end = statement.span.end;
    }
    let mut next = 0;
    let mut line_start = 0;
    for (index, line) in tree.lines().iter().enumerate() {
        assert_eq!(line.statements.start, next, "every statement stands on one line");
        assert!(line.span.start >= line_start, "lines are in order");
        for statement in line.statements.clone() {
            assert_eq!(tree.line_of(statement) as usize, index, "a statement finds its line");
            let span = tree.statements()[statement as usize].span;
            assert!(line.span.start <= span.start && span.end <= line.span.end, "a statement stays on its line");
        }
        next = line.statements.end;
        line_start = line.span.end;
    }
    assert_eq!(next as usize, tree.statements().len());
    let mut end = 0;
    for token in tree.tokens() {
        assert!(token.span.start >= end && !token.span.is_empty(), "tokens are in order and disjoint");
        end = token.span.end;
    }
    let broken = tree.statements().iter().filter(|statement| is_error(statement)).count();
    let errors = errors(tree).len();
    assert!(broken <= errors, "a broken statement has a diagnostic: {source:?}");
}

/// Whether a statement could not be read.
pub(crate) fn is_error(statement: &Statement) -> bool {
    statement.kind == StatementKind::Error
}

/// The diagnostics that are errors.
pub(crate) fn errors(tree: &Tree) -> Vec<&Diagnostic> {
    tree.errors().iter().filter(|error| error.severity == Severity::Error).collect()
}

/// The diagnostics as a person sees them.
pub(crate) fn rendered(source: &str) -> String {
    let tree = checked(source);
    let report = FileReport::new(SourceFile::new("Prog0.8K", source), tree.errors());
    let mut out = Vec::new();
    text::render(&[report], text::Options::default(), &mut out).expect("writing to memory succeeds");
    String::from_utf8(out).expect("the report is text")
}
