//! Makes a remark a comment, which takes no memory on the controller.

use acrc_diagnostics::{Edit, Span};
use acrc_syntax::ast::{Separator, StatementKind};

use super::{ActionKind, CodeAction, Request};

pub(super) fn add(request: &Request<'_>, actions: &mut Vec<CodeAction>) {
    for at in request.statements() {
        if let Some(edit) = to_comment(request, at) {
            let title = "Write the remark with an apostrophe, which is not stored";
            actions.push(request.here(ActionKind::Rewrite, title, vec![edit]));
        }
    }
}

fn to_comment(request: &Request<'_>, at: u32) -> Option<Edit> {
    let tree = request.tree;
    let statement = tree.statements().get(at as usize)?;
    let StatementKind::Remark(text) = statement.kind else { return None };
    let line = tree.lines().get(tree.line_of(at) as usize)?;
    let is_first = line.statements.start == at;
    // A number alone deletes its line, and a THEN needs something behind it.
    if is_first && line.number.is_some() || statement.separator == Separator::Then {
        return None;
    }
    let before = at.checked_sub(1).filter(|_| !is_first).and_then(|before| tree.statements().get(before as usize));
    let start = before.map_or(statement.span.start, |before| before.span.end);
    let blank = u32::from(request.slice(text).starts_with(' '));
    let apostrophe = if is_first { "'" } else { " ' " };
    Some(Edit::replace(Span::new(start, text.start + blank), apostrophe))
}
