//! What commands set and report: servo gains, limits, jog and gear profiles, sources, analog gains.
//!
//! Where a parameter or flag is another way to a setting, that number is its only memory, and the catalogue says which one. The other settings are kept
//! here, by command and object.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use acrc_catalog::{AddressLaw, CommandId, ObjectKind, SetBy, all_bits, all_commands, all_parameters, command};
use acrc_vm::{Source, Value};

use crate::error::ControllerError;
use crate::machine::Machine;
use crate::nonvolatile::{Setting, SettingValue};

/// One value of a setting.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Item {
    /// A number.
    Number(Value),
    /// An object, parameter, array or word: `GEAR SRC X ENC2`.
    Source(Source),
    /// The name of a source that nobody has set: `NONE`.
    Factory(&'static str),
}

impl Item {
    fn saved(&self) -> Option<SettingValue> {
        match self {
            Self::Number(number) => Some(SettingValue::Number(number.clone())),
            Self::Source(source) => Some(SettingValue::Source(*source)),
            Self::Factory(_) => None,
        }
    }
}

/// The flags that keep a setting.
pub(crate) fn setting_flags() -> impl Iterator<Item = u32> {
    let laws = all_bits().filter(|row| row.set_by.is_some()).map(|row| row.law);
    laws.flat_map(|law| (0..law.count).filter_map(move |place| law.number(place)))
}

/// The settings that have no number: by command, object, and segment where an object has several.
#[derive(Clone, Debug, Default)]
pub(crate) struct Settings {
    kept: BTreeMap<(CommandId, u16, i32), Vec<Item>>,
}

impl Settings {
    fn keep(&mut self, command: CommandId, object: u16, items: Vec<Item>) {
        let segment = match items.first() {
            Some(Item::Number(number)) if SEGMENTED.contains(&command) => number.to_long().unwrap_or(0),
            _ => 0,
        };
        self.kept.insert((command, object, segment), items);
    }

    /// Everything that has been set.
    pub(crate) fn all(&self) -> impl Iterator<Item = Setting> {
        self.kept.iter().map(|((command, object, _), items)| Setting {
            command: *command,
            object: *object,
            values: items.iter().filter_map(Item::saved).collect(),
        })
    }

    /// Forgets everything but `settings`.
    pub(crate) fn replace(&mut self, settings: &[Setting]) {
        self.kept.clear();
        for setting in settings {
            let items = setting.values.iter().map(|value| match value {
                SettingValue::Number(number) => Item::Number(number.clone()),
                SettingValue::Source(source) => Item::Source(*source),
            });
            self.keep(setting.command, setting.object, items.collect());
        }
    }

    /// What was set for an object; nothing at power-up.
    pub(crate) fn of(&self, command: CommandId, object: u16) -> Vec<Item> {
        let segments = (command, object, i32::MIN)..=(command, object, i32::MAX);
        self.kept.range(segments).flat_map(|(_, items)| items).cloned().collect()
    }

    /// Forgets what some commands have set, for one object or for all.
    pub(crate) fn forget(&mut self, commands: &[CommandId], object: Option<u16>) {
        self.kept
            .retain(|(command, of, _), _| !commands.contains(command) || object.is_some_and(|object| object != *of));
    }
}

/// Settings whose first value says which segment of the table they are for.
const SEGMENTED: [CommandId; 2] = [command::CAM_SEG, command::BSC_SEG];

/// How many objects of a kind any controller has, where the catalogue says so: `PLSn` with 0 to 7.
pub(crate) fn most_objects(kind: ObjectKind) -> Option<u8> {
    static COUNTS: LazyLock<BTreeMap<ObjectKind, u8>> = LazyLock::new(|| {
        let count = |kind: &ObjectKind| {
            let command = all_commands().find(|command| command.name == kind.name())?;
            let number = command.arguments.iter().find(|argument| argument.name == "n")?;
            let last = number.range.split(&[' ', '.']).filter_map(|part| part.parse::<u8>().ok()).max()?;
            Some((*kind, last.saturating_add(1)))
        };
        ObjectKind::ALL.iter().filter_map(count).collect()
    });
    COUNTS.get(&kind).copied()
}

/// What a command's values are kept in.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// One parameter a value.
    Parameters,
    /// One flag a bit of the value.
    Flags,
}

/// The commands whose values have numbers.
static PLACES: LazyLock<BTreeMap<CommandId, (Kind, Vec<AddressLaw>)>> = LazyLock::new(|| {
    let parameters = all_parameters().filter_map(|row| Some((row.set_by?, row.law)));
    let bits = all_bits().filter_map(|row| Some((row.set_by?, row.law)));
    let places = by_command(parameters).map(|(command, laws)| (command, (Kind::Parameters, laws)));
    places.chain(by_command(bits).map(|(command, laws)| (command, (Kind::Flags, laws)))).collect()
});

/// The laws of each command in the order of its parts.
fn by_command(rows: impl Iterator<Item = (SetBy, AddressLaw)>) -> impl Iterator<Item = (CommandId, Vec<AddressLaw>)> {
    let mut parts: BTreeMap<CommandId, BTreeMap<u8, AddressLaw>> = BTreeMap::new();
    for (set_by, law) in rows {
        parts.entry(set_by.command).or_default().insert(set_by.part, law);
    }
    parts.into_iter().map(|(command, parts)| (command, parts.into_values().collect()))
}

impl Machine {
    /// Stores what a command sets for an object.
    pub(crate) fn set_setting(
        &mut self,
        command: CommandId,
        object: u16,
        items: Vec<Item>,
    ) -> Result<(), ControllerError> {
        let items = completed(command, items)?;
        match numbers(command, object)? {
            Some((Kind::Parameters, numbers)) => self.set_parameters(command, &numbers, &items),
            Some((Kind::Flags, numbers)) => {
                self.set_flags(command, &numbers, &items)?;
                self.touch_setting(command, object);
                Ok(())
            }
            None => {
                self.settings.keep(command, object, items);
                self.touch_setting(command, object);
                Ok(())
            }
        }
    }

    fn touch_setting(&mut self, command: CommandId, object: u16) {
        match u8::try_from(object) {
            Ok(axis) if command.info().takes_axes && axis < self.model.axes => self.motion.touch_axis(axis),
            _ => self.motion.touch(),
        }
    }

    /// What a command has set for an object, or what it is at power-up.
    pub(crate) fn setting(&self, command: CommandId, object: u16) -> Result<Vec<Item>, ControllerError> {
        match numbers(command, object)? {
            Some((Kind::Parameters, numbers)) => {
                numbers.into_iter().map(|number| self.read_parameter(number.into()).map(Item::Number)).collect()
            }
            Some((Kind::Flags, numbers)) => {
                let bits = numbers.into_iter().enumerate();
                let value = bits.fold(0, |value, (bit, number)| value | i32::from(self.flags.get(number)) << bit);
                Ok(vec![Item::Number(Value::Long(value))])
            }
            None => {
                let kept = self.settings.of(command, object);
                Ok(if kept.is_empty() { factory(command, object) } else { kept })
            }
        }
    }

    fn set_parameters(&mut self, command: CommandId, numbers: &[u32], items: &[Item]) -> Result<(), ControllerError> {
        for (number, item) in numbers.iter().zip(items) {
            let Item::Number(value) = item else { return Err(number_expected(command)) };
            self.write_parameter((*number).into(), value)?;
        }
        Ok(())
    }

    fn set_flags(&mut self, command: CommandId, numbers: &[u32], items: &[Item]) -> Result<(), ControllerError> {
        let [Item::Number(value)] = items else { return Err(number_expected(command)) };
        let value = value.to_long().map_err(ControllerError::Program)?;
        let most = (1 << numbers.len()) - 1;
        if !(0..=most).contains(&value) {
            let problem = format!("{value} is not between 0 and {most}");
            return Err(ControllerError::BadValue { command: command.info().name, problem });
        }
        for (bit, number) in numbers.iter().enumerate() {
            self.flags.set(*number, value >> bit & 1 == 1);
        }
        Ok(())
    }
}

/// The numbers that hold the values of a command for an object, if they have any.
fn numbers(command: CommandId, object: u16) -> Result<Option<(Kind, Vec<u32>)>, ControllerError> {
    let Some((kind, laws)) = PLACES.get(&command) else { return Ok(None) };
    let numbers = laws.iter().map(|law| numbered(command, law, object)).collect::<Result<_, _>>()?;
    Ok(Some((*kind, numbers)))
}

/// The number that belongs to an object.
fn numbered(command: CommandId, law: &AddressLaw, object: u16) -> Result<u32, ControllerError> {
    let number = u32::from(object).checked_sub(law.first_index).and_then(|place| law.number(place));
    number.ok_or_else(|| {
        let kind = command.info().prefixes.first().map_or("", |kind| kind.name());
        let last = (law.first_index + law.count).saturating_sub(1) as u8;
        ControllerError::NoSuchObject { object: kind, index: i64::from(object), last }
    })
}

/// The values of a command in the forms of its arguments, those of a pair that were left out added.
fn completed(command: CommandId, items: Vec<Item>) -> Result<Vec<Item>, ControllerError> {
    let info = command.info();
    let mut completed = Vec::with_capacity(items.len());
    for (place, item) in items.into_iter().enumerate() {
        let kind = info.arguments.get(place).map_or("", |argument| argument.kind);
        completed.push(match item {
            Item::Number(value) => Item::Number(in_form(command, kind, &value)?),
            other => other,
        });
    }
    let opposite = info.arguments.get(completed.len()).is_some_and(|argument| argument.opposite);
    if let ([Item::Number(value)], true) = (&completed[..], opposite) {
        let real = value.to_f64().map_err(ControllerError::Program)?;
        // A difference, so that the opposite of 0 has no sign.
        completed.push(Item::Number(Value::Single((0.0 - real) as f32)));
    }
    Ok(completed)
}

fn in_form(command: CommandId, kind: &str, value: &Value) -> Result<Value, ControllerError> {
    let real = value.to_f64().map_err(ControllerError::Program)?;
    let single = real as f32;
    match kind {
        "long" => value.to_long().map(Value::Long).map_err(ControllerError::Program),
        "FP32" if single.is_finite() => Ok(Value::Single(single)),
        "FP32" => Err(ControllerError::BadValue {
            command: command.info().name,
            problem: format!("{real} is beyond the range of 32 bits"),
        }),
        _ => Ok(value.clone()),
    }
}

/// What a setting is at power-up: the default of its arguments where a document states one, else 0.
fn factory(id: CommandId, object: u16) -> Vec<Item> {
    let info = id.info();
    if id == command::HLBIT {
        // On the ACR90x0 the lowest inputs belong to the lowest axis, three to each.
        return vec![Item::Number(Value::Long(i32::from(object) * 3))];
    }
    let arguments = info.arguments.iter().filter(|argument| argument.name != "n");
    let items = arguments.take(usize::from(info.tuple_min.max(1))).map(|argument| {
        match (argument.default_value, argument.default) {
            (Some(value), _) => Item::Number(Value::Single(value as f32)),
            (None, "") => Item::Number(Value::Long(0)),
            (None, word) => Item::Factory(word),
        }
    });
    let items: Vec<_> = items.collect();
    if items.is_empty() { vec![Item::Number(Value::Long(0))] } else { items }
}

fn number_expected(command: CommandId) -> ControllerError {
    ControllerError::Expected { command: command.info().name, expected: "numbers" }
}
