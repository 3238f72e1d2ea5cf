//! What each parameter and flag number is to the machine: one entry a number, made once from the catalogue, so that a program that polls one costs no
//! search.

use std::sync::LazyLock;

use acrc_catalog::{
    Access, BitKind, Confidence, Known, Law, Space, ValueType, all_flag_words, all_parameter_blocks, all_parameters,
    bit, flag_words, law, parameter,
};

use acrc_motion::axis::Side;

use super::live::Live;
use crate::flags::{FIRST_WORD, Flags};
use crate::orders::Order;

/// What reading and writing a parameter does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// No document names it: plain memory, and the run says so.
    Undocumented,
    /// It keeps what is written.
    Plain,
    /// It follows from the state of the machine.
    Live(Live),
}

/// The form in which a parameter keeps its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    Long,
    Single,
    /// No document says: whole numbers are longs, others singles.
    Unknown,
}

/// The numbered objects that a model has more or fewer of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Owner {
    None,
    Axis,
    Master,
    Program,
    Plc,
}

/// One parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Parameter {
    pub(crate) kind: Kind,
    pub(crate) form: Form,
    /// Programs cannot write it.
    pub(crate) read_only: bool,
    pub(crate) owner: Owner,
    /// Which axis, master, ... it belongs to.
    pub(crate) object: u8,
}

/// What writing a flag does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    /// No document names it: plain memory, and the run says so.
    Undocumented,
    /// It keeps its state.
    None,
    /// Programs cannot write it.
    ReadOnly,
    /// It clears itself; what it asks for is no part of the dry run.
    Request,
    /// An order to a master.
    Master(Order),
    RunProgram,
    HaltProgram,
    RunPlc,
    HaltPlc,
    PauseProgram,
    EnableDrive,
    KillMotion,
    ResetMotionEnable,
    /// A setting of an axis.
    AxisSetting,
    /// Jogs while it is set.
    Jog(Side),
    /// Ends a jog.
    JogOff,
    /// Starts to look for home.
    Home,
    /// Echo or prompt of a stream.
    Stream,
}

impl Effect {
    /// Whether giving a flag the state that it has does nothing.
    pub(super) fn is_idle(self, state: bool) -> bool {
        match self {
            Self::Undocumented | Self::None | Self::ReadOnly | Self::Request | Self::Jog(_) | Self::Stream => true,
            Self::PauseProgram | Self::EnableDrive | Self::AxisSetting => false,
            Self::Master(_)
            | Self::RunProgram
            | Self::HaltProgram
            | Self::RunPlc
            | Self::HaltPlc
            | Self::KillMotion
            | Self::JogOff
            | Self::Home
            | Self::ResetMotionEnable => !state,
        }
    }
}

/// One flag.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Flag {
    pub(crate) effect: Effect,
    pub(crate) owner: Owner,
    /// Which axis, master, ... it belongs to.
    pub(crate) object: u8,
}

/// The tables.
#[derive(Debug)]
pub(crate) struct Map {
    /// Parameters from [`FIRST_WORD`] on.
    parameters: Vec<Parameter>,
    flags: Vec<Flag>,
    /// Values at power-up that are not 0.
    defaults: Vec<(u32, f64)>,
}

/// The tables of every controller.
pub(crate) fn map() -> &'static Map {
    static MAP: LazyLock<Map> = LazyLock::new(Map::new);
    &MAP
}

impl Map {
    fn new() -> Self {
        let last = all_parameter_blocks().map(|block| block.last).max().unwrap_or(FIRST_WORD);
        let words = all_flag_words().map(|words| words.law.last() + 1 - FIRST_WORD).max().unwrap_or(0);
        let defaults = all_parameters()
            .flat_map(|row| (0..row.law.count).filter_map(|place| Some((row.law.number(place)?, row.default(place)?))));
        Self {
            parameters: (FIRST_WORD..=last).map(describe_parameter).collect(),
            flags: (0..words * u32::BITS).map(describe_flag).collect(),
            defaults: defaults.filter(|(_, value)| *value != 0.0).collect(),
        }
    }

    /// A parameter; `None` for user parameters and beyond the last that any controller has.
    pub(crate) fn parameter(&self, number: u32) -> Option<Parameter> {
        self.parameters.get(number.checked_sub(FIRST_WORD)? as usize).copied()
    }

    /// A flag.
    pub(crate) fn flag(&self, number: u32) -> Flag {
        const UNDOCUMENTED: Flag = Flag { effect: Effect::Undocumented, owner: Owner::None, object: 0 };
        self.flags.get(number as usize).copied().unwrap_or(UNDOCUMENTED)
    }

    /// The first flag that no document names, and behind which no document names any.
    pub(crate) fn documented_flags(&self) -> i64 {
        self.flags.len() as i64
    }

    /// How many parameters there are from [`FIRST_WORD`] on.
    pub(crate) fn parameters(&self) -> usize {
        self.parameters.len()
    }

    /// Values at power-up that are not 0, by parameter.
    pub(crate) fn defaults(&self) -> &[(u32, f64)] {
        &self.defaults
    }
}

/// Whether a parameter is memory that follows from nothing else: user parameters, and system parameters but flag words and live ones.
pub(crate) fn is_plain_parameter(number: u32) -> bool {
    let plain = |parameter: Parameter| parameter.kind == Kind::Plain;
    number < FIRST_WORD || number >= FIRST_WORD + Flags::WORDS && map().parameter(number).is_some_and(plain)
}

/// Whether no document says in which form a parameter keeps its value.
pub(crate) fn is_of_unknown_form(number: u32) -> bool {
    number >= FIRST_WORD + Flags::WORDS
        && map().parameter(number).is_some_and(|parameter| parameter.form == Form::Unknown)
}

/// Whether the world around the controller may change a flag: inputs, states of networks and of hardware, flags that a host writes. Outputs, requests
/// and what follows from programs and motion are the controller's own.
pub(crate) fn is_outside_flag(number: u32) -> bool {
    let flag = map().flag(number);
    match flag.effect {
        Effect::None => bit(number).object != Space::Output,
        Effect::ReadOnly => flag.owner == Owner::None,
        _ => false,
    }
}

fn describe_parameter(number: u32) -> Parameter {
    let info = parameter(number);
    let (owner, object) = owner(info.object, info.object_index);
    let kind = match Live::of(number) {
        Some(live) => Kind::Live(live),
        None if info.known == Known::Unknown && flag_words(number).is_none() => Kind::Undocumented,
        None => Kind::Plain,
    };
    let read_only = info.access == Access::Read && proven(info.confidence);
    let form = match info.ty {
        Some(ValueType::Long) => Form::Long,
        Some(ValueType::Single | ValueType::Double) => Form::Single,
        Some(ValueType::String) | None => Form::Unknown,
    };
    Parameter { kind, form, read_only, owner, object }
}

fn describe_flag(number: u32) -> Flag {
    let info = bit(number);
    let (owner, object) = owner(info.object, info.object_index);
    let of = |(law, effect): &(Law, Effect)| law.index_of(number).map(|_| *effect);
    let effect = match EFFECTS.iter().find_map(of) {
        _ if info.access == Access::Read && proven(info.confidence) => Effect::ReadOnly,
        Some(effect) => effect,
        None if info.kind == Some(BitKind::Request) && proven(info.confidence) => Effect::Request,
        None => Effect::None,
    };
    Flag { effect, owner, object }
}

/// Flags that do something, or would.
const EFFECTS: [(Law, Effect); 28] = [
    (law::FEEDHOLD_REQUEST, Effect::Master(Order::Feedhold)),
    (law::CYCLE_START_REQUEST, Effect::Master(Order::CycleStart)),
    (law::KILL_ALL_MOVES, Effect::Master(Order::Kill)),
    (law::STOP_ALL_MOVES, Effect::Master(Order::Stop)),
    (law::RUN_REQUEST, Effect::RunProgram),
    (law::HALT_REQUEST, Effect::HaltProgram),
    (law::PLC_RUN_REQUEST, Effect::RunPlc),
    (law::PLC_HALT_REQUEST, Effect::HaltPlc),
    (law::PROGRAM_PAUSE, Effect::PauseProgram),
    (law::DRIVE_ENABLE, Effect::EnableDrive),
    (law::KILL_ALL_MOTION_REQUEST, Effect::KillMotion),
    (law::MEI_LATCH_RESET, Effect::ResetMotionEnable),
    (law::JOG_FORWARD, Effect::Jog(Side::Positive)),
    (law::JOG_REVERSE, Effect::Jog(Side::Negative)),
    (law::JOG_STOPPING, Effect::JogOff),
    (law::JOG_HOME_REQUEST, Effect::Home),
    (law::POS_LIMIT_ENABLE, Effect::AxisSetting),
    (law::NEG_LIMIT_ENABLE, Effect::AxisSetting),
    (law::POS_SOFT_LIMIT_ENABLE, Effect::AxisSetting),
    (law::NEG_SOFT_LIMIT_ENABLE, Effect::AxisSetting),
    (law::POS_LIMIT_INVERT, Effect::AxisSetting),
    (law::NEG_LIMIT_INVERT, Effect::AxisSetting),
    (law::HOME_INVERT, Effect::AxisSetting),
    (law::POS_LIMIT_HIT, Effect::AxisSetting),
    (law::NEG_LIMIT_HIT, Effect::AxisSetting),
    (law::EXC_RESPONSE_ENABLE, Effect::AxisSetting),
    (law::STREAM_ECHO, Effect::Stream),
    (law::STREAM_NO_PROMPT, Effect::Stream),
];

/// Whether a row of the catalogue is certain enough to refuse a write, or to take a set flag away again.
fn proven(confidence: Confidence) -> bool {
    matches!(confidence, Confidence::High | Confidence::Medium)
}

fn owner(space: Space, index: Option<u32>) -> (Owner, u8) {
    let owner = match space {
        // There is a Drive Talk block for each axis.
        Space::Axis | Space::DriveTalk => Owner::Axis,
        Space::Master => Owner::Master,
        Space::Program => Owner::Program,
        Space::Plc => Owner::Plc,
        _ => Owner::None,
    };
    (owner, index.and_then(|index| u8::try_from(index).ok()).unwrap_or(0))
}
