//! Instructions that need the whole machine: calls of the host, memory, strings, variables by computed numbers,
//! functions. In the loop of the numbers each of them would take registers from all others.

use super::arithmetic::random_bound;
use super::calls::{self, Files};
use super::{Meter, Stop, shared, values};
use crate::code::Code;
use crate::fault::FaultKind;
use crate::frame::Frame;
use crate::functions::power;
use crate::host::Host;
use crate::locals::{DimBlock, Locals, Sizes};
use crate::op::{DeviceQuery, Op, Slot};
use crate::text::Text;
use crate::value::Value;

/// Executes the instruction that the frame points at, and moves on. Gives a reason if the run stops here.
pub(super) fn slow<H: Host>(
    code: &Code,
    frame: &mut Frame,
    locals: &mut Locals,
    host: &mut H,
    meter: &mut Meter,
) -> Result<Option<Stop>, FaultKind> {
    let Some(op) = code.ops.get(frame.pc as usize).copied() else { return Ok(Some(Stop::Ended)) };
    match op {
        Op::Call { index } => {
            host.reached(meter.used());
            let stop = calls::call(code, frame, locals, host, index);
            if host.interrupts() {
                meter.revoke();
            }
            return stop;
        }
        Op::JumpUnlessBit { number, state, target } => {
            host.reached(meter.used());
            if host.bit(i64::from(number))? != state {
                frame.pc = target;
                return Ok(None);
            }
        }
        Op::Device { query, to, device } => {
            let device = long(locals, device)?;
            host.reached(meter.used());
            match ask(host, query, device)? {
                Some(value) => set(frame, to, value),
                None => {
                    // The whole statement is evaluated again when a character may have come: the scratch slots may serve an immediate
                    // statement in between. A character that an earlier GETCH of the same statement took is lost.
                    frame.pc = code.statement_start(frame.pc);
                    meter.take_back();
                    return Ok(Some(Stop::Blocked));
                }
            }
        }
        Op::TextCall { function, to, from, count } => {
            let start = usize::from(from);
            let arguments = frame.values.get(start..start + usize::from(count)).unwrap_or_default();
            let value = function.evaluate(arguments)?;
            set(frame, to, value);
        }
        Op::LoadVariable { .. } | Op::StoreVariable { .. } | Op::LoadElement { .. } | Op::StoreElement { .. } => {
            variable(op, frame, locals)?;
        }
        Op::Dim { block, array, count, length } => {
            let sizes =
                Sizes { array: long(locals, array)?, count: long(locals, count)?, length: long(locals, length)? };
            locals.dimension(block, sizes, frame.memory())?;
            if block == DimBlock::Moves {
                host.move_buffer(locals.moves());
            }
        }
        Op::Clear => {
            locals.clear();
            host.move_buffer(0);
        }
        Op::ClearMoves => {
            locals.clear_moves();
            host.move_buffer(0);
        }
        _ => on_files(code, frame, locals, host, meter, op)?,
    }
    frame.pc += 1;
    Ok(None)
}

/// What only works on the files, or between them and the host.
fn on_files<H: Host>(
    code: &Code,
    frame: &mut Frame,
    locals: &mut Locals,
    host: &mut H,
    meter: &mut Meter,
    op: Op,
) -> Result<(), FaultKind> {
    let Locals { longs, doubles, texts, .. } = locals;
    let mut files = values::Files { longs, doubles, values: &mut frame.values };
    match op {
        Op::DoublePower { to, left, right } => {
            let result = power(files.double(left)?, files.double(right)?)?;
            files.set_double(to, result)
        }
        Op::DoubleMath { function, to, from } => {
            let result = function.evaluate(files.double(from)?, code.angle)?;
            files.set_double(to, result)
        }
        Op::Random { to, below } => {
            let below = random_bound(files.double(below)?)?;
            files.set_double(to, f64::from(host.random(below)))
        }
        Op::LoadParameter { .. }
        | Op::LoadParameterAt { .. }
        | Op::StoreParameter { .. }
        | Op::StoreParameterAt { .. }
        | Op::LoadBit { .. }
        | Op::LoadBitAt { .. }
        | Op::StoreBit { .. }
        | Op::StoreBitAt { .. }
        | Op::SetBit { .. } => shared::execute(op, host, meter, files),
        _ => values::execute(op, code, files, texts),
    }
}

/// A variable or element through the file of values.
fn variable(op: Op, frame: &mut Frame, locals: &mut Locals) -> Result<(), FaultKind> {
    match op {
        Op::LoadVariable { class, to, index } => {
            let value = locals.read_variable(class, i64::from(long(locals, index)?))?;
            set(frame, to, value);
        }
        Op::StoreVariable { class, index, from } => {
            let index = i64::from(long(locals, index)?);
            locals.write_variable(class, index, value(frame, from)?)?;
        }
        Op::LoadElement { class, to, array, element } => {
            let (array, element) = (i64::from(long(locals, array)?), i64::from(long(locals, element)?));
            let value = locals.read_element(class, array, element)?;
            set(frame, to, value);
        }
        Op::StoreElement { class, array, element, from } => {
            let (array, element) = (i64::from(long(locals, array)?), i64::from(long(locals, element)?));
            locals.write_element(class, array, element, value(frame, from)?)?;
        }
        _ => {}
    }
    Ok(())
}

/// Asks a device. `None` when there is nothing yet to wait for.
fn ask<H: Host>(host: &mut H, query: DeviceQuery, device: i32) -> Result<Option<Value>, FaultKind> {
    Ok(match query {
        DeviceQuery::Waits => Some(Value::truth_value(host.character_waits(device)?)),
        DeviceQuery::AwaitCharacter => host.take_character(device)?.map(|character| Value::Long(i32::from(character))),
        DeviceQuery::TakeCharacter => {
            let character = host.take_character(device)?;
            Some(Value::Text(Text::from(character.as_slice())))
        }
    })
}

fn long(locals: &Locals, slot: Slot) -> Result<i32, FaultKind> {
    Files { locals, values: &[] }.long(slot)
}

fn value(frame: &Frame, slot: Slot) -> Result<&Value, FaultKind> {
    frame.values.get(usize::from(slot)).ok_or(FaultKind::NumberExpected)
}

fn set(frame: &mut Frame, slot: Slot, value: Value) {
    if let Some(place) = frame.values.get_mut(usize::from(slot)) {
        *place = value;
    }
}
