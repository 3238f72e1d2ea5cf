//! What happens in a world, and when.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::{AXES, InputFile, WorldError, resolve_input};
use crate::registers::is_plain_parameter;
use crate::streams::{Port, as_typed};
use crate::time::parse_duration;

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
    /// What happens to the mechanics.
    pub happenings: Vec<Happening>,
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

/// Something that happens to the mechanics around the controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Happening {
    /// Something holds an axis.
    Jam(u8),
    /// Nothing holds it any more.
    Free(u8),
    /// The signals of an encoder are lost.
    EncoderLost(u8),
    /// They are back.
    EncoderBack(u8),
    /// A drive reports a fault.
    DriveFault(u8),
    /// The motion enable input is closed (true) or opens (false).
    MotionEnable(bool),
}

impl Happening {
    /// The axis that it happens to.
    pub fn axis(&self) -> Option<u8> {
        match self {
            Self::Jam(axis)
            | Self::Free(axis)
            | Self::EncoderLost(axis)
            | Self::EncoderBack(axis)
            | Self::DriveFault(axis) => Some(*axis),
            Self::MotionEnable(_) => None,
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EventFile {
    at: TimeFile,
    #[serde(default)]
    set: Vec<InputFile>,
    #[serde(default)]
    clear: Vec<InputFile>,
    #[serde(default)]
    parameters: BTreeMap<String, f64>,
    stream: Option<String>,
    text: Option<String>,
    #[serde(default)]
    jam: Vec<i64>,
    #[serde(default)]
    free: Vec<i64>,
    #[serde(default)]
    encoder_lost: Vec<i64>,
    #[serde(default)]
    encoder_back: Vec<i64>,
    #[serde(default)]
    drive_fault: Vec<i64>,
    motion_enable: Option<bool>,
    note: Option<String>,
}

#[derive(Deserialize)]
#[serde(untagged, expecting = "expected a number of seconds or a text such as \"2.5s\"")]
enum TimeFile {
    Seconds(f64),
    Text(String),
}

pub(super) fn read(event: usize, file: &EventFile, inputs: &BTreeMap<String, u32>) -> Result<WorldEvent, WorldError> {
    let at = match &file.at {
        TimeFile::Seconds(seconds) => *seconds,
        TimeFile::Text(text) => parse_duration(text).map_err(|problem| WorldError::Time { event, problem })?,
    };
    if !(at.is_finite() && (0.0..=1e9).contains(&at)) {
        return Err(WorldError::Unreachable { event, at });
    }
    let typed = read_typed(event, file)?;
    let happenings = read_happenings(event, file)?;
    let flags = file.set.is_empty() && file.clear.is_empty() && file.parameters.is_empty();
    if flags && typed.is_none() && happenings.is_empty() {
        return Err(WorldError::Empty { event });
    }
    let resolve = |list: &[InputFile]| {
        let place = || format!("event {event}");
        list.iter().map(|input| resolve_input(place, input, inputs)).collect::<Result<Vec<_>, _>>()
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
        happenings,
        note: file.note.clone(),
    })
}

fn read_happenings(event: usize, file: &EventFile) -> Result<Vec<Happening>, WorldError> {
    let kinds = [
        ("jam", &file.jam, Happening::Jam as fn(u8) -> Happening),
        ("free", &file.free, Happening::Free),
        ("encoder_lost", &file.encoder_lost, Happening::EncoderLost),
        ("encoder_back", &file.encoder_back, Happening::EncoderBack),
        ("drive_fault", &file.drive_fault, Happening::DriveFault),
    ];
    let mut happenings: Vec<Happening> = file.motion_enable.map(Happening::MotionEnable).into_iter().collect();
    for (key, axes, happening) in kinds {
        for number in axes {
            let axis = u8::try_from(*number).ok().filter(|axis| *axis < AXES);
            let place = || format!("event {event}, `{key}`");
            let axis = axis.ok_or_else(|| WorldError::NoSuchAxis { place: place(), axis: number.to_string() })?;
            happenings.push(happening(axis));
        }
    }
    Ok(happenings)
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
