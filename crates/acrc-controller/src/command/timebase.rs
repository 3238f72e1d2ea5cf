//! The time in which the moves of a master pass (guide, command list: `SRC`, `TOV`).

use acrc_catalog::{Keyword, ObjectKind, command};
use acrc_motion::Advanced;
use acrc_vm::{Call, Outcome, Reference, Source};

use super::arguments::scalar;
use super::master_settings::number;
use super::settings::{argument_items, source_name};
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::settings::Item;

pub(super) const COMMANDS: &[Entry] = &[(command::SRC, Action::Run(source)), (command::TOV, Action::Run(stretch))];

/// What moves the time of a master on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TimeBase {
    /// `SRC`
    source: Source,
    /// Count of the source at the last tick.
    count: i32,
    /// `TOV`
    pub(super) factor: f64,
    /// How much time passed in the last tick, in servo periods: what velocities along the path are to be multiplied by.
    pub(crate) rate: f64,
}

impl TimeBase {
    pub(crate) const CLOCK: Self =
        Self { source: Source::Word(Keyword::Clock, None), count: 0, factor: 1.0, rate: 1.0 };
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
        let count = self.source_count(source)?.unwrap_or(0);
        let time = &mut self.masters[master].time;
        (time.source, time.count) = (source, count);
        Ok(())
    }

    /// Lets the time of a master pass that belongs to one servo period.
    pub(crate) fn pass_time(&mut self, index: usize) -> Advanced {
        let TimeBase { source, count, factor, .. } = self.masters[index].time;
        let counts = match self.source_count(source) {
            // The clock counts servo periods.
            Ok(None) if matches!(source, Source::Word(Keyword::Clock, _)) => 1,
            Ok(Some(now)) => {
                self.masters[index].time.count = now;
                now.wrapping_sub(count)
            }
            // A source that was taken away stands still, as none does.
            Ok(None) | Err(_) => 0,
        };
        let master = &mut self.masters[index];
        master.time.rate = f64::from(counts) * factor;
        master.profiler.advance_counts(i64::from(counts), self.clock.period() * factor)
    }

    /// Begins to count the source of a master that has been at rest.
    pub(crate) fn begin_time(&mut self, index: usize) {
        if let Ok(Some(count)) = self.source_count(self.masters[index].time.source) {
            self.masters[index].time.count = count;
        }
    }

    /// What a source has counted so far; `None` for one that is no counter.
    fn source_count(&self, source: Source) -> Result<Option<i32>, ControllerError> {
        match source {
            Source::Word(Keyword::Clock | Keyword::None, _) => Ok(None),
            Source::Reference(Reference::Parameter(number)) => {
                let value = self.read_parameter(number)?;
                value.to_long().map(Some).map_err(ControllerError::Program)
            }
            Source::Object(ObjectKind::Encoder, Some(index)) => {
                let index = Self::object("ENC", i64::from(index), self.model.axes)?;
                Ok(self.encoder_count(index))
            }
            other => {
                let problem = format!("{} is no source that the dry run can follow", source_name(other));
                Err(ControllerError::BadValue { command: command::SRC.info().name, problem })
            }
        }
    }
}
