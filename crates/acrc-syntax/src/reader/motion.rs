//! Axes and flags as arguments (guide, "Making Motion", "Command Syntax").

use acrc_catalog::ObjectKind;
use acrc_diagnostics::Span;

use super::arguments::{AxisValue, Rules};
use super::statement::MAX_AXIS_NAME;
use super::{Read, Reader};
use crate::ast::{Argument, Axis, BitArgument, Expr};
use crate::lexer::{Token, TokenKind};

impl Reader<'_> {
    /// `X`, `X5`, `X/25`, `Y(3,-1)`. Where a command takes bare axes only, an axis with a value is a move of its own,
    /// unless it is the first argument.
    pub(super) fn axis(&mut self, rules: &Rules, token: Token, is_first: bool) -> Read<Option<Argument>> {
        if rules.axis == AxisValue::Nothing && !is_first && may_start_target(self.peek_at(1).kind) {
            return Ok(None);
        }
        self.bump();
        let name = token.span;
        let (slash, value) = self.axis_value(rules)?;
        let span = Span::new(name.start, self.consumed_to());
        Ok(Some(Argument::Axis(Axis { span, name, slash, value })))
    }

    /// An object whose word is taken, with the value that an axis by number may have.
    pub(super) fn object_value(&mut self, rules: &Rules, kind: ObjectKind, word: Token) -> Read<Argument> {
        let mut object = self.object_behind(kind, word);
        if kind == ObjectKind::Axis && rules.axis != AxisValue::Nothing {
            (object.slash, object.value) = self.axis_value(rules)?;
            object.span = Span::new(object.name.start, self.consumed_to());
        }
        Ok(Argument::Object(object))
    }

    /// The slash and the value behind an axis.
    fn axis_value(&mut self, rules: &Rules) -> Read<(Option<Span>, Option<Box<Argument>>)> {
        let slash = self.accept(TokenKind::Slash).map(|slash| slash.span);
        let token = self.peek();
        let value = match token.kind {
            TokenKind::Word => self.word_behind_axis(rules, token, slash.is_some())?,
            TokenKind::Dollar if self.assignment_ahead() => None,
            _ if self.starts_value() => Some(self.group_or_value()?),
            _ => None,
        };
        if slash.is_some() && value.is_none() {
            return Err(self.expected("a distance"));
        }
        Ok((slash, value.map(Box::new)))
    }

    /// A word behind an axis is its value, if it can't be the next axis or the next statement.
    fn word_behind_axis(&mut self, rules: &Rules, token: Token, required: bool) -> Read<Option<Argument>> {
        let word = self.word(token);
        if rules.axis == AxisValue::Source
            && let Some(source) = self.source_word(token)
        {
            return Ok(Some(source));
        }
        if self.is_operand_or_function(token, word) {
            if self.assignment_ahead() && !required {
                return Ok(None);
            }
            return self.value().map(|value| Some(Argument::Value(value)));
        }
        let is_name = word.as_ref().is_none_or(super::expression::may_be_name);
        let assigned = self.peek_at(self.name_length()).kind == TokenKind::Equal;
        let is_long = token.span.len() > MAX_AXIS_NAME;
        let takes_value = rules.axis != AxisValue::Nothing && is_long;
        // `X/ Y5`: the next axis, not an alias of that name.
        let is_next_axis = !is_long && may_start_target(self.peek_at(1).kind);
        if is_name && !assigned && (required && !is_next_axis || takes_value) {
            return Ok(Some(Argument::Value(self.alias())));
        }
        Ok(None)
    }

    /// `ENC2`, `NONE`, `CLOCK` as the source of an axis.
    fn source_word(&mut self, token: Token) -> Option<Argument> {
        let word = self.word(token)?;
        if let Some(kind) = word.object.filter(|&kind| kind != ObjectKind::Axis) {
            self.bump();
            return Some(Argument::Object(self.object_behind(kind, token)));
        }
        let keyword = word.keyword.filter(|_| word.command.is_none())?;
        self.bump();
        Some(Argument::Word(self.keyword_behind(keyword, token)))
    }

    /// `-516`, `BIT 8467`, `(P0)`, an alias: a flag. `TRG` takes a tuple in its place.
    pub(super) fn bit(&mut self) -> Read<Option<Argument>> {
        self.wanted.0 = "a flag";
        let first = self.peek();
        let sign = if first.kind.is_sign() { Some(self.bump()) } else { None };
        let keyword = self.accept_word("BIT").is_some();
        let token = self.peek();
        if token.kind == TokenKind::LeftParen && sign.is_none() && !keyword {
            let group = self.group_or_value()?;
            self.wanted = (super::statement::END, None);
            return Ok(Some(match group {
                Argument::Value(index) => {
                    Argument::Bit(BitArgument { span: index.span, negative: false, keyword, index })
                }
                other => other,
            }));
        }
        if let Some(failure) = self.based_number(token) {
            return Err(failure);
        }
        let Some(index) = self.bit_index(token)? else {
            return if sign.is_some() || keyword { Err(self.expected("the number of a flag")) } else { Ok(None) };
        };
        self.wanted = (super::statement::END, None);
        Ok(Some(Argument::Bit(BitArgument {
            span: Span::new(first.span.start, self.consumed_to()),
            negative: sign.is_some_and(|sign| sign.kind != TokenKind::Plus),
            keyword,
            index,
        })))
    }

    fn bit_index(&mut self, token: Token) -> Read<Option<Expr>> {
        let wanted = match token.kind {
            TokenKind::Integer | TokenKind::Real | TokenKind::LeftParen => true,
            TokenKind::Word => {
                let word = self.word(token);
                let is_name = word.as_ref().is_none_or(super::expression::may_be_name);
                let assigned = is_name && self.peek_at(self.name_length()).kind == TokenKind::Equal;
                (is_name && !assigned) || self.is_operand_or_function(token, word) && !self.assignment_ahead()
            }
            _ => false,
        };
        if wanted { self.value().map(Some) } else { Ok(None) }
    }

    /// A flag, then a move: `INT -24 X100`.
    pub(super) fn bit_and_move(&mut self) -> Read<Vec<Argument>> {
        let mut arguments: Vec<Argument> = self.bit()?.into_iter().collect();
        arguments.extend(self.axes_of_move()?);
        Ok(arguments)
    }

    /// `-P12290 (100, 5)`
    pub(super) fn parameter_tuple(&mut self) -> Read<Vec<Argument>> {
        self.wanted.0 = "a parameter";
        let mut arguments = Vec::new();
        if self.starts_value() && !self.assignment_ahead() {
            arguments.push(Argument::Value(self.value()?));
            self.wanted = ("two values in parentheses", None);
            if self.peek().kind == TokenKind::LeftParen {
                arguments.push(self.group_or_value()?);
                self.wanted.0 = super::statement::END;
            }
        }
        Ok(arguments)
    }
}

/// Whether a token behind a name makes it an axis with a target.
pub(super) fn may_start_target(kind: TokenKind) -> bool {
    kind.is_sign() || matches!(kind, TokenKind::Integer | TokenKind::Real | TokenKind::Slash | TokenKind::LeftParen)
}
