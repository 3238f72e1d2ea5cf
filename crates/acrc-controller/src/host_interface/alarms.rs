//! Alarms for clients (Ethernet specification, "Alarms to Clients").
//!
//! No document gives the codes of controller alarms, or says how a program raises its own. The codes here are this project's, one
//! bit each, so that the filter of a client chooses among them; what raises the alarm of programs is an option
//! ([`Options::user_alarm`](crate::Options::user_alarm)).

use acrc_catalog::{Law, law};

use crate::controller::Controller;
use crate::machine::Machine;
use crate::task::Task;

/// An alarm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HostAlarm {
    /// The parameter of [`Options::user_alarm`](crate::Options::user_alarm) has another value.
    User {
        /// The value as a long integer.
        value: u32,
    },
    /// Something has happened to the controller.
    Controller {
        /// What.
        kind: AlarmKind,
        /// To which axis or program; PLC programs count from 256.
        object: u32,
        /// How often this has happened to it since power-up.
        count: u32,
    },
}

/// What happens to a controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum AlarmKind {
    /// A program or PLC program stopped with an error.
    ProgramFault,
    /// The Kill All Motion Request of an axis came on.
    MotionKilled,
    /// The drive of an axis has a fault.
    DriveFault,
    /// The following error of an axis went beyond its limit.
    FollowingError,
    /// The encoder of an axis gives no signal.
    EncoderFault,
    /// An axis ran into a limit switch.
    HardLimit,
    /// An axis reached a software limit.
    SoftLimit,
    /// The motion enable input opened.
    MotionDisabled,
}

impl AlarmKind {
    /// Every kind, in the order of their codes.
    pub const ALL: [Self; 8] = [
        Self::ProgramFault,
        Self::MotionKilled,
        Self::DriveFault,
        Self::FollowingError,
        Self::EncoderFault,
        Self::HardLimit,
        Self::SoftLimit,
        Self::MotionDisabled,
    ];

    /// Its code: one bit.
    pub const fn code(self) -> u32 {
        1 << self as u8
    }
}

/// The flags that come on when something happens to an axis.
const AXIS_FLAGS: [(AlarmKind, Law); 8] = [
    (AlarmKind::MotionKilled, law::KILL_ALL_MOTION_REQUEST),
    (AlarmKind::DriveFault, law::DRIVE_FAULT_LATCHED),
    (AlarmKind::FollowingError, law::EXC_FAULT_LATCHED),
    (AlarmKind::EncoderFault, law::ENCODER_SIGNAL_LOST),
    (AlarmKind::HardLimit, law::POS_LIMIT_HIT),
    (AlarmKind::HardLimit, law::NEG_LIMIT_HIT),
    (AlarmKind::SoftLimit, law::POS_SOFT_LIMIT_HIT),
    (AlarmKind::SoftLimit, law::NEG_SOFT_LIMIT_HIT),
];

/// PLC programs are the objects from this one on.
const FIRST_PLC: u32 = 256;
/// Alarms that are kept until somebody takes them; what comes behind them is counted only.
const KEPT: usize = 1024;

/// What has been seen of alarms.
#[derive(Debug, Default)]
pub(crate) struct Alarms {
    /// The parameter whose changes are alarms.
    user: Option<u32>,
    value: Option<u32>,
    /// The flags of each axis that were set, one bit each in the order of [`AXIS_FLAGS`].
    axes: Vec<u8>,
    motion_disabled: bool,
    counts: std::collections::BTreeMap<(AlarmKind, u32), u32>,
    raised: Vec<HostAlarm>,
}

impl Alarms {
    pub(crate) fn new(user: Option<u32>) -> Self {
        Self { user, ..Self::default() }
    }

    /// A program has stopped with an error.
    pub(crate) fn program_fault(&mut self, task: Task) {
        let object = match task {
            Task::Program(number) => u32::from(number),
            Task::Plc(number) => FIRST_PLC + u32::from(number),
        };
        self.raise(AlarmKind::ProgramFault, object);
    }

    /// Whether the value of a parameter has to be looked at behind every slice.
    pub(crate) fn watches(&self) -> bool {
        self.user.is_some()
    }

    /// Looks at the parameter whose changes are alarms. Its first value is none.
    pub(crate) fn look(&mut self, machine: &Machine) {
        let Some(parameter) = self.user else { return };
        let value = machine.read_parameter(i64::from(parameter)).ok();
        let Some(value) = value.and_then(|value| super::number::long(&value)).map(i32::cast_unsigned) else { return };
        let before = self.value.replace(value);
        if before.is_some_and(|before| before != value) {
            self.keep(HostAlarm::User { value });
        }
    }

    fn look_at_flags(&mut self, machine: &Machine) {
        self.axes.resize(machine.axes.len(), 0);
        for axis in 0..machine.axes.len() {
            let is_set = |law: Law| law.get(axis as u32).is_some_and(|flag| machine.flags.get(flag));
            let now = AXIS_FLAGS.iter().rev().fold(0, |bits, (_, law)| bits << 1 | u8::from(is_set(*law)));
            let came = now & !std::mem::replace(&mut self.axes[axis], now);
            for (bit, (kind, _)) in AXIS_FLAGS.iter().enumerate() {
                if came >> bit & 1 == 1 {
                    self.raise(*kind, axis as u32);
                }
            }
        }
        let disabled = !machine.is_motion_enabled();
        if disabled && !std::mem::replace(&mut self.motion_disabled, disabled) {
            self.raise(AlarmKind::MotionDisabled, 0);
        }
        self.motion_disabled = disabled;
    }

    fn raise(&mut self, kind: AlarmKind, object: u32) {
        let count = self.counts.entry((kind, object)).or_default();
        *count += 1;
        let count = *count;
        self.keep(HostAlarm::Controller { kind, object, count });
    }

    fn keep(&mut self, alarm: HostAlarm) {
        if self.raised.len() < KEPT {
            self.raised.push(alarm);
        }
    }
}

impl Controller {
    /// The alarms since this was asked last, in the order in which they were noticed. Flags are looked at now, so a caller that
    /// wants every alarm asks in each tick that it lets pass.
    pub fn take_alarms(&mut self) -> Vec<HostAlarm> {
        self.alarms.look(&self.machine);
        self.alarms.look_at_flags(&self.machine);
        std::mem::take(&mut self.alarms.raised)
    }
}
