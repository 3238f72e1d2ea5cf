//! What goes wrong around an axis, and what the controller does about it (guide, "Kill All Motion Request vs. Kill All Moves", "Error Handling",
//! "Troubleshooting").

use acrc_catalog::law;

use crate::machine::Machine;
use crate::world::Happening;

impl Machine {
    /// Lets something happen to the mechanics.
    pub(crate) fn happen(&mut self, happening: Happening) {
        match happening {
            Happening::Jam(axis) | Happening::Free(axis) => {
                let setpoint = self.setpoint_pulses(axis);
                if let Some(mechanism) = self.mechanics.of_mut(axis) {
                    mechanism.settle(setpoint);
                    mechanism.jammed = matches!(happening, Happening::Jam(_));
                }
            }
            Happening::EncoderLost(axis) => self.lose_encoder(axis),
            Happening::EncoderBack(axis) => {
                if let Some(mechanism) = self.mechanics.of_mut(axis) {
                    mechanism.blind = false;
                }
            }
            Happening::DriveFault(axis) => {
                if axis < self.model.axes {
                    self.flags.set_law(law::DRIVE_FAULT_LATCHED, u32::from(axis), true);
                    self.fail(axis);
                }
            }
            Happening::MotionEnable(closed) => self.set_from_outside(law::MEI_OPEN.at(0), !closed),
        }
    }

    /// Secondary setpoint of an axis in pulses; 0 for one that the model does not have.
    fn setpoint_pulses(&self, axis: u8) -> f64 {
        let state = self.axes.get(usize::from(axis));
        state.map_or(0.0, |state| self.registers_of(axis).secondary_setpoint() * state.pulses_per_unit)
    }

    /// An axis cannot go on: it is killed, and its drive goes off.
    pub(super) fn fail(&mut self, axis: u8) {
        self.kill_motion(axis);
        self.set_drive(axis, false);
    }

    fn lose_encoder(&mut self, axis: u8) {
        let setpoint = self.setpoint_pulses(axis);
        let Some(mechanism) = self.mechanics.of_mut(axis) else { return };
        mechanism.settle(setpoint);
        mechanism.blind = true;
        self.flags.set_law(law::ENCODER_SIGNAL_LOST, u32::from(axis), true);
        self.fail(axis);
    }

    /// Clears the faults of an encoder that has its signals (`ENC RES`).
    pub(crate) fn reset_encoder_faults(&mut self, encoder: u8) {
        let blind = self.mechanics.of(encoder).is_some_and(|mechanism| mechanism.blind);
        if !blind {
            for law in [law::ENCODER_SIGNAL_FAULT, law::ENCODER_SIGNAL_LOST] {
                self.flags.set_law(law, u32::from(encoder), false);
            }
        }
    }

    /// An input or another flag from outside takes a state.
    pub(crate) fn set_from_outside(&mut self, flag: u32, state: bool) {
        if self.flags.get(flag) == state {
            return;
        }
        self.flags.set(flag, state);
        self.motion.touch_flag(flag);
        self.see_input(flag, state);
        if flag == law::MEI_OPEN.at(0) && state {
            self.flags.set(law::MEI_LATCHED.at(0), true);
            for axis in 0..self.model.axes {
                self.fail(axis);
            }
        }
    }

    /// Whether the motion enable input lets drives be enabled.
    pub(crate) fn is_motion_enabled(&self) -> bool {
        !self.flags.get(law::MEI_OPEN.at(0)) && !self.flags.get(law::MEI_LATCHED.at(0))
    }
}

impl super::Mechanism {
    /// Brings the place of a machine that is led up to date, before something happens to it.
    fn settle(&mut self, setpoint: f64) {
        if self.is_led() {
            self.place = setpoint + self.origin + self.missed;
        }
    }
}
