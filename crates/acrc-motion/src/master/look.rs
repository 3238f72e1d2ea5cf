//! Looking ahead over the moves that wait (the guide's LOOK), and over the pieces of one curve.
//!
//! From the last move back to the running one it is found how fast each may begin so that every corner, and the end of
//! what is known, is met with the deceleration ramp. A move then ends no faster than the next may begin.

use super::lay::length;
use super::moves::MoveSettings;
use super::path::Path;
use super::queue::Queued;
use super::{AXES, Master, SettingError};
use crate::profile::reachable;
use crate::trig::{DEGREE, angle};
use crate::value::{InvalidValue, Quantity, not_negative};

/// Part by which a velocity stays below what just fits, so that rounding does not make it too much.
const MARGIN: f64 = 1e-9;

/// How corners between moves are taken (LOOK ANG): an angle of zero is straight on, one of 180 degrees straight back.
///
/// Between the two angles the velocity at the corner falls evenly from the lower one of both moves to zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lookahead {
    /// Angle up to which a corner does not slow down, degrees.
    pub full: f64,
    /// Angle from which a corner is a stop, degrees.
    pub stop: f64,
}

impl Lookahead {
    fn validate(&self) -> Result<(), InvalidValue> {
        not_negative(Quantity::CornerAngle, self.full)?;
        not_negative(Quantity::CornerAngle, self.stop)?;
        Ok(())
    }

    /// Part of the velocity that a corner leaves.
    fn share(&self, corner: f64) -> f64 {
        if corner <= self.full {
            1.0
        } else if corner >= self.stop {
            0.0
        } else {
            (self.stop - corner) / (self.stop - self.full)
        }
    }
}

impl Master {
    /// Sets whether and how moves look ahead over those that wait (LOOK). `None`, the default, keeps to the guide: a
    /// move without a stop ramp ends at the velocity it has.
    ///
    /// With it, such a move slows down with its deceleration ramp for the corner at its end, for the velocity of the
    /// next move and for what comes after that; and for rest at the end of the last move that is known. A move with a
    /// stop ramp ends as ever, or slower.
    pub fn set_lookahead(&mut self, lookahead: Option<Lookahead>) -> Result<(), SettingError> {
        if let Some(lookahead) = &lookahead {
            lookahead.validate()?;
        }
        if self.lookahead != lookahead {
            self.lookahead = lookahead;
            self.look_ahead(true);
        }
        Ok(())
    }

    /// How moves look ahead.
    pub fn lookahead(&self) -> Option<Lookahead> {
        self.lookahead
    }

    /// Finds anew how fast the moves may end, from the last one back; `all` of them, or only as far as it changes.
    pub(super) fn look_ahead(&mut self, all: bool) {
        for index in (0..self.queue.len()).rev() {
            let Some(this) = self.queue.get(index) else { return };
            let exit = self.exit(&this.path, &this.settings, self.queue.get(index + 1));
            let ceiling = if self.lookahead.is_some() {
                this.settings.velocity * self.override_factor(this.override_by)
            } else {
                f64::INFINITY
            };
            let ceiling = ceiling.min(this.path.ceiling());
            let own = (this.settings.stop > 0.0).then_some(this.settings.final_velocity);
            let end = exit.or(own);
            let entry = end.map_or(f64::INFINITY, |end| entry(&this.path, &this.settings, end)).min(ceiling);
            if !all && this.exit == exit && this.entry == entry && index + 1 < self.queue.len() {
                return;
            }
            self.queue.limit(index, entry, exit);
        }
        let Some(running) = &self.running else { return };
        let exit = self.exit(running.path(), running.settings(), self.queue.first());
        let factor = self.factor(running.override_by());
        if let Some(running) = &mut self.running {
            running.set_exit(exit, factor);
        }
    }

    /// How fast a move may end. `None` where only its own settings count.
    fn exit(&self, path: &Path, settings: &MoveSettings, next: Option<&Queued>) -> Option<f64> {
        let limit = match (next, &self.lookahead) {
            (Some(next), _) if path.is_joined() => next.entry,
            (Some(next), Some(_)) if !self.begins_by_itself(next.gate) => 0.0,
            (Some(next), Some(lookahead)) => {
                let full = next.settings.velocity.min(settings.velocity);
                let share = lookahead.share(next.corner);
                // A corner that costs nothing does not limit the override either.
                if share == 1.0 { next.entry } else { next.entry.min(share * full) }
            }
            (Some(next), None) if next.path.ceiling().is_finite() => next.path.ceiling(),
            (None, Some(_)) if !path.is_joined() => 0.0,
            _ => return None,
        };
        let limit = if settings.stop > 0.0 { limit.min(settings.final_velocity) } else { limit };
        (limit.is_finite() && !(settings.stop > 0.0 && next.is_none())).then_some(limit)
    }

    /// The angle between the direction in which the last move ends and that in which another begins, degrees.
    pub(super) fn corner(&self, path: &Path) -> f64 {
        let (before, behind) = (&self.heading, path.heading(false, &self.ground.weights));
        if *before == NO_HEADING || behind == NO_HEADING {
            return 0.0;
        }
        // Of two directions of length one: the difference and the sum are the sides across half the angle.
        let across: [f64; AXES] = core::array::from_fn(|slot| behind[slot] - before[slot]);
        let along: [f64; AXES] = core::array::from_fn(|slot| behind[slot] + before[slot]);
        2.0 * angle(length(&across), length(&along)) / DEGREE
    }
}

/// How fast a move may begin to end at `exit`.
fn entry(path: &Path, settings: &MoveSettings, exit: f64) -> f64 {
    let ramp = if settings.stop > 0.0 { settings.stop } else { settings.deceleration };
    reachable(exit, path.length(), ramp, settings.jerk) * (1.0 - MARGIN)
}

/// The direction of no move.
pub(super) const NO_HEADING: [f64; AXES] = [0.0; AXES];
