//! Running a program.
//!
//! [`run`] executes statements until the budget is used up, the program ends, a command has to wait, or something goes
//! wrong, and says which. All state lies in the frame, the local variables and the host, so a program goes on where it
//! stopped when it is run again.

mod arithmetic;
mod calls;
mod input;
mod shared;
mod slow;
mod steps;
mod values;

use crate::account::{Account, LINE, STATEMENTS_PER_LINE};
use crate::code::Code;
use crate::fault::{Fault, FaultKind};
use crate::frame::Frame;
use crate::host::Host;
use crate::locals::Locals;

pub use input::input_fits;

/// How much a program may do at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Lines or statements that may be begun.
    units: u32,
    /// Statements of the same line that a unit covers behind its first.
    extent: u32,
}

impl Budget {
    /// Lines that one run executes at most, so that its statements can be counted with 32 bits.
    const MOST_LINES: u32 = u32::MAX / STATEMENTS_PER_LINE;

    /// A number of lines, as the scheduler of a controller grants them; at most sixteen million at once. What a program
    /// does is the same whether its lines are cut into several budgets or not.
    pub const fn lines(lines: u32) -> Self {
        let units = if lines < Self::MOST_LINES { lines } else { Self::MOST_LINES };
        Self { units, extent: STATEMENTS_PER_LINE - 1 }
    }

    /// A number of statements, wherever they stand.
    pub const fn statements(statements: u32) -> Self {
        Self { units: statements, extent: 0 }
    }
}

/// Why a run stopped.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// The program ended: by `END`, at `ENDP`, behind its last line, or because a command ended it.
    Ended,
    /// The budget is used up.
    Budget,
    /// A command has to wait and is offered again by the next run.
    Blocked,
    /// Something went wrong. The place is in the fault.
    Fault(Box<Fault>),
}

/// What a run did.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Why it stopped.
    pub stop: Stop,
    /// Statements that were begun.
    pub statements: u32,
    /// What was used of the budget.
    pub used: u32,
}

/// What is left of the budget.
#[derive(Clone, Copy, Debug)]
struct Meter {
    /// Units that are left in the upper half, statements that were begun in the lower: one addition counts both.
    count: u64,
    /// Statements of the present line that need no further unit.
    left: u32,
    /// What `left` is at the start of a unit.
    extent: u32,
    /// Units that were granted.
    granted: u32,
}

impl Meter {
    /// A unit of `count`.
    const UNIT: u64 = LINE as u64;

    fn new(budget: Budget) -> Self {
        let Budget { units, extent } = budget;
        Self { count: u64::from(units) * Self::UNIT, left: 0, extent, granted: units }
    }

    /// Accounts for a statement. False when the budget does not allow it.
    #[inline]
    fn begin(&mut self, line: bool) -> bool {
        if line || self.left == 0 {
            if self.count < Self::UNIT {
                return false;
            }
            self.count -= Self::UNIT - 1;
            self.left = self.extent;
        } else {
            self.count += 1;
            self.left -= 1;
        }
        true
    }

    /// The balance with which the program goes on behind the line that was begun just now; `None` when its statements
    /// have to be counted one by one.
    #[inline]
    fn balance(&self, line: &Account, behind: &Account) -> Option<i64> {
        let balance = behind.balance(self.count);
        (self.extent > 0 && balance >= line.least()).then_some(balance)
    }

    /// Takes note of what was used with a balance, up to an account.
    fn settle(&mut self, balance: i64, behind: &Account) {
        self.count = behind.count(balance);
        self.left = u32::from(behind.left);
    }

    /// Units that were used.
    #[inline]
    fn used(&self) -> u32 {
        self.granted - (self.count >> 32) as u32
    }

    /// The statement that was begun last begins anew in a later run, which counts it.
    fn take_back(&mut self) {
        self.count -= u64::from(self.count as u32 > 0);
    }

    /// Takes the rest of the budget away.
    fn revoke(&mut self) {
        self.granted = self.used();
        self.count %= Self::UNIT;
    }
}

/// Why the fast loop was left.
enum Exit {
    /// An instruction that needs the whole machine.
    Slow,
    Ended,
    Budget,
}

/// Runs a program.
///
/// The frame and the local variables must belong to the code: a frame that ran other code has to be reset first.
pub fn run<H: Host>(code: &Code, frame: &mut Frame, locals: &mut Locals, host: &mut H, budget: Budget) -> Run {
    frame.prepare(code.loops, code.value_slots);
    let mut meter = Meter::new(budget);
    let stop = match execute(code, frame, locals, host, &mut meter) {
        Ok(stop) => stop,
        Err(kind) => {
            frame.held = false;
            Stop::Fault(Box::new(Fault { kind, pc: frame.pc }))
        }
    };
    Run { stop, statements: meter.count as u32, used: meter.used() }
}

fn execute<H: Host>(
    code: &Code,
    frame: &mut Frame,
    locals: &mut Locals,
    host: &mut H,
    meter: &mut Meter,
) -> Result<Stop, FaultKind> {
    // A call that is offered again has begun its statement before.
    if frame.held
        && let Some(stop) = slow::slow(code, frame, locals, host, meter)?
    {
        return Ok(stop);
    }
    loop {
        match steps::steps(code, frame, locals, host, meter)? {
            Exit::Ended => return Ok(Stop::Ended),
            Exit::Budget => return Ok(Stop::Budget),
            Exit::Slow => loop {
                if let Some(stop) = slow::slow(code, frame, locals, host, meter)? {
                    return Ok(stop);
                }
                // What is left of a statement is often slow as well.
                if !code.continues_slowly(frame.pc) {
                    break;
                }
            },
        }
    }
}
