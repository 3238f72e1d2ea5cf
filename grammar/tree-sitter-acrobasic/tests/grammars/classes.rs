//! What each token is for the compiler.

use std::fmt::Write as _;

use acrc_diagnostics::{LineIndex, Span};
use acrc_syntax::Tree;
use acrc_syntax::ast::{Argument, Axis, Expr, ExprKind, Object, Operand, Statement, StatementKind, Target};
use acrc_syntax::lexer::{Token, TokenKind};

use crate::programs::Program;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Class {
    /// A command, a daughter, an object or another word of the language.
    Keyword,
    Number,
    String,
    Comment,
    Label,
    /// A sign, a comparison, an assignment, the slash of an incremental target.
    Operator,
    /// An operator that is a word.
    OperatorWord,
    /// The word of a parameter.
    Parameter,
    /// The word of a flag.
    Bit,
    /// The word of another class of variable.
    Variable,
    Function,
    /// An alias or an axis.
    Name,
    Punctuation,
}

/// The class of each token of the statements that could be read, in order.
pub(crate) fn of(tree: &Tree) -> Vec<(Span, Class)> {
    let mut classes = Classes { tree, marks: Vec::new() };
    for statement in tree.statements() {
        classes.statement(statement);
    }
    let mut marks = classes.marks;
    marks.extend(tree.lines().iter().filter_map(|line| line.number).map(|number| (number.span, Some(Class::Label))));
    marks.sort_by_key(|(span, _)| span.start);
    let mut found: Vec<(Span, Class)> = Vec::new();
    for token in tree.tokens() {
        let at = marks.partition_point(|(span, _)| span.start <= token.span.start);
        let mark = at.checked_sub(1).and_then(|at| marks.get(at)).filter(|(span, _)| token.span.start < span.end);
        match mark {
            // A name may be cut into several tokens.
            Some((span, Some(class))) if found.last().is_none_or(|(last, _)| last != span) => {
                found.push((*span, *class));
            }
            Some(_) => {}
            None => found.extend(plain(*token).map(|class| (token.span, class))),
        }
    }
    found
}

/// Compares what a grammar says about each byte of programs with the class that the compiler has for each token.
pub(crate) fn compare(
    programs: impl IntoIterator<Item = Program>,
    mut classify: impl FnMut(&str) -> Vec<Option<Class>>,
) {
    let mut wrong = String::new();
    let mut compared = 0;
    for Program { name, text } in programs {
        let found = classify(&text);
        let lines = LineIndex::new(&text);
        for (span, class) in of(&acrc_syntax::parse(&text)) {
            // Blanks around a remark are of no class.
            let slice = &text[span.range()];
            let end = span.start as usize + slice.trim_end().len();
            let start = end - slice.trim().len();
            compared += 1;
            if found[start..end].iter().any(|byte| *byte != Some(class)) {
                let line = lines.position(span.start).line;
                let _ = writeln!(wrong, "{name}:{line}: `{slice}` is {class:?}, not {:?}", &found[start..end]);
            }
        }
    }
    assert!(compared > 3000, "only {compared} tokens were compared");
    assert!(wrong.is_empty(), "{wrong}");
}

/// What a token is that no statement says more about.
fn plain(token: Token) -> Option<Class> {
    Some(match token.kind {
        TokenKind::Word | TokenKind::Dollar | TokenKind::Question => Class::Keyword,
        TokenKind::Integer | TokenKind::Real => Class::Number,
        TokenKind::String => Class::String,
        TokenKind::Comment | TokenKind::RemarkText => Class::Comment,
        TokenKind::Underscore => Class::Label,
        TokenKind::Colon
        | TokenKind::Semicolon
        | TokenKind::Comma
        | TokenKind::Hash
        | TokenKind::LeftParen
        | TokenKind::RightParen => Class::Punctuation,
        TokenKind::Newline | TokenKind::Unknown | TokenKind::Ellipsis | TokenKind::End | TokenKind::Blank => {
            return None;
        }
        TokenKind::NoBreakSpace => return None,
        _ => Class::Operator,
    })
}

struct Classes<'t> {
    tree: &'t Tree,
    /// Spans with their class; without one what could not be read.
    marks: Vec<(Span, Option<Class>)>,
}

impl Classes<'_> {
    fn mark(&mut self, span: Span, class: Class) {
        self.marks.push((span, Some(class)));
    }

    /// Marks the token that starts at a place.
    fn mark_token(&mut self, start: u32, class: Class) {
        let tokens = self.tree.tokens();
        let at = tokens.partition_point(|token| token.span.start < start);
        if let Some(token) = tokens.get(at) {
            self.mark(token.span, class);
        }
    }

    fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Remark(_) => self.mark_token(statement.span.start, Class::Comment),
            StatementKind::Label(label) => self.mark(label.name, Class::Label),
            StatementKind::Assign(assign) => self.exprs([&assign.target, &assign.value]),
            StatementKind::If(head) => self.expr(&head.condition),
            StatementKind::For(head) => {
                self.exprs([&head.variable, &head.start, &head.end].into_iter().chain(&head.step));
            }
            StatementKind::Print(print) => {
                let items = print.items.iter().map(|item| &item.value);
                self.exprs(print.device.iter().chain(&print.using).chain(items));
            }
            StatementKind::Input(input) => {
                self.exprs(input.device.iter().chain(&input.variables));
            }
            StatementKind::Dim(dim) => self.exprs(dim.index.iter().chain(&dim.sizes)),
            StatementKind::Define(define) => {
                self.mark_token(statement.span.start, Class::Keyword);
                self.mark(define.name, Class::Name);
                self.expr(&define.operand);
            }
            StatementKind::Command(command) => {
                for argument in &command.arguments {
                    self.argument(argument);
                }
            }
            StatementKind::Error => self.marks.push((statement.span, None)),
        }
    }

    fn argument(&mut self, argument: &Argument) {
        match argument {
            Argument::Value(expr) | Argument::Device(expr) => self.expr(expr),
            Argument::Tuple(tuple) => self.exprs(&tuple.values),
            Argument::Axis(Axis { name, value, .. }) => {
                self.mark(*name, Class::Name);
                self.value(value.as_deref());
            }
            Argument::Object(Object { value, .. }) => self.value(value.as_deref()),
            Argument::Bit(bit) => {
                if bit.keyword {
                    let sign = bit.span.start + u32::from(self.is_sign(bit.span.start));
                    self.mark_token(sign, Class::Bit);
                }
                self.expr(&bit.index);
            }
            Argument::Target(Target::Label(span)) => self.mark(*span, Class::Label),
            Argument::Target(Target::Line(..)) | Argument::Word(_) | Argument::Interpolation(..) => {}
        }
    }

    fn is_sign(&self, start: u32) -> bool {
        self.tree.tokens().iter().any(|token| token.span.start == start && token.kind.is_sign())
    }

    fn value(&mut self, value: Option<&Argument>) {
        if let Some(value) = value {
            self.argument(value);
        }
    }

    fn exprs<'e>(&mut self, exprs: impl IntoIterator<Item = &'e Expr>) {
        for expr in exprs {
            self.expr(expr);
        }
    }

    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Alias => self.mark(expr.span, Class::Name),
            ExprKind::Operand(operand) => self.operand(expr.span.start, operand),
            ExprKind::Paren(inner) => self.expr(inner),
            ExprKind::Unary(operator, operand) => {
                if operator.name().starts_with(char::is_alphabetic) {
                    self.mark_token(expr.span.start, Class::OperatorWord);
                }
                self.expr(operand);
            }
            ExprKind::Binary(operator, place, sides) => {
                if operator.name().starts_with(char::is_alphabetic) {
                    self.mark(*place, Class::OperatorWord);
                }
                self.exprs(sides.iter());
            }
            ExprKind::Call(function, arguments) => {
                let length = function.info().name.len() as u32;
                self.mark(Span::new(expr.span.start, expr.span.start + length), Class::Function);
                self.exprs(arguments);
            }
            ExprKind::Integer(_) | ExprKind::Real(_) | ExprKind::String(_) | ExprKind::Error => {}
        }
    }

    fn operand(&mut self, start: u32, operand: &Operand) {
        let class = match operand.class.name() {
            "P" => Class::Parameter,
            "BIT" => Class::Bit,
            _ => Class::Variable,
        };
        self.mark_token(start, class);
        self.exprs(std::iter::once(&operand.index).chain(&operand.element));
    }
}
