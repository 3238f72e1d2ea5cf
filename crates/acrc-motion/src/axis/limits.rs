//! End-of-travel limits of one axis (the guide's "Limit Detection", "Dedicated I/O for Homing"; HLBIT, HLIM, HLDEC, SLIM,
//! SLM, SLDEC and the level-invert flags).
//!
//! [`TravelLimits::update`] decides, once a tick, whether an axis has to stop and how. What follows a stop is up to the
//! caller: a hardware limit sets the Kill All Motion Request of the axis, a software limit only Kill All Moves of its
//! master (see [`KillProtocol`](super::KillProtocol)); either stops the master and all of its axes.
//!
//! What the guide leaves open, and how it is read here, stands in `docs/fidelity.md`, "Jog, homing, limits and kills".

use super::{HomeInputs, Side, Window};
use crate::value::{InvalidValue, Quantity, not_negative};

/// One truth value for each side, as the values 0 to 3 of HLIM and SLIM have it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sides {
    /// The positive side: bit 0 of the value.
    pub positive: bool,
    /// The negative side: bit 1 of the value.
    pub negative: bool,
}

impl Sides {
    /// Reads the value of HLIM or SLIM: 0 none, 1 positive, 2 negative, 3 both.
    pub fn from_code(code: u8) -> Option<Self> {
        (code < 4).then_some(Self { positive: code & 1 != 0, negative: code & 2 != 0 })
    }

    /// The value that stands for it.
    pub fn code(self) -> u8 {
        u8::from(self.positive) | u8::from(self.negative) << 1
    }

    /// The truth value of one side.
    pub fn get(self, side: Side) -> bool {
        match side {
            Side::Positive => self.positive,
            Side::Negative => self.negative,
        }
    }

    fn set(&mut self, side: Side) {
        match side {
            Side::Positive => self.positive = true,
            Side::Negative => self.negative = true,
        }
    }
}

/// The inputs behind HLBIT: positive limit, negative limit and home, from the number of the first.
///
/// All three lie in one block of 32 inputs; those beyond its end do not exist and read as clear.
pub fn limit_inputs(first: u32) -> [Option<u32>; 3] {
    [0, 1, 2].map(|next| (first % 32 + next < 32).then(|| first + next))
}

/// The settings of the limits of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LimitSettings {
    /// Limit inputs that stop the axis (HLIM; flags 16148 and 16149 of axis 0).
    pub hardware: Sides,
    /// Software limits that stop it (SLIM; flags 16150 and 16151).
    pub software: Sides,
    /// Limit inputs that are active when clear (flags 16144 and 16145).
    pub inverted: Sides,
    /// The home input is active when clear (flag 16146).
    pub home_inverted: bool,
    /// The software limits, u (SLM).
    pub travel: Window,
    /// Ramp of a stop at a hardware limit, u/s² (HLDEC); zero stops at once.
    pub hardware_deceleration: f64,
    /// Ramp of a stop at a software limit, u/s² (SLDEC); zero stops at once.
    pub software_deceleration: f64,
}

/// What kind of limit was met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitKind {
    /// An input.
    Hardware,
    /// A position.
    Software,
}

/// A stop that a limit asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitStop {
    /// The kind of limit.
    pub kind: LimitKind,
    /// The side it is on.
    pub side: Side,
    /// The ramp to stop with, u/s².
    pub deceleration: f64,
}

/// The limit flags of an axis: quinary flags, indices 0 to 2, 4, 5, 12 and 13.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LimitFlags {
    /// Active limit inputs (16128, 16129 of axis 0).
    pub inputs: Sides,
    /// The home input is active (16130).
    pub home: bool,
    /// A hardware limit has stopped the axis; the program clears these (16132, 16133).
    pub hardware: Sides,
    /// The setpoint is at or behind an enabled software limit; they clear themselves (16140, 16141).
    pub software: Sides,
}

/// The end-of-travel limits of one axis.
#[derive(Clone, Copy, Debug, Default)]
pub struct TravelLimits {
    settings: LimitSettings,
    flags: LimitFlags,
    /// The limits that were being run into in the tick before.
    met: [Sides; 2],
}

impl TravelLimits {
    /// The settings in force.
    pub fn settings(&self) -> &LimitSettings {
        &self.settings
    }

    /// Changes the settings; they act from the next tick on.
    pub fn set_settings(&mut self, settings: LimitSettings) -> Result<(), InvalidValue> {
        not_negative(Quantity::Deceleration, settings.hardware_deceleration)?;
        not_negative(Quantity::Deceleration, settings.software_deceleration)?;
        settings.travel.validate()?;
        self.settings = settings;
        Ok(())
    }

    /// Looks at the inputs as they are wired, the primary setpoint (u) and its velocity (u/s).
    ///
    /// `homing` says that the axis homes. A stop is asked for once, in the tick in which the limit is met.
    pub fn update(&mut self, levels: HomeInputs, setpoint: f64, velocity: f64, homing: bool) -> Option<LimitStop> {
        let settings = self.settings;
        let inputs = Sides {
            positive: levels.positive_limit != settings.inverted.positive,
            negative: levels.negative_limit != settings.inverted.negative,
        };
        let behind = settings.travel.reached(setpoint);
        let software = Sides {
            positive: settings.software.positive && behind == Some(Side::Positive),
            negative: settings.software.negative && behind == Some(Side::Negative),
        };
        self.flags = LimitFlags { inputs, home: levels.home != settings.home_inverted, software, ..self.flags };
        let hardware = Sides {
            positive: settings.hardware.positive && inputs.positive,
            negative: settings.hardware.negative && inputs.negative,
        };
        let heading = Side::of(velocity);
        let before = core::mem::take(&mut self.met);
        let side = heading.filter(|_| !homing)?;
        let mut stop = None;
        let kinds = [
            (LimitKind::Hardware, hardware, settings.hardware_deceleration),
            (LimitKind::Software, software, settings.software_deceleration),
        ];
        for ((kind, active, deceleration), (met, before)) in kinds.into_iter().zip(self.met.iter_mut().zip(before)) {
            if active.get(side) {
                met.set(side);
                if stop.is_none() && !before.get(side) {
                    stop = Some(LimitStop { kind, side, deceleration });
                }
            }
        }
        if stop.is_some_and(|stop| stop.kind == LimitKind::Hardware) {
            self.flags.hardware.set(side);
        }
        stop
    }

    /// The flags of the axis.
    pub fn flags(&self) -> LimitFlags {
        self.flags
    }

    /// Sets the latched flags of hardware limits as a program writes them.
    pub fn set_latched(&mut self, hardware: Sides) {
        self.flags.hardware = hardware;
    }

    /// The inputs as homing sees them: levels inverted, and without the limits that are not enabled.
    pub fn homing_inputs(&self) -> HomeInputs {
        let LimitFlags { inputs, home, .. } = self.flags;
        let enabled = self.settings.hardware;
        HomeInputs {
            home,
            positive_limit: enabled.positive && inputs.positive,
            negative_limit: enabled.negative && inputs.negative,
        }
    }
}
