//! What is to be felt along the way of an axis: switches, and the marks of its encoder.

use acrc_motion::axis::{CaptureMode, CaptureSource};

use crate::machine::Machine;

impl Machine {
    /// Lets the load follow, and switches and marks show that it has moved.
    pub(super) fn sense(&mut self, axis: u8) {
        let state = &self.axes[usize::from(axis)];
        let Some(mechanism) = self.mechanics.of_mut(axis) else { return };
        let play = mechanism.world.backlash * state.pulses_per_unit;
        mechanism.load = mechanism.load.clamp(mechanism.place - play, mechanism.place);
        let looked = std::mem::replace(&mut mechanism.looked, mechanism.place);
        let way = (looked != mechanism.place && !mechanism.blind).then_some((looked, mechanism.place));
        let mark = way
            .zip(mechanism.world.marker)
            .and_then(|((from, to), marker)| marker.crossed(mechanism.units(from, state), mechanism.units(to, state)));
        if let Some(mark) = mark {
            let place = (mark - mechanism.world.start) * state.pulses_per_unit;
            let actual = place - mechanism.missed - mechanism.origin;
            for rising in [true, false] {
                self.see_edge(axis, CaptureMode { source: CaptureSource::FirstMarker, rising }, actual);
            }
        }
        self.touch_switches(axis);
    }

    /// Gives the inputs of the switches of an axis the levels that they have where its load is.
    fn touch_switches(&mut self, axis: u8) {
        let Some(load) = self.load(axis) else { return };
        let mut index = 0;
        while let Some(switch) = self.mechanics.of(axis).and_then(|mechanism| mechanism.world.switches.get(index)) {
            let (input, level) = (switch.input, switch.region.contains(load) != switch.normally_closed);
            if let Some(mechanism) = self.mechanics.of_mut(axis)
                && let Some(shown) = mechanism.levels.get_mut(index)
                && shown.replace(level) != Some(level)
            {
                self.set_from_outside(input, level);
            }
            index += 1;
        }
    }

    /// Looks at everything along the way of every axis, at power-up.
    pub(crate) fn sense_all(&mut self) {
        for axis in 0..self.model.axes {
            self.sense(axis);
        }
    }
}
