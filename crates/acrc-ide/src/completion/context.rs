//! What is expected at a place.

use acrc_analysis::{Db, Project, SourceFile};
use acrc_catalog::{CommandId, Keyword};
use acrc_diagnostics::Span;
use acrc_syntax::lexer::TokenKind;
use acrc_syntax::units::Level;

use crate::typed::{Head, Typed};
use crate::{FilePosition, level_of, statement_at};

/// What is being written.
pub(super) struct Context<'a> {
    pub(super) project: Project,
    pub(super) level: Level,
    /// The line before the word that is being written.
    pub(super) before: Typed<'a>,
    /// The word that is being written, which may be empty.
    pub(super) part: &'a str,
    /// Where it stands.
    pub(super) span: Span,
    pub(super) expected: Expected,
}

/// What may come next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Expected {
    /// A statement.
    Statement,
    /// An argument of a command; `first` directly behind its words, where a daughter may follow too.
    Argument { id: CommandId, first: bool },
    /// A value.
    Expression,
    /// What an alias stands for: a parameter, a flag or a variable.
    Target,
    /// The name that `#DEFINE` introduces, and other places for something new.
    Nothing,
}

impl<'a> Context<'a> {
    /// `None` in remarks and texts.
    pub(super) fn new(db: &'a dyn Db, position: FilePosition) -> Option<Self> {
        let FilePosition { project, file, offset } = position;
        let typed = Typed::before(db, file, offset)?;
        let is_part = |kind| matches!(kind, TokenKind::Word | TokenKind::Dollar | TokenKind::Hash);
        let mut start = typed.tokens.len();
        // `#DEF` and `CHR$` are two tokens, an alias such as `clamp2` too.
        let mut from = offset;
        while let Some(token) = start.checked_sub(1).and_then(|last| typed.tokens.get(last))
            && token.span.end.min(offset) == from
            && (is_part(token.kind) || (token.kind == TokenKind::Integer && touches_word(&typed, start - 1)))
        {
            start -= 1;
            from = token.span.start;
        }
        let span = Span::new(from, offset);
        let part = file.text(db).get(span.range())?;
        let before = typed.up_to(start);
        let level = statement_at(db, file, offset)
            .map_or_else(|| level_before(db, file, offset), |statement| level_of(db, file, statement));
        let mark = before.tokens.last().filter(|last| last.kind == TokenKind::Underscore && last.span.end == from);
        let expected = match (mark, expected(&before.up_to(start - usize::from(mark.is_some())))) {
            // A label that is new.
            (Some(_), Expected::Statement) => Expected::Nothing,
            (_, expected) => expected,
        };
        Some(Self { project, level, before, part, span, expected })
    }

    /// Whether a number ends at the cursor: a word in its place would grow together with it.
    pub(super) fn touches_number(&self) -> bool {
        let last = self.before.tokens.last().filter(|_| self.part.is_empty());
        last.is_some_and(|last| {
            matches!(last.kind, TokenKind::Integer | TokenKind::Real) && last.span.end == self.span.start
        })
    }

    /// The words that are being written up to the cursor, for what is looked up by name: `kamr axis 1`. They begin behind
    /// the command or sign before them.
    pub(super) fn phrase(&self) -> (Span, &'a str) {
        let first = match self.expected {
            Expected::Argument { .. } => self.before.last_command().map_or(0, |(_, end)| end),
            // Behind the name of the alias.
            Expected::Target => self.before.last_command().map_or(0, |(_, end)| end + 1),
            _ => 0,
        };
        let tokens = self.before.tokens.get(first..).unwrap_or_default();
        let mut start = self.span.start;
        for (place, token) in tokens.iter().enumerate().rev() {
            // `encoder 0 pos`, but not `X10 pos`.
            let numbers_word = || {
                let word = place.checked_sub(1).and_then(|before| tokens.get(before));
                word.is_some_and(|word| word.kind == TokenKind::Word && word.span.end < token.span.start)
            };
            match token.kind {
                TokenKind::Word if !ends_phrase(self.before.slice(token)) => start = token.span.start,
                TokenKind::Integer if start < self.span.start || self.part.is_empty() || numbers_word() => {
                    start = token.span.start;
                }
                _ => break,
            }
        }
        let span = Span::new(start, self.span.end);
        (span, self.before.text.get(span.range()).unwrap_or_default())
    }
}

/// Whether a word belongs to the statement, and not to the name of a parameter or flag: `ALL` may be either.
fn ends_phrase(text: &str) -> bool {
    let Some(word) = acrc_catalog::word(text) else { return false };
    let joins =
        matches!(word.keyword, Some(Keyword::As | Keyword::Using | Keyword::To | Keyword::Then | Keyword::Step));
    word.operator.is_some() || word.unary.is_some() || joins
}

/// Whether digits are glued to letters before them.
fn touches_word(typed: &Typed<'_>, place: usize) -> bool {
    let number = typed.tokens.get(place);
    let before = place.checked_sub(1).and_then(|before| typed.tokens.get(before));
    match (before, number) {
        (Some(word), Some(number)) => word.kind == TokenKind::Word && word.span.end == number.span.start,
        _ => false,
    }
}

/// The level of a place at which no statement stands: that of the one before it.
fn level_before(db: &dyn Db, file: SourceFile, offset: u32) -> Level {
    let sections = &acrc_analysis::query::file_index(db, file).sections;
    let statements = acrc_analysis::query::parse(db, file).statements();
    let next = statements.partition_point(|statement| statement.span.start < offset) as u32;
    let holds = |section: &&acrc_analysis::index::SectionIndex| {
        let section = &section.section;
        section.opener.map_or(section.statements.start, |opener| opener) < next || section.statements.start <= next
    };
    let last = sections.iter().rfind(holds);
    last.map_or_else(|| file.role(db).start(), |section| section.section.level)
}

fn expected(before: &Typed<'_>) -> Expected {
    if before.begins_statement() {
        return Expected::Statement;
    }
    let mut end = before.tokens.len();
    while let Some((open, _)) = before.open_paren(end) {
        match before.head(open) {
            Head::Group => end = open,
            Head::Function(_) | Head::Operand(_) | Head::Argument => return Expected::Expression,
        }
    }
    let last = before.tokens.last().map(|token| token.kind);
    if matches!(last, Some(TokenKind::LeftParen | TokenKind::Equal)) {
        return Expected::Expression;
    }
    match before.last_command() {
        Some((acrc_catalog::command::DEFINE, used)) if used == before.tokens.len() => Expected::Nothing,
        Some((acrc_catalog::command::DEFINE, _)) => Expected::Target,
        Some((id, used)) => Expected::Argument { id, first: used == before.tokens.len() },
        None if end < before.tokens.len() || before.assigns() => Expected::Expression,
        None => Expected::Statement,
    }
}
