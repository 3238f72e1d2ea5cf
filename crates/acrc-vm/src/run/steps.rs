//! The loop that executes instructions.
//!
//! It holds the files as slices, so it must not change their lengths: what does (`DIM`, `CLEAR`) and what is rare or
//! large anyway leaves it and is executed in [`super::slow`].

use acrc_catalog::OperandClass;

use super::arithmetic::{absolute, finite, long_operate, negate, quotient, random_bound, remainder, value_operate};
use super::{Exit, Meter};
use crate::code::Code;
use crate::fault::FaultKind;
use crate::frame::Frame;
use crate::functions::power;
use crate::host::Host;
use crate::locals::{Locals, round_to_single};
use crate::op::{Begins, Op, SCRATCH, Slot};
use crate::value::{Value, double_to_long};

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
    let (limit, used) = (locals.limit(), locals.used());
    let longs = locals.longs.as_mut_slice();
    let doubles = locals.doubles.as_mut_slice();
    let values = frame.values.as_mut_slice();
    let loops = frame.loops.as_mut_slice();
    let steps = &*code.steps;
    let mut pc = frame.pc as usize;
    let Meter { mut units, mut left, mut statements, extent } = *meter;

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
        macro_rules! value {
            ($slot:expr) => {
                match values.get(usize::from($slot)) {
                    Some(value) => value,
                    None => break Err(FaultKind::NumberExpected),
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
        macro_rules! set_value {
            ($slot:expr, $value:expr) => {{
                let value: Value = $value;
                if let Some(place) = values.get_mut(usize::from($slot)) {
                    *place = value;
                }
            }};
        }

        let Some(step) = steps.get(pc) else { break Ok(Exit::Ended) };
        if step.begins != Begins::Nothing {
            if step.begins == Begins::Line || left == 0 {
                if units == 0 || !host.line() {
                    break Ok(Exit::Budget);
                }
                units -= 1;
                left = extent;
            } else {
                left -= 1;
            }
            statements += 1;
            host.statement(pc as u32);
        }
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

            Op::ValueConst { to, index } => {
                if let (Some(place), Some(constant)) =
                    (values.get_mut(usize::from(to)), code.constants.get(index as usize))
                {
                    place.clone_from(constant);
                }
            }
            Op::ValueMove { to, from } => set_value!(to, value!(from).clone()),
            Op::ValueNegate { to, from } => set_value!(to, checked!(negate(value!(from)))),
            Op::ValueAbs { to, from } => set_value!(to, checked!(absolute(value!(from)))),
            Op::ValueOperate { operator, to, left, right } => {
                set_value!(to, checked!(value_operate(operator, value!(left), value!(right))));
            }
            Op::RealCompare { relation, to, left, index } => {
                let Some(real) = code.reals.get(index as usize) else { break Err(FaultKind::NumberExpected) };
                let state = match value!(left) {
                    Value::Single(value) => relation.holds(value, &real.single),
                    value => relation.holds(&checked!(value.to_f64()), &real.decimal),
                };
                set_long!(to, -i32::from(state));
            }
            Op::TextJoin { to, left, right } => {
                let joined = checked!(value!(left).as_text()).joined(checked!(value!(right).as_text()));
                set_value!(to, Value::Text(joined));
            }
            Op::TextCompare { relation, to, left, right } => {
                let state = relation.holds(checked!(value!(left).as_text()), checked!(value!(right).as_text()));
                set_long!(to, -i32::from(state));
            }

            Op::LongToDouble { to, from } => set_double!(to, f64::from(long!(from))),
            Op::DoubleToLong { to, from } => set_long!(to, double_to_long(double!(from))),
            Op::LongToValue { to, from } => set_value!(to, Value::Long(long!(from))),
            Op::DoubleToValue { to, from } => set_value!(to, Value::Double(double!(from))),
            Op::SingleToValue { to, from } => set_value!(to, Value::Single(double!(from) as f32)),
            Op::ValueToLong { to, from } => set_long!(to, checked!(value!(from).to_long())),
            Op::ValueToDouble { to, from } => set_double!(to, checked!(value!(from).to_f64())),
            Op::ValueTruth { to, from } => set_long!(to, -i32::from(checked!(value!(from).truth()))),

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
            Op::LoadText { to, index } => match locals.texts.items.get(index as usize) {
                Some(text) => set_value!(to, Value::Text(text.clone())),
                None => break Err(undimensioned(OperandClass::StringV, index, locals.texts.items.len())),
            },
            Op::StoreText { index, from } => {
                let text = checked!(value!(from).as_text()).clone().truncated(locals.texts.length);
                match locals.texts.items.get_mut(index as usize) {
                    Some(place) => *place = text,
                    None => break Err(undimensioned(OperandClass::StringV, index, locals.texts.items.len())),
                }
            }
            Op::LoadLongElement { to, array, element } => {
                let element = i64::from(long!(element));
                set_long!(to, *checked!(locals.long_arrays.get(i64::from(array), element)));
            }
            Op::StoreLongElement { array, element, from } => {
                let (element, value) = (i64::from(long!(element)), long!(from));
                *checked!(locals.long_arrays.get_mut(i64::from(array), element)).0 = value;
            }
            Op::LoadDoubleElement { to, array, element } => {
                let element = i64::from(long!(element));
                set_double!(to, *checked!(locals.double_arrays.get(i64::from(array), element)));
            }
            Op::StoreDoubleElement { array, element, from } => {
                let (element, value) = (i64::from(long!(element)), double!(from));
                *checked!(locals.double_arrays.get_mut(i64::from(array), element)).0 = value;
            }

            Op::LoadParameter { to, number } => set_value!(to, checked!(host.parameter(i64::from(number)))),
            Op::LoadParameterAt { to, number } => set_value!(to, checked!(host.parameter(i64::from(long!(number))))),
            Op::StoreParameter { number, from } => checked!(host.set_parameter(i64::from(number), value!(from))),
            Op::StoreParameterAt { number, from } => {
                checked!(host.set_parameter(i64::from(long!(number)), value!(from)));
            }
            Op::LoadBit { to, number } => set_long!(to, -i32::from(checked!(host.bit(i64::from(number))))),
            Op::LoadBitAt { to, number } => {
                set_long!(to, -i32::from(checked!(host.bit(i64::from(long!(number))))));
            }
            Op::StoreBit { number, from } => checked!(host.set_bit(i64::from(number), long!(from) != 0)),
            Op::StoreBitAt { number, from } => {
                checked!(host.set_bit(i64::from(long!(number)), long!(from) != 0));
            }
            Op::SetBit { number, state } => checked!(host.set_bit(i64::from(number), state)),

            Op::Jump { target } => {
                pc = target as usize;
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
            Op::JumpUnlessLongConst { relation, left, value, target } => {
                if !relation.holds(&long!(left), &value) {
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
                if checked!(host.bit(i64::from(number))) != state {
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
                if let Some(state) = loops.get_mut(usize::from(index)) {
                    checked!(state.begin(end, step, whole));
                }
            }
            Op::LoopTest { index, counter, target } => {
                if let Some(state) = loops.get_mut(usize::from(index))
                    && double!(counter) > state.end
                {
                    state.step = 0.0;
                    pc = target as usize;
                    continue;
                }
            }
            Op::LoopTestLong { index, counter, target } => {
                if let Some(state) = loops.get_mut(usize::from(index))
                    && i64::from(long!(counter)) > state.end_long
                {
                    state.step = 0.0;
                    pc = target as usize;
                    continue;
                }
            }
            Op::LoopStep { index, to, from } => match loops.get(usize::from(index)) {
                Some(state) if state.step != 0.0 => set_double!(to, double!(from) + state.step),
                _ => break Err(FaultKind::NextWithoutFor),
            },
            Op::LoopNext { index, counter, target } => {
                let next = match loops.get_mut(usize::from(index)) {
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
                let next = match loops.get_mut(usize::from(index)) {
                    Some(state) if state.step != 0.0 => {
                        let next = i64::from(long!(counter)) + state.step_long;
                        if next > state.end_long {
                            state.step = 0.0;
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

            Op::TextCall { .. }
            | Op::Device { .. }
            | Op::LoadVariable { .. }
            | Op::StoreVariable { .. }
            | Op::LoadElement { .. }
            | Op::StoreElement { .. }
            | Op::Dim { .. }
            | Op::Clear
            | Op::Call { .. } => break Ok(Exit::Slow),
        }
        pc += 1;
    };
    frame.pc = pc as u32;
    *meter = Meter { units, left, statements, extent };
    result
}

/// The fault of a variable that does not exist, by its slot.
#[cold]
fn missing(class: OperandClass, slot: Slot, length: usize) -> FaultKind {
    let count = length.saturating_sub(SCRATCH) as u32;
    FaultKind::Undimensioned { class, index: i64::from(slot) - SCRATCH as i64, count }
}

#[cold]
fn undimensioned(class: OperandClass, index: u32, count: usize) -> FaultKind {
    FaultKind::Undimensioned { class, index: i64::from(index), count: count as u32 }
}
