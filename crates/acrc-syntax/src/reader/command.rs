//! The name of a command: prefix, words and daughters (guide, "Basic Setup", command groups).

use acrc_catalog::{Command as Row, CommandId, Explanation, ObjectKind, Shape};
use acrc_diagnostics::Span;

use super::{Failure, Read, Reader};
use crate::ast::{Argument, Command, Object, StatementKind};
use crate::lexer::{Token, TokenKind};

impl Reader<'_> {
    /// A command whose first word is taken: its further words and its arguments.
    pub(super) fn named_command(&mut self, prefix: Option<Object>, id: CommandId, first: Token) -> Read<StatementKind> {
        let id = self.daughters(id);
        let row = id.info();
        let name = Span::new(first.span.start, self.consumed_to());
        if row.daughter_required || row.shape == Shape::Parent && !self.peek().kind.ends_statement() {
            return Err(self.daughter_missing(row, name));
        }
        self.wanted.1 = Some(name);
        self.with_arguments(prefix, id, name)
    }

    /// Takes the daughters that follow, the longest name first. An object that a daughter names stays an argument
    /// (`ATTACH SLAVE0`, `CMT0 ENC0 ENC1`).
    fn daughters(&mut self, mut id: CommandId) -> CommandId {
        while let Some((daughter, words)) = self.daughter(id) {
            id = daughter;
            if self.names_object(daughter.info()) {
                break;
            }
            self.skip(words);
        }
        id
    }

    /// The daughter at the next token and the number of its tokens.
    pub(super) fn daughter(&self, parent: CommandId) -> Option<(CommandId, usize)> {
        let token = self.peek();
        if token.kind != TokenKind::Word || parent.info().daughters.is_empty() {
            return None;
        }
        let next = self.peek_at(1);
        if next.kind == TokenKind::Integer && next.span.start == token.span.end {
            let numbered = acrc_catalog::daughter(parent, self.slice(Span::cover(token.span, next.span)));
            if let Some(daughter) = numbered {
                return Some((daughter, 2));
            }
        }
        acrc_catalog::daughter(parent, self.slice(token.span)).map(|daughter| (daughter, 1))
    }

    /// Whether the daughter at the next token stands for an object that is one of its arguments.
    fn names_object(&self, daughter: &Row) -> bool {
        matches!(daughter.shape, Shape::Attach | Shape::Free)
            && self.peek_at(1).kind == TokenKind::Integer
            && self.word(self.peek()).is_some_and(|word| word.object.is_some())
    }

    fn with_arguments(&mut self, prefix: Option<Object>, id: CommandId, name: Span) -> Read<StatementKind> {
        let arguments = self.arguments_of(id.info(), prefix.is_some())?;
        let prefix = prefix.map(Box::new);
        Ok(StatementKind::Command(Box::new(Command { prefix, id, name, arguments })))
    }

    /// A move, with or without its keyword.
    pub(super) fn move_statement(&mut self, prefix: Option<Object>, id: CommandId, name: Span) -> Read<StatementKind> {
        self.with_arguments(prefix, id, name)
    }

    /// `AXIS0 PPU 4000`, `ENC0 SRC 0`, `ADC MODE 1`, `FSTAT0 (48, 2)`: an object, then a daughter or a command that
    /// takes it as a prefix.
    pub(super) fn object_command(&mut self, id: CommandId, first: Token) -> Read<StatementKind> {
        let kind = self.word(first).and_then(|word| word.object);
        let (Some(kind), TokenKind::Integer) = (kind, self.peek().kind) else {
            return self.named_command(None, id, first);
        };
        let object = self.object_behind(kind, first);
        let next = self.peek();
        if let Some((daughter, words)) = self.daughter(id) {
            if self.names_object(daughter.info()) {
                return self.with_arguments(Some(object), daughter, Span::empty(next.span.start));
            }
            self.skip(words);
            return self.named_command(Some(object), daughter, next);
        }
        if let Some(command) = self.prefixed_command(kind, next) {
            self.bump();
            return self.named_command(Some(object), command, next);
        }
        if id.info().max_args == 0 {
            return Err(self.expected_after("a command", object.name));
        }
        self.wanted = ("a daughter or values in parentheses", Some(object.name));
        self.with_arguments(Some(object), id, Span::empty(next.span.start))
    }

    /// The command at a token, if it takes an object of this kind as its prefix.
    fn prefixed_command(&self, kind: ObjectKind, token: Token) -> Option<CommandId> {
        let id = self.word(token)?.command?;
        let takes = |row: &Row| row.prefixes.contains(&kind);
        let row = id.info();
        let has_own_objects = row.shape == Shape::Object;
        (!has_own_objects && (takes(row) || row.daughters.iter().any(|daughter| takes(daughter.info())))).then_some(id)
    }

    /// Whether the object at the next token is the prefix of a command, with its number at the token behind.
    pub(super) fn is_prefix(&self, kind: ObjectKind, object: CommandId) -> bool {
        let next = self.peek_at(2);
        if self.peek_at(1).kind != TokenKind::Integer || next.kind != TokenKind::Word {
            return false;
        }
        acrc_catalog::daughter(object, self.slice(next.span)).is_some() || self.prefixed_command(kind, next).is_some()
    }

    /// The object whose word is taken: its number follows, if it has one.
    pub(super) fn object_behind(&mut self, kind: ObjectKind, word: Token) -> Object {
        let number = self.accept(TokenKind::Integer);
        let index = number.map(|number| self.slice(number.span).parse().unwrap_or(u32::MAX));
        let name = Span::new(word.span.start, self.consumed_to());
        Object { span: name, name, kind, index, slash: None, value: None }
    }

    /// Arguments by the shape of the row.
    fn arguments_of(&mut self, row: &Row, prefixed: bool) -> Read<Vec<Argument>> {
        match row.shape {
            Shape::Condition => Ok(vec![self.condition()?]),
            Shape::Target => self.target(),
            Shape::Bit => Ok(self.bit()?.into_iter().collect()),
            Shape::BitMove => self.bit_and_move(),
            Shape::ParameterTuple => self.parameter_tuple(),
            Shape::Open => self.open(),
            Shape::Close => self.close_device(),
            _ => self.arguments(row, prefixed),
        }
    }

    fn daughter_missing(&self, row: &Row, name: Span) -> Failure {
        const LISTED: usize = 12;
        let failure = self.expected_after("a daughter", name);
        if self.peek().kind == TokenKind::Equal {
            return failure.help(super::statement::NO_ASSIGNMENT);
        }
        if let Some(near) = self.nearest_daughter(row) {
            return failure.help(format!("did you mean `{near}`?"));
        }
        let words: Vec<&str> = row.daughters.iter().map(|daughter| daughter.info().word).collect();
        let listed = words.get(..LISTED.min(words.len())).unwrap_or_default().join(", ");
        let more = if words.len() > LISTED { ", ..." } else { "" };
        failure.help(format!("`{}` is followed by one of {listed}{more}", row.name))
    }

    /// The name of the daughter that the next word resembles.
    fn nearest_daughter(&self, row: &Row) -> Option<&'static str> {
        let token = self.peek();
        let word = self.slice(token.span);
        if token.kind != TokenKind::Word || !self.may_suggest(word) {
            return None;
        }
        let Explanation::Near { suggestions, .. } = acrc_catalog::explain(&format!("{} {word}", row.name)) else {
            return None;
        };
        let is_daughter = |name: &&str| row.daughters.iter().any(|daughter| daughter.info().name == *name);
        suggestions.into_iter().find(is_daughter)
    }
}
