//! Why a statement could not be read, in words.

use acrc_diagnostics::{Applicability, Diagnostic, Edit, Fix, Span};

use super::Reader;
use crate::codes;
use crate::lexer::{Token, TokenKind};

/// The reading of a statement ended; the diagnostic says why.
#[derive(Debug)]
pub(super) struct Failure(pub(super) Box<Diagnostic>);

/// The result of reading a part of a statement.
pub(super) type Read<T> = Result<T, Failure>;

/// More errors than this are not listed: a file that is no program has one in each line.
pub(super) const MAX_ERRORS: usize = 10_000;
/// Characters of a token that a message shows.
const MAX_SHOWN: usize = 32;

impl Failure {
    /// Adds what to do about it.
    pub(super) fn help(self, text: impl Into<String>) -> Self {
        Self(Box::new(self.0.with_help(text)))
    }

    /// Adds a second place.
    pub(super) fn related(self, span: Span, text: &str) -> Self {
        Self(Box::new(self.0.with_related(span, text)))
    }

    /// Adds a repair.
    pub(super) fn fix(self, fix: Fix) -> Self {
        Self(Box::new(self.0.with_fix(fix)))
    }
}

impl Reader<'_> {
    /// The next token is not what must come after what has just been read.
    pub(super) fn expected(&self, what: &str) -> Failure {
        self.expected_after(what, self.last_read())
    }

    /// What was read last, in one piece where a number touches its word: `P0`, not `0`.
    pub(super) fn last_read(&self) -> Span {
        let before = self.position.checked_sub(2).and_then(|index| self.tokens.get(index));
        match before {
            Some(word)
                if matches!(word.kind, TokenKind::Word | TokenKind::Dollar)
                    && word.span.end == self.previous.start
                    && self.slice(self.previous).bytes().all(|byte| byte.is_ascii_digit()) =>
            {
                Span::cover(word.span, self.previous)
            }
            _ => self.previous,
        }
    }

    /// The next token is not what must come after the text at `after`.
    pub(super) fn expected_after(&self, what: &str, after: Span) -> Failure {
        let token = self.peek_name();
        let found = self.describe(token);
        let after = shown(self.slice(after));
        let message = if self.position == self.statement_start || after.is_empty() {
            format!("expected {what}, found {found}")
        } else {
            format!("expected {what} after `{after}`, found {found}")
        };
        let place = if token.kind.ends_line() { Span::empty(self.consumed_to()) } else { token.span };
        let diagnostic = Diagnostic::error(codes::SYNTAX_ERROR, place, message);
        Failure(Box::new(diagnostic.with_label(format!("expected {what}"))))
    }

    /// The next token can't stand here, for the reason given.
    pub(super) fn refuse(&self, message: impl Into<String>) -> Failure {
        Failure(Box::new(Diagnostic::error(codes::SYNTAX_ERROR, self.peek().span, message)))
    }

    /// The next token, with the number that touches it if it is a word.
    fn peek_name(&self) -> Token {
        let token = self.peek();
        let next = self.peek_at(1);
        if token.kind == TokenKind::Word && next.kind == TokenKind::Integer && next.span.start == token.span.end {
            return Token { kind: token.kind, span: Span::cover(token.span, next.span) };
        }
        token
    }

    /// A token as a message names it.
    pub(super) fn describe(&self, token: Token) -> String {
        match token.kind {
            TokenKind::Newline | TokenKind::End => "the end of the line".to_owned(),
            TokenKind::Comment => "a comment".to_owned(),
            _ => format!("`{}`", shown(self.slice(token.span))),
        }
    }

    /// A string runs to the end of its line.
    pub(super) fn report_unterminated(&mut self, token: Token) {
        let text = self.slice(token.span);
        let end = token.span.start + text.trim_end().len() as u32;
        let fix =
            Fix::new(Applicability::Unsafe, "close the string at the end of the line", vec![Edit::insert(end, "\"")]);
        self.report(
            Diagnostic::error(
                codes::UNTERMINATED_STRING,
                Span::new(token.span.start, end),
                "the string has no closing quote",
            )
            .with_help("a string ends on the line on which it starts")
            .with_fix(fix),
        );
    }

    /// Adds what was found, up to a limit that no program reaches.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        if self.errors.len() < MAX_ERRORS {
            self.errors.push(diagnostic);
        }
    }
}

/// The start of a text, so that a message stays readable.
pub(super) fn shown(text: &str) -> String {
    match text.char_indices().nth(MAX_SHOWN) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}
