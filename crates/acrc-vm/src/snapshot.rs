//! Recognising a state that a program has been in before.

use crate::frame::{Frame, LoopState};
use crate::locals::Locals;

/// Where a program stood between two lines, and what its variables held.
///
/// A program that comes back to the same state while nothing around it changes goes on as it did before, for ever.
/// Numbers are compared by their bits, so 0 and -0 differ.
#[derive(Clone, Debug)]
pub struct Snapshot {
    pc: u32,
    calls: Vec<u32>,
    loops: Vec<LoopState>,
    locals: Locals,
}

impl Snapshot {
    /// Takes note of the present state. `None` while a call is held: what it waits for is not part of a snapshot.
    pub fn take(frame: &Frame, locals: &Locals) -> Option<Self> {
        (!frame.held).then(|| Self {
            pc: frame.pc,
            calls: frame.calls.clone(),
            loops: frame.loops.clone(),
            locals: locals.clone(),
        })
    }

    /// Whether the state is the same again.
    pub fn matches(&self, frame: &Frame, locals: &Locals) -> bool {
        self.pc == frame.pc
            && !frame.held
            && self.calls == frame.calls
            && self.loops.iter().map(LoopState::bits).eq(frame.loops.iter().map(LoopState::bits))
            && self.locals.equals(locals)
    }
}
