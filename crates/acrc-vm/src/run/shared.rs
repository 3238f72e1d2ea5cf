//! Instructions on what a program shares with the rest of the controller: parameters and flags by number.

use super::Meter;
use super::values::Files;
use crate::fault::FaultKind;
use crate::host::Host;
use crate::op::Op;

/// Executes an instruction on parameters and flags.
pub(super) fn execute<H: Host>(op: Op, host: &mut H, meter: &mut Meter, mut files: Files) -> Result<(), FaultKind> {
    host.reached(meter.used());
    match op {
        Op::LoadParameter { to, number } => return files.set_value(to, host.parameter(i64::from(number))?),
        Op::LoadParameterAt { to, number } => {
            let number = files.long(number)?;
            return files.set_value(to, host.parameter(i64::from(number))?);
        }
        Op::LoadBit { to, number } => return files.set_long(to, -i32::from(host.bit(i64::from(number))?)),
        Op::LoadBitAt { to, number } => {
            let number = files.long(number)?;
            return files.set_long(to, -i32::from(host.bit(i64::from(number))?));
        }
        Op::StoreParameter { number, from } => host.set_parameter(i64::from(number), files.value(from)?)?,
        Op::StoreParameterAt { number, from } => {
            host.set_parameter(i64::from(files.long(number)?), files.value(from)?)?;
        }
        Op::StoreBit { number, from } => host.set_bit(i64::from(number), files.long(from)? != 0)?,
        Op::StoreBitAt { number, from } => host.set_bit(i64::from(files.long(number)?), files.long(from)? != 0)?,
        Op::SetBit { number, state } => host.set_bit(i64::from(number), state)?,
        _ => {}
    }
    if host.interrupts() {
        meter.revoke();
    }
    Ok(())
}
