//! Text to tokens (guide, "Programming Basics": command syntax and remarks).
//!
//! The lexer knows the shapes of numbers, strings and words, and one word: a `REM` at the start of a statement, whose
//! text is no code. What a word means is decided by the reader with the catalogue. Every byte belongs to a token or
//! is a blank between two tokens.

mod token;

use acrc_diagnostics::Span;
use logos::Logos;
pub use token::{Token, TokenKind};
pub(crate) use token::{is_quote, rest_of_line};

/// The tokens of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lexed {
    /// All tokens but blanks, in order.
    pub tokens: Vec<Token>,
    /// Typographic characters that stand where ASCII is meant, remarks and the inside of strings not included.
    pub typographic: Vec<Span>,
}

/// Cuts a text into tokens. Never fails: what is no token is [`TokenKind::Unknown`].
///
/// Offsets are 32 bits wide; a text beyond 4 GiB is not read, which [`crate::SourceText`] refuses first.
#[must_use]
pub fn tokenize(text: &str) -> Lexed {
    let mut lexed = Lexed { tokens: Vec::with_capacity(text.len() / 4 + 1), typographic: Vec::new() };
    let mut lexer = TokenKind::lexer(text);
    let mut place = Place::LineStart;
    while let Some(result) = lexer.next() {
        let kind = result.unwrap_or(TokenKind::Unknown);
        if kind == TokenKind::Blank {
            continue;
        }
        let span = Span::from(lexer.span());
        match kind {
            TokenKind::NoBreakSpace => {
                lexed.typographic.push(span);
                continue;
            }
            TokenKind::Dash => lexed.typographic.push(span),
            TokenKind::String | TokenKind::Comment => {
                note_delimiters(lexer.slice(), span, kind, &mut lexed.typographic);
            }
            _ => {}
        }
        lexed.tokens.push(Token { kind, span });
        if kind == TokenKind::Word && place != Place::Inside && lexer.slice().eq_ignore_ascii_case("REM") {
            let length = token::rest_of_line(lexer.remainder());
            lexer.bump(length);
            let text = Span::new(span.end, span.end + length as u32);
            if !text.is_empty() {
                lexed.tokens.push(Token { kind: TokenKind::RemarkText, span: text });
            }
        }
        place = place.after(kind);
    }
    lexed
}

/// Where in a line the next token stands, as far as a remark needs to know.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    /// A line number may follow.
    LineStart,
    /// A statement starts.
    StatementStart,
    /// In a statement.
    Inside,
}

impl Place {
    fn after(self, kind: TokenKind) -> Self {
        match kind {
            TokenKind::Newline => Self::LineStart,
            TokenKind::Colon => Self::StatementStart,
            TokenKind::Integer if self == Self::LineStart => Self::StatementStart,
            _ => Self::Inside,
        }
    }
}

/// Notes the curly quotes around a string and the curly apostrophe before a comment.
fn note_delimiters(slice: &str, span: Span, kind: TokenKind, typographic: &mut Vec<Span>) {
    let mut characters = slice.chars();
    let first = characters.next().filter(|first| !first.is_ascii());
    if let Some(first) = first {
        typographic.push(Span::new(span.start, span.start + first.len_utf8() as u32));
    }
    if kind == TokenKind::String
        && let Some(last) = characters.next_back().filter(|&last| !last.is_ascii() && token::is_quote(last))
    {
        typographic.push(Span::new(span.end - last.len_utf8() as u32, span.end));
    }
}
