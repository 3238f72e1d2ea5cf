//! Comments that switch the formatter off and on: `' acrc: fmt off`, `REM acrc: fmt on`.

use acrc_syntax::Tree;
use acrc_syntax::ast::{Line, StatementKind};

/// What a comment for acrc begins with.
const MARK: &str = "acrc:";

/// What a comment tells the formatter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Directive {
    /// The lines below are left alone.
    Off,
    /// The lines below are formatted again.
    On,
}

/// The directive of a line that holds nothing but the comment.
pub(crate) fn of(text: &str, tree: &Tree, line: &Line) -> Option<Directive> {
    let comment = match (line.statements.len(), line.comment) {
        (0, Some(comment)) => {
            let slice = text.get(comment.range())?;
            slice.get(slice.chars().next()?.len_utf8()..)?
        }
        (1, None) => match tree.statements().get(line.statements.start as usize)?.kind {
            StatementKind::Remark(remark) => text.get(remark.range())?,
            _ => return None,
        },
        _ => return None,
    };
    let (mark, order) = comment.trim_start().split_at_checked(MARK.len())?;
    let mut words = order.split_ascii_whitespace();
    if !mark.eq_ignore_ascii_case(MARK) || !words.next()?.eq_ignore_ascii_case("fmt") {
        return None;
    }
    let directive = match words.next()? {
        word if word.eq_ignore_ascii_case("off") => Directive::Off,
        word if word.eq_ignore_ascii_case("on") => Directive::On,
        _ => return None,
    };
    words.next().is_none().then_some(directive)
}
