//! The thread that lets virtual time pass.
//!
//! It wakes at fixed instants, a millisecond apart, never after a fixed delay, so that it does not drift; while nothing goes on it sleeps until
//! something is to come or somebody rings.

use std::sync::Arc;
use std::time::{Duration, Instant};

use parking_lot::MutexGuard;

use crate::Histogram;
use crate::core::{BEAT, Next};
use crate::shared::{Phase, Shared};

/// What the thread has measured.
#[derive(Debug, Default)]
pub(crate) struct Pace {
    pub(crate) slip: Histogram,
}

/// What a thread that goes first leaves the others between two bursts.
const BREATH: Duration = Duration::from_micros(100);
/// Missed beats that are counted one by one after a stall.
const MOST_MISSED: u32 = 10_000;

/// Lets time pass until the server ends.
pub(crate) fn run(shared: &Arc<Shared>) -> Pace {
    let mut pace = Pace::default();
    let first = shared.core().is_real_time() && crate::priority::go_first();
    // The instant for which it sleeps, while something goes on.
    let mut planned: Option<Instant> = None;
    while !shared.bell.has_ended() {
        let now = Instant::now();
        let mut core = shared.core();
        let next = core.pass(now);
        let status = shared.subscribers.is_due(now).then(|| crate::status::contents(&mut core.controller));
        let beat = core.beat_after(now);
        core.asleep = next.is_far(beat);
        let keeps_time = core.keeps_time();
        let alarms = core.controller.take_alarms();
        let restarted = core.has_restarted();
        MutexGuard::unlock_fair(core);
        if restarted {
            shared.enter(Phase::Restarted);
        }
        for alarm in alarms {
            // Without management connections nobody gets it.
            let _ = shared.alarms.send(alarm.into());
        }
        if let Some(status) = status {
            shared.subscribers.send(&status);
        }
        if next == Next::Now {
            // Behind: what is missed is counted when it is made up for.
            planned = planned.or(Some(now)).filter(|_| keeps_time);
            if first {
                // Nobody else would get the processor.
                std::thread::sleep(BREATH);
            }
            continue;
        }
        if let Some(planned) = planned.take() {
            pace.record(planned);
        }
        let wakes = match next {
            Next::At(instant) => Some(instant),
            Next::Now | Next::Never => None,
        };
        let sends = shared.subscribers.next_due();
        let until = [wakes, sends].into_iter().flatten().min();
        planned = until.filter(|_| keeps_time && wakes == Some(beat) && until == wakes);
        shared.bell.sleep_until(until);
    }
    pace
}

impl Pace {
    /// The ticks of all beats from this one on are done now.
    fn record(&mut self, planned: Instant) {
        let slip = planned.elapsed();
        let missed = u32::try_from(slip.as_nanos() / BEAT.as_nanos()).unwrap_or(u32::MAX).min(MOST_MISSED);
        for beat in 0..=missed {
            self.slip.record(slip.saturating_sub(Duration::from_millis(u64::from(beat))));
        }
    }
}
