//! Tokens to lines and statements.
//!
//! The reader is driven by the catalogue: it takes the longest command name at the start of a statement, and the shape
//! of the row says which arguments may follow ([`arguments`]). A statement ends at the end of the line, at a colon, or
//! where its arguments are complete and another one can start. Whatever can't be read becomes one error statement, up
//! to the next colon or the end of the line.

mod arguments;
mod command;
mod cursor;
mod expression;
mod failure;
mod flow;
mod memory;
mod mistakes;
mod motion;
mod output;
mod repair;
mod statement;
mod typography;

use acrc_diagnostics::{Applicability, Diagnostic, Edit, Fix, Severity, Span};
use expression::Work;
use failure::{Failure, Read};

use crate::ast::{Line, LineNumber, Separator, Statement, StatementKind};
use crate::codes;
use crate::lexer::{Lexed, Token, TokenKind};
use crate::tree::Tree;

/// What is read and what came of it.
pub(crate) struct Reader<'t> {
    text: &'t str,
    tokens: &'t [Token],
    position: usize,
    /// What is left of the next token after its front was taken.
    split: Option<Token>,
    /// The token that was taken last.
    previous: Span,
    /// Position at which the present statement starts.
    statement_start: usize,
    /// What could still follow in the present statement, and the words behind which it would stand.
    wanted: (&'static str, Option<Span>),
    work: Work,
    lines: Vec<Line>,
    statements: Vec<Statement>,
    errors: Vec<Diagnostic>,
    /// Tokens that were cut in two: their positions and where.
    cuts: Vec<(usize, u32)>,
    /// Tokens that turned out to be the text of a remark.
    remarks: Vec<(std::ops::Range<usize>, Span)>,
}

/// Reads a whole text.
pub(crate) fn read(text: &str, lexed: Lexed) -> Tree {
    let mut reader = Reader::new(text, &lexed.tokens);
    reader.all_lines();
    reader.report_typography(&lexed.typographic);
    let Reader { mut lines, mut statements, mut errors, cuts, remarks, .. } = reader;
    errors.sort_by_key(|error| error.span.start);
    let mut tokens = repair::tokens(lexed.tokens, &cuts, &remarks);
    // Trees live long and are many.
    tokens.shrink_to_fit();
    lines.shrink_to_fit();
    statements.shrink_to_fit();
    errors.shrink_to_fit();
    Tree { tokens, lines, statements, errors }
}

/// Reads one expression that is the whole text, up to its end.
pub(crate) fn read_expression(text: &str, lexed: &Lexed) -> (crate::ast::Expr, Vec<Diagnostic>) {
    let mut reader = Reader::new(text, &lexed.tokens);
    let result = reader.full_expression().and_then(|expr| {
        if reader.peek().kind == TokenKind::End { Ok(expr) } else { Err(reader.expected("an operator")) }
    });
    let expr = result.unwrap_or_else(|failure| {
        reader.settle(0, failure);
        crate::ast::Expr { span: Span::new(0, text.len() as u32), kind: crate::ast::ExprKind::Error }
    });
    reader.report_typography(&lexed.typographic);
    (expr, reader.errors)
}

impl<'t> Reader<'t> {
    fn new(text: &'t str, tokens: &'t [Token]) -> Self {
        Self {
            text,
            tokens,
            position: 0,
            split: None,
            previous: Span::default(),
            statement_start: 0,
            wanted: (statement::END, None),
            work: Work::default(),
            lines: Vec::with_capacity(text.len() / 24 + 1),
            statements: Vec::with_capacity(text.len() / 24 + 1),
            errors: Vec::new(),
            cuts: Vec::new(),
            remarks: Vec::new(),
        }
    }

    fn all_lines(&mut self) {
        let mut start = 0;
        loop {
            self.line(start);
            let end = self.bump();
            if end.kind != TokenKind::Newline {
                return;
            }
            start = end.span.end;
        }
    }

    /// Reads a line up to its line break.
    fn line(&mut self, start: u32) {
        let first = self.statements.len() as u32;
        let number = self.line_number();
        let mut separator = Separator::Line;
        let mut comment = None;
        loop {
            let token = self.peek();
            match token.kind {
                TokenKind::Newline | TokenKind::End => break,
                TokenKind::Comment => {
                    comment = Some(token.span);
                    if self.statements.len() as u32 > first {
                        self.report_late_comment(token, first);
                    }
                    self.bump();
                }
                TokenKind::Colon => {
                    self.bump();
                    if separator == Separator::Blank {
                        separator = Separator::Colon;
                    }
                }
                _ => {
                    self.statement(separator, first);
                    separator = self.separator_behind();
                }
            }
        }
        if separator == Separator::Then {
            // The statement stays an `IF`, so that the block that was probably meant is not lost.
            let failure = self.expected("a statement").help("leave `THEN` out where a block of lines follows");
            self.report(*failure.0);
        }
        self.lines.push(Line {
            span: Span::new(start, self.peek().span.start),
            number,
            statements: first..self.statements.len() as u32,
            comment,
        });
    }

    fn line_number(&mut self) -> Option<LineNumber> {
        let token = self.accept(TokenKind::Integer)?;
        Some(LineNumber { value: self.slice(token.span).parse().unwrap_or(u32::MAX), span: token.span })
    }

    /// How the next statement is set off from the one that was just read.
    fn separator_behind(&self) -> Separator {
        match self.statements.last().map(|statement| &statement.kind) {
            Some(StatementKind::If(head)) if head.then.is_some() => Separator::Then,
            _ => Separator::Blank,
        }
    }

    /// Reads one statement; `line_start` is the index of the first one of its line.
    fn statement(&mut self, separator: Separator, line_start: u32) {
        let start = self.peek().span.start;
        let before = self.consumed_to();
        let mark = self.errors.len();
        self.statement_start = self.position;
        self.wanted = (statement::END, None);
        let read = match self.statement_kind() {
            Ok(_) if self.position == self.statement_start => Err(self.expected("a statement")),
            read => read,
        };
        let leftover = read.as_ref().ok().and_then(|kind| self.leftover(kind));
        let (kind, behind) = match (read, leftover) {
            (Ok(kind), None) => (kind, None),
            // The arguments are complete: what follows them is broken, not the statement.
            (Ok(kind), Some(failure)) if self.wanted.0 == statement::END => (kind, Some(failure)),
            (Err(failure), _) | (Ok(_), Some(failure)) => {
                self.settle(mark, failure);
                self.recover();
                (StatementKind::Error, None)
            }
        };
        if matches!(kind, StatementKind::Remark(_)) {
            self.check_remark(separator, start, before, line_start);
        }
        self.push(start, separator, kind);
        if let Some(failure) = behind {
            let start = self.peek().span.start;
            self.report(*failure.0);
            self.recover();
            self.push(start, Separator::Blank, StatementKind::Error);
        }
    }

    fn push(&mut self, start: u32, separator: Separator, kind: StatementKind) {
        self.statements.push(Statement { span: Span::new(start, self.consumed_to()), separator, kind });
    }

    /// A statement that could not be read has one diagnostic: an error that was already reported for it, else the
    /// failure itself.
    fn settle(&mut self, mark: usize, failure: Failure) {
        let reported = self.errors.get(mark..).unwrap_or_default();
        let first = reported.iter().find(|error| error.severity == Severity::Error).cloned();
        self.errors.truncate(mark);
        self.report(first.unwrap_or(*failure.0));
    }

    /// Passes over the rest of a statement that could not be read.
    fn recover(&mut self) {
        while !self.peek().kind.ends_statement() {
            let starts_remark = self.is_word(self.peek(), "REM") && !self.touches(self.peek());
            if starts_remark && self.position > self.statement_start {
                return;
            }
            self.bump();
        }
    }

    fn check_remark(&mut self, separator: Separator, start: u32, before: u32, line_start: u32) {
        let word = Span::new(start, start + 3);
        let on_this_line = self.statements.get(line_start as usize..).unwrap_or_default();
        if separator == Separator::Blank {
            let fix = Fix::safe("insert a colon before the remark", vec![Edit::insert(before, " :")]);
            self.report(
                Diagnostic::warning(codes::REMARK_WITHOUT_COLON, word, "no colon between the statement and its remark")
                    .with_help("write ` : REM`")
                    .with_fix(fix),
            );
        } else if on_this_line.iter().any(|statement| matches!(statement.kind, StatementKind::Label(_))) {
            self.report(
                Diagnostic::advice(codes::REMARK_ON_LABEL_LINE, word, "a remark stands on the line of a label")
                    .with_help("put the remark on a line of its own"),
            );
        }
    }

    fn report_late_comment(&mut self, token: Token, line_start: u32) {
        let text = self.slice(token.span);
        let mark = text.chars().next().map_or(0, char::len_utf8);
        let place = Span::new(token.span.start, token.span.start + mark as u32);
        let is_spaced = text.get(mark..).is_none_or(|rest| rest.is_empty() || rest.starts_with([' ', '\t']));
        let on_this_line = self.statements.get(line_start as usize..).unwrap_or_default();
        let gap = on_this_line.last().map_or("", |last| self.slice(Span::new(last.span.end, token.span.start)));
        let colon = if gap.contains(':') { "" } else { ": " };
        let word = format!("{colon}REM{}", if is_spaced { "" } else { " " });
        // On the line of a label the guide forbids a remark, and behind PROGRAM it becomes a line of the program.
        let is_bold = on_this_line.iter().any(|statement| match &statement.kind {
            StatementKind::Label(_) => true,
            StatementKind::Command(command) => command.id == acrc_catalog::command::PROGRAM,
            _ => false,
        });
        let applicability = if is_bold { Applicability::Unsafe } else { Applicability::Safe };
        let fix = Fix::new(applicability, "make it a remark", vec![Edit::replace(place, word)]);
        self.report(
            Diagnostic::warning(
                codes::COMMENT_AFTER_STATEMENT,
                place,
                "an apostrophe comment stands behind a statement",
            )
            .with_help("only a line that starts with an apostrophe is dropped by the download; use ` : REM` here")
            .with_fix(fix),
        );
    }
}
