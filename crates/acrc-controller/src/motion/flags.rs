//! The flags that follow from what an axis does by itself.

use acrc_catalog::{Law, law};

use crate::machine::Machine;
use crate::mechanics::Mechanism;

impl Machine {
    /// Brings the jog and limit flags of an axis in line with its profilers.
    pub(super) fn update_axis_flags(&mut self, axis: u8) {
        let state = &self.axes[usize::from(axis)];
        let jog = state.profilers.jog.flags();
        let limits = state.limits.flags();
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
        self.update_in_position(axis);
    }

    /// An axis is in position when its coordinated move and its jog have come to their ends, and its following error is within the band of `IPB`.
    pub(crate) fn update_in_position(&mut self, axis: u8) {
        let arrived =
            self.position(axis) == self.target(axis) && self.mechanics.of(axis).is_none_or(Mechanism::in_position);
        let jogs = self.axes[usize::from(axis)].profilers.jog.active();
        self.flags.set_law(law::NOT_IN_POSITION, u32::from(axis), !arrived || jogs);
    }
}
