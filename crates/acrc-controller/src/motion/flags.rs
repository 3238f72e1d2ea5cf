//! The flags that follow from what an axis does by itself.

use acrc_catalog::{Law, law};

use acrc_motion::axis::{JogFlags, LimitFlags};

use crate::machine::Machine;
use crate::mechanics::Mechanism;

/// What the flags of an axis were last brought in line with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shown {
    jog: JogFlags,
    limits: LimitFlags,
}

impl Machine {
    /// Brings the jog and limit flags of an axis in line with its profilers.
    pub(super) fn update_axis_flags(&mut self, axis: u8) {
        let state = &mut self.axes[usize::from(axis)];
        let shown = Shown { jog: state.profilers.jog.flags(), limits: state.limits.flags() };
        let before = state.shown.replace(shown);
        self.update_in_position(axis);
        if before == Some(shown) {
            return;
        }
        let Shown { jog, limits } = shown;
        let states: [(Law, bool); 13] = [
            (law::JOG_ACTIVE, jog.active),
            (law::JOG_FLAG_25, jog.negative),
            (law::JOG_FLAG_26, jog.at_speed),
            (law::JOG_STOPPING, jog.stopping),
            (law::JOG_FORWARD, jog.forward),
            (law::JOG_REVERSE, jog.reverse),
            (law::POS_LIMIT_INPUT, limits.inputs.positive),
            (law::NEG_LIMIT_INPUT, limits.inputs.negative),
            (law::HOME_INPUT, limits.home),
            (law::POS_LIMIT_HIT, limits.hardware.positive),
            (law::NEG_LIMIT_HIT, limits.hardware.negative),
            (law::POS_SOFT_LIMIT_HIT, limits.software.positive),
            (law::NEG_SOFT_LIMIT_HIT, limits.software.negative),
        ];
        for (law, state) in states {
            self.flags.set_law(law, u32::from(axis), state);
        }
    }

    /// An axis is in position when its coordinated move and its jog have come to their ends, and its following error is within the band of `IPB`.
    pub(crate) fn update_in_position(&mut self, axis: u8) {
        let arrived =
            self.position(axis) == self.target(axis) && self.mechanics.of(axis).is_none_or(Mechanism::in_position);
        let state = &mut self.axes[usize::from(axis)];
        let in_position = arrived && !state.profilers.jog.active();
        if state.in_position.replace(in_position) != Some(in_position) {
            self.flags.set_law(law::NOT_IN_POSITION, u32::from(axis), !in_position);
        }
    }
}
