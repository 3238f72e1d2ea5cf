//! Quantities of axes and other objects by name: `X.position`, `X.jog_offset`, `MASTER0.vector_velocity`.
//!
//! Every field of the catalogue that belongs to a numbered object is a quantity. Three more are what the motion of an axis is computed from, in the
//! units of programs and without the rounding of the registers.

use acrc_catalog::{
    BitRow, ParameterRow, Space, ValueType, all_bits, all_parameters, bit_number, law, parameter, parameter_number,
};
use acrc_controller::View;
use acrc_trace::Signal;

use super::{Column, Reading};

/// The panel of the following errors, which are 0 on an ideal machine.
pub(super) const FOLLOWING_ERROR_GROUP: &str = "following error";
const FOLLOWING_ERROR: &str = "following_error";
/// The unit of the catalogue for the pulses of an axis, which its `PPU` turns into units.
const PULSES: &str = "counts";

/// What the motion of an axis is computed from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    Position,
    Velocity,
    Acceleration,
}

impl Quantity {
    pub(super) const ALL: [Self; 3] = [Self::Position, Self::Velocity, Self::Acceleration];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Position => "position",
            Self::Velocity => "velocity",
            Self::Acceleration => "acceleration",
        }
    }

    fn unit(self) -> &'static str {
        match self {
            Self::Position => "units",
            Self::Velocity => "units/s",
            Self::Acceleration => "units/s²",
        }
    }

    pub(super) fn value(self, view: &View, axis: u8) -> f64 {
        match self {
            Self::Position => view.position(axis),
            Self::Velocity => view.motion(axis).0,
            Self::Acceleration => view.motion(axis).1,
        }
    }

    fn column(self, axis: u8, owner: &str) -> Column {
        let source = match self {
            Self::Position => {
                let [position, ppu] = [law::CURRENT_POSITION, law::PPU].map(|law| law.at(u32::from(axis)));
                format!("P{position} / P{ppu}")
            }
            Self::Velocity | Self::Acceleration => String::new(),
        };
        let name = format!("{owner}.{}", self.name());
        let signal = Signal::continuous(name, self.unit(), self.name()).with_source(source);
        Column { signal, label: None, reading: Reading::Motion(axis, self) }
    }
}

/// What is worth seeing of every axis.
pub(super) fn main_columns(axis: u8, owner: &str) -> Vec<Column> {
    let motion = Quantity::ALL.map(|quantity| quantity.column(axis, owner));
    motion.into_iter().chain(column(Space::Axis, u32::from(axis), owner, FOLLOWING_ERROR)).collect()
}

/// A quantity of an object by name or acronym, in any case.
pub(super) fn column(space: Space, index: u32, owner: &str, name: &str) -> Option<Column> {
    let same = |other: &str| other.eq_ignore_ascii_case(name);
    if let (Space::Axis, Ok(axis)) = (space, u8::try_from(index))
        && let Some(quantity) = Quantity::ALL.into_iter().find(|quantity| same(quantity.name()))
    {
        return Some(quantity.column(axis, owner));
    }
    let asked = |field: &str, also: &[&str]| same(field) || also.iter().any(|also| same(also));
    if let Some(row) = parameters(space).find(|row| asked(row.field, row.also)) {
        let number = parameter_number(row.field, index)?;
        return Some(of_parameter(row, number, index, owner));
    }
    let row = bits(space).find(|row| asked(row.field, row.also))?;
    let number = bit_number(row.field, index)?;
    let signal = Signal::bit(format!("{owner}.{}", row.field), "bits").with_source(format!("BIT{number}"));
    Some(Column { signal, label: None, reading: Reading::Bit(number) })
}

fn of_parameter(row: &ParameterRow, number: u32, index: u32, owner: &str) -> Column {
    let name = format!("{owner}.{}", row.field);
    let axis = u8::try_from(index).ok().filter(|_| row.object == Space::Axis && row.unit == PULSES);
    let group = if row.field == FOLLOWING_ERROR { FOLLOWING_ERROR_GROUP } else { row.title };
    let (unit, source, reading) = match axis {
        Some(axis) => {
            let ppu = law::PPU.at(index);
            ("units", format!("P{number} / P{ppu}"), Reading::Pulses(number, axis))
        }
        None => (parameter(number).unit, format!("P{number}"), Reading::Parameter(number)),
    };
    Column { signal: Signal::continuous(name, unit, group).with_source(source), label: None, reading }
}

/// The names of the quantities of an object.
pub(super) fn names(space: Space) -> Vec<&'static str> {
    let motion = Quantity::ALL.into_iter().filter(|_| space == Space::Axis).map(Quantity::name);
    let mut names: Vec<&str> = motion.chain(parameters(space).map(|row| row.field)).collect();
    names.extend(bits(space).map(|row| row.field));
    names.sort_unstable();
    names.dedup();
    names
}

fn parameters(space: Space) -> impl Iterator<Item = &'static ParameterRow> {
    all_parameters()
        .filter(move |row| row.object == space && row.law.per_object == 1 && row.ty != Some(ValueType::String))
}

fn bits(space: Space) -> impl Iterator<Item = &'static BitRow> {
    all_bits().filter(move |row| row.object == space && row.law.per_object == 1)
}
