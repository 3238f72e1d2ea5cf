//! Taking out a comment that suppresses nothing.
//!
//! An apostrophe comment never reaches a controller. A remark does: it takes a place in the stored program, and on a
//! line of its own a share of the time of the program. Only where lines stay lines is it taken out unseen.

use acrc_analysis::FileContext;
use acrc_catalog::command;
use acrc_diagnostics::{Edit, Fix, Span};
use acrc_syntax::ast::{Separator, StatementKind};

use super::Site;
use super::comment::Allow;

/// Takes out the whole comment.
pub(crate) fn comment(file: &FileContext<'_>, site: Site) -> Option<Fix> {
    let title = "remove the comment";
    let lines = file.tree.lines();
    let line = lines.get(site.line)?;
    if !site.alone {
        let before = match site.remark {
            Some(remark) => file.tree.statements().get(remark.checked_sub(1)? as usize)?,
            None => file.tree.statements().get(line.statements.end.checked_sub(1)? as usize)?,
        };
        let remark = site.remark.and_then(|remark| file.tree.statements().get(remark as usize));
        let is_body = remark.is_some_and(|remark| remark.separator == Separator::Then);
        // Behind PROGRAM begins the stored text: the remark is a line of it.
        let is_line = matches!(&before.kind, StatementKind::Command(command) if command.id == command::PROGRAM);
        let conditional = matches!(&before.kind, StatementKind::If(branch) if branch.then.is_some());
        if is_body || conditional || is_line {
            // Without it nothing would be left behind THEN.
            return remark.map(|remark| emptied(remark.span));
        }
        return Some(Fix::safe(title, vec![Edit::delete(Span::new(before.span.end, site.span.end))]));
    }
    if line.number.is_some() {
        // A number without anything behind it deletes the line of that number.
        return site.remark.map(|_| emptied(site.span));
    }
    let whole = match (lines.get(site.line + 1), site.line.checked_sub(1).and_then(|before| lines.get(before))) {
        (Some(next), _) => Span::new(line.span.start, next.span.start),
        (None, Some(before)) => Span::new(before.span.end, line.span.end),
        (None, None) => line.span,
    };
    let edits = vec![Edit::delete(whole)];
    Some(if site.remark.is_some() { Fix::unsafe_("remove the line", edits) } else { Fix::safe(title, edits) })
}

/// Leaves the remark in its place, without its text.
fn emptied(span: Span) -> Fix {
    Fix::safe("leave an empty remark", vec![Edit::replace(span, "REM")])
}

/// Takes some of the names, by their places in order, out of the list.
pub(crate) fn names(file: &FileContext<'_>, allow: &Allow, unused: &[usize]) -> Option<Fix> {
    let kept = allow.names.iter().enumerate().filter(|(place, _)| unused.binary_search(place).is_err());
    let kept: Option<Vec<&str>> = kept.map(|(_, span)| file.text.get(span.range())).collect();
    let list = format!("({})", kept?.join(", "));
    Some(Fix::safe("take them off the list", vec![Edit::replace(allow.list, list)]))
}
