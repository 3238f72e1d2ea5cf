//! How lines end.

use acrc_syntax::Tree;
use acrc_syntax::lexer::TokenKind;

/// In the order of preference where a text has as many of one kind as of another.
const ENDS: [&str; 3] = ["\n", "\r\n", "\r"];

/// The line end that most lines of a text have; LF for a text without one.
pub(crate) fn dominant(tree: &Tree, text: &str) -> &'static str {
    let mut counts = [0_usize; ENDS.len()];
    for token in tree.tokens().iter().filter(|token| token.kind == TokenKind::Newline) {
        let end = text.get(token.span.range()).unwrap_or_default();
        for (count, _) in counts.iter_mut().zip(ENDS).filter(|(_, known)| *known == end) {
            *count += 1;
        }
    }
    let most = counts.iter().copied().max().unwrap_or_default();
    let found = ENDS.into_iter().zip(counts).find(|&(_, count)| count == most);
    found.map_or(ENDS[0], |(end, _)| end)
}
