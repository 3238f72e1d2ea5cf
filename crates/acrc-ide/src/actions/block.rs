//! A conditional line as a block, and back.

use acrc_catalog::command;
use acrc_diagnostics::{Edit, Span};
use acrc_syntax::ast::{Line, Separator, Statement, StatementKind};
use acrc_syntax::blocks::BlockKind;

use super::{ActionKind, CodeAction, Request};
use crate::edits::{indent_at, line_break};
use crate::folding::statements_of;
use crate::place::section_of;

pub(super) fn add(request: &Request<'_>, actions: &mut Vec<CodeAction>) {
    for at in request.statements() {
        if let Some(edits) = to_block(request, at) {
            actions.push(request.here(ActionKind::Rewrite, "Write the condition as a block", edits));
        }
        if let Some(edits) = to_line(request, at) {
            actions.push(request.here(ActionKind::Rewrite, "Write the condition on one line", edits));
        }
    }
}

/// The line on which a statement stands first, without a number or a comment.
fn plain_line<'a>(request: &Request<'a>, at: u32) -> Option<(&'a Line, &'a [Statement])> {
    let line = request.tree.lines().get(request.tree.line_of(at) as usize)?;
    let is_plain = line.statements.start == at && line.number.is_none() && line.comment.is_none();
    is_plain.then(|| (line, statements_of(request.tree, line)))
}

/// `IF (a) THEN b : c` to three lines.
fn to_block(request: &Request<'_>, at: u32) -> Option<Vec<Edit>> {
    let StatementKind::If(head) = &request.tree.statements().get(at as usize)?.kind else { return None };
    head.then?;
    let (line, [_, inner @ ..]) = plain_line(request, at)? else { return None };
    let (first, last) = (inner.first()?, inner.last()?);
    if !inner.iter().all(may_move) {
        return None;
    }
    let end = line_break(request.text, request.tree, line.span.start);
    let indent = indent_at(request.text, request.tree, line.span.start);
    Some(vec![
        Edit::replace(Span::new(head.condition.span.end, first.span.start), format!("{end}{indent}    ")),
        Edit::insert(last.span.end, format!("{end}{indent}ENDIF")),
    ])
}

/// An `IF` with nothing but one line between it and its `ENDIF`. A block around it would not take a line with `THEN`.
fn to_line(request: &Request<'_>, at: u32) -> Option<Vec<Edit>> {
    let Request { db, file, tree, .. } = *request;
    let StatementKind::If(head) = &tree.statements().get(at as usize)?.kind else { return None };
    let blocks = &section_of(db, file, at)?.blocks;
    let block = blocks.block_of(at).filter(|block| block.opener == at && block.branches.is_empty())?;
    let around = std::iter::successors(blocks.parent(block), |block| blocks.parent(block));
    if head.then.is_some() || around.into_iter().any(|block| block.kind == BlockKind::If) {
        return None;
    }
    let ([_], [first, ..], [_]) =
        (plain_line(request, at)?.1, plain_line(request, at + 1)?.1, plain_line(request, block.closer?)?.1)
    else {
        return None;
    };
    let body = plain_line(request, at + 1)?.1;
    let (last, closer) = (body.last()?, tree.statements().get(block.closer? as usize)?);
    let holds_all = at + 1 + body.len() as u32 == block.closer?;
    // A remark would take what follows it; here nothing does.
    (holds_all && body.iter().all(may_move)).then(|| {
        vec![
            Edit::replace(Span::new(head.condition.span.end, first.span.start), " THEN "),
            Edit::delete(Span::new(last.span.end, closer.span.end)),
        ]
    })
}

/// Whether a statement means the same in a block and behind `THEN`.
fn may_move(statement: &Statement) -> bool {
    match &statement.kind {
        StatementKind::If(_)
        | StatementKind::For(_)
        | StatementKind::Label(_)
        | StatementKind::Define(_)
        | StatementKind::Error => false,
        StatementKind::Remark(_) => statement.separator != Separator::Line && statement.separator != Separator::Then,
        StatementKind::Command(command) => ![
            command::WHILE,
            command::WEND,
            command::NEXT,
            command::ENDIF,
            command::ELSE,
            command::ELSEIF,
            command::ELSE_IF,
        ]
        .contains(&command.id),
        _ => true,
    }
}
