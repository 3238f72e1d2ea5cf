//! How far a program may run in one go without anybody noticing.
//!
//! While only one program computes, nothing moves, and nobody watches each tick, the slices of the other programs and of
//! communication are empty. The program then executes the lines of many slices at once. Time follows where it is looked
//! at: before a line touches the machine, the clock is moved on to the slice to which the line belongs ([`Pace`]). What
//! a run does and when is the same to the tick.

use super::{Controller, Observer};
use crate::footprint::Places;
use crate::program::{NEVER, Program};
use crate::scheduler::HIGH_PROGRAMS;
use crate::terminal::Demand;
use crate::watch::Circle;

/// Lines that a program executes in one slice (`docs/fidelity.md`, program scheduling).
pub(crate) const LINES_PER_SLICE: u32 = 4;
/// Slices that are executed at once at most, so that a run can be interrupted.
const LONGEST: u64 = 1 << 16;

/// When the lines of a program are executed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    /// Tick of the slice to which the first line belongs.
    first: u64,
    /// Ticks from one slice of the program to its next; 0 when all lines belong to one slice.
    stride: u64,
    /// Slices whose lines may be executed.
    slices: u32,
    /// Another program waits for something that this one may do.
    awaited: bool,
    /// Lines that were begun.
    lines: u32,
    /// Somebody has to look before the next line.
    leave: bool,
}

impl Pace {
    /// One slice, now.
    pub(crate) fn slice(now: u64) -> Self {
        Self { first: now, stride: 0, slices: 1, awaited: false, lines: 0, leave: false }
    }

    /// Slices whose lines may be executed.
    pub(super) fn slices(&self) -> u32 {
        self.slices
    }

    /// Tick of the slice to which the first line belongs.
    pub(super) fn first(&self) -> u64 {
        self.first
    }

    /// Slices that are over before the one of the present line.
    pub(super) fn passed(&self, now: u64) -> u64 {
        (now - self.first).checked_div(self.stride).unwrap_or(0)
    }

    /// Lines that may be executed.
    pub(super) fn budget(&self) -> u32 {
        self.slices * LINES_PER_SLICE
    }

    /// Takes note of how many lines were begun.
    pub(crate) fn reach(&mut self, lines: u32) {
        self.lines = lines;
    }

    /// The next line must not begin yet.
    pub(crate) fn is_over(&self) -> bool {
        self.leave
    }

    /// Tick of the slice to which the present line belongs.
    #[inline]
    pub(crate) fn tick(&self) -> u64 {
        self.first + self.stride * u64::from(self.lines.saturating_sub(1) / LINES_PER_SLICE)
    }

    /// More than the lines of one slice are executed.
    pub(crate) fn is_ahead(&self) -> bool {
        self.stride > 0
    }

    /// Whether whatever the program does to the machine matters to somebody.
    pub(crate) fn is_awaited(&self) -> bool {
        self.awaited
    }

    /// The next line has to wait until somebody has looked.
    pub(crate) fn leave(&mut self) {
        self.leave = true;
    }
}

impl Controller {
    /// How far a program may run that has its slice now. `end` is the last tick of the run.
    pub(super) fn pace(&self, number: usize, end: u64, observer: &dyn Observer) -> Pace {
        let now = self.machine.clock.ticks();
        let here = Pace::slice(now);
        if self.machine.is_busy() || !self.boot.done || self.alarms.watches() || observer.watches_every_tick() {
            return here;
        }
        let mut until = self.machine.next_event_tick().map_or(end, |tick| tick.min(end));
        let mut ring = 1;
        let mut awaited = false;
        for typed in self.machine.terminal.channels().filter_map(|channel| channel.typed.as_ref()) {
            // What is written to user parameters meanwhile would not be noticed.
            if typed.waits_for.any_user() {
                return here;
            }
            awaited = true;
        }
        match self.channel_demand() {
            Demand::Now => return here,
            Demand::At(tick) => until = until.min(tick),
            Demand::Nothing => {}
        }
        for (other, program) in self.programs.iter().enumerate().filter(|(_, program)| program.is_active()) {
            ring += 1;
            if other == number {
                continue;
            }
            // The low programs share a slice: they pass it on, or wait together.
            let high = number.max(other) < HIGH_PROGRAMS;
            let Some(tick) = self.bystander(program).filter(|_| high) else { return here };
            until = until.min(tick);
            awaited |= program.release.is_none();
        }
        for plc in self.plcs.iter().filter(|plc| plc.program.is_active()) {
            let Some(release) = self.bystander(&plc.program) else { return here };
            until = until.min(release).min(plc.ladder.next_timer());
            awaited = true;
        }
        let stride = ring * self.machine.clock.slice_ticks();
        let longest = self.programs[number].watch.stride().min(LONGEST);
        let slices = until.saturating_sub(now).div_ceil(stride).min(longest);
        if slices < 2 { here } else { Pace { stride, slices: slices as u32, awaited, ..here } }
    }

    /// The tick before which a program does nothing of its own while another one runs ahead; [`NEVER`] when only a change can end that. `None` when
    /// it has to be looked at in each of its slices.
    fn bystander(&self, program: &Program) -> Option<u64> {
        // What is written to user parameters meanwhile would not be noticed.
        let blind = |reads: Places| reads.any_user();
        if let Some(tick) = program.waits(&self.changes) {
            return (!blind(program.waits_for)).then_some(tick);
        }
        // A circle of one slice needs no execution at all.
        let still = |circle: &Circle| circle.slices == 1 && !blind(circle.reads);
        program.circle(&self.changes).filter(still).map(|_| NEVER)
    }
}
