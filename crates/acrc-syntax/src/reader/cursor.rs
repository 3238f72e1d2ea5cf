//! The place in the tokens of a text.

use acrc_catalog::Word;
use acrc_diagnostics::Span;

use super::Reader;
use crate::lexer::{Token, TokenKind};

impl<'t> Reader<'t> {
    /// The next token; at the end of the text an empty one.
    pub(super) fn peek(&self) -> Token {
        self.split.unwrap_or_else(|| self.token(self.position))
    }

    /// The token `distance` places behind the next one.
    pub(super) fn peek_at(&self, distance: usize) -> Token {
        if distance == 0 { self.peek() } else { self.token(self.position + distance) }
    }

    fn token(&self, index: usize) -> Token {
        self.tokens
            .get(index)
            .copied()
            .unwrap_or(Token { kind: TokenKind::End, span: Span::empty(self.text.len() as u32) })
    }

    /// Takes the next token.
    pub(super) fn bump(&mut self) -> Token {
        let token = self.peek();
        self.previous = token.span;
        self.position += 1;
        self.split = None;
        token
    }

    /// Takes `count` tokens.
    pub(super) fn skip(&mut self, count: usize) {
        for _ in 0..count {
            self.bump();
        }
    }

    /// Takes the next token if it is of this kind.
    pub(super) fn accept(&mut self, kind: TokenKind) -> Option<Token> {
        (self.peek().kind == kind).then(|| self.bump())
    }

    /// Takes the next token if it is this word, in any case.
    pub(super) fn accept_word(&mut self, word: &str) -> Option<Token> {
        self.is_word(self.peek(), word).then(|| self.bump())
    }

    /// Whether a token is this word, in any case.
    pub(super) fn is_word(&self, token: Token, word: &str) -> bool {
        token.kind == TokenKind::Word && self.slice(token.span).eq_ignore_ascii_case(word)
    }

    /// End of what has been read.
    pub(super) fn consumed_to(&self) -> u32 {
        self.previous.end
    }

    /// Whether nothing stands between what has been read and this token.
    pub(super) fn touches(&self, token: Token) -> bool {
        token.span.start == self.previous.end
    }

    /// The text of a span.
    pub(super) fn slice(&self, span: Span) -> &'t str {
        self.text.get(span.range()).unwrap_or_default()
    }

    /// What the catalogue knows about a word.
    pub(super) fn word(&self, token: Token) -> Option<Word> {
        if token.kind == TokenKind::Word { acrc_catalog::word(self.slice(token.span)) } else { None }
    }

    /// The word at the start of the next token is taken, the rest of its letters stay: `THENP0`.
    pub(super) fn take_front(&mut self, length: u32) -> Span {
        let token = self.peek();
        let middle = (token.span.start + length).min(token.span.end);
        let rest = Span::new(middle, token.span.end);
        self.split = Some(Token { kind: token.kind, span: rest });
        self.cuts.push((self.position, middle));
        self.previous = Span::new(token.span.start, middle);
        self.previous
    }

    /// Number of tokens that the name at the next token has: a word and the letters, digits and underscores that touch
    /// it (`LOOP1`, `Cycle2Start`). A name of very many pieces is not followed to its end: whoever looks ahead from
    /// each of them would read the line over and over.
    pub(super) fn name_length(&self) -> usize {
        const REACH: usize = 32;
        let mut end = self.peek().span.end;
        for length in 1..REACH {
            let next = self.peek_at(length);
            if next.span.start != end || !self.continues_name(next) {
                return length;
            }
            end = next.span.end;
        }
        REACH
    }

    /// Takes the name at the next token.
    pub(super) fn name(&mut self) -> Span {
        let start = self.bump().span.start;
        while self.touches(self.peek()) && self.continues_name(self.peek()) {
            self.bump();
        }
        Span::new(start, self.consumed_to())
    }

    fn continues_name(&self, token: Token) -> bool {
        match token.kind {
            TokenKind::Word | TokenKind::Integer | TokenKind::Underscore => true,
            // `LOOP1E3`: the lexer takes the end of the name for a number.
            TokenKind::Real => self.slice(token.span).bytes().all(|byte| byte.is_ascii_alphanumeric()),
            _ => false,
        }
    }
}
