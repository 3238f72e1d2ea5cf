//! What outlasts a reset, as plain data: nothing in it refers to the controller that it comes from.

use acrc_catalog::CommandId;
use acrc_catalog::memory::SystemBlock;
use acrc_image::{Alias, AxisName, Unit, UnitName};
use acrc_motion::MoveSettings;
use acrc_vm::{Source, Text, Value};

/// Everything that a controller has when its power comes on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Saved {
    /// The model, as the catalogue names it.
    pub model: String,
    /// Battery-backed memory; `None` when it was lost, so that it has factory settings.
    pub memory: Option<Memory>,
    /// The retained user parameters P38912 to P39423 that are not zero, by rising number.
    pub retained: Vec<(u32, Value)>,
    /// What `ESAVE` saved; `None` after `ERASE`.
    pub parameters: Option<SystemParameters>,
    /// The user image in flash memory; `None` after `FLASH ERASE`.
    pub image: Option<FlashImage>,
}

/// Working memory: what `DIM` gave out at the `SYS` prompt, and what is in it. Local variables are not kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Memory {
    /// Every block with its bytes.
    pub blocks: Vec<(SystemBlock, u32)>,
    /// The alias table that the texts refer to.
    pub aliases: Vec<Alias>,
    /// The stored texts, one a program or PLC program.
    pub programs: Vec<Unit>,
    /// The stored texts that have mistakes, as they were typed.
    pub typed: Vec<TypedText>,
    /// P0 and those behind it, as many as have memory.
    pub user: Vec<f64>,
    /// The hardware of `CONFIG`, where it is not that of the factory.
    pub hardware: Option<String>,
    /// What protects the programs from `LIST` (`PASSWORD`).
    pub password: Option<Text>,
}

/// A text that cannot be compiled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TypedText {
    /// Whose it is: a program or PLC program.
    pub name: UnitName,
    /// Its lines in their order.
    pub lines: Vec<TypedLine>,
}

/// A line of a text that cannot be compiled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TypedLine {
    /// Its number.
    pub number: u32,
    /// The number was typed, and is not the one that the line is hidden behind.
    pub written: bool,
    /// Its statements.
    pub text: String,
}

/// The user image in flash memory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlashImage {
    /// It is loaded at power-up; false after `FLASH RES`.
    pub in_use: bool,
    /// It has everything (`FLASH IMAGE`), not the programs only (`FLASH SAVE`).
    pub everything: bool,
    /// What it holds. Without `everything`, the blocks are those of programs and aliases, and there are no user parameters.
    pub memory: Memory,
}

/// What `ESAVE` saves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SystemParameters {
    /// Servo period in seconds.
    pub period: f64,
    /// The axes by number.
    pub axes: Vec<AxisParameters>,
    /// The masters by number.
    pub masters: Vec<MasterParameters>,
    /// Values of commands that are kept and reported.
    pub settings: Vec<Setting>,
    /// Parameters that differ from their defaults, by rising number.
    pub parameters: Vec<(u32, Value)>,
    /// Flags that keep a setting and are set.
    pub flags: Vec<u32>,
}

/// Settings of one axis.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisParameters {
    /// Pulses per programming unit (`PPU`).
    pub pulses_per_unit: f64,
    /// What `ATTACH AXIS` connected it to; `None` for the factory's.
    pub signals: Option<String>,
}

/// Attachments and settings of one master.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MasterParameters {
    /// The program that it is attached to.
    pub program: Option<u8>,
    /// The axes in its slots.
    pub slaves: Vec<Slave>,
    /// What the next move is made with.
    pub settings: MoveSettings,
    /// `VECTOR`
    pub vector: f64,
    /// `FOV`
    pub feedrate_override: f64,
}

/// An axis in a slot of a master.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slave {
    /// The slot.
    pub slot: u8,
    /// The axis.
    pub axis: u8,
    /// Its name in the program of the master.
    pub name: AxisName,
    /// Its weight in the length of paths (`VECDEF`).
    pub weight: f64,
}

/// Values of a command for one object.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The command: `PGAIN`.
    pub command: CommandId,
    /// Axis, encoder or converter.
    pub object: u16,
    /// Its values.
    pub values: Vec<SettingValue>,
}

/// One value of a setting.
#[derive(Clone, Debug, PartialEq)]
pub enum SettingValue {
    /// A number.
    Number(Value),
    /// Where a signal comes from: `GEAR SRC X ENC2`.
    Source(Source),
}
