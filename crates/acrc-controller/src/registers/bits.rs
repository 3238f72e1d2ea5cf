//! Reading and writing flags by number, with what that does to the machine (guide, "Parameters and Bits", "Kill All Motion Request vs. Kill All Moves").

use acrc_catalog::{bit, law};

use super::map::{Effect, map};
use crate::error::ControllerError;
use crate::flags::{FIRST_WORD, Flags};
use crate::machine::Machine;
use crate::orders::Order;
use crate::request::Request;

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
            Effect::None => self.flags.set(number, state),
            Effect::ReadOnly => {
                return Err(ControllerError::ReadOnly { name: format!("BIT{number}"), title: bit(number).title });
            }
            Effect::Undocumented => {
                self.flags.set(number, state);
                self.note_undocumented(format_args!("BIT{number}"));
            }
            Effect::NotSimulated => {
                self.flags.set(number, state);
                self.note_effect(number, state);
            }
            // Requests clear themselves; so does Stop All Moves, when the master has stopped.
            Effect::Request => self.note_effect(number, state),
            Effect::Master(Order::Kill) if !state => self.flags.set(number, false),
            Effect::Master(order) if state => self.order(index, order),
            Effect::RunProgram if state => self.requests.push(Request::Run(object)),
            Effect::HaltProgram if state => self.requests.push(Request::Halt(object)),
            Effect::PauseProgram if state => self.requests.push(Request::Pause(object)),
            Effect::PauseProgram => self.requests.push(Request::Resume(object)),
            Effect::Master(_) | Effect::RunProgram | Effect::HaltProgram => {}
            Effect::EnableDrive => self.set_drive(object, state),
            Effect::KillMotion if state => self.kill_motion(object),
            Effect::KillMotion => self.flags.set(number, false),
            Effect::ResetMotionEnable => self.reset_motion_enable(state),
        }
        Ok(())
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

    /// Kill All Motion Request: every axis of the master gets it, and the master Kill All Moves. The flags stay until they are cleared.
    fn kill_motion(&mut self, axis: u8) {
        let slave = self.axes.get(usize::from(axis)).and_then(|axis| axis.slave);
        self.flags.set_law(law::KILL_ALL_MOTION_REQUEST, u32::from(axis), true);
        let Some(slave) = slave else { return };
        let master = usize::from(slave.master);
        let axes: Vec<u8> = self.masters[master].attached().map(|(_, axis)| axis).collect();
        for axis in axes {
            self.flags.set_law(law::KILL_ALL_MOTION_REQUEST, u32::from(axis), true);
        }
        if self.moves(master) {
            self.notes
                .insert("an axis was killed in motion: the dry run stops it without the ramp of HLDEC".to_owned());
        }
        self.order(master, Order::Kill);
    }

    /// The latch of the motion enable input is released once the input is closed.
    fn reset_motion_enable(&mut self, state: bool) {
        if state && !self.flags.get(law::MEI_OPEN.at(0)) {
            self.flags.set(law::MEI_LATCHED.at(0), false);
        }
    }

    fn note_effect(&mut self, number: u32, state: bool) {
        if state {
            let title = bit(number).title;
            self.notes.insert(format!("{title} was set: the dry run does not simulate what it does"));
        }
    }
}

fn checked_bit(number: i64) -> Result<u32, ControllerError> {
    u32::try_from(number).ok().filter(|bit| Flags::contains(*bit)).ok_or(ControllerError::UnknownBit(number))
}
