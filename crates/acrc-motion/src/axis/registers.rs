//! The position registers of an axis and the commands that move values between them (the guide's "Primary Setpoint",
//! "REN Details", "RES Details", "JOG REN Details", "JOG RES Details", "Servo Loop Fundamentals"; Figures 1 to 3 and 11
//! to 17).
//!
//! This is arithmetic only: a command takes the registers as they are and says what they become. The caller reads them
//! from the profilers and writes them back.
//!
//! What the guide leaves open, and how it is read here, stands in `docs/fidelity.md`, "Jog, homing, limits and kills".

/// The position registers of one axis, all in the same unit: programming units or pulses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Registers {
    /// Output of the coordinated moves profiler, called the current position (C).
    pub coordinated: f64,
    /// Jog offset (J).
    pub jog: f64,
    /// Gear offset (G).
    pub gear: f64,
    /// Cam offset (K).
    pub cam: f64,
    /// Output of the backlash generator.
    pub backlash: f64,
    /// Output of the ballscrew profiler.
    pub ballscrew: f64,
    /// Actual position, from the feedback device.
    pub actual: f64,
}

impl Registers {
    /// The primary setpoint: the sum of all profilers (Figure 1, Figure 15).
    pub fn primary_setpoint(&self) -> f64 {
        self.coordinated + self.offsets()
    }

    /// The secondary setpoint: the primary one, compensated (Figure 16).
    pub fn secondary_setpoint(&self) -> f64 {
        self.primary_setpoint() + self.compensation()
    }

    /// The following error: how far the actual position is behind the secondary setpoint (Figure 17).
    pub fn following_error(&self) -> f64 {
        self.secondary_setpoint() - self.actual
    }

    fn offsets(&self) -> f64 {
        self.jog + self.gear + self.cam
    }

    fn compensation(&self) -> f64 {
        self.backlash + self.ballscrew
    }

    /// REN: the setpoints become the actual position, and the coordinated position is computed back from them (Figure 2).
    #[must_use]
    pub fn match_actual(&self) -> Self {
        let primary = self.actual - self.compensation();
        Self { coordinated: primary - self.offsets(), ..*self }
    }

    /// RES: setpoints, coordinated and actual position become `position`, the offsets zero (Figure 3).
    ///
    /// Compensation is cleared, too; its generators make it anew from the next tick on.
    #[must_use]
    pub fn reset(&self, position: f64) -> Self {
        Self { coordinated: position, actual: position, ..Self::default() }
    }

    /// JOG REN: the coordinated position becomes `position`, and the jog offset takes the difference (Figures 11, 12).
    #[must_use]
    pub fn coordinated_into_jog(&self, position: f64) -> Self {
        Self { jog: self.jog + (self.coordinated - position), coordinated: position, ..*self }
    }

    /// JOG RES: the jog offset becomes `offset`, and the coordinated position takes the difference (Figures 13, 14).
    #[must_use]
    pub fn jog_into_coordinated(&self, offset: f64) -> Self {
        Self { coordinated: self.coordinated + (self.jog - offset), jog: offset, ..*self }
    }

    /// CAM RES: the cam offset becomes `offset`, and the coordinated position takes the difference.
    #[must_use]
    pub fn cam_into_coordinated(&self, offset: f64) -> Self {
        Self { coordinated: self.coordinated + (self.cam - offset), cam: offset, ..*self }
    }

    /// GEAR RES: the gear offset becomes `offset`, and nothing takes the difference.
    #[must_use]
    pub fn reset_gear(&self, offset: f64) -> Self {
        Self { gear: offset, ..*self }
    }

    /// The place that was `position` becomes zero; offsets stay (MSEEK, once the marker is captured there).
    #[must_use]
    pub fn zeroed_at(&self, position: f64) -> Self {
        Self { coordinated: self.coordinated - position, actual: self.actual - position, ..*self }
    }

    /// NORM: the coordinated position comes to lie within one turn of a rotary axis, from zero up to `length`, which has to be
    /// positive. The actual position loses the same number of turns.
    #[must_use]
    pub fn normalized(&self, length: f64) -> Self {
        let folded = crate::wrap::wrap(self.coordinated, length);
        Self { coordinated: folded, actual: self.actual - (self.coordinated - folded), ..*self }
    }
}

/// An axis that follows another one's primary setpoint (LOCK, UNLOCK).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GantryLock {
    distance: f64,
}

impl GantryLock {
    /// Locks an axis whose primary setpoint is `follower` to one whose is `leader`, both in the follower's unit.
    pub fn new(leader: f64, follower: f64) -> Self {
        Self { distance: follower - leader }
    }

    /// The primary setpoint of the follower, instead of the sum of its own profilers.
    pub fn primary_setpoint(&self, leader: f64) -> f64 {
        leader + self.distance
    }

    /// The follower's registers after UNLOCK: its own profilers stand for the position it was led to.
    pub fn released(&self, leader: f64, follower: &Registers) -> Registers {
        let coordinated = self.primary_setpoint(leader) - (follower.primary_setpoint() - follower.coordinated);
        Registers { coordinated, ..*follower }
    }
}
