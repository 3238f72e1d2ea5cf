//! Arguments of commands, by their shape in the catalogue.
//!
//! One loop reads the arguments of all commands that have no grammar of their own; [`rules`] says for each shape what it
//! may take. How many there must be, and of what kind, is for the checker to say.

use acrc_catalog::{Command as Row, CommandId, Keyword, ObjectKind, Shape, Word as Known, command};
use acrc_diagnostics::Span;

use super::expression::may_be_name;
use super::motion::may_start_target;
use super::statement::MAX_AXIS_NAME;
use super::{Read, Reader};
use crate::ast::{Argument, Expr, ExprKind, Tuple, Word};
use crate::lexer::{Token, TokenKind};

/// What a shape takes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rules {
    /// What comes next, in the words of a message.
    wanted: &'static str,
    /// Numbers, strings, parentheses and variables that are no part of an axis, at most.
    values: usize,
    /// What a word is that the catalogue does not know.
    names: Names,
    /// What may follow an axis.
    pub(super) axis: AxisValue,
    /// Which objects are arguments.
    objects: Objects,
    /// Objects, at most.
    max_objects: usize,
    /// `ALL`, `NONE`, `CLOCK` and their like.
    words: bool,
    /// Commas may separate.
    commas: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Names {
    /// The start of the next statement.
    Statement,
    Alias,
    Axis,
    /// An axis, or an alias when it is too long for one.
    Either,
}

/// What may follow an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum AxisValue {
    Nothing,
    Value,
    Source,
    /// A value, and interpolation keywords between the axes.
    Target,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Objects {
    None,
    Axes,
    Programs,
    Masters,
    All,
}

impl Objects {
    fn contain(self, kind: ObjectKind) -> bool {
        match self {
            Self::None => false,
            Self::Axes => kind == ObjectKind::Axis,
            Self::Programs => matches!(kind, ObjectKind::Prog | ObjectKind::Plc),
            Self::Masters => kind == ObjectKind::Master,
            Self::All => true,
        }
    }
}

const ANY: usize = usize::MAX;

const NOTHING: Rules = Rules {
    wanted: super::statement::END,
    values: 0,
    names: Names::Statement,
    axis: AxisValue::Nothing,
    objects: Objects::None,
    max_objects: ANY,
    words: false,
    commas: false,
};

const AXES: Rules = Rules { wanted: "an axis", names: Names::Axis, objects: Objects::Axes, ..NOTHING };

const VALUE: Rules = Rules { wanted: "a value", values: 1, names: Names::Alias, ..NOTHING };

const OBJECTS: Rules = Rules { wanted: "an object", objects: Objects::All, words: true, ..NOTHING };

fn rules(shape: Shape) -> Rules {
    match shape {
        Shape::Value | Shape::Index | Shape::Clear => VALUE,
        Shape::Values => Rules { values: ANY, commas: true, ..VALUE },
        Shape::String => Rules { wanted: "a string", names: Names::Statement, words: true, ..VALUE },
        Shape::Axes => AXES,
        Shape::AxisValues => Rules { axis: AxisValue::Value, values: 1, ..AXES },
        Shape::AxisSources => Rules { axis: AxisValue::Source, values: 1, objects: Objects::All, words: true, ..AXES },
        Shape::Move => Rules { axis: AxisValue::Target, ..AXES },
        Shape::Source => Rules { wanted: "a source", objects: Objects::All, max_objects: 1, words: true, ..VALUE },
        Shape::Programs => {
            Rules { wanted: "a program, a PLC or `ALL`", objects: Objects::Programs, max_objects: 1, ..OBJECTS }
        }
        Shape::Masters => Rules { wanted: "a master", objects: Objects::Masters, ..OBJECTS },
        Shape::Attach => Rules { values: 1, ..OBJECTS },
        Shape::Detach | Shape::Config => OBJECTS,
        Shape::Object => Rules { names: Names::Statement, ..VALUE },
        Shape::Free => Rules {
            wanted: "an argument",
            values: ANY,
            names: Names::Either,
            axis: AxisValue::Target,
            objects: Objects::All,
            words: true,
            commas: true,
            ..NOTHING
        },
        _ => NOTHING,
    }
}

/// What has been read of the arguments of a command.
struct Seen {
    arguments: Vec<Argument>,
    values: usize,
    objects: usize,
    /// A comma was the last thing.
    comma: bool,
}

impl Seen {
    fn is_first(&self) -> bool {
        self.arguments.is_empty()
    }
}

impl Reader<'_> {
    /// The arguments of a shape without a grammar of its own. `prefixed`: an object stands before the command.
    pub(super) fn arguments(&mut self, row: &Row, prefixed: bool) -> Read<Vec<Argument>> {
        if row.shape == Shape::Value && self.peek().kind == TokenKind::Equal {
            return Ok(vec![Argument::Value(self.value_behind_equals(row)?)]);
        }
        let mut rules = rules(row.shape);
        if rules.names == Names::Either && !row.takes_axes {
            rules.names = Names::Alias;
        }
        // Behind an object the value stands alone: `AXIS0 PPU Ratio`.
        if rules.names == Names::Axis && rules.values > 0 && prefixed {
            rules.names = Names::Either;
        }
        self.arguments_by(&rules)
    }

    /// The axes of a move.
    pub(super) fn axes_of_move(&mut self) -> Read<Vec<Argument>> {
        self.arguments_by(&rules(Shape::Move))
    }

    fn arguments_by(&mut self, rules: &Rules) -> Read<Vec<Argument>> {
        // Most commands have one argument.
        let mut seen = Seen { arguments: Vec::with_capacity(1), values: 0, objects: 0, comma: false };
        loop {
            if let Some(argument) = self.argument(rules, &mut seen)? {
                seen.arguments.push(argument);
                seen.comma = false;
            } else if seen.comma {
                return Err(self.expected(rules.wanted));
            } else if rules.commas && !seen.is_first() && self.accept(TokenKind::Comma).is_some() {
                seen.comma = true;
            } else {
                break;
            }
        }
        if seen.is_first() {
            self.wanted.0 = rules.wanted;
        } else {
            self.wanted.1 = None;
        }
        Ok(seen.arguments)
    }

    /// The next argument, or nothing where the next statement or something unfitting starts.
    fn argument(&mut self, rules: &Rules, seen: &mut Seen) -> Read<Option<Argument>> {
        let token = self.peek();
        match token.kind {
            TokenKind::Word => self.word_argument(rules, seen, token),
            TokenKind::Dollar if self.assignment_ahead() => Ok(None),
            _ if seen.values < rules.values && self.starts_value() => {
                seen.values += 1;
                self.group_or_value().map(Some)
            }
            _ => Ok(None),
        }
    }

    fn word_argument(&mut self, rules: &Rules, seen: &mut Seen, token: Token) -> Read<Option<Argument>> {
        let Some(word) = self.word(token) else { return self.name_argument(rules, seen, token) };
        if let Some(kind) = self.object_argument(rules, seen, word) {
            seen.objects += 1;
            self.bump();
            return self.object_value(rules, kind, token).map(Some);
        }
        if self.is_operand_or_function(token, Some(word)) {
            if seen.values < rules.values && !self.assignment_ahead() {
                seen.values += 1;
                return Ok(Some(Argument::Value(self.value()?)));
            }
            return Ok(None);
        }
        if let Some(id) = word.command {
            if rules.axis == AxisValue::Target && !seen.is_first() && is_interpolation(id) {
                self.bump();
                return Ok(Some(Argument::Interpolation(id, token.span)));
            }
            return Ok(None);
        }
        if rules.words
            && let Some(keyword) = word.keyword
        {
            self.bump();
            return Ok(Some(Argument::Word(self.keyword_behind(keyword, token))));
        }
        if may_be_name(&word) { self.name_argument(rules, seen, token) } else { Ok(None) }
    }

    /// The kind of the object at the next token, if it is an argument. The first one is always; a later one may be the
    /// prefix of the next statement.
    fn object_argument(&self, rules: &Rules, seen: &Seen, word: Known) -> Option<ObjectKind> {
        let kind = word.object.filter(|&kind| rules.objects.contain(kind))?;
        if seen.objects >= rules.max_objects {
            return None;
        }
        let numbered = self.peek_at(1).kind == TokenKind::Integer;
        // `ATTACH AXIS0 ENC0 CMT0 ENC0` lists objects, though `CMT0 ENC0` could be a statement too.
        let object_follows = self.word(self.peek_at(2)).is_some_and(|next| next.object.is_some())
            && self.peek_at(3).kind == TokenKind::Integer;
        let is_prefix = !object_follows && word.command.is_some_and(|object| self.is_prefix(kind, object));
        (seen.is_first() || numbered && !is_prefix).then_some(kind)
    }

    pub(super) fn keyword_behind(&mut self, keyword: Keyword, word: Token) -> Word {
        let next = self.peek();
        let number = if self.touches(next) { self.accept(TokenKind::Integer) } else { None };
        let index = number.map(|number| self.slice(number.span).parse().unwrap_or(u32::MAX));
        Word { span: Span::new(word.span.start, self.consumed_to()), keyword, index }
    }

    /// A word that the catalogue does not know.
    fn name_argument(&mut self, rules: &Rules, seen: &mut Seen, token: Token) -> Read<Option<Argument>> {
        if self.peek_at(self.name_length()).kind == TokenKind::Equal {
            return Ok(None);
        }
        let short = token.span.len() <= MAX_AXIS_NAME;
        let is_axis = match rules.names {
            Names::Statement => return Ok(None),
            Names::Alias => false,
            Names::Axis if !short => return Ok(None),
            Names::Axis => true,
            Names::Either => short,
        };
        if is_axis {
            return self.axis(rules, token, seen.is_first());
        }
        let moves = short && may_start_target(self.peek_at(1).kind);
        if seen.values >= rules.values || moves {
            return Ok(None);
        }
        seen.values += 1;
        Ok(Some(Argument::Value(self.alias())))
    }

    /// A value, or values in parentheses.
    pub(super) fn group_or_value(&mut self) -> Read<Argument> {
        if self.peek().kind == TokenKind::LeftParen { self.group() } else { Ok(Argument::Value(self.value()?)) }
    }

    /// `(expression)`, `(24, 0)`
    fn group(&mut self) -> Read<Argument> {
        let open = self.peek().span;
        let mut values = self.list()?;
        let span = Span::new(open.start, self.consumed_to());
        Ok(match values.pop() {
            Some(only) if values.is_empty() => Argument::Value(Expr { span, kind: ExprKind::Paren(Box::new(only)) }),
            Some(last) => {
                values.push(last);
                Argument::Tuple(Tuple { span, values })
            }
            None => Argument::Tuple(Tuple { span, values }),
        })
    }

    /// The values between parentheses, which start at the next token.
    pub(super) fn list(&mut self) -> Read<Vec<Expr>> {
        let open = self.bump().span;
        let mut values = Vec::new();
        loop {
            values.push(self.full_expression()?);
            if self.accept(TokenKind::RightParen).is_some() {
                return Ok(values);
            }
            if self.accept(TokenKind::Comma).is_none() {
                return Err(self.expected("`,` or `)`").related(open, "opened here"));
            }
        }
    }

    /// Whether the variable at the next token is assigned: it belongs to the next statement then.
    pub(super) fn assignment_ahead(&self) -> bool {
        /// Tokens of an index in parentheses that are looked at.
        const REACH: usize = 64;
        let mut depth = 0_usize;
        for distance in 1..REACH {
            match self.peek_at(distance).kind {
                TokenKind::LeftParen => depth += 1,
                TokenKind::RightParen if depth == 0 => return false,
                TokenKind::RightParen => depth -= 1,
                kind if kind.ends_line() => return false,
                TokenKind::Integer => {}
                TokenKind::Equal if depth == 0 => return true,
                _ if depth == 0 => return false,
                _ => {}
            }
        }
        false
    }
}

/// Whether the command may stand between the axes of one move.
fn is_interpolation(id: CommandId) -> bool {
    [command::SINE, command::CIRCW, command::CIRCCW, command::TARC, command::MOV].contains(&id)
}
