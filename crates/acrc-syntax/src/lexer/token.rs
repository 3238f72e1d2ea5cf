//! The kinds of tokens and how each is recognised.

use std::ops::ControlFlow;

use acrc_diagnostics::Span;
use logos::{Lexer, Logos};

/// A piece of text with its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it stands.
    pub span: Span,
}

/// What a token is. The lexer knows no words: letters are [`TokenKind::Word`], whatever they spell.
#[derive(Logos, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TokenKind {
    /// Blanks, tabs and form feeds. They separate tokens and are no tokens of a [`crate::Tree`].
    #[regex(r"[ \t\x0C]+")]
    Blank,
    /// A no-break space of any width, as pasted from a document. Read as a blank.
    #[token("\u{A0}")]
    #[token("\u{2007}")]
    #[token("\u{202F}")]
    NoBreakSpace,
    /// LF, CRLF or a lone CR.
    #[regex(r"\r\n|\n|\r")]
    Newline,
    /// Letters. Digits behind them are a token of their own: `SET34`, `X1.5Y2`.
    #[regex("[A-Za-z]+")]
    Word,
    /// Digits.
    #[regex("[0-9]+")]
    Integer,
    /// Digits with a point or an exponent: `1.5`, `.5`, `2.`, `1e-005`.
    #[regex(r"[0-9]+\.[0-9]*([eE][+-]?[0-9]+)?")]
    #[regex(r"\.[0-9]+([eE][+-]?[0-9]+)?")]
    #[regex(r"[0-9]+[eE][+-]?[0-9]+")]
    Real,
    /// A text between quotes, straight or curly; without a closing quote it reaches to the end of the line.
    #[token("\"", lex_string)]
    #[token("\u{201C}", lex_string)]
    #[token("\u{201D}", lex_string)]
    #[token("\u{201E}", lex_string)]
    String,
    /// `$` and the letters behind it: `$V`, `$A`, and the lone `$` of `CHR$`.
    #[regex(r"\$[A-Za-z]*")]
    Dollar,
    /// An apostrophe and the rest of its line.
    #[token("'", lex_rest_of_line)]
    #[token("\u{2018}", lex_rest_of_line)]
    #[token("\u{2019}", lex_rest_of_line)]
    Comment,
    /// The text behind a `REM` that starts a statement, up to the end of its line.
    RemarkText,
    /// `_`
    #[token("_")]
    Underscore,
    /// `#`
    #[token("#")]
    Hash,
    /// `?`
    #[token("?")]
    Question,
    /// `:`
    #[token(":")]
    Colon,
    /// `;`
    #[token(";")]
    Semicolon,
    /// `,`
    #[token(",")]
    Comma,
    /// `(`
    #[token("(")]
    LeftParen,
    /// `)`
    #[token(")")]
    RightParen,
    /// `+`
    #[token("+")]
    Plus,
    /// `-`
    #[token("-")]
    Minus,
    /// A dash or minus sign that is not ASCII. Read as `-`.
    #[token("\u{2010}")]
    #[token("\u{2011}")]
    #[token("\u{2012}")]
    #[token("\u{2013}")]
    #[token("\u{2014}")]
    #[token("\u{2212}")]
    Dash,
    /// `*`
    #[token("*")]
    Star,
    /// `**`
    #[token("**")]
    StarStar,
    /// `^`
    #[token("^")]
    Caret,
    /// `/`
    #[token("/")]
    Slash,
    /// `=`
    #[token("=")]
    Equal,
    /// `<>`
    #[token("<>")]
    NotEqual,
    /// `<`
    #[token("<")]
    Less,
    /// `<=`
    #[token("<=")]
    LessEqual,
    /// `>`
    #[token(">")]
    Greater,
    /// `>=`
    #[token(">=")]
    GreaterEqual,
    /// `<<`
    #[token("<<")]
    ShiftLeft,
    /// `>>`
    #[token(">>")]
    ShiftRight,
    /// `…`, which listings in print use for left-out lines.
    #[token("\u{2026}")]
    Ellipsis,
    /// Any other character.
    Unknown,
    /// The end of the text, the kind of the empty token that a reader meets there.
    End,
}

impl TokenKind {
    /// Whether a line ends here. An apostrophe comment ends it too: nothing else can follow.
    #[must_use]
    pub const fn ends_line(self) -> bool {
        matches!(self, Self::Newline | Self::Comment | Self::End)
    }

    /// Whether a statement ends here.
    #[must_use]
    pub const fn ends_statement(self) -> bool {
        self.ends_line() || matches!(self, Self::Colon)
    }

    /// Whether this is a sign of a number.
    #[must_use]
    pub const fn is_sign(self) -> bool {
        matches!(self, Self::Plus | Self::Minus | Self::Dash)
    }
}

/// Whether the character opens or closes a string.
pub(crate) const fn is_quote(character: char) -> bool {
    matches!(character, '"' | '\u{201C}' | '\u{201D}' | '\u{201E}')
}

/// Length of the text before the next line break.
pub(crate) fn rest_of_line(text: &str) -> usize {
    text.bytes().position(|byte| byte == b'\n' || byte == b'\r').unwrap_or(text.len())
}

fn lex_rest_of_line(lexer: &mut Lexer<TokenKind>) {
    lexer.bump(rest_of_line(lexer.remainder()));
}

/// Closes a string. A straight opening quote is closed by a straight one if the line has one, so that curly quotes may
/// stand in a text; text copied from a document mixes them, and then any quote closes.
fn lex_string(lexer: &mut Lexer<TokenKind>) {
    let straight = lexer.slice() == "\"";
    let mut curly = None;
    let close = lexer.remainder().char_indices().try_for_each(|(at, character)| match character {
        '\n' | '\r' => ControlFlow::Break(curly.unwrap_or(at)),
        '"' => ControlFlow::Break(at + 1),
        quote if is_quote(quote) && !straight => ControlFlow::Break(at + quote.len_utf8()),
        quote if is_quote(quote) => {
            curly.get_or_insert(at + quote.len_utf8());
            ControlFlow::Continue(())
        }
        _ => ControlFlow::Continue(()),
    });
    let end = match close {
        ControlFlow::Break(end) => end,
        ControlFlow::Continue(()) => curly.unwrap_or(lexer.remainder().len()),
    };
    lexer.bump(end);
}
