//! Moves of a host (guide, "Binary Move Command").
//!
//! A move goes the way of a statement: it is queued on its master, waits behind what moves already, and is refused where a
//! statement would be. What it says of velocities stays with the master, as `VEL`, `FVEL`, `ACC` and `DEC` would; how it begins
//! and ends is for this move only. Whole numbers are pulses, others programming units.

use acrc_catalog::{CommandId, command};
use acrc_motion::{Arc, ControlPoint, Move, MoveSettings, Override, Target, Turn};

use super::{HostError, number};
use crate::command::{CurveLine, LAST_KNOT, moving_velocity};
use crate::controller::{Controller, Observer};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::master::SLOTS;

/// A coordinate of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coordinate {
    /// A long integer: pulses of the axis.
    Pulses(i32),
    /// An IEEE single: programming units.
    Units(f32),
}

/// How a move ends and follows the overrides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveStart {
    /// With rapid move modes disabled.
    Lockouts {
        /// The final velocity is 0.
        final_velocity: bool,
        /// The feedrate override is 1.
        feedrate_override: bool,
        /// The stop ramp is the deceleration; otherwise there is none.
        stop_ramp: bool,
    },
    /// With rapid move modes enabled.
    Mode {
        /// The kind of move.
        mode: MoveMode,
        /// The override that applies is 1.
        override_lockout: bool,
    },
}

/// The kinds of moves when rapid move modes are enabled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveMode {
    /// Hands its velocity over to the next move.
    FeedContinuous,
    /// Slows down to its final velocity.
    FeedCornering,
    /// Stops.
    FeedStopping,
    /// Stops, and follows the rapid override.
    Rapid,
}

/// What a move goes along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HostPath {
    /// A line.
    Line,
    /// An arc of two slaves; the others go along a line.
    Arc(HostArc),
    /// A point of a spline.
    Spline {
        /// Its knot.
        knot: Option<f32>,
    },
    /// A control point of a NURBS curve.
    Nurb {
        /// Its knot.
        knot: Option<f32>,
        /// Its weight.
        weight: Option<f32>,
    },
}

/// An arc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HostArc {
    /// The slaves of its primary and its secondary axis.
    pub slaves: [u8; 2],
    /// It runs from the positive primary axis toward the positive secondary axis.
    pub counterclockwise: bool,
    /// Its center on both axes.
    pub center: [Coordinate; 2],
    /// The center counts from where the move before ends.
    pub incremental: bool,
    /// Scaling of its radius on both axes.
    pub scaling: Option<[f32; 2]>,
}

/// What a move asks for beside motion. Nothing of it has an effect, which the run notes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MoveExtras {
    /// It counts in the move counter of its master.
    pub counts: bool,
    /// The host is to be interrupted when it starts.
    pub interrupts: bool,
    /// It sets the block skip check of its master.
    pub checks_block_skip: bool,
}

/// A move of a master.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HostMove {
    /// The master.
    pub master: u8,
    /// New velocity of the master, in units/s.
    pub velocity: Option<f32>,
    /// New final velocity of the master, in units/s.
    pub final_velocity: Option<f32>,
    /// New acceleration and deceleration of the master, in units/s^2.
    pub acceleration: Option<f32>,
    /// How it ends and follows the overrides.
    pub start: MoveStart,
    /// What else it asks for.
    pub extras: MoveExtras,
    /// Targets count from where the move before ends.
    pub incremental: bool,
    /// Where each slave goes.
    pub targets: [Option<Coordinate>; SLOTS],
    /// What it goes along.
    pub path: HostPath,
}

/// What has become of a move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Queued {
    /// It runs, or waits behind others.
    Yes,
    /// The master has no room for it now. Nothing has changed: it is to be offered again, and what comes behind it in the channel
    /// has to wait, as behind a statement.
    NoRoom,
}

impl Controller {
    /// Whether the flag Enable Rapid Move Modes of a master is set, which decides what two bits of a move mean. No document gives
    /// its number; [`Options::rapid_move_modes`](crate::Options::rapid_move_modes) does.
    pub fn has_rapid_move_modes(&self, master: u8) -> bool {
        let stride = acrc_catalog::FLAGS_PER_WORD;
        self.rapid_move_modes.is_some_and(|first| self.machine.flags.get(first + u32::from(master) * stride))
    }

    /// Queues a move on its master.
    ///
    /// # Errors
    /// When the model lacks the master, one of the slaves has no axis, the moves of the master or the motion of its axes are
    /// killed, the move would have no velocity, or a value makes no sense.
    pub fn host_move(&mut self, ordered: &HostMove, observer: &mut dyn Observer) -> Result<Queued, HostError> {
        let model = self.machine.model;
        let master = usize::from(Machine::object("MASTER", i64::from(ordered.master), model.masters)?);
        self.machine.admits_moves(master)?;
        let settings = self.machine.settings_of(master, ordered)?;
        moving_velocity(ordered.path.command(), master, settings.velocity)?;
        if self.machine.masters[master].kinematics.is_on() {
            return Err(HostError::Kinematics(ordered.master));
        }
        let buffered = self.machine.masters[master].program;
        let buffered = buffered.and_then(|program| self.programs.get(usize::from(program)));
        let buffered = buffered.map_or(0, |program| program.locals.moves());
        let queued = self.machine.take_host_move(master, ordered, settings, buffered)?;
        if queued == Queued::Yes {
            self.machine.note_host_move(ordered);
            self.conclude_order(observer);
        }
        Ok(queued)
    }
}

impl Machine {
    fn take_host_move(
        &mut self,
        master: usize,
        ordered: &HostMove,
        settings: MoveSettings,
        buffered: u32,
    ) -> Result<Queued, HostError> {
        let kind = ordered.path.command();
        let (knot, weight) = match ordered.path {
            HostPath::Spline { knot } => (knot, None),
            HostPath::Nurb { knot, weight } => (knot, weight),
            HostPath::Line | HostPath::Arc(_) => {
                let mut next = self.straight_or_arc(master, ordered, settings)?;
                if !self.end_curve(kind, master)? || !self.takes_move(master, buffered) {
                    return Ok(Queued::NoRoom);
                }
                if self.pair(master, &mut next)? && !self.queue_move(kind, master, &next)? {
                    return Ok(Queued::NoRoom);
                }
                self.masters[master].keep(ordered, settings);
                return Ok(Queued::Yes);
            }
        };
        let nurbs = matches!(ordered.path, HostPath::Nurb { .. });
        let open = self.masters[master].ahead.curve.as_ref().map(|curve| curve.is_nurbs());
        let ends = knot == Some(LAST_KNOT as f32) && ordered.targets.iter().all(Option::is_none);
        if ends || open.is_some_and(|open| open != nurbs) {
            if !self.end_curve(kind, master)? {
                return Ok(Queued::NoRoom);
            }
            if ends {
                return Ok(Queued::Yes);
            }
        }
        if !self.deliver_piece(kind, master)? {
            return Ok(Queued::NoRoom);
        }
        let line = self.curve_line(master, ordered, knot, weight)?;
        if self.masters[master].ahead.curve.is_none() {
            self.masters[master].begin_curve(nurbs);
        }
        self.masters[master].keep(ordered, settings);
        self.add_line(kind, master, &line)?;
        Ok(Queued::Yes)
    }

    /// What a move is made with: the settings of its master, with those that it brings along.
    fn settings_of(&self, master: usize, ordered: &HostMove) -> Result<MoveSettings, HostError> {
        let mut settings = self.masters[master].move_settings();
        if let Some(velocity) = not_negative(command::VEL, ordered.velocity)? {
            settings.velocity = velocity;
        }
        if let Some(velocity) = not_negative(command::FVEL, ordered.final_velocity)? {
            settings.final_velocity = velocity;
        }
        if let Some(acceleration) = not_negative(command::ACC, ordered.acceleration)? {
            (settings.acceleration, settings.deceleration) = (acceleration, acceleration);
        }
        Ok(settings)
    }

    /// A move along a line or an arc.
    fn straight_or_arc(
        &self,
        master: usize,
        ordered: &HostMove,
        mut settings: MoveSettings,
    ) -> Result<Move, HostError> {
        let override_by = ordered.start.apply(&mut settings);
        let mut next = Move::new(settings).overridden_by(override_by);
        for (slot, target) in ordered.targets.iter().enumerate() {
            let Some(target) = target else { continue };
            let units = self.coordinate(master, slot, *target)?;
            let target = if ordered.incremental { Target::Relative(units) } else { Target::Absolute(units) };
            next.targets[slot] = Some(target);
        }
        match ordered.path {
            HostPath::Arc(arc) => self.arc(master, ordered, &arc, next),
            _ => Ok(next),
        }
    }

    /// Makes an arc of two of the targets of a move. A target that is missing is where the move before ends.
    fn arc(&self, master: usize, ordered: &HostMove, arc: &HostArc, mut next: Move) -> Result<Move, HostError> {
        if arc.scaling.is_some_and(|scaling| scaling != [1.0; 2]) {
            return Err(HostError::RadiusScaling);
        }
        let slots = arc.slaves.map(usize::from);
        let (mut target, mut center) = ([0.0; 2], [0.0; 2]);
        for (place, slot) in slots.into_iter().enumerate() {
            center[place] = self.coordinate(master, slot, arc.center[place])?;
            let here = if ordered.incremental { 0.0 } else { self.masters[master].profiler.programmed_target(slot) };
            target[place] = match next.targets[slot].take() {
                Some(Target::Absolute(target) | Target::Relative(target)) => target,
                Some(Target::Sine(_)) | None => here,
            };
        }
        let turn = if arc.counterclockwise { Turn::CounterClockwise } else { Turn::Clockwise };
        let (relative_target, relative_center) = (ordered.incremental, arc.incremental);
        Ok(next.arc(Arc { slots, target, center, relative_target, relative_center, turn }))
    }

    /// A point of a curve.
    fn curve_line(
        &self,
        master: usize,
        ordered: &HostMove,
        knot: Option<f32>,
        weight: Option<f32>,
    ) -> Result<CurveLine, HostError> {
        let knot = knot.map(number::finite).transpose()?.map(f64::from);
        let mut line = CurveLine { knot, point: ControlPoint::new(), has_point: false };
        line.point.weight = weight.map(number::finite).transpose()?.map(f64::from);
        for (slot, target) in ordered.targets.iter().enumerate() {
            let Some(target) = target else { continue };
            let units = self.coordinate(master, slot, *target)?;
            let before = self.masters[master]
                .ahead
                .curve
                .as_ref()
                .map_or_else(|| self.masters[master].profiler.programmed_target(slot), |curve| curve.point(slot));
            line.point.position[slot] = Some(if ordered.incremental { before + units } else { units });
            line.has_point = true;
        }
        Ok(line)
    }

    /// A coordinate of a slave in units.
    fn coordinate(&self, master: usize, slot: usize, coordinate: Coordinate) -> Result<f64, HostError> {
        let axis = self.masters[master].slots.get(slot).copied().flatten();
        let axis = axis.ok_or(HostError::NoSlave { master: master as u8, slave: slot })?;
        match coordinate {
            Coordinate::Pulses(pulses) => Ok(self.axes[usize::from(axis)].units(f64::from(pulses))),
            Coordinate::Units(units) => Ok(f64::from(number::finite(units)?)),
        }
    }

    /// Says what of a move has no effect.
    fn note_host_move(&mut self, ordered: &HostMove) {
        let without_effect = [
            (ordered.extras.counts, "move counter"),
            (ordered.extras.interrupts, "interrupt of the host"),
            (ordered.extras.checks_block_skip, "block skip check"),
        ];
        for (_, what) in without_effect.iter().filter(|(asked, _)| *asked) {
            let master = ordered.master;
            self.notes.insert(format!("a host's move of master {master} asked for the {what}: that has no effect"));
        }
    }
}

impl crate::master::Master {
    /// Keeps what a move says of the master's own settings.
    fn keep(&mut self, ordered: &HostMove, used: MoveSettings) {
        let settings = &mut self.settings;
        if ordered.velocity.is_some() {
            settings.velocity = used.velocity;
        }
        if ordered.final_velocity.is_some() {
            settings.final_velocity = used.final_velocity;
        }
        if ordered.acceleration.is_some() {
            (settings.acceleration, settings.deceleration) = (used.acceleration, used.deceleration);
        }
    }
}

impl MoveStart {
    /// Changes the settings of a move. Gives the override that acts on it.
    fn apply(self, settings: &mut MoveSettings) -> Override {
        let (stops, final_velocity, acting, locked) = match self {
            Self::Lockouts { final_velocity, feedrate_override, stop_ramp } => {
                (stop_ramp, !final_velocity, Override::Feedrate, feedrate_override)
            }
            Self::Mode { mode, override_lockout } => {
                let rapid = if mode == MoveMode::Rapid { Override::Rapid } else { Override::Feedrate };
                (mode != MoveMode::FeedContinuous, mode == MoveMode::FeedCornering, rapid, override_lockout)
            }
        };
        settings.stop = if stops { settings.deceleration } else { 0.0 };
        if !final_velocity {
            settings.final_velocity = 0.0;
        }
        if locked { Override::Locked } else { acting }
    }
}

impl HostPath {
    /// The statement that makes such a move.
    const fn command(&self) -> CommandId {
        match self {
            Self::Line => command::MOV,
            Self::Arc(HostArc { counterclockwise: true, .. }) => command::CIRCCW,
            Self::Arc(_) => command::CIRCW,
            Self::Spline { .. } => command::SPLINE,
            Self::Nurb { .. } => command::NURB,
        }
    }
}

fn not_negative(command: CommandId, value: Option<f32>) -> Result<Option<f64>, HostError> {
    let Some(value) = value else { return Ok(None) };
    let value = f64::from(number::finite(value)?);
    if value < 0.0 {
        let problem = format!("{value} is negative");
        return Err(ControllerError::BadValue { command: command.info().name, problem }.into());
    }
    Ok(Some(value))
}
