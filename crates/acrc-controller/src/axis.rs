//! One axis: scaling, drive state, position registers, motion (guide, "Primary Setpoint" and "REN Details").
//!
//! Unless the world describes a machine, the plant is ideal: the actual position follows the setpoint at once, so the following error is zero.
//! Positions are kept in programming units; the controller's registers in pulses are computed from them.

use acrc_motion::axis::{AxisProfilers, GantryLock, SourceCounts, TravelLimits};

use crate::machine::Machine;
use crate::mechanics::CaptureState;
use crate::motion::{Followers, Shown, Table};

/// State of one axis.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    /// Pulses per programming unit (`PPU`).
    pub(crate) pulses_per_unit: f64,
    /// Coordinated position in units while no master has the axis as a slave.
    pub(crate) rest_position: f64,
    /// Where it is attached: master and slave slot.
    pub(crate) slave: Option<SlaveSlot>,
    /// What `ATTACH AXIS` connected it to, as `ATTACH` reports it; `None` for the factory's.
    pub(crate) signals: Option<String>,
    /// The drive has been enabled at least once.
    pub(crate) was_enabled: bool,
    /// Its own profilers: jog, homing, gear, cam and compensation.
    pub(crate) profilers: AxisProfilers,
    /// How far its master has moved it in this tick, in units, while its own profilers are at work.
    pub(crate) carried: f64,
    /// What backlash compensation adds to the setpoint, units.
    pub(crate) backlash: f64,
    /// Its end-of-travel limits.
    pub(crate) limits: TravelLimits,
    /// The gear goes on at the end of the tick, when the speed of its source is known.
    pub(crate) engages: bool,
    /// What its sources have counted in this tick.
    pub(crate) counts: SourceCounts,
    /// What its profilers follow.
    pub(crate) followers: Followers,
    /// Where the points of its cam are.
    pub(crate) cam_table: Table,
    /// Where the points of its ballscrew compensation are.
    pub(crate) ballscrew_table: Table,
    /// The axis that it follows as a gantry.
    pub(crate) lock: Option<Lock>,
    /// The inputs of its limits: positive, negative, home (`HLBIT`).
    pub(crate) switches: [Option<u32>; 3],
    /// What captures its position.
    pub(crate) capture: CaptureState,
    /// What its flags show; nothing yet at power-up.
    pub(crate) shown: Option<Shown>,
    /// Whether its flag says that it is in position.
    pub(crate) in_position: Option<bool>,
    /// What a run reports of it.
    pub(crate) statistics: AxisStatistics,
}

/// An axis that a gantry axis follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lock {
    pub(crate) leader: u8,
    pub(crate) gantry: GantryLock,
}

/// A slot of a master.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SlaveSlot {
    pub(crate) master: u8,
    pub(crate) slot: u8,
}

/// What an axis did during a run, in programming units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisStatistics {
    /// Distance travelled.
    pub travel: f64,
    /// What [`AxisStatistics::travel`] is too large by, from rounding.
    travel_error: f64,
    /// Highest speed, units/s.
    pub peak_velocity: f64,
    /// Highest acceleration, units/s^2. Steps of velocity, where a ramp is 0, do not count.
    pub peak_acceleration: f64,
}

impl Axis {
    pub(crate) fn new() -> Self {
        Self {
            pulses_per_unit: 1.0,
            rest_position: 0.0,
            slave: None,
            signals: None,
            was_enabled: false,
            profilers: AxisProfilers::default(),
            carried: 0.0,
            backlash: 0.0,
            limits: TravelLimits::default(),
            engages: false,
            counts: SourceCounts::default(),
            followers: Followers::default(),
            cam_table: Table::default(),
            ballscrew_table: Table::default(),
            lock: None,
            switches: [None; 3],
            capture: CaptureState::default(),
            shown: None,
            in_position: None,
            statistics: AxisStatistics::default(),
        }
    }

    /// Units as the whole pulses of a register.
    pub(crate) fn pulses(&self, units: f64) -> i32 {
        (units * self.pulses_per_unit).round() as i32
    }

    /// Pulses of a register as units.
    pub(crate) fn units(&self, pulses: f64) -> f64 {
        pulses / self.pulses_per_unit
    }
}

impl AxisStatistics {
    /// Takes in one tick of motion.
    pub(crate) fn record(&mut self, from: f64, to: f64, velocity: f64, acceleration: f64) {
        // Compensated, since a long run sums up millions of small steps.
        let step = (to - from).abs() - self.travel_error;
        let travel = self.travel + step;
        self.travel_error = (travel - self.travel) - step;
        self.travel = travel;
        self.peak_velocity = self.peak_velocity.max(velocity.abs());
        self.peak_acceleration = self.peak_acceleration.max(acceleration.abs());
    }
}

impl Machine {
    /// Position of the coordinated profiler of an axis in units.
    pub(crate) fn position(&self, axis: u8) -> f64 {
        let state = &self.axes[usize::from(axis)];
        match state.slave {
            Some(SlaveSlot { master, slot }) => self.masters[usize::from(master)].profiler.position(usize::from(slot)),
            None => state.rest_position,
        }
    }

    /// Where the coordinated moves given so far will leave an axis, in units.
    pub(crate) fn target(&self, axis: u8) -> f64 {
        match self.axes[usize::from(axis)].slave {
            Some(SlaveSlot { master, slot }) => self.masters[usize::from(master)].profiler.target(usize::from(slot)),
            None => self.position(axis),
        }
    }

    /// Velocity (units/s) and acceleration (units/s^2) of an axis, from all of its profilers.
    pub(crate) fn motion(&self, axis: u8) -> (f64, f64) {
        let (velocity, acceleration) = self.coordinated_motion(axis);
        let profilers = &self.axes[usize::from(axis)].profilers;
        (velocity + profilers.velocity(), acceleration + profilers.jog.state().acceleration)
    }

    /// The part of its master in [`Machine::motion`].
    pub(crate) fn coordinated_motion(&self, axis: u8) -> (f64, f64) {
        match self.axes[usize::from(axis)].slave {
            Some(SlaveSlot { master, slot }) => self.masters[usize::from(master)].motion(usize::from(slot)),
            None => (0.0, 0.0),
        }
    }

    /// Whether an axis moves, by its master, by itself, or led by another one.
    pub(crate) fn axis_in_motion(&self, axis: u8) -> bool {
        let state = &self.axes[usize::from(axis)];
        state.moves() || self.master_moves(axis) || state.lock.is_some_and(|lock| self.axis_in_motion(lock.leader))
    }

    /// Whether the master of an axis moves.
    pub(crate) fn master_moves(&self, axis: u8) -> bool {
        let slave = self.axes[usize::from(axis)].slave;
        slave.is_some_and(|slave| self.masters[usize::from(slave.master)].profiler.in_motion())
    }
}
