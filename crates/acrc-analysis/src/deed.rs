//! What statements do to the machine, as far as something else in a project depends on it: a move depends on a
//! velocity, a velocity on nothing. One table for commands, one for flags, one for parameters.

use std::sync::LazyLock;

use acrc_catalog::{CommandId, Keyword, ObjectKind, OperandClass, Space, command};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, Command};

use crate::index::WriteKind;
use crate::walk;

/// A kind of thing that programs do to axes, masters and each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Deed {
    /// A coordinated move of an axis (guide, "Coordinated Moves Profiler").
    Move,
    /// `JOG FWD`, `REV`, `ABS`, `INC`
    Jog,
    /// `JOG HOME`
    Home,
    /// `GEAR ON`
    Gear,
    /// `CAM ON`
    Cam,
    /// Enables the drive of an axis.
    DriveOn,
    /// Hands the drive's enable and fault signals to the controller (`BIT8468` of axis 0).
    DriveSignals,
    /// Pulses per unit of an axis.
    PulsesPerUnit,
    /// Velocity of the jog profiler of an axis, other than zero.
    JogVelocity,
    /// Velocity of the last approach of homing.
    HomeVelocity,
    /// Lets homing come back to the edge.
    HomeBackup,
    /// Source of electronic gearing.
    GearSource,
    /// Source of the electronic cam.
    CamSource,
    /// A segment of the table of the electronic cam.
    CamTable,
    /// Inputs of the limits and of home of an axis.
    LimitInputs,
    /// Enables hardware limits of an axis.
    HardLimitsOn,
    /// Positions of the software limits of an axis.
    SoftLimits,
    /// Enables software limits of an axis.
    SoftLimitsOn,
    /// Band of the following error of an axis.
    ErrorBand,
    /// Lets an excess of following error stop the axis.
    ErrorResponse,
    /// Clears the kill of all motion of an axis.
    KillCleared,
    /// Velocity of a master, other than zero.
    Velocity,
    /// Acceleration of a master.
    Acceleration,
    /// Ramp at the end of the moves of a master.
    StopRamp,
    /// Starts a program.
    Run,
    /// Says that its program starts at power-up.
    Boot,
    /// Looks whether a program runs.
    Watch,
}

impl Deed {
    /// How many there are.
    pub(crate) const COUNT: usize = Self::Watch as usize + 1;

    /// Everything that makes an axis move.
    pub const MOTION: [Self; 5] = [Self::Move, Self::Jog, Self::Home, Self::Gear, Self::Cam];

    /// Whether it makes an axis move.
    pub fn is_motion(self) -> bool {
        Self::MOTION.contains(&self)
    }

    /// Whether it is done to the master of a program, or to a program, and not to an axis.
    pub(crate) fn is_of_program(self) -> bool {
        OF_MASTERS.contains(&self) || matches!(self, Self::Run | Self::Boot | Self::Watch)
    }
}

/// What a command must say to do what it does; otherwise it reports, or switches off.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Says {
    Nothing,
    Value,
    /// A value other than zero.
    NonZero,
}

const COMMANDS: &[(CommandId, Deed, Says)] = &[
    (command::AXIS_MOVE, Deed::Move, Says::Value),
    (command::MOV, Deed::Move, Says::Value),
    (command::CIRCW, Deed::Move, Says::Value),
    (command::CIRCCW, Deed::Move, Says::Value),
    (command::SINE, Deed::Move, Says::Value),
    (command::TARC, Deed::Move, Says::Value),
    (command::MSEEK, Deed::Move, Says::Value),
    (command::JOG_FWD, Deed::Jog, Says::Nothing),
    (command::JOG_REV, Deed::Jog, Says::Nothing),
    (command::JOG_ABS, Deed::Jog, Says::Value),
    (command::JOG_INC, Deed::Jog, Says::Value),
    (command::JOG_HOME, Deed::Home, Says::Nothing),
    (command::GEAR_ON, Deed::Gear, Says::Nothing),
    (command::CAM_ON, Deed::Cam, Says::Nothing),
    (command::DRIVE_ON, Deed::DriveOn, Says::Nothing),
    (command::PPU, Deed::PulsesPerUnit, Says::Value),
    (command::JOG_VEL, Deed::JogVelocity, Says::NonZero),
    (command::JOG_HOMVF, Deed::HomeVelocity, Says::Value),
    (command::GEAR_SRC, Deed::GearSource, Says::Value),
    (command::CAM_SRC, Deed::CamSource, Says::Value),
    (command::CAM_SEG, Deed::CamTable, Says::Value),
    (command::HLBIT, Deed::LimitInputs, Says::Value),
    (command::HLIM, Deed::HardLimitsOn, Says::NonZero),
    (command::SLM, Deed::SoftLimits, Says::Value),
    (command::SLIM, Deed::SoftLimitsOn, Says::NonZero),
    (command::EXC, Deed::ErrorBand, Says::Value),
    (command::VEL, Deed::Velocity, Says::NonZero),
    (command::F, Deed::Velocity, Says::NonZero),
    (command::ACC, Deed::Acceleration, Says::Value),
    (command::STP, Deed::StopRamp, Says::Value),
    (command::RUN, Deed::Run, Says::Nothing),
    (command::LRUN, Deed::Run, Says::Nothing),
    (command::PBOOT, Deed::Boot, Says::Nothing),
];

/// [`COMMANDS`] by the id of the command.
static BY_COMMAND: LazyLock<Vec<Option<(Deed, Says)>>> = LazyLock::new(|| {
    let mut by_command = vec![None; acrc_catalog::all_commands().len()];
    for (id, deed, says) in COMMANDS {
        if let Some(entry) = by_command.get_mut(usize::from(id.0)) {
            *entry = Some((*deed, *says));
        }
    }
    by_command
});

/// Fields of flags (`acrc_catalog::BitRow::field`) with what writing them does.
const FLAGS: &[(&str, WriteKind, Deed)] = &[
    ("drive_enable", WriteKind::Set, Deed::DriveOn),
    // Wizard code has a PLC program that enables the drive at this flag.
    ("wizard_drive_enable", WriteKind::Set, Deed::DriveOn),
    ("drive_io_enable", WriteKind::Set, Deed::DriveSignals),
    ("kill_all_motion_request", WriteKind::Clear, Deed::KillCleared),
    ("exc_response_enable", WriteKind::Set, Deed::ErrorResponse),
    ("pos_limit_enable", WriteKind::Set, Deed::HardLimitsOn),
    ("neg_limit_enable", WriteKind::Set, Deed::HardLimitsOn),
    ("pos_soft_limit_enable", WriteKind::Set, Deed::SoftLimitsOn),
    ("neg_soft_limit_enable", WriteKind::Set, Deed::SoftLimitsOn),
    ("home_backup_enable", WriteKind::Set, Deed::HomeBackup),
    ("run_request", WriteKind::Set, Deed::Run),
];

/// Fields of parameters (`acrc_catalog::ParameterRow::field`) with what writing them does.
const PARAMETERS: &[(&str, Deed)] = &[
    ("ppu", Deed::PulsesPerUnit),
    ("jog_velocity", Deed::JogVelocity),
    // One client in the field sets the velocity there.
    ("jog_velocity_current", Deed::JogVelocity),
    ("exc_plus", Deed::ErrorBand),
    ("exc_minus", Deed::ErrorBand),
    ("limit_a_plus", Deed::SoftLimits),
    ("limit_a_minus", Deed::SoftLimits),
    ("limit_b_plus", Deed::SoftLimits),
    ("limit_b_minus", Deed::SoftLimits),
];

/// Fields of flags that show whether a program runs.
const PROGRAM_STATE: [&str; 2] = ["program_running", "run_request"];

/// The settings that the parameters of a master hold; which parameter holds which is not known.
const OF_MASTERS: [Deed; 3] = [Deed::Velocity, Deed::Acceleration, Deed::StopRamp];

/// A deed of a command with what it is done to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Act {
    /// What is done.
    pub deed: Deed,
    /// To what. The name of an axis is where it is written.
    pub on: On<Span>,
    /// The object or axis, or the whole name of a command without one.
    pub span: Span,
}

/// What something is done to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum On<N> {
    /// What the level implies, such as the master of the program.
    Level,
    /// An axis by its name.
    Axis(N),
    /// An object by its number: `AXIS0`, `PROG1`, `MASTER0`. No number when none is written.
    Object(ObjectKind, Option<u32>),
    /// A word: `ALL`.
    Word(Keyword),
}

/// What a command does.
pub fn acts(command: &Command) -> impl Iterator<Item = Act> {
    let entry = BY_COMMAND.get(usize::from(command.id.0)).copied().flatten();
    entry.into_iter().flat_map(move |(deed, says)| {
        let whole = whole(command);
        let parts = whole.is_none().then(|| command.arguments.iter().filter_map(part)).into_iter().flatten();
        let said = whole.into_iter().chain(parts);
        said.filter(move |(_, _, value)| suffices(says, *value)).map(move |(on, span, _)| Act { deed, on, span })
    })
}

/// What a command acts on when it acts on one thing: the object before it, or what the level implies.
fn whole(command: &Command) -> Option<(On<Span>, Span, Option<&Argument>)> {
    let value = command.arguments.first();
    match &command.prefix {
        Some(prefix) => Some((On::Object(prefix.kind, prefix.index), prefix.name, value)),
        None if command.arguments.iter().any(|argument| part(argument).is_some()) => None,
        None => Some((On::Level, command.name, value)),
    }
}

fn part(argument: &Argument) -> Option<(On<Span>, Span, Option<&Argument>)> {
    match argument {
        Argument::Axis(axis) => Some((On::Axis(axis.name), axis.name, axis.value.as_deref())),
        Argument::Object(object) => Some((On::Object(object.kind, object.index), object.name, object.value.as_deref())),
        Argument::Word(word) => Some((On::Word(word.keyword), word.span, None)),
        _ => None,
    }
}

fn suffices(says: Says, value: Option<&Argument>) -> bool {
    match (says, value) {
        (Says::Nothing, _) => true,
        (_, None) => false,
        (Says::NonZero, Some(Argument::Value(value))) => walk::literal(value) != Some(0.0),
        (Says::Value | Says::NonZero, Some(_)) => true,
    }
}

/// The program whose state a flag shows.
pub(crate) fn watched(flag: u64) -> Option<u32> {
    let info = acrc_catalog::bit(u32::try_from(flag).ok()?);
    info.object_index.filter(|_| PROGRAM_STATE.contains(&info.field))
}

/// What writing a flag or parameter does to which axis, master or program.
pub(crate) fn of(class: OperandClass, number: u64, how: WriteKind) -> Vec<(Deed, u32)> {
    match class {
        OperandClass::Bit => of_flag(number, how),
        OperandClass::Parameter if how == WriteKind::Assign => of_parameter(number),
        _ => Vec::new(),
    }
}

fn of_flag(number: u64, how: WriteKind) -> Vec<(Deed, u32)> {
    let Some(info) = u32::try_from(number).ok().map(acrc_catalog::bit) else { return Vec::new() };
    // The flags that wizard code reserves are one row for all axes.
    let Some(object) = info.object_index.or(info.element) else { return Vec::new() };
    let does = |(field, kind, _): &&(&str, WriteKind, Deed)| {
        *field == info.field && (*kind == how || how == WriteKind::Assign)
    };
    FLAGS.iter().filter(does).map(|(_, _, deed)| (*deed, object)).collect()
}

fn of_parameter(number: u64) -> Vec<(Deed, u32)> {
    let Ok(number) = u32::try_from(number) else { return Vec::new() };
    if acrc_catalog::flag_words(number).is_some() {
        let flags = acrc_catalog::flags_in(number).map(u64::from);
        return flags.flat_map(|flag| of_flag(flag, WriteKind::Assign)).collect();
    }
    let info = acrc_catalog::parameter(number);
    let Some(object) = info.object_index else { return Vec::new() };
    if info.object == Space::Master {
        return OF_MASTERS.map(|deed| (deed, object)).to_vec();
    }
    PARAMETERS.iter().filter(|(field, _)| *field == info.field).map(|(_, deed)| (*deed, object)).collect()
}

/// What writing some flag may do.
pub(crate) fn of_any_flag() -> impl Iterator<Item = Deed> {
    FLAGS.iter().map(|(_, _, deed)| *deed)
}

/// What writing some parameter may do.
pub(crate) fn of_any_parameter() -> impl Iterator<Item = Deed> {
    PARAMETERS.iter().map(|(_, deed)| *deed).chain(OF_MASTERS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_of_the_tables_is_one_of_the_catalogue() {
        for (field, _, _) in FLAGS {
            assert!(acrc_catalog::all_bits().any(|row| row.field == *field), "{field}");
        }
        for field in PROGRAM_STATE {
            assert!(acrc_catalog::all_bits().any(|row| row.field == field), "{field}");
        }
        for (field, _) in PARAMETERS {
            assert!(acrc_catalog::all_parameters().any(|row| row.field == *field), "{field}");
        }
    }

    #[test]
    fn flags_and_their_words_do_the_same() {
        assert_eq!(of_flag(8497, WriteKind::Set), [(Deed::DriveOn, 1)]);
        assert_eq!(of_flag(8497, WriteKind::Clear), []);
        assert_eq!(of_flag(1986, WriteKind::Set), [(Deed::DriveOn, 2)]);
        let word = of_parameter(4361);
        assert!(word.contains(&(Deed::DriveOn, 1)) && word.contains(&(Deed::KillCleared, 1)), "{word:?}");
        assert_eq!(of_parameter(12604), [(Deed::JogVelocity, 1)]);
        assert_eq!(of_parameter(8193).len(), OF_MASTERS.len());
        assert_eq!(of_parameter(u64::MAX), []);
    }
}
