//! Commands that set a value which stays, and report it: the settings of the catalogue ([`crate::settings`]).

use acrc_catalog::{Command, CommandId, ObjectKind, command};
use acrc_vm::{Arg, ArgValue, Call, Outcome, Reference, Source, Value, format};

use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::settings::{Item, most_objects};

/// Settings that act by themselves on the controller unless they are 0, and what the run says of them.
const ACTING: [(CommandId, &str); 1] = [(command::ENC_ROTARY, "was set: the dry run does not fold encoder positions")];

/// Commands that make settings those of power-up again.
const FORGETTING: [(CommandId, &[CommandId]); 4] = [
    (command::CAM_CLEAR, &[command::CAM_DIM, command::CAM_SEG]),
    (command::BSC_CLEAR, &[command::BSC_DIM, command::BSC_SEG]),
    (command::FSTAT_CLEAR, &[command::FSTAT]),
    (command::SAMP_CLEAR, &[command::SAMP_SRC, command::SAMP_BASE, command::SAMP_TRG]),
];

pub(super) const COMMANDS: &[Entry] = &[(command::FSTAT_CLEAR, Action::Run(forget))];

/// How a setting is executed, if the command is one.
pub(super) fn action(info: &Command) -> Option<Action> {
    info.setting.then_some(Action::Run(keep))
}

/// Keeps the values of each object of a call, or reports them where none are given.
pub(super) fn keep(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    for (object, items) in context.setting_items(call)? {
        if items.is_empty() {
            context.report_setting(call.command, object)?;
            continue;
        }
        if let Some((_, what)) = ACTING.iter().find(|(command, _)| *command == call.command)
            && items.iter().any(|item| !matches!(item, Item::Number(value) if value.truth() == Ok(false)))
        {
            let name = call.command.info().name;
            context.machine.notes.insert(format!("{name} {what}"));
        }
        context.machine.set_setting(call.command, object, items)?;
    }
    Ok(Outcome::Done)
}

/// Forgets the settings of the axes of a call; commands of no axis do so for all objects.
pub(super) fn forget(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let forgotten = FORGETTING.iter().find(|(command, _)| *command == call.command).map_or(&[][..], |(_, rest)| rest);
    if !call.command.info().takes_axes {
        context.machine.settings.forget(forgotten, None);
        return Ok(Outcome::Done);
    }
    for argument in context.axes(call)? {
        context.machine.settings.forget(forgotten, Some(u16::from(argument.axis)));
    }
    Ok(Outcome::Done)
}

impl Context<'_> {
    /// The objects of a call, each with the values given to it.
    fn setting_items(&self, call: &Call) -> Result<Vec<(u16, Vec<Item>)>, ControllerError> {
        let info = call.command.info();
        let prefixed = match call.prefix {
            Some((ObjectKind::Axis, index)) => Some(u16::from(self.axis(index.map_or(-1, i64::from))?)),
            Some((kind, index)) => {
                let index = index.unwrap_or(0);
                if let Some(count) = most_objects(kind) {
                    Machine::object(kind.name(), i64::from(index), count)?;
                }
                Some(index)
            }
            None if info.takes_axes => None,
            None => Some(0),
        };
        if let Some(object) = prefixed {
            let mut items = Vec::new();
            for argument in call.arguments {
                items.extend(argument_items(info.name, argument)?);
            }
            return Ok(vec![(object, items)]);
        }
        call.arguments
            .iter()
            .map(|argument| {
                let (axis, value) = self.axis_and_value(call, argument)?;
                Ok((u16::from(axis), value_items(value)))
            })
            .collect()
    }

    fn report_setting(&mut self, command: CommandId, object: u16) -> Result<(), ControllerError> {
        for item in self.machine.setting(command, object)? {
            match item {
                Item::Number(value) => self.report_text(&format::number(&value)),
                Item::Source(source) => self.report_text(&source_name(source)),
                Item::Factory(word) => self.report_text(word),
            }
        }
        Ok(())
    }
}

pub(super) fn argument_items(command: &'static str, argument: &Arg) -> Result<Vec<Item>, ControllerError> {
    Ok(match argument {
        Arg::Value(value, _) => vec![Item::Number(value.clone())],
        Arg::Tuple(values) => values.iter().cloned().map(Item::Number).collect(),
        Arg::Object { kind, index, value: ArgValue::None, .. } => vec![Item::Source(Source::Object(*kind, *index))],
        Arg::Word { keyword, index } => vec![Item::Source(Source::Word(*keyword, *index))],
        Arg::Reference { target, negative: false, .. } => vec![Item::Source(Source::Reference(*target))],
        Arg::Bit { index, negative: false } => vec![Item::Source(Source::Reference(Reference::Bit(*index)))],
        _ => return Err(ControllerError::Expected { command, expected: "values behind it" }),
    })
}

fn value_items(value: &ArgValue) -> Vec<Item> {
    let numbers = |values: &[Value]| values.iter().cloned().map(Item::Number).collect();
    match value {
        ArgValue::None => Vec::new(),
        ArgValue::Value(value) => vec![Item::Number(value.clone())],
        ArgValue::Tuple(values) => numbers(values),
        ArgValue::Table { values, table } => {
            let mut items: Vec<Item> = numbers(values);
            items.push(Item::Source(Source::Reference(*table)));
            items
        }
        ArgValue::Source(source) => vec![Item::Source(*source)],
    }
}

/// A source as it is written.
pub(super) fn source_name(source: Source) -> String {
    let glued = |word: &str, index: Option<u16>| index.map_or(word.to_owned(), |index| format!("{word}{index}"));
    match source {
        Source::Object(kind, index) => glued(kind.name(), index),
        Source::Word(keyword, index) => glued(keyword.name(), index),
        Source::Reference(Reference::Parameter(number)) => format!("P{number}"),
        Source::Reference(Reference::Bit(number)) => format!("BIT{number}"),
        Source::Reference(Reference::Variable { class, index }) => format!("{class}{index}"),
        Source::Reference(Reference::Array { class, array }) => format!("{class}{array}"),
        Source::Reference(Reference::Element { class, array, element }) => format!("{class}{array}({element})"),
    }
}
