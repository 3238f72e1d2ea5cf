//! Conditions, loops and jumps (guide, "Program Flow").

use acrc_catalog::Keyword;
use acrc_diagnostics::{Applicability, Edit, Fix, Span};

use super::{Read, Reader};
use crate::ast::{Argument, For, If, StatementKind, Target};
use crate::lexer::{Token, TokenKind};

impl Reader<'_> {
    /// `IF (condition)`, `IF (condition) THEN`; the word `IF` is taken.
    pub(super) fn if_statement(&mut self) -> Read<StatementKind> {
        let condition = self.full_expression()?;
        let then = self.then();
        if then.is_none() && !self.peek().kind.ends_statement() && !self.is_word(self.peek(), "REM") {
            let failure = self.expected_after("`THEN` or the end of the line", condition.span);
            return Err(failure.help("with `THEN` the rest of the line is conditional; without it a block starts"));
        }
        Ok(StatementKind::If(Box::new(If { condition, then })))
    }

    /// `THEN`, which other letters may touch: `THENP0=1`.
    fn then(&mut self) -> Option<Span> {
        let token = self.peek();
        let word = Keyword::Then.name();
        if token.kind != TokenKind::Word || !starts_with(self.slice(token.span), word) {
            return None;
        }
        let length = word.len() as u32;
        Some(if token.span.len() == length { self.bump().span } else { self.take_front(length) })
    }

    /// The condition of `WHILE` and `ELSEIF`.
    pub(super) fn condition(&mut self) -> Read<Argument> {
        let condition = self.full_expression()?;
        self.wanted = (super::statement::END, None);
        Ok(Argument::Value(condition))
    }

    /// `FOR variable = start TO end STEP step`; the word `FOR` is taken.
    pub(super) fn for_statement(&mut self) -> Read<StatementKind> {
        let variable = self.value()?;
        if self.accept(TokenKind::Equal).is_none() {
            return Err(self.expected_after("`=`", variable.span));
        }
        let start = self.full_expression()?;
        if self.accept_word(Keyword::To.name()).is_none() {
            return Err(self.expected_after("`TO`", start.span));
        }
        let end = self.full_expression()?;
        let step = match self.accept_word(Keyword::Step.name()) {
            Some(_) => Some(self.full_expression()?),
            None => None,
        };
        Ok(StatementKind::For(Box::new(For { variable, start, end, step })))
    }

    /// The label or the line number behind `GOTO` and `GOSUB`.
    pub(super) fn target(&mut self) -> Read<Vec<Argument>> {
        let token = self.peek();
        let target = match token.kind {
            TokenKind::Integer => {
                self.bump();
                let line = self.slice(token.span).parse().unwrap_or(u32::MAX);
                Target::Line(line, token.span)
            }
            TokenKind::Word => Target::Label(self.name()),
            TokenKind::Underscore => return Err(self.underscored_target(token)),
            _ => {
                self.wanted.0 = "a label or a line number";
                return Ok(Vec::new());
            }
        };
        self.wanted.1 = None;
        Ok(vec![Argument::Target(target)])
    }

    fn underscored_target(&self, underscore: Token) -> super::Failure {
        let fix = Fix::new(Applicability::Safe, "remove the underscore", vec![Edit::delete(underscore.span)]);
        self.refuse("a jump names its label without the underscore").fix(fix)
    }
}

fn starts_with(text: &str, word: &str) -> bool {
    text.get(..word.len()).is_some_and(|front| front.eq_ignore_ascii_case(word))
}
