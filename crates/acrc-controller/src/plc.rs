//! What a PLC program keeps from scan to scan: the rung that is being worked out, timers and counters.
//!
//! The guide names the commands and their place only; how rungs are put together follows the catalogue's rows
//! (`plc_ladder.toml`) and `docs/fidelity.md`, "PLC programs".

use std::collections::BTreeMap;

use crate::footprint::Changes;
use crate::program::{NEVER, Program};

/// A PLC program.
#[derive(Debug)]
pub(crate) struct Plc {
    pub(crate) program: Program,
    pub(crate) ladder: Ladder,
}

impl Plc {
    /// An empty slot.
    pub(crate) fn new(number: u8) -> Self {
        Self { program: Program::new(), ladder: Ladder::new(number) }
    }

    /// The tick before which its scans do nothing new as long as nothing changes; [`NEVER`] when only that can. `None` when each scan may.
    pub(crate) fn rests(&self, changes: &Changes) -> Option<u64> {
        let circle = || self.program.circle(changes).map(|_| self.ladder.next_timer());
        self.program.waits(changes).or_else(circle)
    }
}

/// The state of one PLC program besides its place and variables.
#[derive(Debug)]
pub(crate) struct Ladder {
    number: u8,
    /// States of the blocks of the present rung, latest last.
    blocks: Vec<bool>,
    /// The rung has driven something, so the next contact begins another one.
    driven: bool,
    timers: BTreeMap<i32, Timer>,
    counters: BTreeMap<i32, Counter>,
    /// A timer or counter has changed since the scan began.
    changed: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct Timer {
    /// Tick at which its rung came on.
    since: Option<u64>,
    /// Ticks that it has to stay on.
    preset: u64,
    done: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct Counter {
    count: i32,
    /// The state of its count rung in the latest scan.
    input: bool,
}

/// How a contact is put to the rung.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Join {
    /// It begins a block.
    Load,
    And,
    Or,
}

impl Ladder {
    pub(crate) fn new(number: u8) -> Self {
        Self {
            number,
            blocks: Vec::new(),
            driven: false,
            timers: BTreeMap::new(),
            counters: BTreeMap::new(),
            changed: false,
        }
    }

    /// The number of its PLC program.
    pub(crate) fn number(&self) -> u8 {
        self.number
    }

    /// Goes back to the first rung.
    pub(crate) fn begin_scan(&mut self) {
        self.blocks.clear();
        self.driven = false;
    }

    /// Whether a timer or counter has changed since this was last asked.
    pub(crate) fn take_changed(&mut self) -> bool {
        std::mem::take(&mut self.changed)
    }

    /// A contact. `None` when there is no block to join it to.
    pub(crate) fn contact(&mut self, join: Join, state: bool) -> Option<()> {
        if join == Join::Load {
            if std::mem::take(&mut self.driven) {
                self.blocks.clear();
            }
            self.blocks.push(state);
            return Some(());
        }
        let block = self.blocks.last_mut()?;
        *block = if join == Join::And { *block && state } else { *block || state };
        Some(())
    }

    /// Joins the two latest blocks. `None` when there are not two.
    pub(crate) fn join(&mut self, join: Join) -> Option<()> {
        let state = self.blocks.pop()?;
        let block = self.blocks.last_mut()?;
        *block = if join == Join::And { *block && state } else { *block || state };
        Some(())
    }

    /// The state that an output gets.
    pub(crate) fn drive(&mut self) -> Option<bool> {
        self.driven = true;
        self.blocks.last().copied()
    }

    /// The two rungs of a latch or counter, which leave one.
    pub(crate) fn pair(&mut self) -> Option<(bool, bool)> {
        let second = self.blocks.pop()?;
        Some((self.drive()?, second))
    }

    /// Replaces the state of the rung.
    pub(crate) fn leave(&mut self, state: bool) {
        if let Some(block) = self.blocks.last_mut() {
            *block = state;
        }
    }

    /// A timer: on once its rung has been on for `preset` ticks without a break.
    pub(crate) fn timer(&mut self, index: i32, preset: u64, now: u64) -> Option<()> {
        let on = self.drive()?;
        let timer = self.timers.entry(index).or_default();
        let before = (timer.since, timer.preset, timer.done);
        timer.preset = preset;
        timer.since = if on { timer.since.or(Some(now)) } else { None };
        timer.done = timer.since.is_some_and(|since| now - since >= preset);
        self.changed |= before != (timer.since, timer.preset, timer.done);
        let done = timer.done;
        self.leave(done);
        Some(())
    }

    /// A counter: counts the times that its first rung comes on, starts again while the second one is on, and is on from
    /// `preset` counts.
    pub(crate) fn counter(&mut self, index: i32, preset: i32) -> Option<()> {
        let (input, reset) = self.pair()?;
        let counter = self.counters.entry(index).or_default();
        let before = (counter.count, counter.input);
        if reset {
            counter.count = 0;
        } else if input && !counter.input && counter.count < preset {
            counter.count += 1;
        }
        counter.input = input;
        self.changed |= before != (counter.count, counter.input);
        let done = counter.count >= preset;
        self.leave(done);
        Some(())
    }

    /// Tick at which the next timer comes on by itself; [`NEVER`] when none runs.
    pub(crate) fn next_timer(&self) -> u64 {
        let running = self.timers.values().filter(|timer| !timer.done);
        running.filter_map(|timer| Some(timer.since?.saturating_add(timer.preset))).min().unwrap_or(NEVER)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_join_in_the_order_of_a_rung() {
        let mut ladder = Ladder::new(0);
        // (off OR on) AND (on AND on)
        let contacts = [(Join::Load, false), (Join::Or, true), (Join::Load, true), (Join::And, true)];
        for (join, state) in contacts {
            ladder.contact(join, state).expect("there is a block");
        }
        ladder.join(Join::And).expect("there are two");
        assert_eq!(ladder.drive(), Some(true));
        ladder.contact(Join::Load, false).expect("a rung begins");
        assert_eq!((ladder.drive(), ladder.join(Join::Or)), (Some(false), None), "the rung before is over");
    }

    #[test]
    fn a_timer_needs_its_rung_without_a_break() {
        let mut ladder = Ladder::new(0);
        let mut scan = |on: bool, now: u64| {
            ladder.begin_scan();
            ladder.contact(Join::Load, on).expect("a rung begins");
            ladder.timer(1, 10, now).expect("there is a rung");
            (ladder.drive() == Some(true), ladder.next_timer(), ladder.take_changed())
        };
        assert_eq!(scan(true, 5), (false, 15, true));
        assert_eq!(scan(true, 14), (false, 15, false));
        assert_eq!(scan(true, 15), (true, NEVER, true));
        assert_eq!(scan(false, 16), (false, NEVER, true));
        assert_eq!(scan(true, 20), (false, 30, true));
    }

    #[test]
    fn a_counter_counts_edges_up_to_its_preset() {
        let mut ladder = Ladder::new(0);
        let mut scan = |input: bool, reset: bool| {
            ladder.begin_scan();
            ladder.contact(Join::Load, input).expect("a rung begins");
            ladder.contact(Join::Load, reset).expect("a block begins");
            ladder.counter(0, 2).expect("there are two");
            ladder.drive() == Some(true)
        };
        let inputs = [(true, false), (true, false), (false, false), (true, false), (false, false), (false, true)];
        assert_eq!(inputs.map(|(input, reset)| scan(input, reset)), [false, false, false, true, true, false]);
    }
}
