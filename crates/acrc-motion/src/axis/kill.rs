//! What a Kill All Motion Request, Kill All Moves and Stop All Moves do to axes and masters (the guide's "Kill All Motion
//! Request vs. Kill All Moves").
//!
//! The flags belong to the controller, where programs and people set and clear them. [`KillProtocol::update`] looks at them
//! once a tick, spreads what has newly been set, and says what has to stop:
//!
//! - A Kill All Motion Request of an axis also sets that of every other axis of its master, and Kill All Moves of that
//!   master. Each of these axes stops with HLDEC through its jog profiler, which takes over its whole velocity and keeps
//!   the way it needs as a jog offset; jog, gear, cam and ballscrew go off ([`AxisProfilers::stop`]).
//! - Kill All Moves ends the moves of a master without a ramp. Jog, gear and cam go on.
//! - Stop All Moves lets the moves ramp down with DEC; once they stand it sets Kill All Moves and clears itself.
//! - While a flag is set, new motion is refused: [`KillFlags::refusal`]. Programs go on.
//!
//! [`AxisProfilers::stop`]: super::AxisProfilers::stop
//!
//! What the guide leaves open, and how it is read here, stands in `docs/fidelity.md`, "Jog, homing, limits and kills".

use crate::master::AXES;

/// A set of axes or of masters, by number.
pub type NumberSet = u16;

/// The kill flags of a controller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KillFlags {
    /// Axes whose Kill All Motion Request is set (8467 of axis 0, every 32).
    pub requests: NumberSet,
    /// Masters whose Kill All Moves is set (522 of master 0).
    pub moves: NumberSet,
    /// Masters whose Stop All Moves is set (523 of master 0).
    pub stops: NumberSet,
}

/// Why motion is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// A Kill All Motion Request of the axis or of another one of its master: "Associated Slave Kill Motion Request
    /// Active".
    Request,
    /// Kill All Moves of the master, for coordinated moves only.
    Moves,
}

/// Which master each axis is a slave of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Groups {
    /// The master of each axis.
    pub master_of: [Option<u8>; AXES],
}

impl Groups {
    fn master(&self, axis: usize) -> Option<u8> {
        self.master_of.get(axis).copied().flatten()
    }

    /// The axes of a master.
    pub fn axes_of(&self, master: u8) -> NumberSet {
        let slaves = self.master_of.iter().enumerate().filter(|(_, of)| **of == Some(master));
        slaves.fold(0, |set, (axis, _)| set | single(axis))
    }

    /// An axis with all others of its master.
    pub fn group_of(&self, axis: usize) -> NumberSet {
        single(axis) | self.master(axis).map_or(0, |master| self.axes_of(master))
    }
}

impl KillFlags {
    /// Why an axis may not start to move now: by its own profilers, or as part of a coordinated move.
    pub fn refusal(&self, groups: &Groups, axis: usize, coordinated: bool) -> Option<Refusal> {
        if self.requests & groups.group_of(axis) != 0 {
            return Some(Refusal::Request);
        }
        let killed = groups.master(axis).is_some_and(|master| self.moves & single(master.into()) != 0);
        (coordinated && killed).then_some(Refusal::Moves)
    }

    /// CTRL-X, CTRL-Z: requests for every one of these axes.
    pub fn request_all(&mut self, axes: NumberSet) {
        self.requests |= axes;
    }

    /// CTRL-Y: no requests and no killed moves any more.
    pub fn clear_all(&mut self) {
        self.requests = 0;
        self.moves = 0;
    }

    /// DRIVE ON of an axis whose drive was off: clears its request and Kill All Moves of its master.
    pub fn drive_enabled(&mut self, groups: &Groups, axis: usize) {
        self.requests &= !single(axis);
        self.moves &= !groups.master(axis).map_or(0, |master| single(master.into()));
    }
}

/// What has to stop in a tick, in this order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KillActions {
    /// Axes that stop with HLDEC.
    pub stop_axes: NumberSet,
    /// Axes that stop with SLDEC.
    pub soft_stop_axes: NumberSet,
    /// Masters whose moves ramp down with DEC.
    pub ramp_masters: NumberSet,
    /// Masters whose moves end at once. Axes that stop take over the velocity of the moves first.
    pub kill_masters: NumberSet,
}

/// The members of a set, ascending.
pub fn members(set: NumberSet) -> impl Iterator<Item = usize> {
    (0..AXES).filter(move |member| set & single(*member) != 0)
}

fn single(member: usize) -> NumberSet {
    if member < AXES { 1 << member } else { 0 }
}

/// The kill protocol of a controller.
#[derive(Clone, Copy, Debug, Default)]
pub struct KillProtocol {
    /// The flags as they were at the last tick.
    seen: KillFlags,
    soft: NumberSet,
}

impl KillProtocol {
    /// A software limit has stopped an axis: its group stops, and Kill All Moves is set, at the next update.
    pub fn software_limit(&mut self, flags: &mut KillFlags, groups: &Groups, axis: usize) {
        self.soft |= groups.group_of(axis);
        flags.moves |= groups.master(axis).map_or(0, |master| single(master.into()));
    }

    /// Spreads what was set since the last tick, and says what has to stop. `moving` tells whether a master has moves.
    pub fn update(&mut self, flags: &mut KillFlags, groups: &Groups, moving: impl Fn(usize) -> bool) -> KillActions {
        for axis in members(flags.requests & !self.seen.requests) {
            flags.requests |= groups.group_of(axis);
            flags.moves |= groups.master(axis).map_or(0, |master| single(master.into()));
        }
        let ramp_masters = flags.stops & !self.seen.stops;
        for master in members(flags.stops) {
            // A master that was told to ramp down in this tick has not begun to.
            if !moving(master) {
                flags.stops &= !single(master);
                flags.moves |= single(master);
            }
        }
        let stop_axes = flags.requests & !self.seen.requests;
        let actions = KillActions {
            stop_axes,
            soft_stop_axes: core::mem::take(&mut self.soft) & !stop_axes,
            ramp_masters: ramp_masters & flags.stops,
            kill_masters: flags.moves & !self.seen.moves,
        };
        self.seen = *flags;
        actions
    }
}
