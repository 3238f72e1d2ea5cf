//! What the tree knows about single tokens: which are names, and between which no blank belongs.
//!
//! A token tells by its kind how it is set off from its neighbours, with few exceptions: `-` before a value is a sign,
//! a parenthesis behind a function belongs to it, a number behind an axis is its target. The exceptions are collected
//! here, in one walk over a statement.

use acrc_catalog::{Shape, UnaryOperator, command};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{
    Argument, Axis, BitArgument, Command, Dim, Expr, ExprKind, Input, Object, Operand, Print, Separator, Statement,
    StatementKind, Target,
};
use acrc_syntax::lexer::{Token, TokenKind};

/// The exceptions of one token.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Mark(u8);

impl Mark {
    /// A name, or a part of one: its case is not changed.
    pub(crate) const NAME: Self = Self(1);
    /// No blank stands before it.
    pub(crate) const TIGHT: Self = Self(2);
    /// No blank stands behind it.
    pub(crate) const SIGN: Self = Self(4);

    pub(crate) const fn has(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    fn add(&mut self, other: Self) {
        self.0 |= other.0;
    }
}

/// Marks the tokens of a line. It is given the statements in the order of the text.
pub(crate) struct Marker<'t> {
    tokens: &'t [Token],
    marks: &'t mut Vec<Mark>,
    /// Index of the token that was looked up last.
    place: usize,
    /// Start of a statement that stands behind a `NEXT` without a colon.
    behind_next: Option<u32>,
    /// The statement before was a `NEXT`.
    was_next: bool,
}

impl<'t> Marker<'t> {
    /// Starts with the tokens of a line; `marks` gets one mark for each.
    pub(crate) fn new(tokens: &'t [Token], marks: &'t mut Vec<Mark>) -> Self {
        marks.clear();
        marks.resize(tokens.len(), Mark::default());
        Self { tokens, marks, place: 0, behind_next: None, was_next: false }
    }

    /// Marks the tokens of a statement.
    pub(crate) fn statement(&mut self, statement: &Statement) {
        let follows_next = self.was_next && statement.separator == Separator::Blank;
        self.behind_next = follows_next.then_some(statement.span.start);
        self.was_next = matches!(&statement.kind, StatementKind::Command(next) if next.id == command::NEXT);
        match &statement.kind {
            StatementKind::Remark(_) | StatementKind::Error => {}
            StatementKind::Label(label) => {
                if !label.detached {
                    self.mark(label.name.start, Mark::TIGHT);
                }
                self.name(label.name);
            }
            StatementKind::Assign(assign) => self.exprs([&assign.target, &assign.value]),
            StatementKind::If(head) => self.expr(&head.condition),
            StatementKind::For(head) => {
                self.exprs([&head.variable, &head.start, &head.end]);
                self.exprs(&head.step);
            }
            StatementKind::Print(print) => self.print(print),
            StatementKind::Input(input) => self.input(input),
            StatementKind::Dim(dim) => self.dim(dim),
            StatementKind::Define(define) => {
                self.name(define.name);
                self.expr(&define.operand);
            }
            StatementKind::Command(command) => self.command(command),
        }
    }

    /// Index of the token that starts at `offset`, or of the first one behind it.
    pub(crate) fn find(&mut self, offset: u32) -> usize {
        // The next token is nearly always close ahead.
        const NEAR: usize = 8;
        let ahead = self.tokens.get(self.place..).unwrap_or_default();
        let is_behind = ahead.first().is_none_or(|token| token.span.start > offset);
        let near = ahead.iter().take(NEAR).position(|token| token.span.start >= offset);
        self.place = match near {
            Some(distance) if !is_behind => self.place + distance,
            _ => self.tokens.partition_point(|token| token.span.start < offset),
        };
        self.place
    }

    fn kind(&self, index: usize) -> Option<TokenKind> {
        self.tokens.get(index).map(|token| token.kind)
    }

    fn mark_at(&mut self, index: usize, mark: Mark) {
        if let Some(place) = self.marks.get_mut(index) {
            place.add(mark);
        }
    }

    fn mark(&mut self, offset: u32, mark: Mark) {
        let index = self.find(offset);
        self.mark_at(index, mark);
    }

    /// The parenthesis before the expression at `offset` stands directly behind its word.
    fn tight_parenthesis_before(&mut self, offset: u32) {
        let inner = self.find(offset);
        if let Some(index) = inner.checked_sub(1).filter(|&index| self.kind(index) == Some(TokenKind::LeftParen)) {
            self.mark_at(index, Mark::TIGHT);
        }
    }

    /// A name may consist of several tokens, which touch.
    fn name(&mut self, span: Span) {
        let mut index = self.find(span.start);
        self.mark_at(index, Mark::NAME);
        index += 1;
        while self.tokens.get(index).is_some_and(|token| token.span.start < span.end) {
            self.mark_at(index, Mark::NAME);
            self.mark_at(index, Mark::TIGHT);
            index += 1;
        }
    }

    /// The words of a command: a number in them touches its word (`CLEAR COM1`).
    fn words(&mut self, span: Span) {
        let mut index = self.find(span.start);
        while self.tokens.get(index).is_some_and(|token| token.span.start < span.end) {
            if self.kind(index) == Some(TokenKind::Integer) {
                self.mark_at(index, Mark::TIGHT);
            }
            index += 1;
        }
    }

    fn print(&mut self, print: &Print) {
        self.exprs(&print.device);
        self.exprs(&print.using);
        self.exprs(print.items.iter().map(|item| &item.value));
    }

    fn input(&mut self, input: &Input) {
        self.exprs(&input.device);
        self.exprs(input.prompt.as_ref().map(|(prompt, _)| prompt));
        self.exprs(&input.variables);
    }

    fn dim(&mut self, dim: &Dim) {
        self.words(dim.name);
        if let Some(index) = &dim.index {
            self.index(index);
        }
        if let (true, Some(first)) = (dim.parenthesised, dim.sizes.first()) {
            self.tight_parenthesis_before(first.span.start);
        }
        self.exprs(&dim.sizes);
    }

    fn command(&mut self, command: &Command) {
        if let Some(prefix) = &command.prefix {
            self.object(prefix);
        }
        self.words(command.name);
        let is_numbered = command.id.info().shape == Shape::Index;
        for argument in &command.arguments {
            if let (true, Argument::Value(value)) = (is_numbered, argument) {
                self.index(value);
            } else {
                self.argument(argument);
            }
        }
    }

    fn argument(&mut self, argument: &Argument) {
        match argument {
            Argument::Value(value) | Argument::Device(value) => self.expr(value),
            Argument::Tuple(tuple) => self.exprs(&tuple.values),
            Argument::Axis(axis) => self.axis(axis),
            Argument::Object(object) => self.object(object),
            Argument::Bit(bit) => self.bit(bit),
            Argument::Word(word) => self.words(word.span),
            Argument::Target(Target::Label(name)) => self.name(*name),
            Argument::Target(Target::Line(..)) | Argument::Interpolation(..) => {}
        }
    }

    /// `X5`, `X-5`, `X(P0)`, `X/5`, but `X P0`: a value that starts with a letter stands apart.
    fn axis(&mut self, axis: &Axis) {
        self.name(axis.name);
        self.slash(axis.slash);
        let Some(value) = axis.value.as_deref() else { return };
        // `NEXT X 5` is a loop's end and a move, but `NEXT X5` is taken for the `NEXT` of another language.
        let is_loose = self.behind_next == Some(axis.span.start);
        match value {
            Argument::Value(expr) if is_closed(expr) && !is_loose => self.mark(expr.span.start, Mark::TIGHT),
            Argument::Tuple(tuple) => self.mark(tuple.span.start, Mark::TIGHT),
            _ => {}
        }
        self.argument(value);
    }

    /// `AXIS0`, `AXIS0/5`
    fn object(&mut self, object: &Object) {
        self.words(object.name);
        self.slash(object.slash);
        if let Some(value) = object.value.as_deref() {
            self.argument(value);
        }
    }

    fn slash(&mut self, slash: Option<Span>) {
        if let Some(slash) = slash {
            self.mark(slash.start, Mark::TIGHT);
            self.mark(slash.start, Mark::SIGN);
        }
    }

    fn bit(&mut self, bit: &BitArgument) {
        let first = self.find(bit.span.start);
        if self.kind(first).is_some_and(TokenKind::is_sign) {
            self.mark_at(first, Mark::SIGN);
        }
        if bit.keyword {
            self.index(&bit.index);
        } else {
            self.expr(&bit.index);
        }
    }

    /// The number behind a word: `P0`, `P(LV0)`, `PROG1`, `BIT24`.
    fn index(&mut self, index: &Expr) {
        if matches!(index.kind, ExprKind::Integer(_) | ExprKind::Paren(_)) {
            self.mark(index.span.start, Mark::TIGHT);
        }
        self.expr(index);
    }

    fn exprs<'e>(&mut self, exprs: impl IntoIterator<Item = &'e Expr>) {
        for expr in exprs {
            self.expr(expr);
        }
    }

    /// The reader limits the depth of expressions, so recursion is safe.
    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Integer(_) | ExprKind::Real(_) | ExprKind::String(_) | ExprKind::Error => {}
            ExprKind::Operand(operand) => self.operand(operand),
            ExprKind::Alias => self.name(expr.span),
            ExprKind::Paren(inner) => self.expr(inner),
            ExprKind::Unary(operator, operand) => {
                if *operator != UnaryOperator::Not {
                    self.mark(expr.span.start, Mark::SIGN);
                }
                self.expr(operand);
            }
            ExprKind::Binary(_, _, operands) => self.exprs(operands.iter()),
            ExprKind::Call(_, arguments) => {
                self.call(expr.span);
                self.exprs(arguments);
            }
        }
    }

    fn operand(&mut self, operand: &Operand) {
        self.index(&operand.index);
        if let Some(element) = &operand.element {
            self.tight_parenthesis_before(element.span.start);
            self.expr(element);
        }
    }

    /// `SIN(`, `CHR$(`
    fn call(&mut self, span: Span) {
        let mut index = self.find(span.start) + 1;
        for kind in [TokenKind::Dollar, TokenKind::LeftParen] {
            let token = self.tokens.get(index);
            if token.is_some_and(|token| token.kind == kind && token.span.start < span.end) {
                self.mark_at(index, Mark::TIGHT);
                index += 1;
            }
        }
    }
}

/// Whether a value shows by its first character where it starts: a number with its sign, or a parenthesis.
fn is_closed(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Integer(_) | ExprKind::Real(_) | ExprKind::Paren(_) => true,
        ExprKind::Unary(operator, operand) => *operator != UnaryOperator::Not && is_closed(operand),
        _ => false,
    }
}
