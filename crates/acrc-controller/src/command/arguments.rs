//! Reading the arguments of a call.

use acrc_catalog::ObjectKind;
use acrc_vm::{Arg, ArgValue, Call, Value};

use super::Context;
use crate::error::ControllerError;
use crate::machine::Machine;

/// One axis named in a call with the value given to it.
pub(super) struct AxisArgument<'a> {
    pub(super) axis: u8,
    pub(super) value: AxisValue<'a>,
}

/// The value given to an axis.
#[derive(Clone, Copy)]
pub(super) enum AxisValue<'a> {
    /// None: the command asks for a report.
    None,
    /// One value.
    One(&'a Value),
    /// A tuple.
    Many(&'a [Value]),
}

impl AxisValue<'_> {
    /// The values as numbers.
    pub(super) fn numbers(self, command: &'static str) -> Result<Vec<f64>, ControllerError> {
        let values = match self {
            Self::None => &[],
            Self::One(value) => std::slice::from_ref(value),
            Self::Many(values) => values,
        };
        values.iter().map(|value| real(command, value)).collect()
    }
}

/// A number that is finite.
pub(super) fn real(command: &'static str, value: &Value) -> Result<f64, ControllerError> {
    match value.to_f64() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(number) => Err(ControllerError::BadValue { command, problem: format!("{number} is no finite number") }),
        Err(_) => Err(ControllerError::Expected { command, expected: "a number" }),
    }
}

/// The only value of a call that sets a value: `VEL 5`. `None` when it asks for a report.
pub(super) fn scalar(call: &Call) -> Result<Option<f64>, ControllerError> {
    let command = call.command.info().name;
    match call.arguments {
        [] => Ok(None),
        [Arg::Value(value, _)] => real(command, value).map(Some),
        _ => Err(ControllerError::Expected { command, expected: "one number" }),
    }
}

impl Context<'_> {
    /// The axes of a call: those named as arguments, or the one of its prefix.
    pub(super) fn axes<'c>(&self, call: &Call<'c>) -> Result<Vec<AxisArgument<'c>>, ControllerError> {
        let command = call.command.info().name;
        if let Some((ObjectKind::Axis, Some(index))) = call.prefix {
            let axis = self.axis(i64::from(index))?;
            let value = match call.arguments {
                [] => AxisValue::None,
                [Arg::Value(value, _)] => AxisValue::One(value),
                [Arg::Tuple(values)] => AxisValue::Many(values),
                _ => return Err(ControllerError::Expected { command, expected: "one value behind AXISn" }),
            };
            return Ok(vec![AxisArgument { axis, value }]);
        }
        call.arguments.iter().map(|argument| self.axis_argument(command, argument, call)).collect()
    }

    pub(super) fn axis_argument<'c>(
        &self,
        command: &'static str,
        argument: &'c Arg,
        call: &Call,
    ) -> Result<AxisArgument<'c>, ControllerError> {
        let (axis, value) = self.axis_and_value(call, argument)?;
        let value = match value {
            ArgValue::None => AxisValue::None,
            ArgValue::Value(value) => AxisValue::One(value),
            ArgValue::Tuple(values) => AxisValue::Many(values),
            ArgValue::Source(_) | ArgValue::Table { .. } => {
                return Err(ControllerError::Expected { command, expected: "a number behind the axis" });
            }
        };
        Ok(AxisArgument { axis, value })
    }

    /// An axis that a call names, with what stands behind it.
    pub(super) fn axis_and_value<'c>(
        &self,
        call: &Call,
        argument: &'c Arg,
    ) -> Result<(u8, &'c ArgValue), ControllerError> {
        match argument {
            Arg::Axis { name, value, .. } => Ok((self.machine.named_axis(self.program(call)?, *name)?, value)),
            Arg::Object { kind: ObjectKind::Axis, index: Some(index), value, .. } => {
                Ok((self.axis(i64::from(*index))?, value))
            }
            _ => Err(ControllerError::Expected { command: call.command.info().name, expected: "axis names" }),
        }
    }

    /// The slots of a master that hold the axes of a call.
    pub(super) fn slots(&self, call: &Call, master: usize) -> Result<Vec<usize>, ControllerError> {
        self.axes(call)?.iter().map(|argument| self.slot(call, master, argument.axis)).collect()
    }

    /// The slot of a master that holds an axis.
    pub(super) fn slot(&self, call: &Call, master: usize, axis: u8) -> Result<usize, ControllerError> {
        let slave = self.machine.axes[usize::from(axis)].slave.filter(|slave| usize::from(slave.master) == master);
        let command = call.command.info().name;
        let slave =
            slave.ok_or(ControllerError::Expected { command, expected: "axes that are attached to a master" })?;
        Ok(usize::from(slave.slot))
    }

    /// An axis by number.
    pub(super) fn axis(&self, index: i64) -> Result<u8, ControllerError> {
        Machine::object("AXIS", index, self.machine.model.axes)
    }

    /// The master that a call means: of its prefix, or of the program.
    pub(super) fn master(&self, call: &Call) -> Result<usize, ControllerError> {
        match call.prefix {
            Some((ObjectKind::Master, Some(index))) => {
                Machine::object("MASTER", i64::from(index), self.machine.model.masters).map(usize::from)
            }
            _ => self.machine.master_of(self.program(call)?).map(usize::from),
        }
    }
}
