//! Lines that are nothing but a remark.

use acrc_syntax::Tree;
use acrc_syntax::ast::{Line, StatementKind};

/// The text of a remark that has a line of its own, without its apostrophe or `REM`.
pub(crate) fn whole_line<'t>(text: &'t str, tree: &Tree, line: &Line) -> Option<&'t str> {
    let remark = match (line.comment, line.statements.len()) {
        (Some(comment), 0) => text.get(comment.range())?.trim_start_matches(['\'', '\u{2018}', '\u{2019}']),
        (None, 1) => match tree.statements().get(line.statements.start as usize)?.kind {
            StatementKind::Remark(span) => text.get(span.range())?,
            _ => return None,
        },
        _ => return None,
    };
    Some(remark.trim())
}
