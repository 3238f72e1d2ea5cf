//! Blanks between the tokens of a line.

use acrc_syntax::lexer::TokenKind;

use crate::marks::Mark;

/// Whether a blank stands between two neighbours.
pub(crate) fn is_apart((left, left_mark): (TokenKind, Mark), (right, right_mark): (TokenKind, Mark)) -> bool {
    use TokenKind::{Comma, Hash, LeftParen, RemarkText, RightParen, Semicolon};
    let tight = right_mark.has(Mark::TIGHT)
        || left_mark.has(Mark::SIGN)
        || matches!(left, LeftParen | Hash)
        || matches!(right, RightParen | Comma | Semicolon | RemarkText);
    !tight
}

/// Whether two tokens that don't touch would be read as something else if they did. The text of a remark takes in
/// everything behind its word.
pub(crate) fn would_merge(left: TokenKind, right: TokenKind) -> bool {
    use TokenKind::{Dollar, Equal, Greater, Integer, Less, Real, Star, Word};
    matches!(
        (left, right),
        (Word | Dollar | Integer | Real, Word)
            | (Integer | Real, Integer | Real)
            | (Word, Dollar)
            | (Less, Less | Equal | Greater)
            | (Greater, Greater | Equal)
            | (Star, Star)
    )
}
