//! Text that can be shown in a terminal: what a program or a file name contains must not move the cursor, change
//! colours or reorder what stands around it.

use std::borrow::Cow;

/// What stands for a character that has no picture of its own.
const REPLACEMENT: char = char::REPLACEMENT_CHARACTER;

/// A message on one line: line ends and tabs become spaces, other control characters become visible.
pub(crate) fn plain_line(text: &str) -> Cow<'_, str> {
    let plain = |c| match c {
        '\n' | '\r' | '\t' => ' ',
        other => visible(other),
    };
    if text.chars().all(|c| plain(c) == c) { Cow::Borrowed(text) } else { text.chars().map(plain).collect() }
}

/// A visible stand-in for a character that is invisible or that a terminal obeys; any other character as it is.
pub(crate) const fn visible(c: char) -> char {
    match c {
        // The block of control pictures has one for each of the first 32 codes, in order.
        '\0'..='\x1F' => match char::from_u32('\u{2400}' as u32 + c as u32) {
            Some(picture) => picture,
            None => REPLACEMENT,
        },
        '\x7F' => '\u{2421}',
        // The second block of control characters, line separators, zero-width characters, and the marks that reorder
        // text; and two that no XML document may have.
        '\u{80}'..='\u{9F}'
        | '\u{200B}'..='\u{200F}'
        | '\u{2028}'..='\u{202E}'
        | '\u{2060}'..='\u{2069}'
        | '\u{FEFF}'
        | '\u{FFFE}'
        | '\u{FFFF}' => REPLACEMENT,
        other => other,
    }
}
