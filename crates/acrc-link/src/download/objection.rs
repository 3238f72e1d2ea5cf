//! Why a download is not begun.

use acrc_catalog::memory::SystemBlock;
use acrc_image::UnitName;
use thiserror::Error;

use super::demand::Demand;
use super::plan::Settings;
use super::script::Script;
use super::survey::Survey;

/// Why a download is not begun.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Objection {
    /// Programs run.
    #[error("{} on the controller", going(.0))]
    Running(Vec<UnitName>),
    /// Something moves.
    #[error("{} in motion", .0.join(", "))]
    Moving(Vec<String>),
    /// Drives are enabled.
    #[error("{}", enabled(.0))]
    Enabled(Vec<u8>),
    /// A program has no memory.
    #[error("{unit} needs {needed} bytes, and {available}")]
    NoMemory {
        /// The program.
        unit: UnitName,
        /// Bytes of its text.
        needed: u64,
        /// What it has.
        available: String,
    },
    /// The programs are protected.
    #[error("the programs of the controller are protected from being listed ({0})")]
    Protected(String),
}

impl Objection {
    /// What to do about it.
    pub fn help(&self) -> &'static str {
        match self {
            Self::Running(_) => "--halt halts all programs first",
            Self::Moving(_) => "wait until it is over, or stop it; --halt ends motion of programs, but not jogging",
            Self::Enabled(_) => "DRIVE OFF disables a drive; --with-drives-enabled goes on all the same",
            Self::NoMemory { .. } => "give it memory with `DIM PROGn(bytes)` at SYS in the setup of the project",
            Self::Protected(_) => "--password \"TEXT\" lifts the protection with PASSWORD OFF",
        }
    }
}

fn going(units: &[UnitName]) -> String {
    let names: Vec<String> = units.iter().map(ToString::to_string).collect();
    format!("{} {}", names.join(", "), if units.len() == 1 { "runs or is paused" } else { "run or are paused" })
}

fn enabled(axes: &[u8]) -> String {
    let names: Vec<String> = axes.iter().map(|axis| format!("AXIS{axis}")).collect();
    let names = names.join(", ");
    if axes.len() == 1 {
        format!("the drive of {names} is enabled")
    } else {
        format!("the drives of {names} are enabled")
    }
}

/// Everything that speaks against a download.
pub(super) fn objections(script: &Script, survey: &Survey, demand: &Demand, settings: &Settings) -> Vec<Objection> {
    let mut objections = Vec::new();
    if !survey.running.is_empty() && !settings.halt {
        objections.push(Objection::Running(survey.running.clone()));
    }
    if !survey.moving.is_empty() && !settings.halt {
        objections.push(Objection::Moving(survey.moving.clone()));
    }
    if !survey.enabled.is_empty() && !settings.with_drives_enabled {
        objections.push(Objection::Enabled(survey.enabled.clone()));
    }
    let password = settings.password.is_some() || script.image.password().ok().flatten().is_some();
    if let Some(text) = survey.protected.as_ref().filter(|_| !password) {
        objections.push(Objection::Protected(text.clone()));
    }
    let memory = if demand.shares_memory() { &demand.memory } else { &survey.memory };
    for unit in script.units() {
        let (needed, block) = (u64::from(unit.memory()), block_of(unit.name));
        let Some((memory, block)) = memory.as_ref().zip(block) else { continue };
        let available = match memory.get(&block) {
            Some(size) if *size >= needed => continue,
            Some(size) => format!("it has {size}"),
            None if demand.shares_memory() => "the project gives it none".to_owned(),
            None => "neither the controller nor the project gives it any".to_owned(),
        };
        objections.push(Objection::NoMemory { unit: unit.name, needed, available });
    }
    objections
}

fn block_of(unit: UnitName) -> Option<SystemBlock> {
    match unit {
        UnitName::Boot => None,
        UnitName::Program(number) => Some(SystemBlock::Program(number)),
        UnitName::Plc(number) => Some(SystemBlock::Plc(number)),
    }
}
