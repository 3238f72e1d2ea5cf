//! How far a program has come.

use acrc_catalog::memory;

use crate::fault::FaultKind;
use crate::host::Arg;
use crate::value::Value;

/// The state of a running program besides its variables.
#[derive(Clone, Debug, Default)]
pub struct Frame {
    pub(crate) pc: u32,
    /// Where `RETURN` goes, innermost last.
    pub(crate) calls: Vec<u32>,
    /// One for each `FOR` of the program. A loop belongs to its statement, so a `GOTO` out of it leaves nothing behind.
    pub(crate) loops: Vec<LoopState>,
    /// The value file.
    pub(crate) values: Vec<Value>,
    /// Arguments of the present call.
    pub(crate) arguments: Vec<Arg>,
    /// The present call has to be offered again.
    pub(crate) held: bool,
    /// Bytes that the calls of another frame on the same variables take.
    pub(crate) reserved: u64,
}

/// The numbers of a running `FOR`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LoopState {
    pub(crate) end: f64,
    /// 0 when the loop does not run.
    pub(crate) step: f64,
    /// The largest whole number up to `end`, for a long counter.
    pub(crate) end_long: i64,
    /// `step` for a long counter, 0 when the loop does not run.
    pub(crate) step_long: i64,
}

impl LoopState {
    /// All of it, to be compared.
    pub(crate) fn bits(&self) -> (u64, u64, i64, i64) {
        (self.end.to_bits(), self.step.to_bits(), self.end_long, self.step_long)
    }

    /// Starts the loop.
    pub(crate) fn begin(&mut self, end: f64, step: f64, whole: bool) -> Result<(), FaultKind> {
        // A long counter moves by whole numbers only.
        let step_used = if whole { step.trunc() } else { step };
        if step_used <= 0.0 {
            return Err(FaultKind::StepNotPositive { step });
        }
        *self = Self { end, step: step_used, end_long: end.floor() as i64, step_long: step_used as i64 };
        Ok(())
    }
}

impl Frame {
    /// At the start of a program.
    pub fn new() -> Self {
        Self::default()
    }

    /// At the start of a statement that is typed while a program stands at `program`: the calls of both share the memory
    /// of the program, everything else is apart.
    pub fn beside(program: &Self) -> Self {
        Self { reserved: program.memory(), ..Self::default() }
    }

    /// Back to the start of the program, or to the start of another.
    pub fn reset(&mut self) {
        self.pc = 0;
        self.calls.clear();
        self.loops.clear();
        self.held = false;
    }

    /// The instruction to be executed next, as [`crate::Code::location`] takes it.
    pub fn pc(&self) -> u32 {
        self.pc
    }

    /// How many `GOSUB` are open.
    pub fn depth(&self) -> usize {
        self.calls.len()
    }

    /// Bytes of program memory that the open calls take.
    pub fn memory(&self) -> u64 {
        self.reserved + memory::CALLS.bytes(self.calls.len() as u64, 0)
    }

    /// True when a call has to be offered again.
    pub fn is_blocked(&self) -> bool {
        self.held
    }

    /// Makes room for what a program needs.
    pub(crate) fn prepare(&mut self, loops: usize, values: usize) {
        if self.loops.len() < loops {
            self.loops.resize(loops, LoopState::default());
        }
        if self.values.len() < values {
            self.values.resize(values, Value::default());
        }
    }
}
