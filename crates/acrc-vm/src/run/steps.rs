//! The loop that executes instructions.
//!
//! It holds the files as slices, so it must not change their lengths: what does (`DIM`, `CLEAR`) and what is rare or
//! large anyway leaves it and is executed in [`super::slow`]. Statements are only counted where the budget may not
//! suffice up to the next jump ([`crate::account`]).

use acrc_catalog::OperandClass;

use super::arithmetic::{finite, long_operate, quotient, remainder};
use super::{Exit, Meter};
use crate::account::{Begins, Route};
use crate::code::Code;
use crate::fault::FaultKind;
use crate::frame::Frame;
use crate::host::Host;
use crate::locals::{Locals, round_to_single};
use crate::op::{Op, SCRATCH, Slot};
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
    let ops = &*code.ops;
    // The instructions that may be executed without counting, and the place where they end.
    let mut ahead = [].iter();
    let mut end = frame.pc as usize;
    let mut balance = OVERDRAWN;

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
        macro_rules! element {
            ($arrays:ident, $array:expr, $element:expr) => {{
                let element = long!($element);
                match locals.$arrays.element($array, element) {
                    Some(place) => place,
                    None => break Err(locals.$arrays.missing($array, element)),
                }
            }};
        }
        // The place of the instruction that is executed.
        macro_rules! pc {
            () => {
                end - ahead.len() - 1
            };
        }
        // Goes on elsewhere.
        macro_rules! jump {
            ($target:expr, $route:expr) => {{
                let target = $target as usize;
                let route: Route = $route;
                let after = balance + route.distance;
                if after >= route.least {
                    balance = after;
                    let Some(there) = ops.get(target..) else { break Ok(Exit::Ended) };
                    ahead = there.iter();
                } else {
                    // From here on statements are counted.
                    if balance != OVERDRAWN {
                        settle(code, pc!(), balance, meter);
                        balance = OVERDRAWN;
                    }
                    ahead = [].iter();
                    end = target;
                }
            }};
        }
        macro_rules! go {
            ($target:expr) => {
                match code.routes.get(pc!()) {
                    Some(route) => {
                        jump!($target, *route);
                    }
                    None => break Ok(Exit::Ended),
                }
            };
        }
        let op = match ahead.next() {
            Some(op) => op,
            None => {
                let pc = end;
                end += 1;
                let Some(op) = ops.get(pc) else { break Ok(Exit::Ended) };
                match begin(code, pc, host, meter) {
                    Ok(None) => {}
                    Ok(Some(left)) => {
                        balance = left;
                        ahead = ops.get(end..).unwrap_or_default().iter();
                        end = ops.len();
                    }
                    Err(exit) => break Ok(exit),
                }
                op
            }
        };
        match *op {
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
            Op::DoubleCompare { relation, to, left, right } => {
                set_long!(to, -i32::from(relation.holds(&double!(left), &double!(right))));
            }
            Op::DoubleRound { to, from } => set_double!(to, f64::from(checked!(round_to_single(double!(from))))),
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
                set_long!(to, *element!(long_arrays, array, element));
            }
            Op::StoreLongElement { array, element, from } => {
                let value = long!(from);
                *element!(long_arrays, array, element) = value;
            }
            Op::LoadDoubleElement { to, array, element } => {
                set_double!(to, *element!(double_arrays, array, element));
            }
            Op::StoreDoubleElement { array, element, from } => {
                let value = double!(from);
                *element!(double_arrays, array, element) = value;
            }
            Op::AddLongElement { array, element, right } => {
                let place = element!(long_arrays, array, element);
                *place = place.wrapping_add(long!(right));
            }
            Op::AddDoubleElement { array, element, right } => {
                let place = element!(double_arrays, array, element);
                *place = checked!(finite(*place + double!(right), "+"));
            }

            Op::LoadUser { to, number } => set_double!(to, checked!(host.user(number))),
            Op::StoreUser { number, from } => checked!(host.set_user(number, double!(from))),

            Op::AddUserConst { number, value } => {
                let sum = checked!(finite(checked!(host.user(number)) + value, "+"));
                checked!(host.set_user(number, sum));
            }

            Op::Jump { target } => go!(target),
            Op::Again { target } => {
                let Some(route) = code.routes.get(pc!()) else { break Ok(Exit::Ended) };
                jump!(target, *route);
                // The usual condition of a loop is decided here, which spares a dispatch in each pass.
                if let Some(Op::JumpUnlessLongConst { range, inside, left, target }) = ahead.as_slice().first() {
                    ahead.next();
                    if range.contains(long!(*left)) != *inside {
                        go!(*target);
                    }
                }
            }
            Op::JumpUnless { from, target } => {
                if long!(from) == 0 {
                    go!(target);
                }
            }
            Op::JumpUnlessLong { relation, left, right, target } => {
                if !relation.holds(&long!(left), &long!(right)) {
                    go!(target);
                }
            }
            Op::JumpUnlessLongConst { range, inside, left, target } => {
                if range.contains(long!(left)) != inside {
                    go!(target);
                }
            }
            Op::JumpUnlessRem { relation, left, divisor, value, target } => {
                if !relation.holds(&checked!(remainder(long!(left), divisor)), &value) {
                    go!(target);
                }
            }
            Op::JumpUnlessDouble { relation, left, right, target } => {
                if !relation.holds(&double!(left), &double!(right)) {
                    go!(target);
                }
            }
            Op::JumpUnlessDoubleConst { relation, left, value, target } => {
                if !relation.holds(&double!(left), &value) {
                    go!(target);
                }
            }
            Op::Gosub { target } => {
                let depth = frame.calls.len() + 1;
                if used + acrc_catalog::memory::CALLS.bytes(depth as u64, 0) > limit {
                    break Err(FaultKind::GosubTooDeep { depth });
                }
                frame.calls.push((end - ahead.len()) as u32);
                go!(target);
            }
            Op::Return => match frame.calls.pop() {
                Some(target) => {
                    let (Some(behind), Some(at)) = (code.accounts.get(pc!() + 1), code.accounts.get(target as usize))
                    else {
                        break Ok(Exit::Ended);
                    };
                    jump!(target, Route::new(behind, at));
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
                    go!(target);
                }
            }
            Op::LoopTestLong { index, counter, target } => {
                if let Some(state) = frame.loops.get_mut(usize::from(index))
                    && i64::from(long!(counter)) > state.end_long
                {
                    state.step_long = 0;
                    go!(target);
                }
            }
            Op::LoopStep { index, to, from } => match frame.loops.get(usize::from(index)) {
                Some(state) if state.step != 0.0 => set_double!(to, double!(from) + state.step),
                _ => break Err(FaultKind::NextWithoutFor),
            },
            Op::LoopNext { index, counter, target } => match frame.loops.get_mut(usize::from(index)) {
                Some(state) if state.step != 0.0 => {
                    let next = double!(counter) + state.step;
                    set_double!(counter, next);
                    if next > state.end {
                        state.step = 0.0;
                    } else {
                        go!(target);
                    }
                }
                _ => break Err(FaultKind::NextWithoutFor),
            },
            Op::LoopNextLong { index, counter, target } => match frame.loops.get_mut(usize::from(index)) {
                Some(state) if state.step_long != 0 => {
                    let next = i64::from(long!(counter)) + state.step_long;
                    set_long!(counter, next as i32);
                    if next > state.end_long {
                        state.step_long = 0;
                    } else {
                        go!(target);
                    }
                }
                _ => break Err(FaultKind::NextWithoutFor),
            },
            Op::End => break Ok(Exit::Ended),
            Op::Raise { index } => {
                let fault = code.faults.get(index as usize).cloned();
                break Err(fault.unwrap_or(FaultKind::NumberExpected));
            }

            // What is rare, large, or calls the host.
            _ => break Ok(Exit::Slow),
        }
    };
    let pc = end - ahead.len() - 1;
    if balance != OVERDRAWN {
        settle(code, pc, balance, meter);
    }
    frame.pc = pc as u32;
    result
}

/// Accounts for what begins with an instruction. Gives the balance if the instructions behind it need no counting.
#[inline(never)]
fn begin<H: Host>(code: &Code, pc: usize, host: &mut H, meter: &mut Meter) -> Result<Option<i64>, Exit> {
    let (Some(account), Some(behind)) = (code.accounts.get(pc), code.accounts.get(pc + 1)) else { return Ok(None) };
    if account.begins == Begins::Nothing {
        return Ok(None);
    }
    if !meter.begin(account.begins == Begins::Line) {
        return Err(Exit::Budget);
    }
    if H::WATCHES_STATEMENTS {
        host.statement(pc as u32);
        return Ok(None);
    }
    Ok(meter.balance(account, behind))
}

/// Brings the meter up to date with an instruction that was begun.
#[inline(never)]
fn settle(code: &Code, pc: usize, balance: i64, meter: &mut Meter) {
    if let Some(behind) = code.accounts.get(pc + 1) {
        meter.settle(balance, behind);
    }
}

/// The balance while statements are counted one by one: less than any jump asks for.
const OVERDRAWN: i64 = i64::MIN / 2;

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
