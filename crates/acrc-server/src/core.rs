//! The controller with its pace: what both threads lock.

use std::sync::Arc;
use std::time::{Duration, Instant};

use acrc_controller::{ChannelId, Controller, Observer, StreamError, StreamName};
use tokio::sync::Notify;

use crate::Speed;

/// Wall time from one look at the controller to the next while something goes on.
pub(crate) const BEAT: Duration = Duration::from_millis(1);
/// Wall time for which the lock is held at a stretch.
const BURST: Duration = Duration::from_micros(500);
/// An answer that is not complete is kept back for so long, so that it leaves as a whole if it is complete by then.
const HOLD: Duration = Duration::from_millis(20);
/// What virtual time may be behind before it gives up catching up.
const LONGEST_LAG: Duration = Duration::from_secs(2);
/// The grid of beats begins anew after so long, so that its numbers stay small.
const LONGEST_GRID: Duration = Duration::from_hours(1);
/// Bytes that may wait for a channel before its client is held back.
pub(crate) const UNREAD: usize = 4096;

/// The controller, and where it is in time.
pub(crate) struct Core {
    pub(crate) controller: Controller,
    pub(crate) observer: Box<dyn Observer + Send>,
    speed: Speed,
    /// When the clock on the wall and that of the controller were together.
    since: (Instant, f64),
    /// The thread of the pace sleeps until something is to come, so virtual time may be behind though nothing is amiss.
    pub(crate) asleep: bool,
    /// Channels that have a client.
    wired: Vec<Wired>,
    pub(crate) lost: Duration,
    /// Restarts of the controller that are known.
    restarts: u32,
}

/// A channel that has a client.
struct Wired {
    channel: ChannelId,
    client: Arc<Notify>,
    /// Since when an answer that is not complete is kept back.
    held: Option<Instant>,
    /// The client is held back until what it has sent is read.
    thirsty: bool,
    /// The client tries again at each beat.
    retries: bool,
}

/// When the controller has to be looked at again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Next {
    /// At once: there is more to do than one burst.
    Now,
    /// At an instant.
    At(Instant),
    /// When somebody says so.
    Never,
}

impl Core {
    pub(crate) fn new(controller: Controller, observer: Box<dyn Observer + Send>, speed: Speed) -> Self {
        let since = (Instant::now(), controller.seconds());
        let restarts = controller.restarts();
        Self { controller, observer, speed, since, asleep: false, wired: Vec::new(), lost: Duration::ZERO, restarts }
    }

    /// Executes the setup code; time begins to pass.
    pub(crate) fn power_up(&mut self) {
        self.controller.step(0, &mut *self.observer);
        self.since = (Instant::now(), self.controller.seconds());
    }

    /// Ends all programs and all motion, since an operating system is to come.
    pub(crate) fn halt(&mut self, streams: &[StreamName]) {
        /// Ctrl-X.
        const KILL: u8 = 0x18;
        self.wake();
        // The clients are gone, so there is a stream.
        if let Some((channel, _)) = self.open(streams, &Arc::default()) {
            self.controller.receive(channel, &[KILL]);
            self.close(channel);
        }
    }

    /// Restarts the controller.
    pub(crate) fn reboot(&mut self) {
        self.wake();
        self.controller.reboot(&mut *self.observer);
        self.has_restarted();
    }

    /// Whether the controller has restarted since this was asked last.
    pub(crate) fn has_restarted(&mut self) -> bool {
        let restarts = self.controller.restarts();
        std::mem::replace(&mut self.restarts, restarts) != restarts
    }

    /// Opens a channel on the first of some streams that is free.
    pub(crate) fn open(&mut self, streams: &[StreamName], client: &Arc<Notify>) -> Option<(ChannelId, StreamName)> {
        let (channel, stream) = streams.iter().find_map(|stream| match self.controller.open_channel(*stream) {
            Ok(channel) => Some((channel, *stream)),
            Err(StreamError::InUse(_) | StreamError::Missing { .. } | StreamError::Unknown(_)) => None,
        })?;
        self.wired.push(Wired { channel, client: Arc::clone(client), held: None, thirsty: false, retries: false });
        Some((channel, stream))
    }

    /// Closes a channel.
    pub(crate) fn close(&mut self, channel: ChannelId) {
        self.controller.close_channel(channel);
        self.wired.retain(|wired| wired.channel != channel);
    }

    /// The client of a channel is told when what it has sent is read, or at the next beat if it wants to try something again.
    pub(crate) fn hold_back(&mut self, channel: ChannelId, retries: bool) {
        if let Some(wired) = self.wired.iter_mut().find(|wired| wired.channel == channel) {
            wired.thirsty = true;
            wired.retries = retries;
        }
    }

    /// Whether virtual time follows the clock on the wall.
    pub(crate) fn keeps_time(&self) -> bool {
        self.speed != Speed::Max
    }

    /// Whether virtual time goes no faster than the clock on the wall, so that it leaves most of a processor to others.
    pub(crate) fn is_real_time(&self) -> bool {
        matches!(self.speed, Speed::Factor(factor) if factor <= 1.0)
    }

    /// Before a client is heard: if the pace sleeps, virtual time is brought up to date, which costs nothing since nothing went on.
    pub(crate) fn wake(&mut self) {
        if !self.asleep {
            return;
        }
        if let Speed::Factor(factor) = self.speed {
            let due = self.due_tick(Instant::now(), factor);
            self.controller.run_until(due, &mut *self.observer);
        }
    }

    /// Lets time pass up to an instant, for one burst at most.
    pub(crate) fn pass(&mut self, now: Instant) -> Next {
        self.asleep = false;
        let next = match self.speed {
            Speed::Factor(factor) => self.keep_up(now, factor),
            Speed::Max => self.rush(now),
        };
        match self.deliver(now) {
            Some(instant) => next.or_at(instant),
            None => next,
        }
    }

    fn keep_up(&mut self, now: Instant, factor: f64) -> Next {
        self.give_up_lag(now, factor);
        let due = self.due_tick(now, factor);
        while self.ticks() < due {
            let stride = self.ticks() + self.ticks_of(BEAT.as_secs_f64());
            let stop = self.controller.rests_until().map_or(stride, |tick| tick.max(stride));
            self.controller.run_until(stop.min(due), &mut *self.observer);
            if now.elapsed() >= BURST && self.ticks() < due {
                return Next::Now;
            }
        }
        let beat = self.beat_after(now);
        match self.controller.rests_until() {
            None => Next::At(beat),
            Some(u64::MAX) => Next::Never,
            Some(tick) => self.instant_of(tick, factor).map_or(Next::Never, |instant| Next::At(instant.max(beat))),
        }
    }

    fn rush(&mut self, now: Instant) -> Next {
        while !self.controller.is_idle() {
            let stride = self.ticks() + self.ticks_of(BEAT.as_secs_f64());
            let stop = match self.controller.rests_until() {
                // What goes on waits for what only somebody else can do.
                Some(u64::MAX) => return Next::Never,
                Some(tick) => tick.max(stride),
                None => stride,
            };
            self.controller.run_until(stop, &mut *self.observer);
            if now.elapsed() >= BURST {
                return Next::Now;
            }
        }
        Next::Never
    }

    /// Tells clients what there is for them. Gives when an answer that is kept back is to leave though it is not complete.
    fn deliver(&mut self, now: Instant) -> Option<Instant> {
        let mut next: Option<Instant> = None;
        for wired in &mut self.wired {
            let traffic = self.controller.traffic(wired.channel);
            let is_read = wired.thirsty && (wired.retries || traffic.unread < UNREAD / 2);
            wired.thirsty &= !is_read;
            if traffic.unsent == 0 {
                wired.held = None;
            } else if traffic.answering {
                let leaves = *wired.held.get_or_insert(now) + HOLD;
                if now < leaves {
                    next = Some(next.map_or(leaves, |next| next.min(leaves)));
                    if !is_read {
                        continue;
                    }
                }
            }
            if traffic.unsent > 0 || is_read {
                wired.client.notify_one();
            }
        }
        next
    }

    /// What is to be sent to a client.
    pub(crate) fn take_output(&mut self, channel: ChannelId) -> Vec<u8> {
        if let Some(wired) = self.wired.iter_mut().find(|wired| wired.channel == channel) {
            wired.held = None;
        }
        self.controller.take_output(channel)
    }

    /// The instant of the wall's grid of beats that comes next.
    pub(crate) fn beat_after(&self, now: Instant) -> Instant {
        let elapsed = now.saturating_duration_since(self.since.0);
        let beats = u32::try_from(elapsed.as_nanos() / BEAT.as_nanos()).unwrap_or(u32::MAX).saturating_add(1);
        self.since.0 + BEAT * beats
    }

    /// A computer that cannot keep up, or was suspended, does not rush through what it has missed.
    fn give_up_lag(&mut self, now: Instant, factor: f64) {
        let (instant, seconds) = self.since;
        let reached = (self.controller.seconds() - seconds) / factor;
        let lag = now.saturating_duration_since(instant).as_secs_f64() - reached;
        // Time in which nothing goes on is made up for at once.
        let rests = self.controller.rests_until().is_some();
        if (lag > LONGEST_LAG.as_secs_f64() && !rests) || reached < 0.0 {
            self.lost += Duration::try_from_secs_f64(lag).unwrap_or_default();
            self.since = (now, self.controller.seconds());
        } else if now.saturating_duration_since(instant) > LONGEST_GRID {
            let beat = self.beat_after(now);
            self.since = (beat, seconds + (beat - instant).as_secs_f64() * factor);
        }
    }

    fn due_tick(&self, now: Instant, factor: f64) -> u64 {
        let (instant, seconds) = self.since;
        let due = seconds + now.saturating_duration_since(instant).as_secs_f64() * factor;
        self.ticks() + self.ticks_of(due - self.controller.seconds())
    }

    /// When a tick that is to come is due.
    fn instant_of(&self, tick: u64, factor: f64) -> Option<Instant> {
        let ahead = tick.saturating_sub(self.ticks()) as f64 * self.controller.view().period();
        let (instant, seconds) = self.since;
        let after = (self.controller.seconds() - seconds + ahead) / factor;
        Duration::try_from_secs_f64(after.max(0.0)).ok().and_then(|after| instant.checked_add(after))
    }

    fn ticks(&self) -> u64 {
        self.controller.view().ticks()
    }

    /// Whole ticks in virtual seconds, a hair less than a tick being one.
    fn ticks_of(&self, seconds: f64) -> u64 {
        (seconds / self.controller.view().period() + 1e-6).max(0.0) as u64
    }
}

impl Next {
    fn or_at(self, instant: Instant) -> Self {
        match self {
            Self::Now => Self::Now,
            Self::At(other) => Self::At(other.min(instant)),
            Self::Never => Self::At(instant),
        }
    }

    /// Whether nothing is to be done for longer than a beat.
    pub(crate) fn is_far(self, beat: Instant) -> bool {
        match self {
            Self::Now => false,
            Self::At(instant) => instant > beat,
            Self::Never => true,
        }
    }
}
