//! What `ACR607` and `ACR608` share: the branches of a block `IF`.

use acrc_diagnostics::Span;
use acrc_syntax::ast::Expr;
use acrc_syntax::blocks::Block;

use crate::Context;
use crate::operands::condition;

/// A branch of a block `IF`.
pub(super) struct Branch<'a> {
    /// The statement that opens it.
    pub(super) head: u32,
    /// Its condition; `ELSE` has none.
    pub(super) condition: Option<&'a Expr>,
    /// Its statements, remarks included; `None` when there are none.
    pub(super) body: Option<Span>,
}

/// The branches of a block in order. Nothing for a block that is not closed.
pub(super) fn branches<'a>(context: &Context<'a>, block: &Block) -> Vec<Branch<'a>> {
    let Some(closer) = block.closer else { return Vec::new() };
    let heads = std::iter::once(block.opener).chain(block.branches.iter().copied());
    let ends = block.branches.iter().copied().chain([closer]);
    let branch = |(head, end): (u32, u32)| Branch {
        head,
        condition: context.tree().statements().get(head as usize).and_then(condition),
        body: (head + 1 < end)
            .then(|| Span::cover(context.statement_span(head + 1), context.statement_span(end.saturating_sub(1)))),
    };
    heads.zip(ends).map(branch).collect()
}
