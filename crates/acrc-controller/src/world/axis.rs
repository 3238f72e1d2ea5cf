//! The mechanics of an axis: what moves when its setpoint does, and what is to be felt on the way.
//!
//! All places are those of the machine in programming units: the counts of the encoder since power-up, divided by `PPU`, and `start`. No command moves
//! them, as `RES` and its like move the registers of the axis.

use std::collections::BTreeMap;

use acrc_motion::InvalidValue;
use acrc_motion::servo::{Encoder, Motor, MotorModel, Stepper};
use serde::Deserialize;

use super::{InputFile, WorldError, resolve_input};

/// The mechanics of an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AxisWorld {
    /// What its output drives.
    pub plant: PlantWorld,
    /// Where it stands at power-up, units.
    pub start: f64,
    /// Play between the encoder and what the axis moves, units. Driven in the positive direction, the load trails by it.
    pub backlash: f64,
    /// The switches along its way.
    pub switches: Vec<Switch>,
    /// The index marks of its encoder.
    pub marker: Option<Marker>,
    /// The inputs that capture its position: the first and the second external one.
    pub capture_inputs: Vec<u32>,
}

/// What the output of an axis drives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum PlantWorld {
    /// The axis is where its setpoint is.
    #[default]
    Ideal,
    /// A motor, driven by the output of the servo loop.
    Motor(MotorWorld),
    /// A stepper motor.
    Stepper(Stepper),
}

/// A motor and its encoder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorWorld {
    /// The motor with its load. Its encoder is multiplied by one.
    pub model: MotorModel,
    /// Lines of the encoder in a turn; `MULT` multiplies them.
    pub lines: f64,
}

/// A switch that is closed along a part of the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch {
    /// The input that it is wired to.
    pub input: u32,
    /// Where the load closes it.
    pub region: Region,
    /// It is closed everywhere else instead.
    pub normally_closed: bool,
}

/// A part of the way of an axis, units; its ends belong to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// Lower end; there may be none.
    pub from: f64,
    /// Upper end; there may be none.
    pub to: f64,
}

impl Region {
    /// Whether a place lies in it.
    pub fn contains(&self, place: f64) -> bool {
        (self.from..=self.to).contains(&place)
    }
}

/// The index marks of an encoder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marker {
    /// Where one of them is, units.
    pub at: f64,
    /// How far it is to the next, units; `None` for a single one.
    pub every: Option<f64>,
}

impl Marker {
    /// The first mark on the way from one place to another, where the way ends but not where it begins.
    pub fn crossed(&self, from: f64, to: f64) -> Option<f64> {
        let ahead = to > from;
        let mark = match self.every {
            None => self.at,
            Some(every) if ahead => self.at + (((from - self.at) / every).floor() + 1.0) * every,
            Some(every) => self.at + (((from - self.at) / every).ceil() - 1.0) * every,
        };
        let on_the_way = if ahead { from < mark && mark <= to } else { to <= mark && mark < from };
        on_the_way.then_some(mark)
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AxisFile {
    plant: Option<toml::Value>,
    #[serde(default)]
    start: f64,
    #[serde(default)]
    backlash: f64,
    #[serde(default)]
    switches: Vec<SwitchFile>,
    marker: Option<MarkerFile>,
    #[serde(default)]
    capture_inputs: Vec<InputFile>,
}

#[derive(Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
enum PlantFile {
    Ideal {},
    Motor(MotorFile),
    Stepper(StepperFile),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MotorFile {
    inertia: f64,
    torque_constant: f64,
    #[serde(default = "one")]
    amplifier_gain: f64,
    #[serde(default)]
    viscous_friction: f64,
    #[serde(default)]
    coulomb_friction: f64,
    #[serde(default)]
    load_torque: f64,
    lines: f64,
}

fn one() -> f64 {
    1.0
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StepperFile {
    #[serde(default)]
    greatest_rate: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SwitchFile {
    input: InputFile,
    from: Option<f64>,
    to: Option<f64>,
    above: Option<f64>,
    below: Option<f64>,
    #[serde(default)]
    normally: Rest,
}

/// What a switch is where nothing touches it.
#[derive(Clone, Copy, Default, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum Rest {
    #[default]
    Open,
    Closed,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MarkerFile {
    #[serde(default)]
    at: f64,
    every: Option<f64>,
}

/// Reads the description of an axis.
pub(super) fn read(axis: u8, file: AxisFile, inputs: &BTreeMap<String, u32>) -> Result<AxisWorld, WorldError> {
    let place = || format!("axis {axis}");
    let count = file.capture_inputs.len();
    if count > 2 {
        return Err(WorldError::CaptureInputs { axis, count });
    }
    let capture_inputs = file.capture_inputs.iter().map(|input| resolve_input(place, input, inputs));
    let switches = file.switches.iter().enumerate();
    Ok(AxisWorld {
        plant: file.plant.map_or(Ok(PlantWorld::Ideal), |plant| read_plant(axis, plant))?,
        start: finite(place, "start", file.start)?,
        backlash: not_negative(place, "backlash", file.backlash)?,
        capture_inputs: capture_inputs.collect::<Result<_, _>>()?,
        switches: switches
            .map(|(index, switch)| read_switch(axis, index + 1, switch, inputs))
            .collect::<Result<_, _>>()?,
        marker: file.marker.map(|marker| read_marker(axis, &marker)).transpose()?,
    })
}

fn read_plant(axis: u8, plant: toml::Value) -> Result<PlantWorld, WorldError> {
    let table = match plant {
        // A plant that has no values may be named only.
        toml::Value::String(kind) => toml::Table::from_iter([("kind".to_owned(), toml::Value::String(kind))]),
        toml::Value::Table(table) => table,
        other => {
            let problem =
                format!("expected \"ideal\", \"stepper\" or a table with its `kind`, found {}", other.type_str());
            return Err(WorldError::Plant { axis, problem });
        }
    };
    let file = table
        .try_into()
        .map_err(|error: toml::de::Error| WorldError::Plant { axis, problem: error.message().to_owned() })?;
    match file {
        PlantFile::Ideal {} => Ok(PlantWorld::Ideal),
        PlantFile::Motor(motor) => read_motor(axis, &motor).map(PlantWorld::Motor),
        PlantFile::Stepper(StepperFile { greatest_rate }) => {
            let place = || format!("axis {axis}, `plant`");
            let rate = not_negative(place, "greatest_rate", greatest_rate)?;
            Stepper::new(rate).map(PlantWorld::Stepper).map_err(|error| impossible(axis, error))
        }
    }
}

fn read_motor(axis: u8, file: &MotorFile) -> Result<MotorWorld, WorldError> {
    let place = || format!("axis {axis}, `plant`");
    let torque_constant = positive(place, "torque_constant", file.torque_constant)?;
    let amplifier_gain = finite(place, "amplifier_gain", file.amplifier_gain)?;
    let lines = positive(place, "lines", file.lines)?;
    let model = MotorModel {
        inertia: positive(place, "inertia", file.inertia)?,
        torque_per_volt: torque_constant * amplifier_gain,
        viscous_friction: not_negative(place, "viscous_friction", file.viscous_friction)?,
        coulomb_friction: not_negative(place, "coulomb_friction", file.coulomb_friction)?,
        load_torque: finite(place, "load_torque", file.load_torque)?,
        encoder: Encoder::new(lines, 1).map_err(|error| impossible(axis, error))?,
    };
    Motor::new(model).map_err(|error| impossible(axis, error))?;
    Ok(MotorWorld { model, lines })
}

/// What only all values together show.
fn impossible(axis: u8, error: InvalidValue) -> WorldError {
    WorldError::Plant { axis, problem: error.to_string() }
}

fn read_switch(
    axis: u8,
    switch: usize,
    file: &SwitchFile,
    inputs: &BTreeMap<String, u32>,
) -> Result<Switch, WorldError> {
    let place = || format!("axis {axis}, switch {switch}");
    let region = match (file.from, file.to, file.above, file.below) {
        (Some(from), Some(to), None, None) => Region { from, to },
        (None, None, Some(above), None) => Region { from: above, to: f64::INFINITY },
        (None, None, None, Some(below)) => Region { from: f64::NEG_INFINITY, to: below },
        _ => return Err(WorldError::SwitchPlace { axis, switch }),
    };
    for (key, value) in [("from", file.from), ("to", file.to), ("above", file.above), ("below", file.below)] {
        finite(place, key, value.unwrap_or(0.0))?;
    }
    if region.to < region.from {
        let (key, value) = ("to", region.to);
        return Err(WorldError::OutOfRange { place: place(), key, value, range: "at least `from`" });
    }
    let input = resolve_input(place, &file.input, inputs)?;
    Ok(Switch { input, region, normally_closed: file.normally == Rest::Closed })
}

fn read_marker(axis: u8, file: &MarkerFile) -> Result<Marker, WorldError> {
    let place = || format!("axis {axis}, `marker`");
    let every = file.every.map(|every| positive(place, "every", every)).transpose()?;
    Ok(Marker { at: finite(place, "at", file.at)?, every })
}

fn finite(place: impl Fn() -> String, key: &'static str, value: f64) -> Result<f64, WorldError> {
    within(place, key, value, value.is_finite(), "a finite number")
}

fn positive(place: impl Fn() -> String, key: &'static str, value: f64) -> Result<f64, WorldError> {
    within(place, key, value, value.is_finite() && value > 0.0, "above 0")
}

fn not_negative(place: impl Fn() -> String, key: &'static str, value: f64) -> Result<f64, WorldError> {
    within(place, key, value, value.is_finite() && value >= 0.0, "0 or more")
}

fn within(
    place: impl Fn() -> String,
    key: &'static str,
    value: f64,
    possible: bool,
    range: &'static str,
) -> Result<f64, WorldError> {
    if possible { Ok(value) } else { Err(WorldError::OutOfRange { place: place(), key, value, range }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_met_on_the_way_to_them_and_not_on_the_way_off() {
        let marker = Marker { at: 2.5, every: Some(10.0) };
        for (from, to, expected) in [
            (0.0, 2.0, None),
            (0.0, 2.5, Some(2.5)),
            (2.5, 3.0, None),
            (2.5, 12.5, Some(12.5)),
            (2.5, 2.0, None),
            (3.0, 2.5, Some(2.5)),
            (3.0, -20.0, Some(2.5)),
            (0.0, -7.5, Some(-7.5)),
            (-7.5, -7.6, None),
            (1.0, 1.0, None),
        ] {
            assert_eq!(marker.crossed(from, to), expected, "{from} {to}");
        }
        let single = Marker { every: None, ..marker };
        assert_eq!(
            [(0.0, 100.0), (100.0, 0.0), (3.0, 4.0)].map(|(from, to)| single.crossed(from, to)),
            [Some(2.5), Some(2.5), None]
        );
    }
}
