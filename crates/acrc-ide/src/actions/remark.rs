//! Makes a remark a comment, which takes no memory on the controller.

use acrc_diagnostics::{Edit, Span};
use acrc_syntax::ast::{Separator, StatementKind};

use super::{ActionKind, CodeAction, Request};
use crate::edits::{indent_at, line_break};

pub(super) fn add(request: &Request<'_>, actions: &mut Vec<CodeAction>) {
    for at in request.statements() {
        if let Some(edits) = to_comment(request, at) {
            let title = "Write the remark with an apostrophe, which is not stored";
            actions.push(request.here(ActionKind::Rewrite, title, edits));
        }
    }
}

fn to_comment(request: &Request<'_>, at: u32) -> Option<Vec<Edit>> {
    let tree = request.tree;
    let statement = tree.statements().get(at as usize)?;
    let StatementKind::Remark(text) = statement.kind else { return None };
    let line = tree.lines().get(tree.line_of(at) as usize)?;
    let is_first = line.statements.start == at;
    // A number alone deletes its line, and a THEN needs something behind it.
    if is_first && line.number.is_some() || statement.separator == Separator::Then {
        return None;
    }
    let words = text.start + u32::from(request.slice(text).starts_with(' '));
    if is_first {
        return Some(vec![Edit::replace(Span::new(statement.span.start, words), "'")]);
    }
    // The download drops lines that begin with an apostrophe; behind a statement the controller would get it.
    let before = tree.statements().get(at.checked_sub(1)? as usize)?;
    let comment = request.slice(Span::new(words, text.end)).trim_end();
    let indent = indent_at(request.text, tree, line.span.start);
    let end = line_break(request.text, tree, line.span.start);
    Some(vec![
        Edit::insert(line.span.start, format!("{indent}'{comment}{end}")),
        Edit::delete(Span::new(before.span.end, text.end)),
    ])
}
