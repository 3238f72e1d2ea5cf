//! An axis that points along the path of two others (the guide's TANG).

use super::lay::short_way;
use super::path::{Path, Place, Shape};
use super::{AXES, Master, SettingError};
use crate::profile::State;
use crate::trig::angle;
use crate::value::{Quantity, finite};

const TURN: f64 = 2.0 * core::f64::consts::PI;

/// Step in the part of the path over which a change of turning is measured.
const STEP: f64 = 1e-5;

/// An axis that is turned to point along a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangent {
    /// The two axes of the path; from the first toward the second the axis turns up.
    pub plane: [usize; 2],
    /// The axis that is turned.
    pub axis: usize,
    /// Length of a turn of that axis, u; negative if it turns the other way.
    pub turn: f64,
    /// Where the axis is while the path leads up the first axis, u.
    pub offset: f64,
}

/// How an axis turns along one path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turning {
    plane: [usize; 2],
    pub(super) axis: usize,
    per_radian: f64,
    /// Direction at the start, radians, and where the axis is then, u.
    start: f64,
    base: f64,
    /// About how far the direction turns over the whole path, radians.
    sweep: f64,
}

impl Turning {
    /// `None` if the axes of the plane do not move at the start.
    fn new(tangent: &Tangent, path: &Path, from: f64) -> Option<Self> {
        let rates = tangent.plane.map(|slot| path.rate(slot, 1, &path.place(0.0)));
        if rates == [0.0; 2] {
            return None;
        }
        let start = angle(rates[1], rates[0]);
        let per_radian = tangent.turn / TURN;
        let aim = tangent.offset + start * per_radian;
        let base = from + short_way(aim - from, tangent.turn.abs());
        let sweep = if let Shape::Winding(winding) = path.shape() { winding.turning(tangent.plane) } else { 0.0 };
        Some(Self { plane: tangent.plane, axis: tangent.axis, per_radian, start, base, sweep })
    }

    /// Where the axis is, u.
    pub(super) fn position(&self, path: &Path, place: &Place) -> f64 {
        let [x, y] = self.plane.map(|slot| path.rate(slot, 1, place));
        if x == 0.0 && y == 0.0 {
            return self.base;
        }
        let turned = angle(y, x) - self.start;
        let whole = libm::rint((self.sweep * place.part() - turned) / TURN);
        self.base + (turned + whole * TURN) * self.per_radian
    }

    /// Change of position with the part of the path.
    fn rate(&self, path: &Path, place: &Place) -> f64 {
        let [[x, dx], [y, dy]] = self.plane.map(|slot| [path.rate(slot, 1, place), path.rate(slot, 2, place)]);
        let square = x * x + y * y;
        if square > 0.0 { (x * dy - y * dx) / square * self.per_radian } else { 0.0 }
    }

    /// Velocity of the axis, u/s.
    pub(super) fn velocity(&self, path: &Path, place: &Place, state: &State) -> f64 {
        self.rate(path, place) * path.part(state.velocity)
    }

    /// Acceleration of the axis, u/s², from how its turning changes over a short stretch of the path.
    pub(super) fn acceleration(&self, path: &Path, place: &Place, state: &State) -> f64 {
        let (low, high) = ((place.part() - STEP).max(0.0), (place.part() + STEP).min(1.0));
        let at = |part: f64| self.rate(path, &path.place(part * path.length()));
        let change = (at(high) - at(low)) / (high - low);
        let rate = path.part(state.velocity);
        self.rate(path, place) * path.part(state.acceleration) + change * (rate * rate)
    }
}

impl Tangent {
    /// Lets the axis follow a path that is laid for axes at `start`.
    pub(super) fn apply(&self, path: &mut Path, start: &[f64; AXES]) {
        let Some(from) = start.get(self.axis) else { return };
        if let Some(turning) = Turning::new(self, path, *from) {
            path.turn(&turning);
        }
    }
}

impl Master {
    /// Sets the axis that points along the path of two others in moves queued from now on (TANG); `None` ends that.
    ///
    /// On arcs and curves the axis turns with the path. Where two moves meet at an angle it jumps, the short way. A move
    /// that gives the axis a target, or does not move the other two, is not followed.
    pub fn set_tangent(&mut self, tangent: Option<Tangent>) -> Result<(), SettingError> {
        if let Some(Tangent { plane: [x, y], axis, turn, offset }) = tangent {
            finite(Quantity::RotaryLength, turn)?;
            finite(Quantity::Position, offset)?;
            if let Some(slot) = [x, y, axis].into_iter().find(|slot| *slot >= AXES) {
                return Err(SettingError::NoSuchSlot(slot));
            }
            if x == y || axis == x || axis == y {
                return Err(SettingError::SameSlot(if x == y { x } else { axis }));
            }
            if turn == 0.0 {
                return Err(SettingError::ZeroTurn);
            }
        }
        self.ground.tangent = tangent;
        Ok(())
    }

    /// The axis that points along the path.
    pub fn tangent(&self) -> Option<Tangent> {
        self.ground.tangent
    }
}
