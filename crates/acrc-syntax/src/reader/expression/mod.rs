//! Values and conditions (guide, "Parametric Evaluation").
//!
//! The reader follows the text with a stack of its own, one frame a parenthesis: it decides what each word is, where
//! the expression ends, and collects the operands and operators of each frame. [`ranks`] makes a tree of a frame.

mod ranks;
mod words;

use acrc_catalog::{FunctionId, OperandClass, Operator, UnaryOperator};
use acrc_diagnostics::Span;
use ranks::{Item, Store};

use super::{Failure, Read, Reader};
use crate::ast::{Expr, ExprKind, Operand};
use crate::lexer::{Token, TokenKind};
pub(super) use words::may_be_name;

/// Parentheses and signs that may stand inside each other. A tree that is deeper is refused, so that whoever walks it
/// may do so by recursion.
const MAX_NESTING: usize = 256;
/// Operators in one expression; a row of equal ranks is a tree of that depth.
const MAX_OPERATORS: usize = 256;

/// How far an expression reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Extent {
    /// As long as operators follow: the right side of an assignment, a condition, an item of `PRINT`.
    Full,
    /// One value with its signs: an argument, which is not continued by an operator unless in parentheses.
    Value,
}

/// An open parenthesis.
#[derive(Debug)]
struct Frame {
    context: Context,
    /// First byte of the expression that the closing parenthesis completes.
    start: u32,
    open: Span,
    /// Where its items and operands start in the shared lists.
    items: usize,
    operands: usize,
}

/// What an open parenthesis belongs to.
#[derive(Debug)]
enum Context {
    Group,
    Index(OperandClass),
    Element(OperandClass, Expr),
    Call(FunctionId, Vec<Expr>),
}

/// The lists of the expression that is being read; kept between expressions for their memory.
#[derive(Debug, Default)]
pub(super) struct Work {
    frames: Vec<Frame>,
    items: Vec<Item>,
    store: Store,
    prefixes: usize,
    operators: usize,
    /// An operand must come next, not an operator.
    wants_operand: bool,
}

impl Work {
    fn reset(&mut self) {
        self.frames.clear();
        self.items.clear();
        self.store.truncate(0);
        self.prefixes = 0;
        self.operators = 0;
        self.wants_operand = true;
    }

    fn operand(&mut self, span: Span, kind: ExprKind) {
        let index = self.store.push(Expr { span, kind });
        self.items.push(Item::Operand(index));
        self.wants_operand = false;
    }

    /// The place of the operand that was read last, if it is a name.
    fn last_name(&self) -> Option<Span> {
        let Some(Item::Operand(index)) = self.items.last() else { return None };
        let operand = self.store.get(*index)?;
        (operand.kind == ExprKind::Alias).then_some(operand.span)
    }

    fn open(&mut self, context: Context, start: u32, open: Span) {
        self.frames.push(Frame { context, start, open, items: self.items.len(), operands: self.store.len() });
        self.wants_operand = true;
    }

    /// Makes one expression of the row from `items` on, and removes it from the lists.
    fn reduce(&mut self, items: usize, operands: usize) -> Result<Expr, ranks::Missing> {
        let row = self.items.get(items..).unwrap_or_default();
        let index = ranks::arrange(row, &mut self.store)?;
        let expr = self.store.take(index).ok_or(ranks::Missing::VALUE)?;
        self.items.truncate(items);
        self.store.truncate(operands);
        Ok(expr)
    }
}

impl Reader<'_> {
    /// Reads an expression.
    pub(super) fn expression(&mut self, extent: Extent) -> Read<Expr> {
        if extent == Extent::Value
            && let Some(number) = self.number()
        {
            return Ok(number);
        }
        let mut work = std::mem::take(&mut self.work);
        work.reset();
        let result = self.collect(&mut work, extent);
        self.work = work;
        result
    }

    /// A plain number, the usual argument.
    fn number(&mut self) -> Option<Expr> {
        let token = self.peek();
        let kind = self.number_kind(token)?;
        self.bump();
        Some(Expr { span: token.span, kind })
    }

    fn number_kind(&self, token: Token) -> Option<ExprKind> {
        let slice = self.slice(token.span);
        match token.kind {
            // Only digits: what does not parse is too large.
            TokenKind::Integer => Some(ExprKind::Integer(slice.parse().unwrap_or(u64::MAX))),
            TokenKind::Real => Some(ExprKind::Real(slice.parse().unwrap_or(f64::INFINITY))),
            _ => None,
        }
    }

    fn collect(&mut self, work: &mut Work, extent: Extent) -> Read<Expr> {
        loop {
            let more = if work.wants_operand { self.operand(work)? } else { self.operator(work, extent)? };
            if !more {
                break;
            }
            if work.frames.len() + work.prefixes > MAX_NESTING {
                return Err(self.refuse(format!("the expression is nested deeper than {MAX_NESTING} levels")));
            }
            if work.operators > MAX_OPERATORS {
                return Err(self.refuse(format!("the expression has more than {MAX_OPERATORS} operators")));
            }
        }
        let Some(frame) = work.frames.last() else {
            return work.reduce(0, 0).map_err(|missing| self.missing(missing));
        };
        let (items, operands, open) = (frame.items, frame.operands, frame.open);
        match work.reduce(items, operands) {
            Err(missing) => Err(self.missing(missing)),
            Ok(_) => Err(self.expected("an operator or `)`").related(open, "opened here")),
        }
    }

    fn missing(&self, missing: ranks::Missing) -> Failure {
        let (token, next) = (self.peek(), self.peek_at(1));
        let is_called = next.kind == TokenKind::LeftParen && next.span.start == token.span.end;
        if missing == ranks::Missing::VALUE && token.kind == TokenKind::Word && is_called {
            return self.unknown_function(token.span);
        }
        let failure = self.expected(missing.0);
        match self.word(token) {
            Some(_) if missing == ranks::Missing::VALUE => failure.help("a word of the language is no name of a value"),
            _ => failure,
        }
    }

    /// Reads what can stand where a value is wanted. False when nothing can.
    fn operand(&mut self, work: &mut Work) -> Read<bool> {
        let token = self.peek();
        match token.kind {
            TokenKind::Integer | TokenKind::Real => {
                if let Some(failure) = self.based_number(token) {
                    return Err(failure);
                }
                if let Some(number) = self.number() {
                    work.operand(number.span, number.kind);
                }
            }
            TokenKind::String => {
                self.bump();
                let text = self.string_text(token);
                work.operand(token.span, ExprKind::String(text));
            }
            TokenKind::LeftParen => {
                self.bump();
                work.open(Context::Group, token.span.start, token.span);
            }
            TokenKind::Plus | TokenKind::Minus | TokenKind::Dash => {
                self.bump();
                let plus = token.kind == TokenKind::Plus;
                let operator = if plus { UnaryOperator::Plus } else { UnaryOperator::Minus };
                work.items.push(Item::Prefix(operator, token.span));
                work.prefixes += 1;
            }
            TokenKind::Word => return self.word_operand(work, token),
            TokenKind::Dollar => return self.dollar_operand(work, token),
            TokenKind::RightParen => return Ok(self.close_empty_call(work)),
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Reads what can follow a value. False when the expression ends before it.
    fn operator(&mut self, work: &mut Work, extent: Extent) -> Read<bool> {
        if extent == Extent::Value && work.frames.is_empty() {
            return Ok(false);
        }
        let token = self.peek();
        match token.kind {
            TokenKind::RightParen => self.close(work),
            TokenKind::Comma => self.next_argument(work),
            TokenKind::LeftParen => match work.last_name() {
                Some(name) => Err(self.unknown_function(name)),
                None => Ok(false),
            },
            _ => {
                let Some(operator) = self.infix_operator(token) else { return Ok(false) };
                self.bump();
                work.items.push(Item::Infix(operator, token.span));
                work.operators += 1;
                work.wants_operand = true;
                Ok(true)
            }
        }
    }

    /// The operator that a token is between two values.
    pub(super) fn infix_operator(&self, token: Token) -> Option<Operator> {
        Some(match token.kind {
            TokenKind::Plus => Operator::Add,
            TokenKind::Minus | TokenKind::Dash => Operator::Sub,
            TokenKind::Star => Operator::Mul,
            TokenKind::Slash => Operator::Div,
            TokenKind::StarStar | TokenKind::Caret => Operator::Pow,
            TokenKind::Equal => Operator::Eq,
            TokenKind::NotEqual => Operator::Ne,
            TokenKind::Less => Operator::Lt,
            TokenKind::LessEqual => Operator::Le,
            TokenKind::Greater => Operator::Gt,
            TokenKind::GreaterEqual => Operator::Ge,
            TokenKind::ShiftLeft => Operator::Shl,
            TokenKind::ShiftRight => Operator::Shr,
            TokenKind::Word => return self.word(token)?.operator,
            _ => return None,
        })
    }

    /// A closing parenthesis completes what its opening one belongs to.
    fn close(&mut self, work: &mut Work) -> Read<bool> {
        let Some(frame) = work.frames.last() else { return Ok(false) };
        let inner = work.reduce(frame.items, frame.operands).map_err(|missing| self.missing(missing))?;
        let Some(frame) = work.frames.pop() else { return Ok(false) };
        let close = self.bump();
        let span = Span::new(frame.start, close.span.end);
        let group =
            |inner| Expr { span: Span::new(frame.open.start, close.span.end), kind: ExprKind::Paren(Box::new(inner)) };
        match frame.context {
            Context::Group => work.operand(span, ExprKind::Paren(Box::new(inner))),
            Context::Index(class) => self.indexed(work, class, frame.start, group(inner)),
            Context::Element(class, index) => {
                let operand = Operand { class, index, element: Some(inner) };
                work.operand(span, ExprKind::Operand(Box::new(operand)));
            }
            Context::Call(function, mut arguments) => {
                arguments.push(inner);
                work.operand(span, ExprKind::Call(function, arguments));
            }
        }
        Ok(true)
    }

    /// A class with its number: complete, unless it is an array and an element follows.
    fn indexed(&mut self, work: &mut Work, class: OperandClass, start: u32, index: Expr) {
        let next = self.peek();
        if class.is_array() && next.kind == TokenKind::LeftParen {
            self.bump();
            work.open(Context::Element(class, index), start, next.span);
        } else {
            let span = Span::new(start, index.span.end);
            let operand = Operand { class, index, element: None };
            work.operand(span, ExprKind::Operand(Box::new(operand)));
        }
    }

    /// A comma between the arguments of a function. False when it belongs to no function.
    fn next_argument(&mut self, work: &mut Work) -> Read<bool> {
        let Some(Frame { context: Context::Call(..), items, operands, .. }) = work.frames.last() else {
            return Ok(false);
        };
        let argument = work.reduce(*items, *operands).map_err(|missing| self.missing(missing))?;
        if let Some(Frame { context: Context::Call(_, arguments), .. }) = work.frames.last_mut() {
            arguments.push(argument);
        }
        self.bump();
        work.wants_operand = true;
        Ok(true)
    }

    /// `TIME$()`
    fn close_empty_call(&mut self, work: &mut Work) -> bool {
        let is_empty = matches!(
            work.frames.last(),
            Some(Frame { context: Context::Call(_, arguments), items, .. })
                if arguments.is_empty() && *items == work.items.len()
        );
        if is_empty && let Some(Frame { context: Context::Call(function, arguments), start, .. }) = work.frames.pop() {
            let close = self.bump();
            work.operand(Span::new(start, close.span.end), ExprKind::Call(function, arguments));
        }
        is_empty
    }

    /// The text between the quotes of a string. A string without its closing quote is reported and taken to the end of
    /// its line.
    pub(super) fn string_text(&mut self, token: Token) -> Span {
        let slice = self.slice(token.span);
        let mut characters = slice.chars();
        let opening = characters.next().map_or(0, char::len_utf8) as u32;
        let closing = characters.next_back().filter(|&last| crate::lexer::is_quote(last));
        let start = token.span.start + opening;
        match closing {
            Some(last) => Span::new(start, token.span.end - last.len_utf8() as u32),
            None => {
                self.report_unterminated(token);
                Span::new(start, token.span.end)
            }
        }
    }
}
