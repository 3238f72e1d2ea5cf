//! What a statement is, by its first word.

use acrc_catalog::{Operator, Shape, command};
use acrc_diagnostics::{Applicability, Diagnostic, Edit, Fix, Span};

use super::expression::may_be_name;
use super::motion::may_start_target;
use super::{Failure, Read, Reader};
use crate::ast::{Assign, Expr, ExprKind, Label, StatementKind};
use crate::codes;
use crate::lexer::{Token, TokenKind, rest_of_line};

/// What must follow a statement whose arguments are complete.
pub(super) const END: &str = "the end of the statement";

/// What to say about an `=` behind a command.
pub(super) const NO_ASSIGNMENT: &str =
    "the value of a command follows it without `=`, and an alias can't have the name of a command";

/// Letters that an axis name may have (guide, "ATTACH SLAVE").
pub(super) const MAX_AXIS_NAME: u32 = 4;

/// A longer word is no mistyped command.
const LONGEST_TYPO: usize = 16;
/// A file with more errors than this is no program, and the search for similar commands is only a waste of time.
const MAX_SUGGESTIONS: usize = 200;

impl Reader<'_> {
    pub(super) fn statement_kind(&mut self) -> Read<StatementKind> {
        let token = self.peek();
        match token.kind {
            TokenKind::Word => self.word_statement(token),
            TokenKind::Underscore => self.label(),
            TokenKind::Question => {
                self.bump();
                self.print(true)
            }
            TokenKind::Hash => self.define(),
            TokenKind::Dollar if self.dollar_class(token).is_some() => self.assignment(),
            TokenKind::Ellipsis => {
                let failure = self.expected("a statement");
                Err(failure.help("listings in print stand for left-out lines this way; delete it"))
            }
            _ => Err(self.expected("a statement")),
        }
    }

    /// Why what follows a statement that was read can neither end it nor start another one.
    pub(super) fn leftover(&self, kind: &StatementKind) -> Option<Failure> {
        let token = self.peek();
        if let StatementKind::Command(command) = kind
            && let Some(failure) = self.foreign_end(command.id, token)
        {
            return Some(failure);
        }
        if token.kind.ends_statement() || self.starts_statement(token) {
            return None;
        }
        let (wanted, after) = self.wanted;
        let failure = self.expected_after(wanted, after.unwrap_or_else(|| self.last_read()));
        Some(match self.infix_operator(token) {
            Some(Operator::Eq) => failure.help(NO_ASSIGNMENT),
            Some(_) if wanted == END => failure.help("a calculated argument stands in parentheses"),
            _ => failure,
        })
    }

    fn starts_statement(&self, token: Token) -> bool {
        match token.kind {
            TokenKind::Word | TokenKind::Underscore | TokenKind::Question => true,
            TokenKind::Dollar => self.dollar_class(token).is_some(),
            TokenKind::Hash => self.is_word(self.peek_at(1), "DEFINE"),
            _ => false,
        }
    }

    fn word_statement(&mut self, token: Token) -> Read<StatementKind> {
        let Some(word) = self.word(token) else { return self.name_statement(token) };
        if word.operand.is_some() {
            return self.assignment();
        }
        match word.command {
            Some(command::REM) => Ok(self.remark()),
            Some(id) => self.command(id),
            None if may_be_name(&word) => self.name_statement(token),
            None => Err(self.misplaced(token)),
        }
    }

    /// A word of the language that starts no statement.
    fn misplaced(&self, token: Token) -> Failure {
        let failure = self.refuse(format!("{} can't start a statement", self.describe(token)));
        if self.is_word(token, "THEN") {
            return failure.help("`THEN` stands on the line of its `IF`");
        }
        failure
    }

    /// A word that the catalogue does not know: an alias that is assigned, or an axis that moves.
    fn name_statement(&mut self, token: Token) -> Read<StatementKind> {
        let length = self.name_length();
        if self.peek_at(length).kind == TokenKind::Equal || self.is_colon_equal(length) {
            return self.assignment();
        }
        let is_short = token.span.len() <= MAX_AXIS_NAME;
        if is_short && self.may_follow_axis(self.peek_at(1)) && !self.is_mistyped_parent(token) {
            return self.move_statement(None, command::AXIS_MOVE, Span::empty(token.span.start));
        }
        if is_short && self.is_move_without_target(token) {
            self.bump();
            return Err(self.expected("a value"));
        }
        Err(self.unknown_command(token))
    }

    fn may_follow_axis(&self, token: Token) -> bool {
        may_start_target(token.kind) || token.kind.ends_statement() || self.starts_statement(token)
    }

    /// `JGO ABS X5`: the next word is a daughter of the command that this word resembles.
    fn is_mistyped_parent(&self, token: Token) -> bool {
        let next = self.peek_at(1);
        if !self.word(next).is_some_and(|word| word.daughter) {
            return false;
        }
        let parent = acrc_catalog::nearest_command(self.slice(token.span)).and_then(acrc_catalog::word);
        let parent = parent.and_then(|word| word.command);
        parent.is_some_and(|parent| acrc_catalog::daughter(parent, self.slice(next.span)).is_some())
    }

    /// Whether the search for a similar word is worth its time.
    pub(super) fn may_suggest(&self, word: &str) -> bool {
        word.len() <= LONGEST_TYPO && self.errors.len() < MAX_SUGGESTIONS
    }

    fn unknown_command(&mut self, token: Token) -> Failure {
        let word = self.slice(token.span);
        let shown = super::failure::shown(word);
        let failure =
            Failure(Box::new(Diagnostic::error(codes::SYNTAX_ERROR, token.span, format!("unknown command `{shown}`"))));
        let colon = self.peek_at(1);
        if colon.kind == TokenKind::Colon && colon.span.start == token.span.end && self.peek_at(2).kind.ends_statement()
        {
            let edits = vec![Edit::insert(token.span.start, "_"), Edit::delete(colon.span)];
            return failure
                .help("a label begins with an underscore, and no colon follows it")
                .fix(Fix::unsafe_(format!("make it the label `_{shown}`"), edits));
        }
        let near = if self.may_suggest(word) { acrc_catalog::nearest_command(word) } else { None };
        match near {
            Some(name) => failure.help(format!("did you mean `{name}`?")).fix(Fix::new(
                Applicability::Unsafe,
                format!("replace it with `{name}`"),
                vec![Edit::replace(token.span, name)],
            )),
            None if token.span.len() <= MAX_AXIS_NAME => failure,
            None => failure.help("an axis has a name of at most four letters; an alias is followed by `=` here"),
        }
    }

    /// `target = value`
    fn assignment(&mut self) -> Read<StatementKind> {
        let target = self.value()?;
        if self.is_colon_equal(0) {
            return Err(self.colon_equal());
        }
        if self.accept(TokenKind::Equal).is_none() {
            return Err(self.expected_after("`=`", target.span));
        }
        let value = self.full_expression()?;
        Ok(StatementKind::Assign(Box::new(Assign { target, value })))
    }

    /// `_name`
    fn label(&mut self) -> Read<StatementKind> {
        let underscore = self.bump();
        let next = self.peek();
        if !matches!(next.kind, TokenKind::Word | TokenKind::Integer | TokenKind::Underscore) {
            return Err(self.expected("the name of a label"));
        }
        let detached = !self.touches(next);
        if detached {
            let gap = Span::new(underscore.span.end, next.span.start);
            self.report(
                Diagnostic::warning(
                    codes::DETACHED_LABEL,
                    gap,
                    "blanks between the underscore of a label and its name",
                )
                .with_help("the name follows the underscore directly")
                .with_fix(Fix::safe("remove the blanks", vec![Edit::delete(gap)])),
            );
        }
        let name = self.name();
        Ok(StatementKind::Label(Label { name, detached }))
    }

    /// `REM text`, up to the end of the line.
    fn remark(&mut self) -> StatementKind {
        let word = self.bump();
        let next = self.peek();
        if next.kind == TokenKind::RemarkText {
            self.bump();
            return StatementKind::Remark(next.span);
        }
        let rest = self.text.get(word.span.end as usize..).unwrap_or_default();
        let text = Span::new(word.span.end, word.span.end + rest_of_line(rest) as u32);
        let first = self.position;
        while self.peek().span.start < text.end && self.peek().kind != TokenKind::End {
            self.bump();
        }
        self.remarks.push((first..self.position, text));
        self.previous = text;
        StatementKind::Remark(text)
    }

    /// `#DEFINE name operand`
    fn define(&mut self) -> Read<StatementKind> {
        self.bump();
        if self.accept_word("DEFINE").is_none() {
            return Err(self.expected("`DEFINE`"));
        }
        if self.peek().kind != TokenKind::Word {
            return Err(self.expected("the name of an alias"));
        }
        let name = self.name();
        let operand = self.value()?;
        Ok(StatementKind::Define(Box::new(crate::ast::Define { name, operand })))
    }

    /// A command of the catalogue that has no prefix.
    fn command(&mut self, id: acrc_catalog::CommandId) -> Read<StatementKind> {
        let first = self.bump();
        match id.info().shape {
            Shape::If => self.if_statement(),
            Shape::For => self.for_statement(),
            Shape::Print => self.print(false),
            Shape::Input => self.input(),
            Shape::Dim => self.dim(first),
            Shape::Object => self.object_command(id, first),
            _ => self.named_command(None, id, first),
        }
    }

    /// A name as an expression.
    pub(super) fn alias(&mut self) -> Expr {
        Expr { span: self.name(), kind: ExprKind::Alias }
    }
}
