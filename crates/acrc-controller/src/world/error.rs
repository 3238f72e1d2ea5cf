//! What can be wrong with a `world.toml`.

use thiserror::Error;

use crate::terminal::StreamError;

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
    #[error("{place}: no input is named `{name}`; `[inputs]` names {known}")]
    UnknownInput {
        /// Where.
        place: String,
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
    #[error(
        "event {event}: nothing happens in it: give `set`, `clear`, `parameters`, `stream` and `text`, or what happens to an axis"
    )]
    Empty {
        /// Position in the file, from 1.
        event: usize,
    },
    /// An axis that no controller has.
    #[error("{place}: no controller has an axis {axis}: they are numbered 0 to 15")]
    NoSuchAxis {
        /// Where.
        place: String,
        /// What was given as its number.
        axis: String,
    },
    /// A value that is not possible.
    #[error("{place}: `{key}` is {value}, and must be {range}")]
    OutOfRange {
        /// Where.
        place: String,
        /// The key.
        key: &'static str,
        /// Its value.
        value: f64,
        /// What it may be.
        range: &'static str,
    },
    /// A plant that cannot be read.
    #[error("axis {axis}, `plant`: {problem}")]
    Plant {
        /// The axis.
        axis: u8,
        /// Why.
        problem: String,
    },
    /// A switch without a place, or with several.
    #[error("axis {axis}, switch {switch}: where it is closed is said by `from` and `to`, by `above`, or by `below`")]
    SwitchPlace {
        /// The axis.
        axis: u8,
        /// Position in its list, from 1.
        switch: usize,
    },
    /// More inputs that capture than a controller has.
    #[error("axis {axis}: `capture_inputs` names {count} inputs: a controller has a first and a second one")]
    CaptureInputs {
        /// The axis.
        axis: u8,
        /// How many there are.
        count: usize,
    },
}
