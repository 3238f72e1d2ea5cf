//! Commands: their arguments are evaluated once, then offered to the host until it is done with them.

use acrc_catalog::OperandClass;

use super::{Stop, input};
use crate::code::Code;
use crate::fault::FaultKind;
use crate::frame::Frame;
use crate::host::{Call, Host, Outcome};
use crate::locals::Locals;
use crate::op::{SCRATCH, Slot};
use crate::plan::{Arguments, Index, Operand, Slots};
use crate::value::Value;

/// Offers the command of the present instruction to the host.
pub(super) fn call<H: Host>(
    code: &Code,
    frame: &mut Frame,
    locals: &mut Locals,
    host: &mut H,
    index: u32,
) -> Result<Option<Stop>, FaultKind> {
    let Some(plan) = code.plans.get(index as usize) else { return Ok(Some(Stop::Ended)) };
    let first = !frame.held;
    let arguments = match &plan.arguments {
        Arguments::Constant(arguments) => &**arguments,
        Arguments::Computed(parts) => {
            if first {
                frame.arguments.clear();
                let slots = Files { locals, values: &frame.values };
                for part in parts {
                    frame.arguments.push(part.build(&slots)?);
                }
            }
            frame.arguments.as_slice()
        }
    };
    let call = Call { command: plan.command, prefix: plan.prefix, arguments, first };
    let outcome = host.command(&call)?;
    frame.held = outcome == Outcome::Again;
    let stop = match outcome {
        Outcome::Again => return Ok(Some(Stop::Blocked)),
        Outcome::Done => None,
        Outcome::End => Some(Stop::Ended),
        Outcome::Input(line) => {
            input::store(&line, arguments, locals, host)?;
            None
        }
    };
    frame.pc += 1;
    Ok(stop)
}

/// The files that arguments are read from.
pub(super) struct Files<'a> {
    pub(super) locals: &'a Locals,
    pub(super) values: &'a [Value],
}

impl Files<'_> {
    /// A long: a variable may be missing, a scratch slot is always there.
    pub(super) fn long(&self, slot: Slot) -> Result<i32, FaultKind> {
        let value = self.locals.longs.get(usize::from(slot)).copied();
        value.ok_or_else(|| self.missing(OperandClass::Lv, slot))
    }

    fn double(&self, slot: Slot) -> Result<f64, FaultKind> {
        let value = self.locals.doubles.get(usize::from(slot)).copied();
        value.ok_or_else(|| self.missing(OperandClass::Dv, slot))
    }

    fn missing(&self, class: OperandClass, slot: Slot) -> FaultKind {
        self.locals.undimensioned(class, i64::from(slot) - SCRATCH as i64)
    }
}

impl Slots for Files<'_> {
    fn operand(&self, operand: &Operand) -> Result<Value, FaultKind> {
        Ok(match operand {
            Operand::Const(value) => value.clone(),
            Operand::Long(slot) => Value::Long(self.long(*slot)?),
            Operand::Double(slot) => Value::Double(self.double(*slot)?),
            Operand::Single(slot) => Value::Single(self.double(*slot)? as f32),
            Operand::Value(slot) => self.values.get(usize::from(*slot)).cloned().unwrap_or_default(),
        })
    }

    fn index(&self, index: Index) -> Result<i64, FaultKind> {
        match index {
            Index::Const(number) => Ok(i64::from(number)),
            Index::Slot(slot) => self.long(slot).map(i64::from),
        }
    }
}
