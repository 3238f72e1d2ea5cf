//! Forms of other languages that would be read here as something else, or as several mistakes.

use acrc_catalog::{Command as Row, CommandId, command, function};
use acrc_diagnostics::{Applicability, Diagnostic, Edit, Fix, Span};

use super::failure::shown;
use super::{Failure, Read, Reader};
use crate::ast::{Expr, ExprKind};
use crate::codes;
use crate::lexer::{Token, TokenKind};

/// How a number starts that is not decimal, and its base.
const BASES: [(char, u32); 3] = [('x', 16), ('X', 16), ('b', 2)];

impl Reader<'_> {
    /// `0x1F`, `0b101`: a number whose base is not ten. The language has none, and would take the letters for an axis
    /// that moves. `0X1` is left alone: an axis X may well touch the zero before it.
    pub(super) fn based_number(&self, token: Token) -> Option<Failure> {
        if token.kind != TokenKind::Integer || self.slice(token.span) != "0" {
            return None;
        }
        let rest = self.text.get(token.span.end as usize..)?;
        let letter = rest.chars().next()?;
        let (_, base) = BASES.into_iter().find(|(mark, _)| *mark == letter)?;
        let tail = rest.get(1..)?;
        let length = tail.bytes().position(|byte| !byte.is_ascii_alphanumeric()).unwrap_or(tail.len());
        let digits = tail.get(..length).filter(|digits| digits.chars().all(|digit| digit.is_digit(base)))?;
        let may_be_axis = letter == 'X' && digits.bytes().all(|byte| byte.is_ascii_digit());
        if digits.is_empty() || may_be_axis {
            return None;
        }
        let span = Span::new(token.span.start, token.span.end + 1 + length as u32);
        let written = shown(self.slice(span));
        let diagnostic =
            Diagnostic::error(codes::SYNTAX_ERROR, span, format!("`{written}` is no number: numbers are decimal"));
        Some(Failure(Box::new(match u32::from_str_radix(digits, base) {
            Ok(value) => diagnostic
                .with_help(format!("write {value}"))
                .with_fix(Fix::safe("write it in decimal", vec![Edit::replace(span, value.to_string())])),
            Err(_) => diagnostic,
        })))
    }

    /// The name at `name` stands before a parenthesis, and is no function.
    pub(super) fn unknown_function(&self, name: Span) -> Failure {
        let message = format!("there is no function `{}`", shown(self.slice(name)));
        let failure = Failure(Box::new(Diagnostic::error(codes::SYNTAX_ERROR, name, message)));
        if acrc_catalog::word(self.slice(name)).and_then(|word| word.command) == Some(command::INT) {
            let name = function::TRUNC.info().name;
            return failure.help(format!("{name} cuts off what is behind the point; INT interrupts a move"));
        }
        failure
    }

    /// Whether the token `distance` places ahead is the `:=` of other languages.
    pub(super) fn is_colon_equal(&self, distance: usize) -> bool {
        let (colon, equal) = (self.peek_at(distance), self.peek_at(distance + 1));
        colon.kind == TokenKind::Colon && equal.kind == TokenKind::Equal && colon.span.end == equal.span.start
    }

    /// The `:=` is taken, so that the colon does not start another statement.
    pub(super) fn colon_equal(&mut self) -> Failure {
        let (colon, equal) = (self.bump(), self.bump());
        let span = Span::cover(colon.span, equal.span);
        Failure(Box::new(
            Diagnostic::error(codes::SYNTAX_ERROR, span, "an assignment is written with `=`")
                .with_fix(Fix::safe("write `=`", vec![Edit::delete(colon.span)])),
        ))
    }

    /// `VEL = P1`: at least one machine in production has such lines, so they are read as `VEL (P1)`.
    pub(super) fn value_behind_equals(&mut self, row: &Row) -> Read<Expr> {
        if self.peek_at(1).kind.ends_statement() {
            return Err(self.expected_after("a value", self.last_read()).help(super::statement::NO_ASSIGNMENT));
        }
        let equals = self.bump().span;
        let value = self.full_expression()?;
        let gap = Span::new(equals.start, value.span.start);
        let stands_alone =
            matches!(value.kind, ExprKind::Integer(_) | ExprKind::Real(_) | ExprKind::String(_) | ExprKind::Paren(_));
        let edits = if stands_alone {
            vec![Edit::delete(gap)]
        } else {
            vec![Edit::replace(gap, "("), Edit::insert(value.span.end, ")")]
        };
        let message = format!("the value of {} follows it without `=`", row.name);
        self.report(
            Diagnostic::warning(codes::EQUALS_AFTER_COMMAND, equals, message)
                .with_help("whether the controller takes it for a value is not documented")
                .with_fix(Fix::unsafe_("remove the `=`", edits)),
        );
        // What is computed stands in parentheses, as the fix would write it.
        Ok(if stands_alone { value } else { Expr { span: value.span, kind: ExprKind::Paren(Box::new(value)) } })
    }

    /// Whether a short word is followed by what neither gives it a target nor starts another statement, and resembles
    /// no command: an axis whose target is wrong.
    pub(super) fn is_move_without_target(&self, token: Token) -> bool {
        let is_no_target = matches!(self.peek_at(1).kind, TokenKind::String | TokenKind::Unknown | TokenKind::Ellipsis);
        is_no_target && acrc_catalog::nearest_command(self.slice(token.span)).is_none()
    }

    /// `NEXT LV0`, `END IF`: ends of blocks as other languages have them.
    pub(super) fn foreign_end(&self, id: CommandId, token: Token) -> Option<Failure> {
        match id {
            command::NEXT => {
                let is_variable = token.kind == TokenKind::Dollar
                    || self.word(token).map_or(token.kind == TokenKind::Word, |word| word.operand.is_some());
                let is_lone = self.peek_at(self.name_length()).kind.ends_statement();
                (is_variable && is_lone).then(|| {
                    let variable = Span::new(token.span.start, self.peek_at(self.name_length() - 1).span.end);
                    let blanks = Span::new(self.consumed_to(), variable.end);
                    Failure(Box::new(Diagnostic::error(codes::SYNTAX_ERROR, variable, "NEXT takes no variable")))
                        .help("it closes the innermost FOR")
                        .fix(Fix::safe("remove the variable", vec![Edit::delete(blanks)]))
                })
            }
            command::END if self.is_word(token, "IF") && self.peek_at(1).kind.ends_statement() => {
                let words = Span::new(self.last_read().start, token.span.end);
                Some(self.refuse("`END IF` closes no block").help("ENDIF is one word").fix(Fix::new(
                    Applicability::Unsafe,
                    "write ENDIF",
                    vec![Edit::replace(words, "ENDIF")],
                )))
            }
            _ => None,
        }
    }
}
