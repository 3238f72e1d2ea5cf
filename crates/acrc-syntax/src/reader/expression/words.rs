//! What a word is in an expression: a variable, a function, an operator or a name.

use acrc_catalog::{FunctionId, OperandClass, Word};
use acrc_diagnostics::Span;

use super::{Context, Item, Work};
use crate::ast::{Expr, ExprKind};
use crate::lexer::{Token, TokenKind};
use crate::reader::{Read, Reader};

impl Reader<'_> {
    /// A word where a value is wanted. False when it is none.
    pub(super) fn word_operand(&mut self, work: &mut Work, token: Token) -> Read<bool> {
        let word = self.word(token);
        if let Some(operator) = word.and_then(|word| word.unary) {
            self.bump();
            work.items.push(Item::Prefix(operator, token.span));
            work.prefixes += 1;
        } else if let Some(class) = word.and_then(|word| word.operand) {
            self.bump();
            self.operand_index(work, class, token)?;
        } else if let Some((function, words)) = self.function(token, word) {
            self.skip(words);
            self.call(work, function, token)?;
        } else if word.as_ref().is_none_or(may_be_name) {
            let span = self.name();
            work.operand(span, ExprKind::Alias);
        } else {
            return Ok(false);
        }
        Ok(true)
    }

    /// `$V0`, `$A0(1)`. False for any other `$`.
    pub(super) fn dollar_operand(&mut self, work: &mut Work, token: Token) -> Read<bool> {
        let Some(class) = self.dollar_class(token) else { return Ok(false) };
        self.bump();
        self.operand_index(work, class, token)?;
        Ok(true)
    }

    /// The class that `$V` and `$A` name.
    pub(in crate::reader) fn dollar_class(&self, token: Token) -> Option<OperandClass> {
        if token.kind != TokenKind::Dollar {
            return None;
        }
        let named = |class: &&OperandClass| class.name().eq_ignore_ascii_case(self.slice(token.span));
        [OperandClass::StringV, OperandClass::StringA].iter().find(named).copied()
    }

    /// The number behind a class, or the expression that gives it.
    fn operand_index(&mut self, work: &mut Work, class: OperandClass, head: Token) -> Read<()> {
        let next = self.peek();
        match next.kind {
            TokenKind::Integer => {
                if let Some(index) = self.number() {
                    self.indexed(work, class, head.span.start, index);
                }
                Ok(())
            }
            TokenKind::LeftParen => {
                self.bump();
                work.open(Context::Index(class), head.span.start, next.span);
                Ok(())
            }
            _ => Err(self.expected("a number or `(`")),
        }
    }

    /// The function that a word names, with the `$` that may belong to it, and the number of its tokens.
    fn function(&self, token: Token, word: Option<Word>) -> Option<(FunctionId, usize)> {
        let next = self.peek_at(1);
        if next.kind == TokenKind::Dollar && next.span.start == token.span.end && next.span.len() == 1 {
            let name = self.slice(Span::cover(token.span, next.span));
            if let Some(function) = acrc_catalog::word(name).and_then(|word| word.function) {
                return Some((function, 2));
            }
        }
        word.and_then(|word| word.function).map(|function| (function, 1))
    }

    /// The parenthesis behind a function. One without arguments needs none.
    fn call(&mut self, work: &mut Work, function: FunctionId, head: Token) -> Read<()> {
        let next = self.peek();
        if next.kind == TokenKind::LeftParen {
            self.bump();
            work.open(Context::Call(function, Vec::new()), head.span.start, next.span);
            Ok(())
        } else if function.info().min_args == 0 {
            let span = Span::new(head.span.start, self.consumed_to());
            work.operand(span, ExprKind::Call(function, Vec::new()));
            Ok(())
        } else {
            Err(self.expected("`(`"))
        }
    }

    /// Whether an expression can start with the next token.
    pub(in crate::reader) fn starts_value(&self) -> bool {
        let token = self.peek();
        match token.kind {
            TokenKind::Integer | TokenKind::Real | TokenKind::String | TokenKind::LeftParen => true,
            TokenKind::Dollar => self.dollar_class(token).is_some(),
            TokenKind::Word => {
                let word = self.word(token);
                word.as_ref().is_none_or(may_be_name)
                    || word.is_some_and(|word| word.unary.is_some())
                    || self.is_operand_or_function(token, word)
            }
            kind => kind.is_sign(),
        }
    }

    /// Whether the next token is a variable or a function: a value without the doubt that a name leaves.
    pub(in crate::reader) fn is_operand_or_function(&self, token: Token, word: Option<Word>) -> bool {
        word.is_some_and(|word| word.operand.is_some())
            || self.dollar_class(token).is_some()
            || self.function(token, word).is_some()
    }

    /// A value that a command takes as it stands: `5`, `-5`, `(P0+1)`, `P0`, `Speed`.
    pub(in crate::reader) fn value(&mut self) -> Read<Expr> {
        self.expression(super::Extent::Value)
    }

    /// An expression with all its operators.
    pub(in crate::reader) fn full_expression(&mut self) -> Read<Expr> {
        self.expression(super::Extent::Full)
    }
}

/// Whether a word that the catalogue knows may still be an alias: daughters are no words of their own.
pub(in crate::reader) fn may_be_name(word: &Word) -> bool {
    word.command.is_none()
        && word.object.is_none()
        && word.function.is_none()
        && word.operator.is_none()
        && word.unary.is_none()
        && word.operand.is_none()
        && word.keyword.is_none()
}
