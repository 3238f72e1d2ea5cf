//! Parameters and flags by number (guide, "Binary Data Packets", "Binary Parameter Access", "Binary Parameter Mask Command", "Binary
//! SET and CLR").

use acrc_vm::Value;

use super::{HostError, number};
use crate::controller::{Controller, Observer};
use crate::error::ControllerError;

impl Controller {
    /// The value of a parameter as a long integer; `None` where there is no such parameter, or no memory for it yet.
    ///
    /// A number with a fraction loses it; from 2^31 to 2^32 the bit pattern is kept; what is further out is the nearest long.
    pub fn parameter_long(&self, parameter: u32) -> Option<i32> {
        number::long(&self.parameter_value(parameter)?)
    }

    /// The value of a parameter as an IEEE single; `None` where there is no such parameter, or no memory for it yet.
    ///
    /// What a single cannot hold exactly is rounded to the nearest, and never infinite.
    pub fn parameter_single(&self, parameter: u32) -> Option<f32> {
        number::single(&self.parameter_value(parameter)?)
    }

    /// The value of a parameter in its own form, as data packets and fast status have it: the bits of a long integer, or of an
    /// IEEE single. `None` where there is no such parameter, or no memory for it yet.
    pub fn parameter_field(&self, parameter: u32) -> Option<u32> {
        number::bits(&self.parameter_value(parameter)?)
    }

    fn parameter_value(&self, parameter: u32) -> Option<Value> {
        self.machine.read_parameter(i64::from(parameter)).ok()
    }

    /// Gives a parameter the value of a long integer, as an assignment of a program does.
    ///
    /// # Errors
    /// When there is no such parameter, or programs may not write it.
    pub fn set_parameter_long(
        &mut self,
        parameter: u32,
        value: i32,
        observer: &mut dyn Observer,
    ) -> Result<(), HostError> {
        self.set_parameter_value(parameter, &Value::Long(value), observer)
    }

    /// Gives a parameter the value of an IEEE single, as an assignment of a program does.
    ///
    /// # Errors
    /// When there is no such parameter, programs may not write it, or the value is infinite or no number.
    pub fn set_parameter_single(
        &mut self,
        parameter: u32,
        value: f32,
        observer: &mut dyn Observer,
    ) -> Result<(), HostError> {
        self.set_parameter_value(parameter, &Value::Single(number::finite(value)?), observer)
    }

    /// Clears the bits of `clear` in a parameter, then sets those of `set`.
    ///
    /// # Errors
    /// When there is no such parameter, programs may not write it, or it is no long integer.
    pub fn mask_parameter(
        &mut self,
        parameter: u32,
        clear: u32,
        set: u32,
        observer: &mut dyn Observer,
    ) -> Result<(), HostError> {
        let before = match self.machine.read_parameter(i64::from(parameter))? {
            Value::Long(before) => before.cast_unsigned(),
            _ => return Err(HostError::NotLong(parameter)),
        };
        let after = before & !clear | set;
        self.set_parameter_value(parameter, &Value::Long(after.cast_signed()), observer)
    }

    pub(super) fn set_parameter_value(
        &mut self,
        parameter: u32,
        value: &Value,
        observer: &mut dyn Observer,
    ) -> Result<(), HostError> {
        let written = self.machine.write_parameter(i64::from(parameter), value);
        // Of a word of flags some may be changed before one is refused.
        self.conclude_order(observer);
        Ok(written?)
    }

    /// Sets or clears a flag, with everything that `SET` and `CLR` of it do.
    ///
    /// # Errors
    /// When there is no such flag, or it can only be read.
    pub fn set_flag(&mut self, flag: u32, state: bool, observer: &mut dyn Observer) -> Result<(), HostError> {
        let written: Result<(), ControllerError> = self.machine.write_bit(i64::from(flag), state);
        self.conclude_order(observer);
        Ok(written?)
    }
}
