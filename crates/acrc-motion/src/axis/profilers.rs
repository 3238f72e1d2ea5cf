//! The profilers of one axis together: a tick of all of them, and the stop of a killed axis.

use super::{Backlash, Cam, CamPoints, Gear, HandWheel, Homing, Jog, Registers};
use crate::value::InvalidValue;

/// What the sources of an axis did in a tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SourceCounts {
    /// Time base of the jog profiler: seconds of the clock, or units of JOG SRC.
    pub jog: f64,
    /// Counts of GEAR SRC.
    pub gear: f64,
    /// Counts of HDW SRC.
    pub hand_wheel: f64,
    /// Counts of CAM SRC.
    pub cam: f64,
    /// Counts of BSC SRC.
    pub ballscrew: f64,
}

impl SourceCounts {
    /// A tick in which only the clock has moved, by `dt` seconds.
    pub fn clock(dt: f64) -> Self {
        Self { jog: dt, ..Self::default() }
    }
}

/// The axis' own profilers. The coordinated one belongs to its master.
#[derive(Clone, Debug, Default)]
pub struct AxisProfilers {
    /// Jog.
    pub jog: Jog,
    /// Homing, which drives the jog profiler.
    pub homing: Homing,
    /// Gear.
    pub gear: Gear,
    /// Hand wheel; it counts as a part of the gear offset.
    pub hand_wheel: HandWheel,
    /// Cam.
    pub cam: Cam,
    /// Ballscrew compensation.
    pub ballscrew: Cam,
    /// Backlash compensation.
    pub backlash: Backlash,
}

impl AxisProfilers {
    /// Lets a tick of `dt` seconds pass.
    pub fn advance(
        &mut self,
        counts: &SourceCounts,
        dt: f64,
        cam_points: &impl CamPoints,
        ballscrew_points: &impl CamPoints,
    ) {
        self.jog.advance(counts.jog);
        self.gear.advance(counts.gear, dt);
        self.hand_wheel.advance(counts.hand_wheel, dt);
        self.cam.advance(counts.cam, dt, cam_points);
        self.ballscrew.advance(counts.ballscrew, dt, ballscrew_points);
    }

    /// The registers of this tick, u, from the coordinated and the actual position.
    pub fn registers(&mut self, coordinated: f64, actual: f64) -> Registers {
        let registers = Registers {
            coordinated,
            jog: self.jog.offset(),
            gear: self.gear.offset() + self.hand_wheel.state().position,
            cam: self.cam.offset(),
            backlash: 0.0,
            ballscrew: self.ballscrew.offset(),
            actual,
        };
        Registers { backlash: self.backlash.update(registers.primary_setpoint()), ..registers }
    }

    /// Velocity of the axis' own part of the primary setpoint, u/s.
    pub fn velocity(&self) -> f64 {
        self.jog.state().velocity + self.gear.velocity() + self.hand_wheel.state().velocity + self.cam.velocity()
    }

    /// Stops the axis with a ramp of `deceleration`, u/s² (HLDEC or SLDEC), while its master moves it with
    /// `coordinated_velocity`, u/s, which ends in the same tick.
    ///
    /// Gear, cam, ballscrew and homing end. The jog profiler takes over the velocity of them all, so the setpoint goes on
    /// without a step and the way of the ramp is left in the jog offset.
    pub fn stop(&mut self, coordinated_velocity: f64, deceleration: f64) -> Result<(), InvalidValue> {
        let velocity = coordinated_velocity + self.velocity();
        self.jog.stop_from(velocity, deceleration)?;
        self.homing.abort();
        self.gear.halt();
        self.hand_wheel.halt();
        self.cam.halt();
        self.ballscrew.halt();
        Ok(())
    }

    /// Whether a profiler of the axis moves it, or would as soon as its source does.
    pub fn active(&self) -> bool {
        self.jog.active() || self.gear.state() != super::GearState::Off || self.cam.is_on()
    }
}
