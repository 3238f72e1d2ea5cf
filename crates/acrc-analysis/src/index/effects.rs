//! What the statements of a file do to the machine, without places: the deeds of its commands, and those of the flags
//! and parameters that it writes. What the setup and the programs of a project leave is put together from these.

use acrc_catalog::{CommandId, ObjectKind, OperandClass, Space, command};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, Command, Expr, ExprKind, Statement, StatementKind};
use acrc_syntax::units::Level;
use rustc_hash::FxHashSet;

use super::Name;
use crate::deed::{self, Deed, On};
use crate::{usage, walk};

/// What a file does, each thing once, sorted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Effects {
    /// What its commands do.
    pub uses: Vec<Use>,
    /// What the flags and parameters do that it writes by their numbers, with the axis, master or program.
    pub writes: Vec<(Deed, u32)>,
    /// The aliases that it writes.
    pub aliases: Vec<(Name, WriteKind)>,
    /// It writes system flags whose numbers are computed.
    pub computed_flags: bool,
    /// It writes system parameters whose numbers are computed.
    pub computed_parameters: bool,
    /// It writes user flags whose numbers are computed, or whole words of flags.
    pub computed_user_flags: bool,
    /// The user flags that it sets, and the numbers that wizard code reserves and that it writes.
    pub user: Vec<UserWrite>,
    /// The axes and masters that its commands name by their numbers.
    pub objects: Vec<(ObjectKind, u32)>,
    /// The programs that name axes.
    pub naming_axes: Vec<Level>,
    /// The programs whose text it holds.
    pub programs: Vec<Level>,
}

/// A user flag or parameter that is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct UserWrite {
    /// Flag or parameter.
    pub class: OperandClass,
    /// Its number.
    pub number: u32,
    /// How it is written.
    pub how: WriteKind,
    /// At the `SYS` prompt.
    pub system: bool,
    /// It stands in one of the programs that the vendor's wizard may fill, see [`usage::is_wizards_program`].
    pub wizards: bool,
}

/// A deed that is done by a command somewhere at a level.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Use<N = Name> {
    /// The deed.
    pub deed: Deed,
    /// The level.
    pub level: Level,
    /// It stands in the stored text of a program; otherwise it is executed as it arrives.
    pub stored: bool,
    /// What it is done to, with the name of an axis in capital letters.
    pub on: On<N>,
}

/// How something is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum WriteKind {
    /// `SET`
    Set,
    /// `CLR`
    Clear,
    /// An assignment, `FOR`, `INPUT`, or the output of a PLC rung.
    Assign,
}

/// Collects the effects of one file, whose text it borrows.
pub(super) struct Collector<'a> {
    text: &'a str,
    uses: FxHashSet<Use<&'a str>>,
    numbers: FxHashSet<(OperandClass, u64, WriteKind)>,
    user: FxHashSet<UserWrite>,
    objects: FxHashSet<(ObjectKind, u32)>,
    aliases: FxHashSet<(&'a str, WriteKind)>,
    effects: Effects,
}

impl<'a> Collector<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            text,
            uses: FxHashSet::default(),
            numbers: FxHashSet::default(),
            user: FxHashSet::default(),
            objects: FxHashSet::default(),
            aliases: FxHashSet::default(),
            effects: Effects::default(),
        }
    }

    /// Adds the stored text of a program that holds something.
    pub(super) fn program(&mut self, level: Level) {
        self.effects.programs.push(level);
    }

    /// Adds a statement of a section.
    pub(super) fn statement(&mut self, level: Level, stored: bool, statement: &Statement) {
        match &statement.kind {
            StatementKind::Command(command) => self.command(level, stored, command),
            StatementKind::Assign(assign) => self.assigned(level, &assign.target),
            StatementKind::For(counted) => self.assigned(level, &counted.variable),
            StatementKind::Input(input) => input.variables.iter().for_each(|variable| self.assigned(level, variable)),
            _ => {}
        }
        let known = self.effects.naming_axes.last() == Some(&level) || !matches!(level, Level::Program(_));
        if !known && walk::axes(statement).next().is_some() {
            self.effects.naming_axes.push(level);
        }
        self.watched(level, stored, statement);
    }

    /// Adds the programs whose state a wait or a condition looks at.
    fn watched(&mut self, level: Level, stored: bool, statement: &Statement) {
        let looks = match &statement.kind {
            StatementKind::If(_) => true,
            StatementKind::Command(command) => [command::INH, command::WHILE].contains(&command.id),
            _ => false,
        };
        if !looks {
            return;
        }
        let mut look = |number: u64| {
            if let Some(program) = deed::watched(number) {
                let on = On::Object(ObjectKind::Prog, Some(program));
                self.uses.insert(Use { deed: Deed::Watch, level, stored, on });
            }
        };
        walk::bits(statement).filter_map(|bit| walk::whole(&bit.index)).for_each(&mut look);
        walk::expressions(statement, &mut |expr| {
            if let ExprKind::Operand(operand) = &expr.kind
                && operand.class == OperandClass::Bit
                && let ExprKind::Integer(number) = operand.index.kind
            {
                look(number);
            }
        });
    }

    fn command(&mut self, level: Level, stored: bool, command: &Command) {
        let how = match command.id {
            command::SET => Some(WriteKind::Set),
            command::CLR => Some(WriteKind::Clear),
            command::OUT | command::OUT_NOT => Some(WriteKind::Assign),
            _ => None,
        };
        if let Some(how) = how {
            for argument in &command.arguments {
                if let Argument::Bit(bit) = argument {
                    self.written(level, OperandClass::Bit, &bit.index, how);
                }
            }
            return;
        }
        let arguments = command.arguments.iter().filter_map(|argument| match argument {
            Argument::Object(object) => Some(object),
            _ => None,
        });
        for object in command.prefix.as_deref().into_iter().chain(arguments).filter(|_| names_objects(command.id)) {
            if let (ObjectKind::Axis | ObjectKind::Master, Some(index)) = (object.kind, object.index) {
                self.objects.insert((object.kind, index));
            }
        }
        for act in deed::acts(command) {
            let on = match act.on {
                On::Level => On::Level,
                On::Axis(name) => On::Axis(slice(self.text, name)),
                On::Object(kind, index) => On::Object(kind, index),
                On::Word(word) => On::Word(word),
            };
            self.uses.insert(Use { deed: act.deed, level, stored, on });
        }
    }

    fn assigned(&mut self, level: Level, target: &Expr) {
        match &target.kind {
            ExprKind::Operand(operand) => self.written(level, operand.class, &operand.index, WriteKind::Assign),
            ExprKind::Alias => {
                self.aliases.insert((slice(self.text, target.span), WriteKind::Assign));
            }
            _ => {}
        }
    }

    fn written(&mut self, level: Level, class: OperandClass, index: &Expr, how: WriteKind) {
        let first = match class {
            OperandClass::Parameter => u64::from(acrc_catalog::FIRST_FLAG_WORD),
            OperandClass::Bit => u64::from(acrc_catalog::first_system_flag()),
            _ => return,
        };
        match &index.kind {
            ExprKind::Integer(number) => {
                if *number >= first {
                    self.numbers.insert((class, *number, how));
                }
                self.user_write(level, class, *number, how);
            }
            // `SET Lamp`: the alias is the flag. In `P(First)` it is a number.
            ExprKind::Alias if class == OperandClass::Bit => {
                self.aliases.insert((slice(self.text, index.span), how));
            }
            ExprKind::Paren(inner) => self.written(level, class, inner, how),
            // In `P(100 + LV0)` the number is where the user's table begins.
            _ if largest_integer(index).is_some_and(|number| number < first) => {
                self.effects.computed_user_flags |= class == OperandClass::Bit;
            }
            _ if class == OperandClass::Bit => {
                self.effects.computed_flags = true;
                self.effects.computed_user_flags = true;
            }
            _ => {
                self.effects.computed_parameters = true;
                self.effects.computed_user_flags = true;
            }
        }
    }

    fn user_write(&mut self, level: Level, class: OperandClass, number: u64, how: WriteKind) {
        let Ok(number) = u32::try_from(number) else { return };
        let wizards = usage::is_wizards_program(level);
        let write = UserWrite { class, number, how, system: level == Level::System, wizards };
        if usage::is_user_flag(class, number) || usage::is_wizards(class, number) {
            self.user.insert(write);
        }
        // A whole word of flags is written at once.
        self.effects.computed_user_flags |=
            class == OperandClass::Parameter && acrc_catalog::parameter(number).object == Space::Flags;
    }

    pub(super) fn finish(self) -> Effects {
        let Self { uses, numbers, aliases, user, objects, mut effects, .. } = self;
        effects.user = user.into_iter().collect();
        effects.objects = objects.into_iter().collect();
        sort(&mut effects.user);
        sort(&mut effects.objects);
        effects.uses = uses.into_iter().map(Use::owned).collect();
        effects.aliases = aliases.into_iter().map(|(name, how)| (name.into(), how)).collect();
        effects.writes = numbers.into_iter().flat_map(|(class, number, how)| deed::of(class, number, how)).collect();
        sort(&mut effects.uses);
        sort(&mut effects.aliases);
        sort(&mut effects.writes);
        sort(&mut effects.programs);
        sort(&mut effects.naming_axes);
        effects
    }
}

/// Whether the objects of a command are what it acts on; those of an attachment are listed with the attachments.
fn names_objects(id: CommandId) -> bool {
    ![command::ATTACH_MASTER, command::ATTACH_SLAVE, command::ATTACH_AXIS].contains(&id)
}

fn sort<T: Ord>(list: &mut Vec<T>) {
    list.sort_unstable();
    list.dedup();
}

impl Use<&str> {
    fn owned(self) -> Use {
        let Self { deed, level, stored, on } = self;
        let on = match on {
            On::Level => On::Level,
            On::Axis(name) => On::Axis(name.to_ascii_uppercase().into()),
            On::Object(kind, index) => On::Object(kind, index),
            On::Word(word) => On::Word(word),
        };
        Use { deed, level, stored, on }
    }
}

/// The largest integer that is written in an expression.
fn largest_integer(expr: &Expr) -> Option<u64> {
    let mut largest = None;
    walk::each(expr, &mut |inner| {
        if let ExprKind::Integer(number) = inner.kind {
            largest = largest.max(Some(number));
        }
    });
    largest
}

fn slice(text: &str, span: Span) -> &str {
    text.get(span.range()).unwrap_or_default()
}
