//! Reading and writing parameters and flags by number (guide, "System Parameters and Flags").

use acrc_catalog::{Access, Confidence, Known, Law, ValueType, bit, law, parameter};
use acrc_vm::Value;

use crate::error::ControllerError;
use crate::flags::{FIRST_WORD, Flags};
use crate::machine::{Machine, Request};
use crate::orders::Order;

impl Machine {
    /// State of a flag.
    pub(crate) fn read_bit(&self, number: i64) -> Result<bool, ControllerError> {
        Ok(self.flags.get(checked_bit(number)?))
    }

    /// Changes a flag, with what that does to the machine.
    pub(crate) fn write_bit(&mut self, number: i64, state: bool) -> Result<(), ControllerError> {
        let number = checked_bit(number)?;
        let info = bit(number);
        if info.access == Access::Read && proven(info.confidence) {
            return Err(ControllerError::ReadOnly { name: format!("BIT{number}"), title: info.title });
        }
        if self.write_master_flag(number, state) || self.write_program_flag(number, state) {
            return Ok(());
        }
        if let Some(axis) = law::DRIVE_ENABLE.index_of(number).filter(|axis| *axis < u32::from(self.model.axes)) {
            self.set_drive(axis as u8, state);
            return Ok(());
        }
        self.flags.set(number, state);
        if state && WITHOUT_EFFECT.iter().any(|law| law.index_of(number).is_some()) {
            self.notes.insert(format!("{} was set: the dry run does not simulate what it does", info.title));
        }
        Ok(())
    }

    /// The flags that command a master. Requests clear themselves: Stop All Moves when the master has stopped, the others at once.
    fn write_master_flag(&mut self, number: u32, state: bool) -> bool {
        for (law, order) in MASTER_FLAGS {
            let Some(index) = law.index_of(number) else { continue };
            if state {
                self.order(index as usize, order);
            } else if order == Order::Kill {
                self.flags.set(number, false);
            }
            return true;
        }
        false
    }

    /// The flags that command a program.
    fn write_program_flag(&mut self, number: u32, state: bool) -> bool {
        let program =
            |law: Law| law.index_of(number).map(|index| index as u8).filter(|index| *index < self.model.programs);
        let request = if let Some(program) = program(law::RUN_REQUEST) {
            state.then_some(Request::Run(program))
        } else if let Some(program) = program(law::HALT_REQUEST) {
            state.then_some(Request::Halt(program))
        } else if let Some(program) = program(law::PROGRAM_PAUSE) {
            Some(if state { Request::Pause(program) } else { Request::Resume(program) })
        } else {
            return false;
        };
        self.requests.extend(request);
        true
    }

    /// The value of a parameter.
    pub(crate) fn read_parameter(&self, number: i64) -> Result<Value, ControllerError> {
        let index = u32::try_from(number).map_err(|_| ControllerError::UnknownParameter(number))?;
        if index < FIRST_WORD {
            let value = self.memory.user(index as usize);
            return value.map(Value::Double).ok_or_else(|| self.outside_user(number));
        }
        if let Some(word) = self.flags.word(index) {
            return Ok(Value::Long(word as i32));
        }
        if let Some(value) = self.live_parameter(index) {
            return Ok(value);
        }
        let info = parameter(index);
        if info.known == Known::OutOfSpace {
            return Err(ControllerError::UnknownParameter(number));
        }
        let stored = self.registers.get(&index).cloned();
        Ok(stored.unwrap_or_else(|| zero(info.ty)))
    }

    /// Parameters that follow from the state of the machine.
    fn live_parameter(&self, number: u32) -> Option<Value> {
        if let Some(axis) = self.axis_of(number) {
            let state = &self.axes[usize::from(axis)];
            let is = |law: Law| law.index_of(number).is_some();
            return if POSITIONS.iter().any(|law| is(*law)) {
                Some(Value::Long(state.pulses(self.position(axis))))
            } else if is(law::TARGET_POSITION) {
                Some(Value::Long(state.pulses(self.target(axis))))
            } else if is(law::FOLLOWING_ERROR) {
                Some(Value::Long(0))
            } else if is(law::PPU) {
                Some(Value::Single(state.pulses_per_unit as f32))
            } else {
                None
            };
        }
        if let Some(axis) = self.encoder_of(number) {
            let actual = self.axes[usize::from(axis)].pulses(self.position(axis));
            return Some(Value::Long(actual.wrapping_add(self.encoder_offsets[usize::from(axis)])));
        }
        if number == law::CLOCK_MS.at(0) {
            return Some(Value::Long(self.clock_milliseconds()));
        }
        let master = self.masters.get(law::VECTOR_VELOCITY.index_of(number)? as usize)?;
        Some(Value::Single(master.profiler.vector_velocity() as f32))
    }

    /// The axis whose block holds a parameter.
    fn axis_of(&self, number: u32) -> Option<u8> {
        let first = law::CURRENT_POSITION.at(0);
        let axis = number.checked_sub(first)? / (law::CURRENT_POSITION.at(1) - first);
        u8::try_from(axis).ok().filter(|axis| *axis < self.model.axes)
    }

    /// The axis that is measured by the encoder whose position a parameter is.
    fn encoder_of(&self, number: u32) -> Option<u8> {
        let encoder = law::ENCODER_POSITION.index_of(number)?;
        u8::try_from(encoder).ok().filter(|axis| *axis < self.model.axes)
    }

    /// Stores a value in a parameter.
    pub(crate) fn write_parameter(&mut self, number: i64, value: &Value) -> Result<(), ControllerError> {
        let index = u32::try_from(number).map_err(|_| ControllerError::UnknownParameter(number))?;
        let (Ok(real), Ok(long)) = (value.to_f64(), value.to_long()) else {
            return Err(ControllerError::BadValue { command: "=", problem: format!("P{number} takes a number") });
        };
        if index < FIRST_WORD {
            let outside = self.outside_user(number);
            *self.memory.user_mut(index as usize).ok_or(outside)? = real;
            return Ok(());
        }
        let info = parameter(index);
        if info.access == Access::Read && proven(info.confidence) {
            return Err(ControllerError::ReadOnly { name: format!("P{number}"), title: info.title });
        }
        if let Some(word) = self.flags.word(index) {
            return self.write_word(index, word, long as u32);
        }
        if info.known == Known::OutOfSpace {
            return Err(ControllerError::UnknownParameter(number));
        }
        if !self.write_live_parameter(index, real, long)? {
            let stored = match info.ty {
                Some(ValueType::Single) => Value::Single(real as f32),
                Some(ValueType::Double) => Value::Double(real),
                _ => Value::Long(long),
            };
            self.registers.insert(index, stored);
        }
        Ok(())
    }

    /// Writes a parameter that changes the state of the machine. False when it is none.
    fn write_live_parameter(&mut self, number: u32, real: f64, long: i32) -> Result<bool, ControllerError> {
        if let Some(axis) = self.axis_of(number) {
            let is = |law: Law| law.index_of(number).is_some();
            if POSITIONS.iter().any(|law| is(*law)) || is(law::TARGET_POSITION) {
                let units = self.axes[usize::from(axis)].units(real);
                self.set_position(axis, units)?;
                return Ok(true);
            }
            if is(law::PPU) {
                self.set_pulses_per_unit(axis, real)?;
                return Ok(true);
            }
            return Ok(false);
        }
        if let Some(axis) = self.encoder_of(number) {
            self.set_encoder(axis, long);
            return Ok(true);
        }
        if number == law::CLOCK_MS.at(0) {
            self.clock_base = (self.clock.ticks(), long);
            return Ok(true);
        }
        Ok(false)
    }

    /// Gives an encoder's register another count without moving its axis.
    pub(crate) fn set_encoder(&mut self, axis: u8, count: i32) {
        let actual = self.axes[usize::from(axis)].pulses(self.position(axis));
        self.encoder_offsets[usize::from(axis)] = count.wrapping_sub(actual);
    }

    /// Writes a flag word bit by bit, so that each bit does what it does when it is set alone.
    fn write_word(&mut self, parameter: u32, before: u32, after: u32) -> Result<(), ControllerError> {
        let first = (parameter - FIRST_WORD) * 32;
        for index in (0..32).filter(|index| (before ^ after) >> index & 1 == 1) {
            self.write_bit(i64::from(first + index), after >> index & 1 == 1)?;
        }
        Ok(())
    }

    pub(crate) fn outside_user(&self, number: i64) -> ControllerError {
        ControllerError::UserParameter { number, count: self.memory.user_count() }
    }
}

/// Flags that command a master.
const MASTER_FLAGS: [(Law, Order); 4] = [
    (law::FEEDHOLD_REQUEST, Order::Feedhold),
    (law::CYCLE_START_REQUEST, Order::CycleStart),
    (law::KILL_ALL_MOVES, Order::Kill),
    (law::STOP_ALL_MOVES, Order::Stop),
];

/// Position registers of an axis, all equal on an ideal machine that neither jogs nor gears.
const POSITIONS: [Law; 4] =
    [law::CURRENT_POSITION, law::ACTUAL_POSITION, law::PRIMARY_SETPOINT, law::SECONDARY_SETPOINT];

/// Flags whose effect belongs to profilers, limits or networks that are not part of this dry run.
const WITHOUT_EFFECT: [Law; 12] = [
    law::KILL_ALL_MOTION_REQUEST,
    law::JOG_FORWARD,
    law::JOG_REVERSE,
    law::JOG_STOPPING,
    law::JOG_HOME_REQUEST,
    law::POS_LIMIT_ENABLE,
    law::NEG_LIMIT_ENABLE,
    law::POS_SOFT_LIMIT_ENABLE,
    law::NEG_SOFT_LIMIT_ENABLE,
    law::EXC_RESPONSE_ENABLE,
    law::CANOPEN_START_NETWORK,
    law::EPL_START_REQUEST,
];

/// Whether a row of the catalogue is certain enough to refuse a write.
fn proven(confidence: Confidence) -> bool {
    matches!(confidence, Confidence::High | Confidence::Medium)
}

fn checked_bit(number: i64) -> Result<u32, ControllerError> {
    u32::try_from(number).ok().filter(|bit| Flags::contains(*bit)).ok_or(ControllerError::UnknownBit(number))
}

fn zero(ty: Option<ValueType>) -> Value {
    match ty {
        Some(ValueType::Single) => Value::Single(0.0),
        Some(ValueType::Double) => Value::Double(0.0),
        _ => Value::Long(0),
    }
}
