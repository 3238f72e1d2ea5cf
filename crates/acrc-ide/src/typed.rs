//! What stands on a line before the cursor, also where it is no statement yet.

use acrc_analysis::query::parse;
use acrc_analysis::{Db, SourceFile};
use acrc_catalog::{CommandId, FunctionId, OperandClass, Shape, command, daughter, word};
use acrc_syntax::ast::StatementKind;
use acrc_syntax::lexer::{Token, TokenKind};

use crate::place::slice;

/// The tokens of a line before a place.
#[derive(Clone, Copy)]
pub(crate) struct Typed<'a> {
    pub(crate) text: &'a str,
    pub(crate) tokens: &'a [Token],
}

/// What an open parenthesis belongs to.
pub(crate) enum Head {
    Function(FunctionId),
    Operand(OperandClass),
    /// An axis or a command.
    Argument,
    /// It groups a part of an expression.
    Group,
}

/// Whether a text has no quote at its end.
fn is_open(text: &str) -> bool {
    text.matches('"').count() % 2 == 1
}

impl<'a> Typed<'a> {
    /// `None` inside of a remark or a text.
    pub(crate) fn before(db: &'a dyn Db, file: SourceFile, offset: u32) -> Option<Self> {
        let tokens = parse(db, file).tokens();
        let end = tokens.partition_point(|token| token.span.start < offset);
        let tokens = tokens.get(..end)?;
        let inside = tokens.last().is_some_and(|last| match last.kind {
            TokenKind::Comment | TokenKind::RemarkText => true,
            TokenKind::String => offset < last.span.end || is_open(slice(file.text(db), last.span)),
            _ => false,
        });
        let line = tokens.iter().rposition(|token| token.kind == TokenKind::Newline).map_or(0, |newline| newline + 1);
        let tokens = tokens.get(line..).filter(|_| !inside)?;
        Some(Self { text: file.text(db), tokens })
    }

    /// The innermost parenthesis that is open before the token `end`, and the commas behind it.
    pub(crate) fn open_paren(&self, end: usize) -> Option<(usize, u32)> {
        let (mut depth, mut commas) = (0_u32, 0);
        for (place, token) in self.tokens.get(..end)?.iter().enumerate().rev() {
            match token.kind {
                TokenKind::RightParen => depth += 1,
                TokenKind::LeftParen if depth == 0 => return Some((place, commas)),
                TokenKind::LeftParen => depth -= 1,
                TokenKind::Comma if depth == 0 => commas += 1,
                TokenKind::Colon => return None,
                _ => {}
            }
        }
        None
    }

    pub(crate) fn head(&self, open: usize) -> Head {
        let before = self.tokens.get(..open).unwrap_or_default();
        let Some(last) = before.last() else { return Head::Group };
        let is_touching = |first: &Token, second: &Token| first.span.end == second.span.start;
        let start = match (last.kind, before.iter().nth_back(1)) {
            // `CHR$`
            (TokenKind::Dollar, Some(word)) if word.kind == TokenKind::Word && is_touching(word, last) => {
                word.span.start
            }
            // `LA0(`
            (TokenKind::Integer, Some(word)) if is_touching(word, last) => word.span.start,
            (TokenKind::Word | TokenKind::Dollar, _) => last.span.start,
            _ => return Head::Group,
        };
        let numbered = last.kind == TokenKind::Integer;
        let name = self.text.get(start as usize..last.span.end as usize).unwrap_or_default();
        let known = word(name.trim_end_matches(|c: char| c.is_ascii_digit()));
        match known {
            Some(known) if known.function.is_some() => known.function.map_or(Head::Group, Head::Function),
            Some(known) if known.command.is_none() => match known.operand {
                // Behind its number only an array has something in parentheses.
                Some(class) if !numbered || class.is_array() => Head::Operand(class),
                None if known.operator.is_some() || known.unary.is_some() => Head::Group,
                _ => Head::Argument,
            },
            _ => Head::Argument,
        }
    }

    /// The command of the statement that a place belongs to.
    pub(crate) fn command(&self, db: &dyn Db, file: SourceFile, offset: u32) -> Option<CommandId> {
        let statements = parse(db, file).statements();
        let after = statements.partition_point(|statement| statement.span.start < offset);
        let statement = statements.get(after.checked_sub(1)?)?;
        let first = self.tokens.first()?;
        let ended = self.tokens.iter().rev().take_while(|token| token.span.start >= statement.span.end);
        if statement.span.start < first.span.start || ended.into_iter().any(|token| token.kind == TokenKind::Colon) {
            return None;
        }
        match &statement.kind {
            StatementKind::Command(command) => Some(command.id),
            StatementKind::If(_) => Some(command::IF),
            StatementKind::For(_) => Some(command::FOR),
            StatementKind::Print(_) => Some(command::PRINT),
            StatementKind::Input(_) => Some(command::INPUT),
            StatementKind::Dim(dim) => Some(dim.id),
            StatementKind::Define(_) => Some(command::DEFINE),
            StatementKind::Error => self.unreadable(statement.span.start),
            StatementKind::Remark(_) | StatementKind::Label(_) | StatementKind::Assign(_) => None,
        }
    }

    /// The command with which a statement begins that could not be read.
    fn unreadable(&self, start: u32) -> Option<CommandId> {
        let mut words = self
            .tokens
            .iter()
            .skip_while(|token| token.span.start < start)
            .take_while(|token| matches!(token.kind, TokenKind::Word | TokenKind::Dollar))
            .map(|token| self.text.get(token.span.range()).unwrap_or_default());
        let first = word(words.next()?)?.command?;
        Some(words.map_while(|word| daughter(first, word)).last().unwrap_or(first))
    }

    /// The same without its last tokens.
    pub(crate) fn up_to(self, end: usize) -> Self {
        Self { tokens: self.tokens.get(..end).unwrap_or_default(), ..self }
    }

    pub(crate) fn slice(&self, token: &Token) -> &'a str {
        self.text.get(token.span.range()).unwrap_or_default()
    }

    /// The last command of the statement, by its words, and how many tokens there are up to its end. Behind an object
    /// (`AXIS0`) that is the command that follows.
    pub(crate) fn last_command(&self) -> Option<(CommandId, usize)> {
        let colon = self.tokens.iter().rposition(|token| token.kind == TokenKind::Colon).map_or(0, |colon| colon + 1);
        let mut found: Option<(CommandId, usize)> = None;
        for (place, token) in self.tokens.iter().enumerate().skip(colon) {
            if !matches!(token.kind, TokenKind::Word | TokenKind::Dollar) {
                continue;
            }
            let text = self.slice(token);
            let previous = place.checked_sub(1).and_then(|before| self.tokens.get(before));
            let define = previous.is_some_and(|previous| previous.kind == TokenKind::Hash);
            let next = match found {
                // `ENC0 SRC`: the number stands between.
                Some((parent, end)) if end == place || end + 1 == place && parent.info().shape == Shape::Object => {
                    daughter(parent, text)
                }
                _ => None,
            };
            let next = next.or_else(|| if define { Some(command::DEFINE) } else { word(text)?.command });
            // `SET kamr axis 1`: the object belongs to the words before it.
            let words_before = previous.is_some_and(|previous| previous.kind == TokenKind::Word)
                && found.is_some_and(|(_, end)| end < place);
            let next = next.filter(|id| !(words_before && id.info().shape == Shape::Object));
            found = next.map(|id| (id, place + 1)).or(found);
        }
        found
    }

    /// Whether a statement begins behind the tokens.
    pub(crate) fn begins_statement(&self) -> bool {
        match self.tokens {
            [] => true,
            [number] if number.kind == TokenKind::Integer => true,
            [.., last] => {
                let is_then = |text: &str| ["THEN", "ELSE"].iter().any(|word| text.eq_ignore_ascii_case(word));
                last.kind == TokenKind::Colon || (last.kind == TokenKind::Word && is_then(self.slice(last)))
            }
        }
    }

    /// Whether the statement assigns something.
    pub(crate) fn assigns(&self) -> bool {
        let own = self.tokens.iter().rev().take_while(|token| token.kind != TokenKind::Colon);
        own.into_iter().any(|token| token.kind == TokenKind::Equal)
    }
}
