//! A motor with a load: inertia, friction and a torque constant.

use core::f64::consts::TAU;

use super::Encoder;
use crate::value::{InvalidValue, Quantity, finite, not_negative};

/// Below this part of the time constant, powers of it replace the exponential, whose differences would lose digits.
const SHORT: f64 = 1e-2;

/// The values of a motor and its load, all at the motor's shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorModel {
    /// Inertia, kg m²; above zero.
    pub inertia: f64,
    /// Torque per volt of the loop's output, N m/V.
    pub torque_per_volt: f64,
    /// Friction in proportion to the velocity, N m per rad/s.
    pub viscous_friction: f64,
    /// Friction that does not depend on the velocity and holds the shaft at rest, N m.
    pub coulomb_friction: f64,
    /// Torque of the load in the positive direction, N m: a weight, for one.
    pub load_torque: f64,
    /// What is on the shaft.
    pub encoder: Encoder,
}

impl MotorModel {
    fn validate(&self) -> Result<(), InvalidValue> {
        if not_negative(Quantity::Inertia, self.inertia)? == 0.0 {
            return Err(InvalidValue { quantity: Quantity::Inertia, value: self.inertia });
        }
        not_negative(Quantity::Friction, self.viscous_friction)?;
        not_negative(Quantity::Friction, self.coulomb_friction)?;
        finite(Quantity::Torque, self.torque_per_volt)?;
        finite(Quantity::Torque, self.load_torque)?;
        Ok(())
    }
}

/// A motor that turns. The torque is constant within a period, and the motion is the exact solution for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motor {
    model: MotorModel,
    /// Angle, turns.
    angle: f64,
    /// Velocity, turns/s.
    velocity: f64,
    response: Response,
}

impl Motor {
    /// A motor at rest at zero.
    pub fn new(model: MotorModel) -> Result<Self, InvalidValue> {
        model.validate()?;
        Ok(Self { model, angle: 0.0, velocity: 0.0, response: Response::default() })
    }

    /// Angle, turns.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// Velocity, turns/s.
    pub fn velocity(&self) -> f64 {
        self.velocity
    }

    /// Its encoder.
    pub fn encoder(&self) -> &Encoder {
        &self.model.encoder
    }

    /// What its encoder has counted, pulses.
    pub fn counted(&self) -> f64 {
        self.model.encoder.count(self.angle)
    }

    /// Stops the shaft where it is, by something that holds it from outside.
    pub fn halt(&mut self) {
        self.velocity = 0.0;
    }

    /// Puts another encoder on the shaft, or sets its multiplier.
    pub fn set_encoder(&mut self, encoder: Encoder) {
        self.model.encoder = encoder;
    }

    /// Turns the shaft by hand: the position jumps, the velocity stays.
    pub fn displace(&mut self, turns: f64) {
        self.angle += turns;
    }

    /// Lets `seconds` pass with a voltage at the drive, or with the drive off.
    pub fn advance(&mut self, volts: Option<f64>, seconds: f64) {
        let torque = volts.unwrap_or(0.0) * self.model.torque_per_volt + self.model.load_torque;
        let mut left = seconds;
        // At most one stop can lie within the period: after it the shaft either stays or turns the other way.
        for _ in 0..2 {
            let Some(net) = self.net_torque(torque) else {
                self.velocity = 0.0;
                return;
            };
            let acceleration = net / (self.model.inertia * TAU);
            match self.stop_within(acceleration, left) {
                Some(time) => {
                    self.move_for(&self.response_over(time), acceleration);
                    self.velocity = 0.0;
                    left -= time;
                }
                None => {
                    self.response = self.response_over(left);
                    self.move_for(&self.response.clone(), acceleration);
                    return;
                }
            }
        }
    }

    /// The torque that accelerates the shaft, but for viscous friction; `None` if friction holds it.
    fn net_torque(&self, torque: f64) -> Option<f64> {
        let direction = if self.velocity == 0.0 { torque } else { self.velocity };
        let friction = if direction < 0.0 { -self.model.coulomb_friction } else { self.model.coulomb_friction };
        let held = self.velocity == 0.0 && torque.abs() <= self.model.coulomb_friction;
        (!held).then_some(torque - friction)
    }

    /// Part of the velocity that is lost in a second.
    fn decay(&self) -> f64 {
        self.model.viscous_friction / self.model.inertia
    }

    /// When the shaft comes to rest, if it does so within `seconds`.
    fn stop_within(&self, acceleration: f64, seconds: f64) -> Option<f64> {
        if self.velocity * acceleration >= 0.0 {
            return None;
        }
        let decay = self.decay();
        let straight = -self.velocity / acceleration;
        let time = if decay == 0.0 { straight } else { libm::log1p(straight * decay) / decay };
        (time < seconds).then_some(time)
    }

    /// How the shaft answers over a time, taken from the last period where that was as long.
    fn response_over(&self, seconds: f64) -> Response {
        if self.response.seconds == seconds { self.response } else { Response::new(self.decay(), seconds) }
    }

    fn move_for(&mut self, response: &Response, acceleration: f64) {
        let from = self.velocity;
        self.angle += from * response.way_of_velocity + acceleration * response.way_of_acceleration;
        self.velocity = from * response.kept + acceleration * response.way_of_velocity;
    }
}

/// What a velocity and an acceleration come to over a time with viscous friction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Response {
    seconds: f64,
    /// Part of the velocity that is kept.
    kept: f64,
    /// Way per velocity, and velocity per acceleration, s.
    way_of_velocity: f64,
    /// Way per acceleration, s².
    way_of_acceleration: f64,
}

impl Response {
    fn new(decay: f64, seconds: f64) -> Self {
        let z = decay * seconds;
        let (first, second) = if z < SHORT {
            let first = 1.0 - z / 2.0 * (1.0 - z / 3.0 * (1.0 - z / 4.0 * (1.0 - z / 5.0 * (1.0 - z / 6.0))));
            let second = 0.5 * (1.0 - z / 3.0 * (1.0 - z / 4.0 * (1.0 - z / 5.0 * (1.0 - z / 6.0 * (1.0 - z / 7.0)))));
            (first, second)
        } else {
            let lost = -libm::expm1(-z);
            (lost / z, (z - lost) / (z * z))
        };
        Self {
            seconds,
            kept: 1.0 - z * first,
            way_of_velocity: seconds * first,
            way_of_acceleration: seconds * seconds * second,
        }
    }
}
