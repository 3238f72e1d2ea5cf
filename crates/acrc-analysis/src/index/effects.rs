//! What the statements of a file do to the machine, without places: which commands act on what at which level, and
//! which bits and parameters are written. What the setup and the programs of a project leave is put together from these.

use acrc_catalog::{CommandId, Keyword, ObjectKind, OperandClass, command};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, Command, Expr, ExprKind, Statement, StatementKind};
use acrc_syntax::units::Level;
use rustc_hash::FxHashSet;

use super::Name;

/// What a file does, each thing once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Effects {
    /// Its commands, sorted.
    pub commands: Vec<CommandUse>,
    /// What it writes, sorted.
    pub writes: Vec<Write>,
}

/// A command that is used at a level, somewhere.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CommandUse<N = Name> {
    /// The level.
    pub level: Level,
    /// It stands in the stored text of a program; otherwise it is executed as it arrives.
    pub stored: bool,
    /// The command.
    pub command: CommandId,
    /// What it acts on. A command with several axes is several uses.
    pub on: On<N>,
    /// It sets something; without a value it reports.
    pub valued: bool,
}

/// What a command acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum On<N = Name> {
    /// Nothing, or what its level implies, such as the master of the program.
    Level,
    /// An axis by its name, in capital letters.
    Axis(N),
    /// An object by its number: `AXIS0`, `PROG1`, `MASTER0`. No number when none is written.
    Object(ObjectKind, Option<u32>),
    /// A word: `ALL`.
    Word(Keyword),
}

/// A bit or parameter that is written.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Write<N = Name> {
    /// The level.
    pub level: Level,
    /// What is written.
    pub what: Written<N>,
    /// How.
    pub how: WriteKind,
}

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Written<N = Name> {
    /// A parameter, bit or variable by its number.
    Operand(OperandClass, u64),
    /// One whose number is computed.
    Computed(OperandClass),
    /// What an alias stands for.
    Alias(N),
}

/// How something is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum WriteKind {
    /// `SET`
    Set,
    /// `CLR`
    Clear,
    /// An assignment, `FOR` or `INPUT`.
    Assign,
}

/// Collects the effects of one file, whose text it borrows.
pub(super) struct Collector<'a> {
    text: &'a str,
    commands: FxHashSet<CommandUse<&'a str>>,
    writes: FxHashSet<Write<&'a str>>,
}

impl<'a> Collector<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { text, commands: FxHashSet::default(), writes: FxHashSet::default() }
    }

    /// Adds a statement of a section.
    pub(super) fn statement(&mut self, level: Level, stored: bool, statement: &Statement) {
        match &statement.kind {
            StatementKind::Command(command) => self.command(level, stored, command),
            StatementKind::Assign(assign) => self.assigned(level, &assign.target),
            StatementKind::For(counted) => self.assigned(level, &counted.variable),
            StatementKind::Input(input) => {
                input.variables.iter().for_each(|variable| self.assigned(level, variable));
            }
            _ => {}
        }
    }

    fn command(&mut self, level: Level, stored: bool, command: &Command) {
        let id = command.id;
        if id == command::SET || id == command::CLR {
            let how = if id == command::SET { WriteKind::Set } else { WriteKind::Clear };
            for argument in &command.arguments {
                if let Argument::Bit(bit) = argument {
                    let what = self.written(OperandClass::Bit, &bit.index);
                    self.writes.insert(Write { level, what, how });
                }
            }
            return;
        }
        let mut use_on = |on, valued| {
            self.commands.insert(CommandUse { level, stored, command: id, on, valued });
        };
        let has_value =
            command.arguments.iter().any(|argument| matches!(argument, Argument::Value(_) | Argument::Tuple(_)));
        let mut alone = true;
        if let Some(prefix) = &command.prefix {
            alone = false;
            use_on(On::Object(prefix.kind, prefix.index), has_value || prefix.value.is_some());
        }
        for argument in &command.arguments {
            let (on, valued) = match argument {
                Argument::Axis(axis) => (On::Axis(slice(self.text, axis.name)), axis.value.is_some()),
                Argument::Object(object) => (On::Object(object.kind, object.index), object.value.is_some()),
                Argument::Word(word) => (On::Word(word.keyword), true),
                _ => continue,
            };
            alone = false;
            use_on(on, valued);
        }
        if alone {
            use_on(On::Level, has_value);
        }
    }

    fn assigned(&mut self, level: Level, target: &Expr) {
        let what = match &target.kind {
            ExprKind::Operand(operand) => self.written(operand.class, &operand.index),
            ExprKind::Alias => Written::Alias(slice(self.text, target.span)),
            _ => return,
        };
        self.writes.insert(Write { level, what, how: WriteKind::Assign });
    }

    fn written(&self, class: OperandClass, index: &Expr) -> Written<&'a str> {
        match &index.kind {
            ExprKind::Integer(number) => Written::Operand(class, *number),
            ExprKind::Alias => Written::Alias(slice(self.text, index.span)),
            ExprKind::Paren(inner) => self.written(class, inner),
            _ => Written::Computed(class),
        }
    }

    pub(super) fn finish(self) -> Effects {
        let mut commands: Vec<CommandUse> = self.commands.into_iter().map(CommandUse::owned).collect();
        commands.sort_unstable();
        commands.dedup();
        let mut writes: Vec<Write> = self.writes.into_iter().map(Write::owned).collect();
        writes.sort_unstable();
        Effects { commands, writes }
    }
}

impl CommandUse<&str> {
    fn owned(self) -> CommandUse {
        let Self { level, stored, command, on, valued } = self;
        let on = match on {
            On::Level => On::Level,
            On::Axis(name) => On::Axis(name.to_ascii_uppercase().into()),
            On::Object(kind, index) => On::Object(kind, index),
            On::Word(word) => On::Word(word),
        };
        CommandUse { level, stored, command, on, valued }
    }
}

impl Write<&str> {
    fn owned(self) -> Write {
        let what = match self.what {
            Written::Operand(class, number) => Written::Operand(class, number),
            Written::Computed(class) => Written::Computed(class),
            Written::Alias(name) => Written::Alias(name.into()),
        };
        Write { level: self.level, what, how: self.how }
    }
}

fn slice(text: &str, span: Span) -> &str {
    text.get(span.range()).unwrap_or_default()
}
