//! The loop that executes instructions.
//!
//! It holds the files as slices, so it must not change their lengths: what does (`DIM`, `CLEAR`) and what is rare or
//! large anyway leaves it and is executed in [`super::slow`].

use acrc_catalog::OperandClass;

use super::arithmetic::{finite, long_operate, quotient, random_bound, remainder};
use super::values::{self, Files};
use super::{Exit, Meter, shared};
use crate::code::Code;
use crate::fault::FaultKind;
use crate::frame::Frame;
use crate::functions::power;
use crate::host::Host;
use crate::locals::{Locals, round_to_single};
use crate::op::{Begins, Op, SCRATCH, Slot};
use crate::value::double_to_long;

/// Executes instructions until one of them needs the whole machine. The frame then points at that instruction; on a
/// fault, at the one at fault.
#[expect(
    clippy::too_many_lines,
    reason = "one arm an instruction; taking them apart would cost the dispatch that the loop is there to avoid"
)]
#[inline(never)]
pub(super) fn steps<H: Host>(
    code: &Code,
    frame: &mut Frame,
    locals: &mut Locals,
    host: &mut H,
    meter: &mut Meter,
) -> Result<Exit, FaultKind> {
    let (limit, used) = (locals.limit(), locals.used() + frame.reserved);
    let longs = locals.longs.as_mut_slice();
    let doubles = locals.doubles.as_mut_slice();
    let steps = &*code.steps;
    let mut pc = frame.pc as usize;
    let mut count = *meter;

    let result = loop {
        // Breaks the loop with a fault.
        macro_rules! checked {
            ($result:expr) => {
                match $result {
                    Ok(value) => value,
                    Err(kind) => break Err(kind),
                }
            };
        }
        macro_rules! long {
            ($slot:expr) => {
                match longs.get(usize::from($slot)) {
                    Some(value) => *value,
                    None => break Err(missing(OperandClass::Lv, $slot, longs.len())),
                }
            };
        }
        macro_rules! double {
            ($slot:expr) => {
                match doubles.get(usize::from($slot)) {
                    Some(value) => *value,
                    None => break Err(missing(OperandClass::Dv, $slot, doubles.len())),
                }
            };
        }
        macro_rules! set_long {
            ($slot:expr, $value:expr) => {{
                let value: i32 = $value;
                match longs.get_mut(usize::from($slot)) {
                    Some(place) => *place = value,
                    None => break Err(missing(OperandClass::Lv, $slot, longs.len())),
                }
            }};
        }
        macro_rules! set_double {
            ($slot:expr, $value:expr) => {{
                let value: f64 = $value;
                match doubles.get_mut(usize::from($slot)) {
                    Some(place) => *place = value,
                    None => break Err(missing(OperandClass::Dv, $slot, doubles.len())),
                }
            }};
        }
        // Accounts for what begins with the instruction at `pc`.
        macro_rules! begin {
            ($begins:expr) => {
                if $begins != Begins::Nothing {
                    if !count.begin($begins == Begins::Line) {
                        break Ok(Exit::Budget);
                    }
                    host.statement(pc as u32);
                }
            };
        }
        let Some(step) = steps.get(pc) else { break Ok(Exit::Ended) };
        begin!(step.begins);
        match step.op {
            Op::Nothing => {}

            Op::LongConst { to, value } => set_long!(to, value),
            Op::LongMove { to, from } => set_long!(to, long!(from)),
            Op::LongNegate { to, from } => set_long!(to, long!(from).wrapping_neg()),
            Op::LongNot { to, from } => set_long!(to, !long!(from)),
            Op::LongAbs { to, from } => set_long!(to, long!(from).wrapping_abs()),
            Op::LongAdd { to, left, right } => set_long!(to, long!(left).wrapping_add(long!(right))),
            Op::LongSub { to, left, right } => set_long!(to, long!(left).wrapping_sub(long!(right))),
            Op::LongMul { to, left, right } => set_long!(to, long!(left).wrapping_mul(long!(right))),
            Op::LongAddConst { to, left, value } => set_long!(to, long!(left).wrapping_add(value)),
            Op::LongMulConst { to, left, value } => set_long!(to, long!(left).wrapping_mul(value)),
            Op::LongRemConst { to, left, value } => set_long!(to, checked!(remainder(long!(left), value))),
            Op::LongOperate { operator, to, left, right } => {
                set_long!(to, checked!(long_operate(operator, long!(left), long!(right))));
            }
            Op::LongCompare { relation, to, left, right } => {
                set_long!(to, -i32::from(relation.holds(&long!(left), &long!(right))));
            }

            Op::DoubleConst { to, value } => set_double!(to, value),
            Op::DoubleMove { to, from } => set_double!(to, double!(from)),
            Op::DoubleNegate { to, from } => set_double!(to, -double!(from)),
            Op::DoubleAbs { to, from } => set_double!(to, double!(from).abs()),
            Op::DoubleAdd { to, left, right } => set_double!(to, checked!(finite(double!(left) + double!(right), "+"))),
            Op::DoubleSub { to, left, right } => set_double!(to, checked!(finite(double!(left) - double!(right), "-"))),
            Op::DoubleMul { to, left, right } => set_double!(to, checked!(finite(double!(left) * double!(right), "*"))),
            Op::DoubleDiv { to, left, right } => set_double!(to, checked!(quotient(double!(left), double!(right)))),
            Op::DoubleAddConst { to, left, value } => set_double!(to, checked!(finite(double!(left) + value, "+"))),
            Op::DoubleMulConst { to, left, value } => set_double!(to, checked!(finite(double!(left) * value, "*"))),
            Op::DoubleDivConst { to, left, value } => set_double!(to, checked!(quotient(double!(left), value))),
            Op::DoublePower { to, left, right } => set_double!(to, checked!(power(double!(left), double!(right)))),
            Op::DoubleMath { function, to, from } => {
                set_double!(to, checked!(function.evaluate(double!(from), code.angle)));
            }
            Op::DoubleCompare { relation, to, left, right } => {
                set_long!(to, -i32::from(relation.holds(&double!(left), &double!(right))));
            }
            Op::DoubleRound { to, from } => set_double!(to, f64::from(checked!(round_to_single(double!(from))))),
            Op::Random { to, below } => {
                let below = checked!(random_bound(double!(below)));
                set_double!(to, f64::from(host.random(below)));
            }

            Op::LongToDouble { to, from } => set_double!(to, f64::from(long!(from))),
            Op::DoubleToLong { to, from } => set_long!(to, double_to_long(double!(from))),
            Op::LoadSingle { to, index } => match locals.singles.get(index as usize) {
                Some(value) => set_double!(to, f64::from(*value)),
                None => break Err(undimensioned(OperandClass::Sv, index, locals.singles.len())),
            },
            Op::StoreSingle { index, from } => {
                let value = checked!(round_to_single(double!(from)));
                match locals.singles.get_mut(index as usize) {
                    Some(place) => *place = value,
                    None => break Err(undimensioned(OperandClass::Sv, index, locals.singles.len())),
                }
            }
            Op::LoadLongElement { to, array, element } => {
                set_long!(to, *checked!(locals.long_arrays.element(array, long!(element))));
            }
            Op::StoreLongElement { array, element, from } => {
                *checked!(locals.long_arrays.element(array, long!(element))) = long!(from);
            }
            Op::LoadDoubleElement { to, array, element } => {
                set_double!(to, *checked!(locals.double_arrays.element(array, long!(element))));
            }
            Op::StoreDoubleElement { array, element, from } => {
                *checked!(locals.double_arrays.element(array, long!(element))) = double!(from);
            }

            Op::LoadUser { to, number } => set_double!(to, checked!(host.user(number))),
            Op::StoreUser { number, from } => checked!(host.set_user(number, double!(from))),
            Op::LoadBit { to, number } => set_long!(to, -i32::from(checked!(shared::bit(host, count.used(), number)))),

            Op::Jump { target } => {
                pc = target as usize;
                continue;
            }
            Op::Again { target } => {
                pc = target as usize;
                // The usual condition of a loop is decided here, which spares a dispatch in each pass.
                if let Some(step) = steps.get(pc)
                    && let Op::JumpUnlessLongConst { range, inside, left, target } = step.op
                {
                    begin!(step.begins);
                    pc = if range.contains(long!(left)) == inside { pc + 1 } else { target as usize };
                }
                continue;
            }
            Op::JumpUnless { from, target } => {
                if long!(from) == 0 {
                    pc = target as usize;
                    continue;
                }
            }
            Op::JumpUnlessLong { relation, left, right, target } => {
                if !relation.holds(&long!(left), &long!(right)) {
                    pc = target as usize;
                    continue;
                }
            }
            Op::JumpUnlessLongConst { range, inside, left, target } => {
                if range.contains(long!(left)) != inside {
                    pc = target as usize;
                    continue;
                }
            }
            Op::JumpUnlessRem { relation, left, divisor, value, target } => {
                if !relation.holds(&checked!(remainder(long!(left), divisor)), &value) {
                    pc = target as usize;
                    continue;
                }
            }
            Op::JumpUnlessDouble { relation, left, right, target } => {
                if !relation.holds(&double!(left), &double!(right)) {
                    pc = target as usize;
                    continue;
                }
            }
            Op::JumpUnlessBit { number, state, target } => {
                if checked!(shared::bit(host, count.used(), number)) != state {
                    pc = target as usize;
                    continue;
                }
            }
            Op::Gosub { target } => {
                let depth = frame.calls.len() + 1;
                if used + acrc_catalog::memory::CALLS.bytes(depth as u64, 0) > limit {
                    break Err(FaultKind::GosubTooDeep { depth });
                }
                frame.calls.push(pc as u32 + 1);
                pc = target as usize;
                continue;
            }
            Op::Return => match frame.calls.pop() {
                Some(behind) => {
                    pc = behind as usize;
                    continue;
                }
                None => break Err(FaultKind::ReturnWithoutGosub),
            },
            Op::LoopBegin { index, end, step, whole } => {
                let (end, step) = (double!(end), double!(step));
                if let Some(state) = frame.loops.get_mut(usize::from(index)) {
                    checked!(state.begin(end, step, whole));
                }
            }
            Op::LoopTest { index, counter, target } => {
                if let Some(state) = frame.loops.get_mut(usize::from(index))
                    && double!(counter) > state.end
                {
                    state.step = 0.0;
                    pc = target as usize;
                    continue;
                }
            }
            Op::LoopTestLong { index, counter, target } => {
                if let Some(state) = frame.loops.get_mut(usize::from(index))
                    && i64::from(long!(counter)) > state.end_long
                {
                    state.step_long = 0;
                    pc = target as usize;
                    continue;
                }
            }
            Op::LoopStep { index, to, from } => match frame.loops.get(usize::from(index)) {
                Some(state) if state.step != 0.0 => set_double!(to, double!(from) + state.step),
                _ => break Err(FaultKind::NextWithoutFor),
            },
            Op::LoopNext { index, counter, target } => {
                let next = match frame.loops.get_mut(usize::from(index)) {
                    Some(state) if state.step != 0.0 => {
                        let next = double!(counter) + state.step;
                        if next > state.end {
                            state.step = 0.0;
                        } else {
                            pc = target as usize;
                            set_double!(counter, next);
                            continue;
                        }
                        next
                    }
                    _ => break Err(FaultKind::NextWithoutFor),
                };
                set_double!(counter, next);
            }
            Op::LoopNextLong { index, counter, target } => {
                let next = match frame.loops.get_mut(usize::from(index)) {
                    Some(state) if state.step_long != 0 => {
                        let next = i64::from(long!(counter)) + state.step_long;
                        if next > state.end_long {
                            state.step_long = 0;
                        } else {
                            pc = target as usize;
                            set_long!(counter, next as i32);
                            continue;
                        }
                        next
                    }
                    _ => break Err(FaultKind::NextWithoutFor),
                };
                set_long!(counter, next as i32);
            }
            Op::End => break Ok(Exit::Ended),
            Op::Raise { index } => {
                let fault = code.faults.get(index as usize).cloned();
                break Err(fault.unwrap_or(FaultKind::NumberExpected));
            }

            Op::LoadParameter { .. }
            | Op::LoadParameterAt { .. }
            | Op::StoreParameter { .. }
            | Op::StoreParameterAt { .. }
            | Op::LoadBitAt { .. }
            | Op::StoreBit { .. }
            | Op::StoreBitAt { .. }
            | Op::SetBit { .. } => {
                let files = Files { longs, doubles, values: &mut frame.values };
                // A copy, so that the count itself may stay in registers.
                let mut meter = count;
                let done = shared::execute(step.op, host, &mut meter, files);
                count = meter;
                checked!(done);
            }
            Op::ValueConst { .. }
            | Op::ValueMove { .. }
            | Op::ValueNegate { .. }
            | Op::ValueAbs { .. }
            | Op::ValueOperate { .. }
            | Op::RealCompare { .. }
            | Op::TextJoin { .. }
            | Op::TextCompare { .. }
            | Op::LongToValue { .. }
            | Op::DoubleToValue { .. }
            | Op::SingleToValue { .. }
            | Op::ValueToLong { .. }
            | Op::ValueToDouble { .. }
            | Op::ValueTruth { .. }
            | Op::LoadText { .. }
            | Op::StoreText { .. } => {
                let files = Files { longs, doubles, values: &mut frame.values };
                checked!(values::execute(step.op, code, files, &mut locals.texts));
            }
            Op::TextCall { .. }
            | Op::Device { .. }
            | Op::LoadVariable { .. }
            | Op::StoreVariable { .. }
            | Op::LoadElement { .. }
            | Op::StoreElement { .. }
            | Op::Dim { .. }
            | Op::Clear
            | Op::ClearMoves
            | Op::Call { .. } => break Ok(Exit::Slow),
        }
        pc += 1;
    };
    frame.pc = pc as u32;
    *meter = count;
    result
}

/// The fault of a variable that does not exist, by its slot.
#[cold]
pub(super) fn missing(class: OperandClass, slot: Slot, length: usize) -> FaultKind {
    let count = length.saturating_sub(SCRATCH) as u32;
    FaultKind::Undimensioned { class, index: i64::from(slot) - SCRATCH as i64, count }
}

#[cold]
pub(super) fn undimensioned(class: OperandClass, index: u32, count: usize) -> FaultKind {
    FaultKind::Undimensioned { class, index: i64::from(index), count: count as u32 }
}
