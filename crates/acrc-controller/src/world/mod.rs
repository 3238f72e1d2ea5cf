//! The machine around the controller, as far as a dry run needs one: named inputs, and a timeline of what happens to them and to parameters that are
//! measured or written by a host.
//!
//! Described by a `world.toml`:
//!
//! ```toml
//! [inputs]
//! light_curtain = 10          # a name for onboard input 10
//! part_present = 11520        # or for another flag that comes from outside: an input of a network
//!
//! [[event]]
//! at = "2.5s"                 # virtual time; a plain number is seconds
//! set = ["light_curtain", 3]  # inputs that come on
//! clear = [4]                 # inputs that go off
//! parameters = { P6408 = 2.5 } # parameters that get a value: 2.5 V at analog input 0
//! note = "operator reaches in" # shown in plots
//!
//! [[event]]
//! at = "4s"
//! stream = "COM1"             # or PROG0: at the terminal that listens to program 0
//! text = "12\n"               # typed there; the end of a line is the Enter key
//! ```

use std::collections::BTreeMap;

use serde::Deserialize;
use thiserror::Error;

use crate::registers::{is_outside_flag, is_plain_parameter};
use crate::streams::{Port, as_typed};
use crate::terminal::StreamError;
use crate::time::parse_duration;

/// Number of onboard inputs (bits 0-31).
pub(crate) const INPUTS: u32 = 32;

/// A scripted change of inputs and parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct WorldEvent {
    /// Virtual time in seconds.
    pub at: f64,
    /// Inputs, and other flags that come from outside, that come on.
    pub set: Vec<u32>,
    /// The same that go off.
    pub clear: Vec<u32>,
    /// Parameters that get a value: analog inputs, user parameters that a host writes. Programs may be refused to write them.
    pub parameters: Vec<(u32, f64)>,
    /// What somebody types.
    pub typed: Option<TypedText>,
    /// What it stands for, for people.
    pub note: Option<String>,
}

/// Text that somebody types.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TypedText {
    /// Where.
    pub port: Port,
    /// The characters, one byte each.
    pub text: Vec<u8>,
}

/// The world of one run: names of inputs and events in order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct World {
    inputs: BTreeMap<String, u32>,
    events: Vec<WorldEvent>,
}

/// A `world.toml` that cannot be used.
#[derive(Debug, Error)]
pub enum WorldError {
    /// Not TOML, or a key that is unknown or of the wrong type.
    #[error(transparent)]
    Toml(#[from] Box<toml::de::Error>),
    /// A time that cannot be read.
    #[error("event {event}: {problem}")]
    Time {
        /// Position in the file, from 1.
        event: usize,
        /// Why.
        problem: crate::time::DurationError,
    },
    /// A time that no run reaches.
    #[error("event {event}: a time of {at} seconds is not possible")]
    Unreachable {
        /// Position in the file, from 1.
        event: usize,
        /// The time.
        at: f64,
    },
    /// A name that `[inputs]` does not give.
    #[error("event {event}: no input is named `{name}`; `[inputs]` names {known}")]
    UnknownInput {
        /// Position in the file, from 1.
        event: usize,
        /// The name.
        name: String,
        /// The names there are.
        known: String,
    },
    /// A flag that the controller decides.
    #[error(
        "{place}: flag {number} does not come from outside: onboard inputs are 0 to 31; networks and hardware have more"
    )]
    NotAnInput {
        /// Where.
        place: String,
        /// The number.
        number: i64,
    },
    /// A key of `parameters` that stands for nothing a world can change.
    #[error("event {event}: `{name}` is no parameter that keeps a value, such as P0 or P6408")]
    NotAParameter {
        /// Position in the file, from 1.
        event: usize,
        /// The key.
        name: String,
    },
    /// A stream that no controller has.
    #[error("event {event}: {problem}; PROG0 stands for the terminal that listens to program 0")]
    UnknownStream {
        /// Position in the file, from 1.
        event: usize,
        /// Why.
        problem: StreamError,
    },
    /// `stream` without `text`, or the other way round.
    #[error("event {event}: `stream` and `text` belong together: where something is typed, and what")]
    HalfTyped {
        /// Position in the file, from 1.
        event: usize,
    },
    /// A character that no controller has.
    #[error("event {event}: `{character}` cannot be typed at a controller: its characters have one byte")]
    Character {
        /// Position in the file, from 1.
        event: usize,
        /// The character.
        character: char,
    },
    /// An event with nothing in it.
    #[error("event {event}: nothing happens in it: give `set`, `clear`, `parameters`, or `stream` and `text`")]
    Empty {
        /// Position in the file, from 1.
        event: usize,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WorldFile {
    #[serde(default)]
    inputs: BTreeMap<String, i64>,
    #[serde(default)]
    event: Vec<EventFile>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EventFile {
    at: TimeFile,
    #[serde(default)]
    set: Vec<InputFile>,
    #[serde(default)]
    clear: Vec<InputFile>,
    #[serde(default)]
    parameters: BTreeMap<String, f64>,
    stream: Option<String>,
    text: Option<String>,
    note: Option<String>,
}

#[derive(Deserialize)]
#[serde(untagged, expecting = "expected a number of seconds or a text such as \"2.5s\"")]
enum TimeFile {
    Seconds(f64),
    Text(String),
}

#[derive(Deserialize)]
#[serde(untagged, expecting = "expected the number or the name of an input")]
enum InputFile {
    Number(i64),
    Name(String),
}

impl World {
    /// Reads the text of a `world.toml`.
    pub fn parse(text: &str) -> Result<Self, WorldError> {
        let file: WorldFile = toml::from_str(text).map_err(Box::new)?;
        let mut inputs = BTreeMap::new();
        for (name, number) in file.inputs {
            let bit = outside(number, || format!("input `{name}`"))?;
            inputs.insert(name, bit);
        }
        let mut events = Vec::with_capacity(file.event.len());
        for (index, event) in file.event.iter().enumerate() {
            events.push(read_event(index + 1, event, &inputs)?);
        }
        // Events of the same time keep the order of the file.
        events.sort_by(|left, right| left.at.total_cmp(&right.at));
        Ok(Self { inputs, events })
    }

    /// The events in order of time.
    pub fn events(&self) -> &[WorldEvent] {
        &self.events
    }

    /// The names given to inputs.
    pub fn inputs(&self) -> impl Iterator<Item = (&str, u32)> {
        self.inputs.iter().map(|(name, bit)| (name.as_str(), *bit))
    }

    /// The name of an input bit.
    pub fn input_name(&self, bit: u32) -> Option<&str> {
        self.inputs().find(|(_, number)| *number == bit).map(|(name, _)| name)
    }

    /// Every input that an event changes, ascending.
    pub fn driven_inputs(&self) -> Vec<u32> {
        let mut bits: Vec<u32> =
            self.events.iter().flat_map(|event| event.set.iter().chain(&event.clear).copied()).collect();
        bits.sort_unstable();
        bits.dedup();
        bits
    }
}

fn outside(number: i64, place: impl FnOnce() -> String) -> Result<u32, WorldError> {
    match u32::try_from(number) {
        Ok(bit) if is_outside_flag(bit) => Ok(bit),
        _ => Err(WorldError::NotAnInput { place: place(), number }),
    }
}

fn read_event(event: usize, file: &EventFile, inputs: &BTreeMap<String, u32>) -> Result<WorldEvent, WorldError> {
    let at = match &file.at {
        TimeFile::Seconds(seconds) => *seconds,
        TimeFile::Text(text) => parse_duration(text).map_err(|problem| WorldError::Time { event, problem })?,
    };
    if !(at.is_finite() && (0.0..=1e9).contains(&at)) {
        return Err(WorldError::Unreachable { event, at });
    }
    let typed = read_typed(event, file)?;
    if file.set.is_empty() && file.clear.is_empty() && file.parameters.is_empty() && typed.is_none() {
        return Err(WorldError::Empty { event });
    }
    let resolve = |list: &[InputFile]| {
        list.iter().map(|input| resolve_input(event, input, inputs)).collect::<Result<Vec<_>, _>>()
    };
    let parameters = file.parameters.iter().map(|(name, value)| {
        let number = name.strip_prefix(['P', 'p']).and_then(|digits| digits.parse().ok());
        let number = number.filter(|number| value.is_finite() && is_plain_parameter(*number));
        let number = number.ok_or_else(|| WorldError::NotAParameter { event, name: name.clone() });
        number.map(|number| (number, *value))
    });
    Ok(WorldEvent {
        at,
        set: resolve(&file.set)?,
        clear: resolve(&file.clear)?,
        parameters: parameters.collect::<Result<_, WorldError>>()?,
        typed,
        note: file.note.clone(),
    })
}

fn read_typed(event: usize, file: &EventFile) -> Result<Option<TypedText>, WorldError> {
    let (stream, text) = match (&file.stream, &file.text) {
        (None, None) => return Ok(None),
        (Some(stream), Some(text)) => (stream, text),
        _ => return Err(WorldError::HalfTyped { event }),
    };
    let port = stream.parse().map_err(|problem| WorldError::UnknownStream { event, problem })?;
    let byte = |character| u8::try_from(character).map_err(|_| WorldError::Character { event, character });
    let text = text.chars().map(byte).collect::<Result<Vec<u8>, WorldError>>()?;
    Ok(Some(TypedText { port, text: as_typed(&text) }))
}

fn resolve_input(event: usize, input: &InputFile, inputs: &BTreeMap<String, u32>) -> Result<u32, WorldError> {
    match input {
        InputFile::Number(number) => outside(*number, || format!("event {event}")),
        InputFile::Name(name) => inputs.get(name).copied().ok_or_else(|| WorldError::UnknownInput {
            event,
            name: name.clone(),
            known: match inputs.len() {
                0 => "none".to_owned(),
                _ => inputs.keys().map(|key| format!("`{key}`")).collect::<Vec<_>>().join(", "),
            },
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn events_are_sorted_and_names_resolved() {
        let world = World::parse(
            "[inputs]\ncurtain = 10\n[[event]]\nat = 3\nclear = [\"curtain\"]\n[[event]]\nat = \"1500ms\"\nset = [\"curtain\", 4]\nnote = \"hand\"\n",
        )
        .expect("a valid world");
        assert_eq!(
            world.events()[0],
            WorldEvent {
                at: 1.5,
                set: vec![10, 4],
                clear: vec![],
                parameters: vec![],
                typed: None,
                note: Some("hand".to_owned())
            }
        );
        assert_eq!(world.events()[1].at, 3.0);
        assert_eq!(world.driven_inputs(), [4, 10]);
        assert_eq!(world.input_name(10), Some("curtain"));
    }

    #[test]
    fn every_bad_world_says_what_is_wrong() {
        for (text, expected) in [
            ("[[event]]\nat = 1\nset = [\"door\"]", "event 1: no input is named `door`; `[inputs]` names none"),
            (
                "[[event]]\nat = 1\nset = [32]",
                "event 1: flag 32 does not come from outside: onboard inputs are 0 to 31",
            ),
            ("[inputs]\ndoor = -1", "input `door`: flag -1 does not come from outside"),
            ("[[event]]\nat = 1\nclear = [516]", "event 1: flag 516 does not come from outside"),
            ("[[event]]\nat = 1\nset = [65536]", "event 1: flag 65536 does not come from outside"),
            ("[[event]]\nat = \"soon\"\nset = [1]", "event 1: `soon` is no duration"),
            ("[[event]]\nat = -1.0\nset = [1]", "event 1: a time of -1 seconds is not possible"),
            ("[[event]]\nat = 1", "event 1: nothing happens in it"),
            ("[[event]]\nat = 1\ntext = \"a\"", "event 1: `stream` and `text` belong together"),
            ("[[event]]\nat = 1\nstream = \"COM9\"\ntext = \"a\"", "event 1: `COM9` is no stream"),
            ("[[event]]\nat = 1\nstream = \"COM1\"\ntext = \"\u{20ac}\"", "event 1: `\u{20ac}` cannot be typed"),
            ("[[event]]\nat = 1\nparameters = { P12290 = 1 }", "event 1: `P12290` is no parameter that keeps a value"),
            ("[[event]]\nat = 1\nparameters = { P4097 = 1 }", "event 1: `P4097` is no parameter that keeps a value"),
            ("[[event]]\nat = 1\nparameters = { BIT5 = 1 }", "event 1: `BIT5` is no parameter that keeps a value"),
            ("[[event]]\nat = true\nset = [1]", "expected a number of seconds"),
            ("[[evnt]]\nat = 1", "unknown field `evnt`"),
        ] {
            let message = World::parse(text).expect_err(text).to_string();
            assert!(message.contains(expected), "{text}\n{message}");
        }
    }
}
