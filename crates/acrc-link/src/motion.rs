//! Moving the axes of a program's master from outside: what stands in the way, the move, where it is, and how it stops.

use std::fmt;
use std::str::FromStr;

use acrc_catalog::{ObjectKind, bit_number, law};
use thiserror::Error;

use crate::answer::parse_number;
use crate::values::Register;
use crate::{Console, LinkError};

/// Where an axis is to go.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// Its name in the program.
    pub axis: String,
    /// Units of the axis.
    pub value: f64,
    /// The value counts from where the axis is.
    pub incremental: bool,
}

/// `X10`, `X-2.5`, `X/-2.5` (incremental); `X1=10` for an axis whose name ends with a digit.
impl FromStr for Target {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let letters = text.trim_start_matches(|letter: char| letter.is_ascii_alphabetic() || letter == '_');
        let (axis, value) = text.split_once('=').unwrap_or_else(|| text.split_at(text.len() - letters.len()));
        let (incremental, number) = match value.trim().strip_prefix('/') {
            Some(number) => (true, number),
            None => (false, value),
        };
        let number = parse_number(number).filter(|number| number.is_finite());
        match number {
            Some(value) if is_axis_name(axis) => Ok(Self { axis: axis.to_owned(), value, incremental }),
            _ => Err(format!("`{text}` is no target: write X10, X-2.5, or X/-2.5 for a distance")),
        }
    }
}

fn is_axis_name(name: &str) -> bool {
    name.starts_with(|first: char| first.is_ascii_alphabetic())
        && name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_')
}

/// As a program writes it.
impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let slash = if self.incremental { "/" } else { "" };
        write!(f, "{} {slash}{}", self.axis, self.value)
    }
}

/// An axis of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    /// Its name in the program.
    pub name: String,
    /// Its number.
    pub number: u32,
}

/// The master of a program and its axes, as `ATTACH` reports them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// The program.
    pub program: u8,
    /// Its master.
    pub master: u32,
    /// Its axes, in the order of its slaves.
    pub axes: Vec<Axis>,
}

/// Why axes cannot be moved.
#[derive(Debug, Error)]
pub enum MoveError {
    /// The connection failed, or the controller refused.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// The program has no master.
    #[error("program {0} has no master: ATTACH shows none")]
    NoMaster(u8),
    /// The program has no such axis.
    #[error("program {program} has no axis named {name}; it has {}", list(.axes))]
    NoAxis {
        /// The program.
        program: u8,
        /// The name.
        name: String,
        /// Its axes.
        axes: Vec<Axis>,
    },
    /// One axis has two targets.
    #[error("{0} has more than one target")]
    Twice(String),
}

fn list(axes: &[Axis]) -> String {
    axes.iter().map(|axis| axis.name.as_str()).collect::<Vec<_>>().join(", ")
}

/// A flag that stands in the way of a move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Obstacle {
    /// The flag, which is set.
    pub flag: Register,
    /// What it means for a move.
    pub meaning: &'static str,
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}) is set: {}", self.flag, self.flag.title(), self.meaning)
    }
}

impl Group {
    /// Goes to the prompt of a program and asks what it has attached.
    ///
    /// # Errors
    /// When the program has no master.
    pub fn find(console: &mut impl Console, program: u8) -> Result<Self, MoveError> {
        console.command(&format!("PROG{program}"))?.silence()?;
        let answer = console.command("ATTACH")?;
        let mut group = Self { program, master: u32::MAX, axes: Vec::new() };
        for line in answer.report()? {
            let object = |kind| line.split_whitespace().find_map(|word| index(word, kind));
            if let Some(master) = object(ObjectKind::Master) {
                group.master = master;
            }
            let name = line.split('"').nth(1).map(str::trim).filter(|name| is_axis_name(name));
            if let (Some(number), Some(name)) = (object(ObjectKind::Axis), name) {
                group.axes.push(Axis { name: name.to_owned(), number });
            }
        }
        if group.master == u32::MAX { Err(MoveError::NoMaster(program)) } else { Ok(group) }
    }

    /// The axes of targets.
    ///
    /// # Errors
    /// When the program has no such axis, or a target is there twice.
    pub fn moved(&self, targets: &[Target]) -> Result<Vec<&Axis>, MoveError> {
        let mut moved: Vec<&Axis> = Vec::new();
        for target in targets {
            let axis = self.axes.iter().find(|axis| axis.name.eq_ignore_ascii_case(&target.axis));
            let axis = axis.ok_or_else(|| MoveError::NoAxis {
                program: self.program,
                name: target.axis.clone(),
                axes: self.axes.clone(),
            })?;
            if moved.contains(&axis) {
                return Err(MoveError::Twice(axis.name.clone()));
            }
            moved.push(axis);
        }
        Ok(moved)
    }

    /// What stands in the way of a move.
    ///
    /// # Errors
    /// When the controller does not answer.
    pub fn obstacles(&self, console: &mut impl Console) -> Result<Vec<Obstacle>, LinkError> {
        let kills = self.axes.iter().filter_map(|axis| law::KILL_ALL_MOTION_REQUEST.get(axis.number));
        let kills = kills.map(|bit| (bit, "no axis of its master moves; acrc reset-kamr clears it"));
        let master = [
            (law::KILL_ALL_MOVES.get(self.master), "the master does not move; acrc reset-kamr clears it"),
            (law::IN_MOTION.get(self.master), "the master moves already"),
            (bit_number("program_running", u32::from(self.program)), "the program has the master"),
        ];
        let master = master.into_iter().filter_map(|(bit, meaning)| Some((bit?, meaning)));
        let mut found = Vec::new();
        for (bit, meaning) in kills.chain(master) {
            if flag(console, bit)? {
                found.push(Obstacle { flag: Register::Bit(bit), meaning });
            }
        }
        Ok(found)
    }

    /// Starts a move, at the velocity of the program.
    ///
    /// # Errors
    /// When the controller refuses it.
    pub fn start(&self, console: &mut impl Console, targets: &[Target]) -> Result<(), LinkError> {
        let targets: Vec<String> = targets.iter().map(ToString::to_string).collect();
        console.command(&format!("MOV {}", targets.join(" ")))?.silence()
    }

    /// Sets the velocity of the program, and gives what it was.
    ///
    /// # Errors
    /// When the controller refuses it.
    pub fn set_velocity(&self, console: &mut impl Console, velocity: f64) -> Result<f64, LinkError> {
        let before = console.command("VEL")?.number()?;
        console.command(&format!("VEL {velocity}"))?.silence()?;
        Ok(before)
    }

    /// Whether the master moves.
    ///
    /// # Errors
    /// When the controller does not answer.
    pub fn is_moving(&self, console: &mut impl Console) -> Result<bool, LinkError> {
        law::IN_MOTION.get(self.master).map_or(Ok(false), |bit| flag(console, bit))
    }

    /// The flag that stops it, and blocks it when it stands, if it is set.
    ///
    /// # Errors
    /// When the controller does not answer.
    pub fn is_killed(&self, console: &mut impl Console) -> Result<bool, LinkError> {
        law::KILL_ALL_MOVES.get(self.master).map_or(Ok(false), |bit| flag(console, bit))
    }

    /// Sets Stop All Moves: the move ramps down with `DEC` and what is left of it is given up. Kill All Moves is set when
    /// it stands (guide, "Kill All Moves").
    ///
    /// # Errors
    /// When the controller does not answer.
    pub fn stop(&self, console: &mut impl Console) -> Result<(), LinkError> {
        match law::STOP_ALL_MOVES.get(self.master) {
            Some(bit) => console.command(&format!("SET {bit}"))?.silence(),
            None => Ok(()),
        }
    }

    /// Where an axis is commanded to be, in its units.
    ///
    /// # Errors
    /// When the controller does not answer.
    pub fn position(&self, console: &mut impl Console, axis: &Axis) -> Result<f64, LinkError> {
        let [position, ppu] = [law::CURRENT_POSITION, law::PPU].map(|law| law.at(axis.number));
        let pulses = console.command(&format!("?P{position}"))?.number()?;
        let ppu = console.command(&format!("?P{ppu}"))?.number()?;
        Ok(if ppu == 0.0 { pulses } else { pulses / ppu })
    }
}

fn flag(console: &mut impl Console, bit: u32) -> Result<bool, LinkError> {
    Ok(console.command(&format!("?BIT{bit}"))?.number()? != 0.0)
}

/// The number of `AXIS3`.
fn index(word: &str, kind: ObjectKind) -> Option<u32> {
    let (head, digits) = word.split_at_checked(kind.name().len())?;
    head.eq_ignore_ascii_case(kind.name()).then(|| digits.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::Target;

    #[test]
    fn targets_are_written_as_in_programs() {
        for (text, line) in [
            ("X10", "X 10"),
            ("Y-2.5", "Y -2.5"),
            ("Z/-1e-7", "Z /-0.0000001"),
            ("X1=3", "X1 3"),
            ("tilt/2", "tilt /2"),
        ] {
            assert_eq!(text.parse::<Target>().map(|target| target.to_string()).as_deref(), Ok(line), "{text}");
        }
        for text in ["", "X", "10", "X10Y20", "X 10 : DRIVE OFF X", "X=", "X/", "Xinf", "X=1:Y=2"] {
            assert!(text.parse::<Target>().is_err(), "{text}");
        }
    }
}
