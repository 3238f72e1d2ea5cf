//! The machine around the controller, as far as a dry run needs one: named inputs, the mechanics of the axes, and a timeline of what happens to them
//! and to parameters that are measured or written by a host.
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
//!
//! [axis.0]
//! plant = { kind = "motor", inertia = 2e-5, torque_constant = 0.157, lines = 4000 }
//! switches = [{ input = 2, from = 0.0, to = 2.0 }, { input = 0, above = 100.0 }]
//! marker = { every = 10.0, at = 2.5 }
//!
//! [[event]]
//! at = "7s"
//! jam = [0]                   # something holds the axis
//! ```
//!
//! `docs/world.md` has all of it.

mod axis;
mod error;
mod event;

pub use axis::{AxisWorld, Marker, MotorWorld, PlantWorld, Region, Switch};
pub use error::WorldError;
pub use event::{Happening, TypedText, WorldEvent};

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::registers::is_outside_flag;

/// Number of onboard inputs (bits 0-31).
pub(crate) const INPUTS: u32 = 32;
/// Axes that the largest controllers have.
const AXES: u8 = 16;

/// The world of one run: names of inputs, mechanics of axes, and events in order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct World {
    inputs: BTreeMap<String, u32>,
    axes: BTreeMap<u8, AxisWorld>,
    events: Vec<WorldEvent>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WorldFile {
    #[serde(default)]
    inputs: BTreeMap<String, i64>,
    #[serde(default)]
    axis: BTreeMap<String, axis::AxisFile>,
    #[serde(default)]
    event: Vec<event::EventFile>,
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
        let mut axes = BTreeMap::new();
        for (name, described) in file.axis {
            let axis = name.parse().ok().filter(|axis| *axis < AXES);
            let axis = axis.ok_or(WorldError::NoSuchAxis { place: "`axis`".to_owned(), axis: name })?;
            axes.insert(axis, axis::read(axis, described, &inputs)?);
        }
        let mut events = Vec::with_capacity(file.event.len());
        for (index, event) in file.event.iter().enumerate() {
            events.push(event::read(index + 1, event, &inputs)?);
        }
        // Events of the same time keep the order of the file.
        events.sort_by(|left, right| left.at.total_cmp(&right.at));
        Ok(Self { inputs, axes, events })
    }

    /// The events in order of time.
    pub fn events(&self) -> &[WorldEvent] {
        &self.events
    }

    /// The mechanics of the axes that are described.
    pub fn axes(&self) -> impl Iterator<Item = (u8, &AxisWorld)> {
        self.axes.iter().map(|(axis, world)| (*axis, world))
    }

    /// Every axis of which something is said.
    pub(crate) fn concerned_axes(&self) -> impl Iterator<Item = u8> {
        let happening = self.events.iter().flat_map(|event| &event.happenings).filter_map(Happening::axis);
        self.axes.keys().copied().chain(happening)
    }

    /// The names given to inputs.
    pub fn inputs(&self) -> impl Iterator<Item = (&str, u32)> {
        self.inputs.iter().map(|(name, bit)| (name.as_str(), *bit))
    }

    /// The name of an input bit.
    pub fn input_name(&self, bit: u32) -> Option<&str> {
        self.inputs().find(|(_, number)| *number == bit).map(|(name, _)| name)
    }

    /// Every input that an event or a switch changes, ascending.
    pub fn driven_inputs(&self) -> Vec<u32> {
        let scripted = self.events.iter().flat_map(|event| event.set.iter().chain(&event.clear).copied());
        let switched = self.axes.values().flat_map(|axis| axis.switches.iter().map(|switch| switch.input));
        let mut bits: Vec<u32> = scripted.chain(switched).collect();
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

fn resolve_input(
    place: impl FnOnce() -> String,
    input: &InputFile,
    inputs: &BTreeMap<String, u32>,
) -> Result<u32, WorldError> {
    match input {
        InputFile::Number(number) => outside(*number, place),
        InputFile::Name(name) => inputs.get(name).copied().ok_or_else(|| WorldError::UnknownInput {
            place: place(),
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
                happenings: vec![],
                note: Some("hand".to_owned())
            }
        );
        assert_eq!(world.events()[1].at, 3.0);
        assert_eq!(world.driven_inputs(), [4, 10]);
        assert_eq!(world.input_name(10), Some("curtain"));
    }

    #[test]
    fn axes_are_described() {
        let world = World::parse(
            "[inputs]\nhome = 2\n[axis.3]\nplant = \"stepper\"\nstart = 5\nbacklash = 0.1\nmarker = { every = 10 }\n\
             capture_inputs = [24]\nswitches = [{ input = \"home\", from = 0, to = 2, normally = \"closed\" }]\n\
             [[event]]\nat = 1\njam = [3]\nmotion_enable = false\n",
        )
        .expect("a valid world");
        let (axis, described) = world.axes().next().expect("an axis");
        assert!(axis == 3 && matches!(described.plant, PlantWorld::Stepper(_)));
        let switch = Switch { input: 2, region: Region { from: 0.0, to: 2.0 }, normally_closed: true };
        assert_eq!((&*described.switches, &*described.capture_inputs), (&[switch][..], &[24][..]));
        assert_eq!((described.start, described.marker), (5.0, Some(Marker { at: 0.0, every: Some(10.0) })));
        assert_eq!(world.events()[0].happenings, [Happening::MotionEnable(false), Happening::Jam(3)]);
        assert_eq!(world.driven_inputs(), [2]);
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
            ("[[event]]\nat = 1\njam = [16]", "event 1, `jam`: no controller has an axis 16"),
            ("[[event]]\nat = 1\ndrive_fault = [-1]", "event 1, `drive_fault`: no controller has an axis -1"),
            ("[[event]]\nat = 1\nmotion_enable = 1", "invalid type: integer `1`, expected a boolean"),
            ("[axis.16]", "`axis`: no controller has an axis 16: they are numbered 0 to 15"),
            ("[axis.X]", "`axis`: no controller has an axis X"),
            ("[axis.0]\nplnt = 1", "unknown field `plnt`"),
            ("[axis.0]\nplant = 3", "axis 0, `plant`: expected \"ideal\", \"stepper\" or a table with its `kind`"),
            ("[axis.0]\nplant = \"real\"", "axis 0, `plant`: unknown variant `real`"),
            ("[axis.0]\nplant = \"motor\"", "axis 0, `plant`: missing field `inertia`"),
            (
                "[axis.0]\nplant = { kind = \"stepper\", inertia = 1 }",
                "axis 0, `plant`: unknown field `inertia`, expected `greatest_rate`",
            ),
            (
                "[axis.1]\nplant = { kind = \"motor\", inertia = 0, torque_constant = 1, lines = 1000 }",
                "axis 1, `plant`: `inertia` is 0, and must be above 0",
            ),
            (
                "[axis.1]\nplant = { kind = \"motor\", inertia = 1, torque_constant = 1, lines = -4 }",
                "axis 1, `plant`: `lines` is -4, and must be above 0",
            ),
            (
                "[axis.1]\nplant = { kind = \"motor\", inertia = 1, torque_constant = 1, lines = 4, coulomb_friction = -1 }",
                "axis 1, `plant`: `coulomb_friction` is -1, and must be 0 or more",
            ),
            (
                "[axis.1]\nplant = { kind = \"stepper\", greatest_rate = nan }",
                "axis 1, `plant`: `greatest_rate` is NaN, and must be 0 or more",
            ),
            ("[axis.0]\nstart = inf", "axis 0: `start` is inf, and must be a finite number"),
            ("[axis.0]\nbacklash = -0.1", "axis 0: `backlash` is -0.1, and must be 0 or more"),
            ("[axis.0]\nmarker = { every = 0 }", "axis 0, `marker`: `every` is 0, and must be above 0"),
            ("[axis.0]\nmarker = { at = nan }", "axis 0, `marker`: `at` is NaN, and must be a finite number"),
            ("[axis.0]\nswitches = [{ input = 2 }]", "axis 0, switch 1: where it is closed is said by `from` and `to`"),
            (
                "[axis.0]\nswitches = [{ input = 2, above = 1, below = 0 }]",
                "axis 0, switch 1: where it is closed is said by",
            ),
            (
                "[axis.0]\nswitches = [{ input = 2, from = 1, to = 0 }]",
                "axis 0, switch 1: `to` is 0, and must be at least `from`",
            ),
            (
                "[axis.0]\nswitches = [{ input = 2, above = nan }]",
                "axis 0, switch 1: `above` is NaN, and must be a finite number",
            ),
            (
                "[axis.0]\nswitches = [{ input = 2, above = 1 }, { input = \"home\", above = 1 }]",
                "axis 0, switch 2: no input is named `home`",
            ),
            (
                "[axis.0]\nswitches = [{ input = 32, above = 1 }]",
                "axis 0, switch 1: flag 32 does not come from outside",
            ),
            ("[axis.0]\nswitches = [{ input = 3, above = 1, normally = \"shut\" }]", "unknown variant `shut`"),
            ("[axis.0]\ncapture_inputs = [1, 2, 3]", "axis 0: `capture_inputs` names 3 inputs"),
        ] {
            let message = World::parse(text).expect_err(text).to_string();
            assert!(message.contains(expected), "{text}\n{message}");
        }
    }
}
