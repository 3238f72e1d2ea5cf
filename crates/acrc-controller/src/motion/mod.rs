//! What axes do by themselves, beside the coordinated moves of their masters: jog, homing, limits, kill.
//!
//! The arithmetic is that of [`acrc_motion::axis`]; here it meets the flags, parameters and settings of the controller. An axis costs nothing while
//! none of its profilers is at work and nothing has been written or has happened since the last tick ([`AxisMotion`]).

mod cam;
mod flags;
mod gear;
mod homing;
mod jog;
mod kill;
mod limit_switch;
mod registers;
mod sampling;
mod settings;
mod sources;
mod tables;
mod tick;

pub(crate) use cam::{Table, TableKind};
pub(crate) use flags::Shown;
pub(crate) use jog::JogOrder;
pub(crate) use registers::Preload;
pub(crate) use settings::refused;
pub(crate) use sources::{Feed, Follower, Followers};
pub(crate) use tables::{ArrayPlace, Arrays, NoArrays};

use acrc_motion::axis::KillProtocol;

use limit_switch::{LIMIT_SWITCHES, Switch};
use sampling::Sampling;
use sources::Gates;

/// What the axes have in common.
#[derive(Clone, Debug)]
pub(crate) struct AxisMotion {
    /// The axes of which a setting has been written since their profilers took theirs, one bit each.
    stale: u32,
    /// The same of a ratchet, limiter, limit switch or channel.
    objects_stale: bool,
    /// An axis moves by itself, or something has happened to which one may react in the next tick.
    awake: bool,
    kills: KillProtocol,
    gates: Gates,
    limit_switches: Vec<Switch>,
    sampling: Sampling,
    /// The axes whose limits or compensation have to be looked at while their masters move them, one bit each.
    guarded: u32,
    /// The flag words in which limit and home inputs lie, as [`word_bit`] has them.
    switch_words: u64,
}

impl AxisMotion {
    /// Power-up.
    pub(crate) fn new() -> Self {
        Self {
            stale: u32::MAX,
            objects_stale: true,
            awake: true,
            kills: KillProtocol::default(),
            gates: Gates::default(),
            limit_switches: vec![Switch::default(); LIMIT_SWITCHES],
            sampling: Sampling::default(),
            guarded: 0,
            switch_words: 0,
        }
    }

    /// Whether the next tick has something to do.
    pub(crate) fn is_awake(&self) -> bool {
        self.awake
    }

    /// A setting of an axis has been written.
    pub(crate) fn touch_axis(&mut self, axis: u8) {
        self.stale |= 1 << axis;
        self.awake = true;
    }

    /// A setting has been written that may be anybody's.
    pub(crate) fn touch(&mut self) {
        self.stale = u32::MAX;
        self.objects_stale = true;
        self.awake = true;
    }

    /// Something has happened in the world.
    pub(crate) fn wake(&mut self) {
        self.awake = true;
    }

    /// A flag has changed that may be a switch.
    #[inline]
    pub(crate) fn touch_flag(&mut self, number: u32) {
        self.awake |= self.switch_words & word_bit(number) != 0 || self.sampling.trigger == Some(number);
    }
}

/// The bit of a set of flag words that stands for the word of a flag. The last one stands for all words that have none of their own.
fn word_bit(flag: u32) -> u64 {
    1 << (flag / u32::BITS).min(u64::BITS - 1)
}
