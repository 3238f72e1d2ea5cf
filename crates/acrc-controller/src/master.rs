//! One master: a coordinated-move profiler with its settings and slave slots (guide, "Master/Slave Attachments").

use acrc_motion::{Lookahead, Master as Profiler, Move, MoveSettings, SettingError};

use crate::command::{CUBIC, Curve, Kinematics, TimeBase};
use crate::coordination::{Condition, Redirection};
use crate::mechanics::Seek;

use crate::command::UNBUFFERED;

/// Slave slots of a master.
pub(crate) const SLOTS: usize = 16;

/// State of one master.
#[derive(Debug)]
pub(crate) struct Master {
    /// The profiler.
    pub(crate) profiler: Profiler,
    /// Moves for which the profiler has places beside the running one.
    pub(crate) places: u32,
    /// `MBUF ON`
    pub(crate) buffered: bool,
    /// What the next move is made with.
    pub(crate) settings: MoveSettings,
    /// Moves take the time of `TMOV`.
    pub(crate) timed: bool,
    pub(crate) look: Look,
    /// What moves its time on (`SRC`, `TOV`).
    pub(crate) time: TimeBase,
    /// The masters with which it begins its moves, itself among them, as bits (`SYNC`); none is zero.
    pub(crate) group: u32,
    /// `INVK`
    pub(crate) kinematics: Kinematics,
    /// `NURB RANK`
    pub(crate) rank: usize,
    /// What statements have said of moves to come.
    pub(crate) ahead: Ahead,
    /// A move has just ended; whether its velocity dropped is known in the next tick.
    pub(crate) settling: bool,
    /// `VECTOR`.
    pub(crate) vector: f64,
    /// The program it is attached to.
    pub(crate) program: Option<u8>,
    /// The axis in each slot.
    pub(crate) slots: [Option<u8>; SLOTS],
    /// What a run reports of it.
    pub(crate) statistics: MasterStatistics,
}

/// `LOOK`
#[derive(Clone, Copy, Debug)]
pub(crate) struct Look {
    pub(crate) on: bool,
    pub(crate) angles: Lookahead,
    pub(crate) mode: f64,
}

impl Default for Look {
    fn default() -> Self {
        Self { on: false, angles: Lookahead { full: 0.0, stop: 90.0 }, mode: 0.0 }
    }
}

/// What statements have said of moves to come, beside their settings.
#[derive(Debug, Default)]
pub(crate) struct Ahead {
    /// What the next move waits for (`TRG`).
    pub(crate) gate: Option<Condition>,
    /// The curve whose points are being given (`SPLINE`, `NURB`).
    pub(crate) curve: Option<Box<Curve>>,
    /// What redirects the last move (`HSINT`).
    pub(crate) redirection: Option<Redirection>,
    /// The search for marks that the move under way makes (`MSEEK`).
    pub(crate) seek: Option<Seek>,
    /// The axes whose moves make arcs in pairs (`TARC ON`).
    pub(crate) arc: Option<OpenArc>,
}

/// Axes whose moves make arcs in pairs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OpenArc {
    pub(crate) slots: [usize; 3],
    /// The point on the way, when the first move of a pair has given it.
    pub(crate) via: Option<[f64; 3]>,
}

impl Ahead {
    fn forget(&mut self) {
        self.gate = None;
        self.curve = None;
        self.redirection = None;
        self.seek = None;
        if let Some(arc) = &mut self.arc {
            arc.via = None;
        }
    }
}

/// What a master did during a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MasterStatistics {
    /// Moves that were completed.
    pub moves: u64,
    /// Ticks in motion.
    pub motion_ticks: u64,
}

impl Master {
    pub(crate) fn new() -> Self {
        Self {
            profiler: Profiler::new(UNBUFFERED as usize),
            places: UNBUFFERED,
            buffered: false,
            settings: MoveSettings::default(),
            timed: true,
            look: Look::default(),
            time: TimeBase::CLOCK,
            group: 0,
            kinematics: Kinematics::default(),
            rank: CUBIC,
            ahead: Ahead::default(),
            settling: false,
            vector: 0.0,
            program: None,
            slots: [None; SLOTS],
            statistics: MasterStatistics::default(),
        }
    }

    /// Velocity along the path, u/s, in the time of the controller.
    pub(crate) fn vector_velocity(&self) -> f64 {
        self.profiler.vector_velocity() * self.time.rate
    }

    /// Velocity (u/s) and acceleration (u/s^2) of a slot, in the time of the controller.
    pub(crate) fn motion(&self, slot: usize) -> (f64, f64) {
        let rate = self.time.rate;
        (self.profiler.velocity(slot) * rate, self.profiler.acceleration(slot) * (rate * rate))
    }

    /// What the next move is made with.
    pub(crate) fn move_settings(&self) -> MoveSettings {
        let time = if self.timed { self.settings.time } else { 0.0 };
        MoveSettings { time, ..self.settings }
    }

    /// Drops what a move that never comes would have been made of.
    pub(crate) fn forget(&mut self) {
        self.kinematics.forget();
        self.ahead.forget();
    }

    /// A move with the gate of `TRG`.
    pub(crate) fn gated(&self, next: &Move) -> Move {
        self.ahead.gate.map_or(*next, |gate| next.gated(gate.code()))
    }

    /// Forgets what was said of the axis that had a slot before.
    pub(crate) fn renew_slot(&mut self, slot: usize) -> Result<(), SettingError> {
        let profiler = &mut self.profiler;
        profiler.set_weight(slot, 1.0)?;
        profiler.set_scale(slot, 1.0, 0.0)?;
        profiler.set_offset(slot, 0.0)?;
        profiler.set_float(slot, 0.0)?;
        profiler.set_rotation([0, 1], 0.0, [0.0; 2])?;
        profiler.set_tangent(None)?;
        self.ahead = Ahead::default();
        Ok(())
    }

    /// The slots that hold an axis.
    pub(crate) fn attached(&self) -> impl Iterator<Item = (usize, u8)> {
        self.slots.iter().enumerate().filter_map(|(slot, axis)| axis.map(|axis| (slot, axis)))
    }
}
