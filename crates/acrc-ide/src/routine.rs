//! The routines of a program: its main code, and the subroutines that `GOSUB` calls.
//!
//! Nothing in the language says where a subroutine ends. Here it reaches from the label or line that is called to the
//! first `RETURN` outside of all blocks; without one, to the next place that is called. Code in no subroutine is main code.
//! A second entry into a subroutine makes another routine that ends with the first.

use std::ops::Range;

use acrc_analysis::SectionIndex;
use acrc_catalog::command;
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
use acrc_syntax::ast::StatementKind;

/// The statements of a subroutine, from the one that is called to its last one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Subroutine {
    pub(crate) statements: Range<u32>,
    /// It ends with a `RETURN`.
    pub(crate) returns: bool,
}

/// The subroutines of a section, in the order of the text.
pub(crate) fn subroutines(tree: &Tree, section: &SectionIndex) -> Vec<Subroutine> {
    let mut entries: Vec<u32> = section.jumps.iter().filter(|jump| jump.call).filter_map(|jump| jump.to).collect();
    entries.sort_unstable();
    entries.dedup();
    let returns = outer_returns(tree, section);
    let end = section.section.statements.end;
    let next_entry = |entry: u32| entries.get(entries.partition_point(|other| *other <= entry)).copied();
    let subroutine = |&entry: &u32| match returns.get(returns.partition_point(|at| *at < entry)) {
        Some(last) => Subroutine { statements: entry..last + 1, returns: true },
        None => Subroutine { statements: entry..next_entry(entry).unwrap_or(end), returns: false },
    };
    entries.iter().map(subroutine).collect()
}

/// The `RETURN`s that stand in no block and behind no `THEN`.
fn outer_returns(tree: &Tree, section: &SectionIndex) -> Vec<u32> {
    let mut returns = Vec::new();
    for at in section.section.statements.clone() {
        let Some(statement) = tree.statements().get(at as usize) else { break };
        let is_return = matches!(&statement.kind, StatementKind::Command(command) if command.id == command::RETURN);
        if is_return && section.blocks.enclosing(at).is_none() && !is_conditional(tree, at) {
            returns.push(at);
        }
    }
    returns
}

/// Whether a statement depends on an `IF` with `THEN` before it on its line.
pub(crate) fn is_conditional(tree: &Tree, statement: u32) -> bool {
    let line = tree.lines().get(tree.line_of(statement) as usize);
    let first = line.map_or(statement, |line| line.statements.start);
    let before = tree.statements().get(first as usize..statement as usize).unwrap_or_default();
    before.iter().any(|other| matches!(&other.kind, StatementKind::If(head) if head.then.is_some()))
}

/// From the first character of some statements to the last.
pub(crate) fn span_of(tree: &Tree, statements: Range<u32>) -> Span {
    let all = tree.statements().get(statements.start as usize..statements.end as usize).unwrap_or_default();
    match (all.first(), all.last()) {
        (Some(first), Some(last)) => Span::cover(first.span, last.span),
        _ => Span::empty(0),
    }
}
