//! Homing (the guide's "Homing", Figures A to J; JOG HOME, JOG HOMVF).
//!
//! [`Homing`] drives a [`Jog`] by what the home and limit inputs show. It looks at them once a tick, after the axis has
//! moved, so an edge is found to within one tick.
//!
//! The edges of the home region are named after the side of the region they lie on: an axis that moves in the positive
//! direction meets the negative edge when the input goes active and the positive edge when it goes inactive.
//!
//! - Without backup (Figures A and B) any edge ends the search: the axis ramps down, and home is where it stands.
//! - With backup (Figures C to J) the axis searches the selected edge at JOG VEL, ramps down, and comes back at JOG HOMVF.
//!   If that is the selected final direction, the edge ends the homing at once. Otherwise the axis crosses it, ramps
//!   down, and ends at the edge on its way back. If the home input is active at the start, the search begins towards
//!   the selected edge, whatever the command says.
//! - A limit that the axis runs into reverses the search. A second one ends the homing: it has failed.
//!
//! When home was found the caller makes the position zero.
//!
//! What the guide leaves open, and how it is read here, stands in `docs/fidelity.md`, "Jog, homing, limits and kills".

use super::jog::Pace;
use super::{Jog, JogError, Side};

/// The homing bits of an axis: indices 24, 25 and 26 of its quinary flags (16152, 16153 and 16154 of axis 0).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HomingOptions {
    /// Home Backup Enable: come back to the edge. Without it the other two mean nothing.
    pub backup: bool,
    /// Home Negative Edge Select: the edge on the negative side of the region; otherwise the positive one.
    pub negative_edge: bool,
    /// Home Negative Final Direction: reach the edge in the negative direction; otherwise in the positive one.
    pub negative_final: bool,
}

impl HomingOptions {
    fn edge(self) -> Side {
        if self.negative_edge { Side::Negative } else { Side::Positive }
    }

    fn last_direction(self) -> Side {
        if self.negative_final { Side::Negative } else { Side::Positive }
    }
}

/// What the switches of an axis show in one tick: true is active, any inversion of the level already applied. A limit
/// that is not enabled is never active.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HomeInputs {
    /// The home switch.
    pub home: bool,
    /// The positive end-of-travel limit.
    pub positive_limit: bool,
    /// The negative end-of-travel limit.
    pub negative_limit: bool,
}

impl HomeInputs {
    fn limit(self, side: Side) -> bool {
        match side {
            Side::Positive => self.positive_limit,
            Side::Negative => self.negative_limit,
        }
    }
}

/// How far a homing is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum HomingStatus {
    /// None has been asked for.
    #[default]
    Idle,
    /// Under way.
    Running,
    /// It ended at home (flag 16134 of axis 0): the position there becomes zero.
    Found,
    /// It ended without home (flag 16135 of axis 0).
    Failed,
}

/// A stretch of the way home.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Leg {
    /// Looking for the edge at JOG VEL.
    Search,
    /// Coming back to it at JOG HOMVF.
    Return,
    /// Approaching it in the final direction, at JOG HOMVF.
    Approach,
}

/// What the axis is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    Moving(Leg, Side),
    /// Ramping down, to go on with this.
    Slowing(Next, Side),
}

/// What comes when the axis stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Next {
    Move(Leg, Side),
    Found,
    Failed,
}

/// The homing of one axis.
#[derive(Clone, Copy, Debug, Default)]
pub struct Homing {
    status: HomingStatus,
    phase: Option<Phase>,
    options: HomingOptions,
    /// HLDEC, u/s².
    limit_deceleration: f64,
    home: bool,
    reversed: bool,
}

impl Homing {
    /// Starts a homing towards `side` (JOG HOME axis 1 or -1), with the inputs of now.
    ///
    /// `limit_deceleration` is HLDEC, u/s². Refused while the axis jogs; that it does not move otherwise is up to the
    /// caller.
    pub fn start(
        &mut self,
        jog: &mut Jog,
        side: Side,
        options: HomingOptions,
        inputs: HomeInputs,
        limit_deceleration: f64,
    ) -> Result<(), JogError> {
        if jog.active() {
            return Err(JogError::InMotion);
        }
        let side = if options.backup && inputs.home { options.edge() } else { side };
        *self = Self {
            status: HomingStatus::Running,
            phase: None,
            options,
            limit_deceleration,
            home: inputs.home,
            reversed: false,
        };
        self.go(jog, Leg::Search, side);
        Ok(())
    }

    /// How far it is.
    pub fn status(&self) -> HomingStatus {
        self.status
    }

    /// Gives up, for an axis that is killed. The jog is left to the caller.
    pub fn abort(&mut self) {
        if self.status == HomingStatus::Running {
            self.end(HomingStatus::Failed);
        }
    }

    /// Looks at the inputs after a tick of the jog, and tells the jog what comes next.
    pub fn update(&mut self, jog: &mut Jog, inputs: HomeInputs) -> HomingStatus {
        let crossed = inputs.home != self.home;
        self.home = inputs.home;
        match self.phase {
            Some(Phase::Moving(_, side)) if inputs.limit(side) => self.meet_limit(jog, side),
            Some(Phase::Moving(leg, side)) if crossed && self.looks_for(edge(side, inputs.home)) => {
                self.meet_edge(jog, leg, side);
            }
            Some(Phase::Slowing(Next::Move(..) | Next::Found, side)) if jog.active() && inputs.limit(side) => {
                self.meet_limit(jog, side);
            }
            Some(Phase::Slowing(next, _)) if !jog.active() => self.resume(jog, next),
            None | Some(Phase::Moving(..) | Phase::Slowing(..)) => {}
        }
        self.status
    }

    fn looks_for(&self, edge: Side) -> bool {
        !self.options.backup || edge == self.options.edge()
    }

    fn go(&mut self, jog: &mut Jog, leg: Leg, side: Side) {
        jog.run_at(side, if leg == Leg::Search { Pace::Jog } else { Pace::HomeFinal });
        self.phase = Some(Phase::Moving(leg, side));
    }

    fn meet_edge(&mut self, jog: &mut Jog, leg: Leg, side: Side) {
        let last = self.options.last_direction();
        let next = match leg {
            Leg::Search if !self.options.backup => Next::Found,
            Leg::Search => Next::Move(Leg::Return, side.opposite()),
            Leg::Return if side != last => Next::Move(Leg::Approach, last),
            Leg::Return | Leg::Approach => {
                jog.halt();
                self.end(HomingStatus::Found);
                return;
            }
        };
        jog.off();
        self.phase = Some(Phase::Slowing(next, side));
    }

    fn meet_limit(&mut self, jog: &mut Jog, side: Side) {
        let again = core::mem::replace(&mut self.reversed, true);
        let next = if again { Next::Failed } else { Next::Move(Leg::Search, side.opposite()) };
        // A deceleration that is no number stops at once.
        if jog.stop_from(jog.state().velocity, self.limit_deceleration).is_err() {
            jog.halt();
        }
        // The limit stays active while the axis slows down behind it: that ramp watches the other one.
        self.phase = Some(Phase::Slowing(next, side.opposite()));
    }

    fn resume(&mut self, jog: &mut Jog, next: Next) {
        match next {
            Next::Move(leg, side) => self.go(jog, leg, side),
            Next::Found => self.end(HomingStatus::Found),
            Next::Failed => self.end(HomingStatus::Failed),
        }
    }

    fn end(&mut self, status: HomingStatus) {
        self.status = status;
        self.phase = None;
    }
}

/// The edge that was crossed in a direction when the input is now `active`.
fn edge(side: Side, active: bool) -> Side {
    if active { side.opposite() } else { side }
}
