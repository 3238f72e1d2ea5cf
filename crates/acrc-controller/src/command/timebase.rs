//! The time in which the moves of a master pass (guide, command list: `SRC`, `TOV`).

use acrc_catalog::{Keyword, command};
use acrc_motion::Advanced;
use acrc_vm::{Call, Outcome, Source};

use super::arguments::scalar;
use super::master_settings::number;
use super::settings::{argument_items, source_name};
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::motion::{Feed, Follower};
use crate::settings::Item;

pub(super) const COMMANDS: &[Entry] = &[(command::SRC, Action::Run(source)), (command::TOV, Action::Run(stretch))];

/// What moves the time of a master on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TimeBase {
    /// `SRC`
    source: Source,
    pub(crate) follower: Follower,
    /// Counts of the source that have not yet passed.
    counts: f64,
    /// `TOV`
    pub(super) factor: f64,
    /// How much time passed in the last tick, in servo periods: what velocities along the path are to be multiplied by.
    pub(crate) rate: f64,
}

impl TimeBase {
    pub(crate) const CLOCK: Self = Self {
        source: Source::Word(Keyword::Clock, None),
        follower: Follower::CLOCK,
        counts: 0.0,
        factor: 1.0,
        rate: 1.0,
    };
}

/// `SRC ENC0`, `SRC P12290`, `SRC CLOCK`, `SRC NONE`
fn source(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let master = context.master(call)?;
    let [argument] = call.arguments else {
        let name = source_name(context.machine.masters[master].time.source);
        context.report_text(&name);
        return Ok(Outcome::Done);
    };
    let [Item::Source(source)] = argument_items(command, argument)?[..] else {
        return Err(ControllerError::Expected { command, expected: "a source" });
    };
    context.machine.set_source(master, source)?;
    context.keep_for_master(call, master, vec![Item::Source(source)])
}

/// `TOV 0.5`: half of the time passes.
fn stretch(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.master(call)?;
    match scalar(call)? {
        None => {
            let factor = context.machine.masters[master].time.factor;
            context.report(factor);
        }
        Some(factor) if factor < 0.0 => {
            let command = call.command.info().name;
            return Err(ControllerError::BadValue { command, problem: format!("{factor} is negative") });
        }
        Some(factor) => {
            context.machine.masters[master].time.factor = factor;
            return context.keep_for_master(call, master, vec![number(factor)]);
        }
    }
    Ok(Outcome::Done)
}

impl Machine {
    /// Sets what moves the time of a master on. What cannot be read is said now, not in the middle of a move.
    pub(super) fn set_source(&mut self, master: usize, source: Source) -> Result<(), ControllerError> {
        let feed = self.checked_feed(source)?;
        let follower = self.follow(feed);
        let time = &mut self.masters[master].time;
        (time.source, time.follower) = (source, follower);
        Ok(())
    }

    /// What a source names, if it exists and counts.
    fn checked_feed(&self, source: Source) -> Result<Feed, ControllerError> {
        let unknown = || {
            let problem = format!("{} is no source that the dry run can follow", source_name(source));
            ControllerError::BadValue { command: command::SRC.info().name, problem }
        };
        let feed = Feed::of(source).ok_or_else(unknown)?;
        match feed {
            Feed::Encoder(encoder) => {
                Self::object("ENC", i64::from(encoder), self.model.axes)?;
            }
            Feed::Parameter(number) => {
                self.read_parameter(number)?.to_long().map_err(ControllerError::Program)?;
            }
            Feed::None | Feed::Clock | Feed::Ratchet(_) | Feed::Limiter(_) => {}
        }
        Ok(feed)
    }

    /// Reads the source of a master that moves, before anything does.
    pub(crate) fn read_time(&mut self, index: usize) {
        let mut follower = self.masters[index].time.follower;
        let counts = self.counted(&mut follower);
        let time = &mut self.masters[index].time;
        time.follower = follower;
        time.counts += counts;
    }

    /// Lets the time of a master pass that belongs to one servo period. Parts of a count wait for their whole.
    pub(crate) fn pass_time(&mut self, index: usize) -> Advanced {
        let period = self.clock.period();
        let master = &mut self.masters[index];
        let time = &mut master.time;
        let counts = time.counts.trunc();
        time.counts -= counts;
        time.rate = counts * time.factor;
        master.profiler.advance_counts(counts as i64, period * time.factor)
    }

    /// Begins to count the source of a master that has been at rest.
    pub(super) fn begin_time(&mut self, index: usize) {
        let follower = self.follow(self.masters[index].time.follower.feed);
        let time = &mut self.masters[index].time;
        (time.follower, time.counts) = (follower, 0.0);
    }
}
