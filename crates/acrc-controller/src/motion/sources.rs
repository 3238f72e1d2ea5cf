//! What axes follow: clock, encoders, parameters, ratchets and frequency limiters (guide, "SRC", "Gear Profiler", "Cam Profiler").
//!
//! Sources are read once a tick before anything moves, so an axis that follows another one is a tick behind it, whichever number it has.

use acrc_catalog::{CommandId, Keyword, ObjectKind, command};
use acrc_motion::axis::SourceCounts;
use acrc_motion::source::{Ratchet, RateLimiter};
use acrc_vm::{Reference, Source};

use crate::machine::Machine;
use crate::settings::{Item, most_objects};

/// Something that counts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Feed {
    /// Nothing.
    #[default]
    None,
    /// The servo clock: a count a period.
    Clock,
    /// An encoder.
    Encoder(u8),
    /// A parameter.
    Parameter(i64),
    /// What a ratchet lets pass.
    Ratchet(u8),
    /// What a frequency limiter lets pass.
    Limiter(u8),
}

impl Feed {
    /// What a source stands for; `None` if it does not count.
    pub(crate) fn of(source: Source) -> Option<Self> {
        Some(match source {
            Source::Object(ObjectKind::Encoder, Some(number)) => Self::Encoder(u8::try_from(number).ok()?),
            Source::Object(ObjectKind::Ratch, Some(number)) => Self::Ratchet(u8::try_from(number).ok()?),
            Source::Object(ObjectKind::Limit, Some(number)) => Self::Limiter(u8::try_from(number).ok()?),
            Source::Reference(Reference::Parameter(number)) => Self::Parameter(number),
            Source::Word(Keyword::Clock, None) => Self::Clock,
            Source::Word(Keyword::None, None) => Self::None,
            _ => return None,
        })
    }

    /// Whether it passes the counts of another one on.
    pub(super) fn is_gate(self) -> bool {
        matches!(self, Self::Ratchet(_) | Self::Limiter(_))
    }
}

/// A feed with the count that was last seen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Follower {
    pub(crate) feed: Feed,
    last: f64,
}

impl Follower {
    /// A follower of the clock.
    pub(crate) const CLOCK: Self = Self { feed: Feed::Clock, last: 0.0 };
}

/// The followers of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Followers {
    pub(super) jog: Follower,
    pub(super) gear: Follower,
    pub(super) hand_wheel: Follower,
    pub(super) cam: Follower,
    pub(super) ballscrew: Follower,
}

/// A ratchet or a limiter: what it follows, and what it let pass in this tick.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Gate<T> {
    follower: Follower,
    kind: T,
    passed: f64,
}

/// The ratchets and limiters of a controller.
#[derive(Clone, Debug, Default)]
pub(super) struct Gates {
    ratchets: Vec<Gate<Ratchet>>,
    limiters: Vec<Gate<RateLimiter>>,
}

impl Machine {
    /// Gives ratchets and limiters their settings.
    pub(super) fn refresh_gates(&mut self) {
        let mut gates = std::mem::take(&mut self.motion.gates);
        let count = |kind| usize::from(most_objects(kind).unwrap_or(8));
        gates.ratchets.resize(count(ObjectKind::Ratch), Gate::default());
        gates.limiters.resize(count(ObjectKind::Limit), Gate::default());
        for (number, gate) in (0..).zip(&mut gates.ratchets) {
            self.refollow(&mut gate.follower, command::RATCH_SRC, number);
            let mode = self.first_setting(command::RATCH_MODE, number);
            match Ratchet::from_mode(mode as u8) {
                Some(kind) if (kind.positive, kind.negative) != (gate.kind.positive, gate.kind.negative) => {
                    gate.kind = kind;
                }
                Some(_) => {}
                None => {
                    self.notes
                        .insert(format!("RATCH{number} MODE {mode}: what it does is not known; it passes everything"));
                }
            }
        }
        for (number, gate) in (0..).zip(&mut gates.limiters) {
            self.refollow(&mut gate.follower, command::LIMIT_SRC, number);
            gate.kind.rate = self.first_setting(command::LIMIT_FREQ, number);
            let multiplier = self.first_setting(command::LIMIT_MULT, number);
            gate.kind.multiplier = if multiplier == 0.0 { 1.0 } else { multiplier };
        }
        self.motion.gates = gates;
    }

    /// Makes a follower follow what its command says now.
    pub(super) fn refollow(&mut self, follower: &mut Follower, source: CommandId, object: u16) {
        let feed = self.feed(source, object);
        if feed != follower.feed {
            *follower = self.follow(feed);
        }
    }

    /// A follower that begins to count now.
    pub(crate) fn follow(&self, feed: Feed) -> Follower {
        Follower { feed, last: self.count_of(feed) }
    }

    fn feed(&mut self, id: CommandId, object: u16) -> Feed {
        let items = self.setting(id, object).unwrap_or_default();
        match items.first() {
            Some(Item::Source(source)) => Feed::of(*source).unwrap_or_else(|| {
                let name = id.info().name;
                self.notes
                    .insert(format!("{name} names a source that the dry run does not follow: nothing moves with it"));
                Feed::None
            }),
            Some(Item::Factory("CLOCK")) => Feed::Clock,
            Some(Item::Factory(_) | Item::Number(_)) | None => Feed::None,
        }
    }

    /// The count of a feed that counts by itself. Ratchets and limiters pass differences on.
    fn count_of(&self, feed: Feed) -> f64 {
        let value = match feed {
            Feed::None | Feed::Clock | Feed::Ratchet(_) | Feed::Limiter(_) => return 0.0,
            Feed::Encoder(encoder) => return f64::from(self.encoder_travel(encoder).unwrap_or(0)),
            Feed::Parameter(number) => self.read_parameter(number),
        };
        value.ok().and_then(|value| value.to_f64().ok()).filter(|value| value.is_finite()).unwrap_or(0.0)
    }

    /// What a feed has counted since it was last asked. Encoders wrap at 32 bits.
    pub(crate) fn counted(&self, follower: &mut Follower) -> f64 {
        match follower.feed {
            Feed::None => 0.0,
            Feed::Clock => 1.0,
            Feed::Ratchet(number) => {
                self.motion.gates.ratchets.get(usize::from(number)).map_or(0.0, |gate| gate.passed)
            }
            Feed::Limiter(number) => {
                self.motion.gates.limiters.get(usize::from(number)).map_or(0.0, |gate| gate.passed)
            }
            Feed::Parameter(_) | Feed::Encoder(_) => {
                let now = self.count_of(follower.feed);
                let before = std::mem::replace(&mut follower.last, now);
                match follower.feed {
                    Feed::Encoder(_) => f64::from((now as i32).wrapping_sub(before as i32)),
                    _ => now - before,
                }
            }
        }
    }

    /// Reads what ratchets and limiters let pass.
    pub(super) fn read_gates(&mut self) {
        let period = self.clock.period();
        let mut gates = std::mem::take(&mut self.motion.gates);
        for gate in &mut gates.ratchets {
            let counts = self.counted(&mut gate.follower);
            gate.passed = gate.kind.pass(counts);
        }
        for gate in &mut gates.limiters {
            let counts = self.counted(&mut gate.follower);
            gate.passed = gate.kind.pass(counts, period);
        }
        self.motion.gates = gates;
    }

    /// What the sources of an axis have counted since the last tick. The period is that of the servo, s.
    pub(super) fn read_followers(&mut self, axis: u8) -> SourceCounts {
        let period = self.clock.period();
        let mut followers = self.axes[usize::from(axis)].followers;
        let jog = match followers.jog.feed {
            Feed::Clock => period,
            // A count of another time base stands for a period.
            _ => self.counted(&mut followers.jog) * period,
        };
        let counts = SourceCounts {
            jog,
            gear: self.counted(&mut followers.gear),
            hand_wheel: self.counted(&mut followers.hand_wheel),
            cam: self.counted(&mut followers.cam),
            ballscrew: self.counted(&mut followers.ballscrew),
        };
        self.axes[usize::from(axis)].followers = followers;
        counts
    }

    /// Clears what a ratchet or a limiter keeps (`RATCH RES`, `LIMIT RES`).
    pub(crate) fn reset_gate(&mut self, ratchet: bool, number: usize) {
        let gates = &mut self.motion.gates;
        if ratchet {
            gates.ratchets.iter_mut().skip(number).take(1).for_each(|gate| gate.kind.reset());
        } else {
            gates.limiters.iter_mut().skip(number).take(1).for_each(|gate| gate.kind.reset());
        }
    }
}
