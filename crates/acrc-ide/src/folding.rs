//! What can be folded: programs, blocks, subroutines, runs of comments and of `#DEFINE`s.

use acrc_analysis::query::{file_index, parse};
use acrc_analysis::{Db, SectionIndex, SourceFile};
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
use acrc_syntax::ast::{Line, StatementKind};
use acrc_syntax::blocks::Block;

use crate::place::{line_at, lines_in};
use crate::routine::{span_of, subroutines};

/// Kinds of what can be folded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FoldKind {
    /// A program, a block or a subroutine.
    Code,
    /// Comments, one below the other.
    Comments,
    /// `#DEFINE`s, one below the other.
    Definitions,
}

/// Lines that can be folded into the first of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fold {
    /// From the first character that belongs to it to the last one; on more than one line.
    pub span: Span,
    /// What it is.
    pub kind: FoldKind,
}

/// What can be folded in a file, in the order of the text; of what begins at one place the larger first.
pub fn folds(db: &dyn Db, file: SourceFile) -> Vec<Fold> {
    let tree = parse(db, file);
    let mut found = Vec::new();
    for section in &file_index(db, file).sections {
        code(tree, section, &mut found);
    }
    runs(tree, FoldKind::Comments, is_comment, &mut found);
    runs(tree, FoldKind::Definitions, is_definition, &mut found);
    found.retain(|fold| lines_in(tree, fold.span).len() > 1);
    found.sort_by_key(|fold| (fold.span.start, std::cmp::Reverse(fold.span.end), fold.kind));
    found.dedup_by_key(|fold| fold.span);
    found
}

fn code(tree: &Tree, index: &SectionIndex, found: &mut Vec<Fold>) {
    let mut add = |span: Span| found.push(Fold { span, kind: FoldKind::Code });
    let section = &index.section;
    if let (Some(opener), Some(closer)) = (section.opener, section.closer) {
        add(span_of(tree, opener..closer + 1));
    }
    for block in index.blocks.all() {
        parts(tree, block, &mut add);
    }
    for routine in subroutines(tree, index).into_iter().filter(|routine| routine.returns) {
        add(span_of(tree, routine.statements));
    }
}

/// A block from its opener to its closer, or to the line before its next branch.
fn parts(tree: &Tree, block: &Block, add: &mut impl FnMut(Span)) {
    let Some(closer) = block.closer else { return };
    let starts = std::iter::once(block.opener).chain(block.branches.iter().copied());
    let ends = block.branches.iter().map(|branch| (*branch, false)).chain([(closer, true)]);
    for (start, (end, is_closer)) in starts.zip(ends) {
        let last = if is_closer { end + 1 } else { end };
        let mut span = span_of(tree, start..last);
        if !is_closer {
            // Statements before an `ELSE` on its own line stay in sight with it.
            let branch = span_of(tree, end..end + 1);
            let before = line_at(tree, branch.start).checked_sub(1).and_then(|line| tree.lines().get(line));
            span = Span::new(span.start, before.map_or(span.start, |line| line.span.end).min(branch.start));
        }
        add(span);
    }
}

/// Lines of one kind that follow each other.
fn runs(tree: &Tree, kind: FoldKind, is_kind: fn(&Tree, &Line) -> bool, found: &mut Vec<Fold>) {
    for run in tree.lines().chunk_by(|a, b| is_kind(tree, a) == is_kind(tree, b)) {
        if let [first, .., last] = run
            && is_kind(tree, first)
        {
            found.push(Fold { span: Span::cover(first.span, last.span), kind });
        }
    }
}

/// Whether nothing but a comment or a remark stands on a line.
pub(crate) fn is_comment(tree: &Tree, line: &Line) -> bool {
    let statements = statements_of(tree, line);
    let only_remarks = statements.iter().all(|statement| matches!(statement.kind, StatementKind::Remark(_)));
    only_remarks && (line.comment.is_some() || !statements.is_empty())
}

fn is_definition(tree: &Tree, line: &Line) -> bool {
    let first = statements_of(tree, line).first();
    first.is_some_and(|first| matches!(first.kind, StatementKind::Define(_)))
}

/// The statements of a line.
pub(crate) fn statements_of<'t>(tree: &'t Tree, line: &Line) -> &'t [acrc_syntax::ast::Statement] {
    tree.statements().get(line.statements.start as usize..line.statements.end as usize).unwrap_or_default()
}
