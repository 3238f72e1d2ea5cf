//! Reading and writing flags by number, with what that does to the machine (guide, "Parameters and Bits", "Kill All Motion Request vs. Kill All Moves").

use acrc_catalog::{bit, law};
use acrc_motion::axis::Side;

use super::map::{Effect, map};
use crate::error::ControllerError;
use crate::flags::{FIRST_WORD, Flags};
use crate::machine::Machine;
use crate::motion::JogOrder;
use crate::orders::Order;
use crate::request::Request;
use crate::task::Task;

impl Machine {
    /// State of a flag.
    pub(crate) fn read_bit(&self, number: i64) -> Result<bool, ControllerError> {
        Ok(self.flags.get(checked_bit(number)?))
    }

    /// Changes a flag, with what that does to the machine.
    pub(crate) fn write_bit(&mut self, number: i64, state: bool) -> Result<(), ControllerError> {
        let number = checked_bit(number)?;
        let flag = map().flag(number);
        if self.is_missing(flag.owner, flag.object) {
            return Ok(());
        }
        let (index, object) = (usize::from(flag.object), flag.object);
        match flag.effect {
            Effect::None => {
                self.flags.set(number, state);
                self.motion.touch_flag(number);
            }
            Effect::ReadOnly => {
                return Err(ControllerError::ReadOnly { name: format!("BIT{number}"), title: bit(number).title });
            }
            Effect::Undocumented => {
                self.flags.set(number, state);
                self.note_undocumented(format_args!("BIT{number}"));
            }
            // Requests clear themselves; so does Stop All Moves, when the master has stopped.
            Effect::Request => self.note_effect(number, state),
            Effect::Master(Order::Kill) if !state => {
                self.flags.set(number, false);
                self.update_kills();
            }
            Effect::Master(order) if state => self.order(index, order),
            Effect::RunProgram if state => self.requests.push(Request::Run(Task::Program(object))),
            Effect::HaltProgram if state => self.requests.push(Request::Halt(Task::Program(object))),
            Effect::RunPlc if state => self.requests.push(Request::Run(Task::Plc(object))),
            Effect::HaltPlc if state => self.requests.push(Request::Halt(Task::Plc(object))),
            Effect::PauseProgram if state => self.requests.push(Request::Pause(object)),
            Effect::PauseProgram => self.requests.push(Request::Resume(object)),
            Effect::EnableDrive => self.set_drive(object, state),
            Effect::KillMotion => {
                self.flags.set(number, state);
                self.update_kills();
            }
            Effect::AxisSetting => {
                self.flags.set(number, state);
                self.motion.touch_axis(object);
            }
            Effect::Stream => {
                self.flags.set(number, state);
                self.motion.touch_flag(number);
                self.echo_as_flagged(object);
            }
            // A flag that has its state already says nothing of the jog that another command has started.
            Effect::Jog(_) if self.flags.get(number) == state => {}
            Effect::Jog(side) => {
                let started = self.jog(object, if state { JogOrder::Run(side) } else { JogOrder::Off });
                self.note_refusal(number, started);
            }
            Effect::JogOff if state => self.jog(object, JogOrder::Off)?,
            Effect::Home if state => {
                let negative = self.flags.get(law::JOG_HOME_DIRECTION.at(u32::from(object)));
                let started = self.home(object, if negative { Side::Negative } else { Side::Positive });
                self.note_refusal(number, started);
            }
            Effect::ResetMotionEnable => self.reset_motion_enable(state),
            Effect::Master(_)
            | Effect::RunProgram
            | Effect::HaltProgram
            | Effect::RunPlc
            | Effect::HaltPlc
            | Effect::JogOff
            | Effect::Home => {}
        }
        Ok(())
    }

    /// Whether a flag is memory only: writing it changes no other flag or parameter but its own word.
    pub(crate) fn is_plain_flag(number: i64) -> bool {
        PLAIN_FLAGS.iter().any(|flags| flags.contains(&number))
    }

    /// Whether a flag can only be read.
    pub(crate) fn is_read_only(number: i64) -> bool {
        u32::try_from(number).is_ok_and(|number| map().flag(number).effect == Effect::ReadOnly)
    }

    /// Whether giving a flag the state that it has does nothing.
    pub(crate) fn is_idle_write(number: i64, state: bool) -> bool {
        u32::try_from(number).is_ok_and(|number| map().flag(number).effect.is_idle(state))
    }

    /// Writes a flag word bit by bit, so that each bit does what it does when it is set alone.
    pub(super) fn write_word(&mut self, parameter: u32, after: u32) -> Result<(), ControllerError> {
        let before = self.flags.word(parameter).unwrap_or(0);
        let first = (parameter - FIRST_WORD) * u32::BITS;
        let mut changed = before ^ after;
        while changed != 0 {
            let index = changed.trailing_zeros();
            self.write_bit(i64::from(first + index), after >> index & 1 == 1)?;
            changed &= changed - 1;
        }
        Ok(())
    }

    /// The latch of the motion enable input is released once the input is closed.
    fn reset_motion_enable(&mut self, state: bool) {
        if state && !self.flags.get(law::MEI_OPEN.at(0)) {
            self.flags.set(law::MEI_LATCHED.at(0), false);
        }
    }

    /// A flag that asks for motion stops no program when there can be none.
    fn note_refusal(&mut self, number: u32, started: Result<(), ControllerError>) {
        if let Err(error) = started {
            self.notes.insert(format!("BIT{number} asked for motion in vain: {error}"));
        }
    }

    fn note_effect(&mut self, number: u32, state: bool) {
        if state {
            let title = bit(number).title;
            self.notes.insert(format!("{title} was set: the dry run does not simulate what it does"));
        }
    }
}

/// Inputs, outputs and the flags of users (guide, "User Flags"); the others may belong to something that acts on them.
const PLAIN_FLAGS: [std::ops::Range<i64>; 2] = [0..256, 1920..2048];

fn checked_bit(number: i64) -> Result<u32, ControllerError> {
    u32::try_from(number).ok().filter(|bit| Flags::contains(*bit)).ok_or(ControllerError::UnknownBit(number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_flags_do_nothing() {
        for number in PLAIN_FLAGS.into_iter().flatten() {
            let effect = map().flag(number as u32).effect;
            assert!(
                matches!(effect, Effect::None | Effect::Undocumented | Effect::ReadOnly),
                "BIT{number}: {effect:?}"
            );
        }
    }
}
