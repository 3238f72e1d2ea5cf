//! The servo loop of one axis and the machines it can drive (the guide's "Servo Loop Fundamentals", "Following Error",
//! "Tuning Example"; PGAIN, IGAIN, ILIMIT, IDELAY, DGAIN, DWIDTH, FFVEL, FFACC, FBVEL, KVP, KVI, KVF, DZL, DZU, DIP, DIN,
//! NOTCH, LOPASS, TLM, DAC GAIN, DAC OFFSET, MULT).
//!
//! [`Servo::update`] makes one output from the secondary setpoint and the actual position, once a servo period. [`Dac`] and
//! [`Encoder`] are what lies between it and a [`Plant`]. Setpoints and positions are in pulses, since the gains are.
//!
//! `output = PGAIN·e + IGAIN·∫e + DGAIN·Δe/Δt + FFVEL·v + FFACC·a - FBVEL·v'`, where `e` is the following error, `v` and
//! `a` velocity and acceleration of the setpoint and `v'` the actual velocity. Then come the velocity loop, the dead zone,
//! the filters and the torque limit.
//!
//! # Assumptions
//!
//! - The output of the integral keeps within ILIMIT, so with an ILIMIT of zero there is none. While the setpoint moves, and
//!   for IDELAY after that, the integral stays as it is; with an IDELAY of zero it grows at all times.
//! - The velocity loop takes the output of the position loop plus `KVF·v` as the velocity to go at, in pulses/s, and gives
//!   `KVP` of the velocity error and `KVI` of its integral as the output; the integral keeps within the torque limit. It is
//!   in force when one of the three is not zero.
//! - DIP and DIN are added outside the dead zone: from nothing at an error of DZL to all at DZU.
//! - NOTCH and LOPASS are filters of second order; frequencies that the servo period cannot sample are no filter.

mod filter;
mod gains;
mod motor;
mod plant;
mod signals;

pub use gains::{DeadZone, ServoGains, VelocityLoop};
pub use motor::{Motor, MotorModel};
pub use plant::{Drive, Plant, Stepper};
pub use signals::{Dac, Encoder};

use filter::Biquad;

use crate::value::{InvalidValue, Quantity, not_negative};

/// What the loop sees in one period.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ServoInputs {
    /// Secondary setpoint, pulses.
    pub setpoint: f64,
    /// Actual position, pulses.
    pub actual: f64,
    /// A profiler moves the axis.
    pub moving: bool,
}

/// The terms of one period; all but the error in volts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ServoOutput {
    /// Setpoint minus actual position, pulses.
    pub following_error: f64,
    /// PGAIN.
    pub proportional: f64,
    /// IGAIN.
    pub integral: f64,
    /// DGAIN.
    pub derivative: f64,
    /// FFVEL.
    pub velocity_feedforward: f64,
    /// FFACC.
    pub acceleration_feedforward: f64,
    /// FBVEL, as it is taken off.
    pub velocity_feedback: f64,
    /// The output, within the torque limit.
    pub volts: f64,
    /// The torque limit has cut the output.
    pub limited: bool,
}

/// What a loop keeps from one period to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Memory {
    inputs: ServoInputs,
    setpoint_velocity: f64,
    integral: f64,
    /// Periods since the end of motion.
    still: u32,
    /// The error when the derivative was last sampled, and the periods since.
    sampled: f64,
    since_sample: u32,
    slope: f64,
    velocity_integral: f64,
}

/// The servo loop of one axis.
#[derive(Clone, Copy, Debug)]
pub struct Servo {
    gains: ServoGains,
    period: f64,
    notch: Option<Biquad>,
    low_pass: Option<Biquad>,
    /// `None` until the first period after a reset.
    memory: Option<Memory>,
    steady: bool,
}

impl Servo {
    /// A loop of a servo period in s (PERIOD), with the factory's gains.
    pub fn new(period: f64) -> Result<Self, InvalidValue> {
        if not_negative(Quantity::Time, period)? == 0.0 {
            return Err(InvalidValue { quantity: Quantity::Time, value: period });
        }
        Ok(Self { gains: ServoGains::default(), period, notch: None, low_pass: None, memory: None, steady: false })
    }

    /// The servo period, s.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Whether the last period has left the loop as it was: as long as its inputs and its gains stay the same, so does its
    /// output, however many periods pass.
    pub fn is_steady(&self) -> bool {
        self.steady
    }

    /// The gains in force.
    pub fn gains(&self) -> &ServoGains {
        &self.gains
    }

    /// Changes the gains; they act from the next period on. A filter that changes begins anew.
    pub fn set_gains(&mut self, gains: ServoGains) -> Result<(), InvalidValue> {
        gains.validate()?;
        if gains.notch != self.gains.notch {
            self.notch = Biquad::notch(gains.notch.0, gains.notch.1, self.period);
        }
        if gains.low_pass != self.gains.low_pass {
            self.low_pass = Biquad::low_pass(gains.low_pass, self.period);
        }
        self.gains = gains;
        self.steady = false;
        Ok(())
    }

    /// Forgets the past: for a drive that is enabled, or after positions were preset.
    pub fn reset(&mut self) {
        self.memory = None;
        self.steady = false;
        for filter in [&mut self.notch, &mut self.low_pass].into_iter().flatten() {
            filter.reset();
        }
    }

    /// Computes the output of one period.
    pub fn update(&mut self, inputs: &ServoInputs) -> ServoOutput {
        let error = inputs.setpoint - inputs.actual;
        let before = (self.memory, self.notch, self.low_pass);
        let mut memory = self.memory.unwrap_or(Memory { inputs: *inputs, sampled: error, ..Memory::default() });
        let velocity = (inputs.setpoint - memory.inputs.setpoint) / self.period;
        let acceleration = (velocity - memory.setpoint_velocity) / self.period;
        let actual_velocity = (inputs.actual - memory.inputs.actual) / self.period;
        let gains = &self.gains;
        let mut output = ServoOutput {
            following_error: error,
            proportional: gains.proportional * error,
            integral: integral(gains, &mut memory, inputs.moving, error, self.period),
            derivative: gains.derivative * slope(gains, &mut memory, error, self.period),
            velocity_feedforward: gains.velocity_feedforward * velocity,
            acceleration_feedforward: gains.acceleration_feedforward * acceleration,
            velocity_feedback: gains.velocity_feedback * actual_velocity,
            volts: 0.0,
            limited: false,
        };
        let mut volts = output.proportional
            + output.integral
            + output.derivative
            + output.velocity_feedforward
            + output.acceleration_feedforward
            - output.velocity_feedback;
        if !gains.velocity_loop.is_off() {
            volts = velocity_loop(gains, &mut memory, volts, [velocity, actual_velocity], self.period);
        }
        volts += gains.dead_zone.added(error);
        for filter in [&mut self.notch, &mut self.low_pass].into_iter().flatten() {
            volts = filter.apply(volts);
        }
        output.volts = gains.torque_limit.clamp(volts);
        output.limited = output.volts != volts;
        let memory = Memory { inputs: *inputs, setpoint_velocity: velocity, ..memory };
        self.memory = Some(memory);
        // The count of periods at rest alone does not matter once the integral may grow.
        let counted = |before: Memory| Memory { still: memory.still, ..before };
        self.steady = grows(gains, &memory, self.period)
            && (before.0.map(counted), before.1, before.2) == (self.memory, self.notch, self.low_pass);
        output
    }
}

/// Whether the integral may grow.
fn grows(gains: &ServoGains, memory: &Memory, period: f64) -> bool {
    // Half a period keeps a delay that is a whole number of them from being missed by rounding, here and below.
    gains.integral_delay == 0.0 || (f64::from(memory.still) - 0.5) * period > gains.integral_delay
}

fn integral(gains: &ServoGains, memory: &mut Memory, moving: bool, error: f64, period: f64) -> f64 {
    memory.still = if moving { 0 } else { memory.still.saturating_add(1) };
    if grows(gains, memory, period) {
        let grown = memory.integral + gains.integral * error * period;
        memory.integral = grown.clamp(-gains.integral_limit, gains.integral_limit);
    }
    memory.integral
}

/// Change of the error per second, sampled at the derivative width.
fn slope(gains: &ServoGains, memory: &mut Memory, error: f64, period: f64) -> f64 {
    memory.since_sample = memory.since_sample.saturating_add(1);
    let periods = f64::from(memory.since_sample);
    if (periods + 0.5) * period > gains.derivative_width {
        memory.slope = (error - memory.sampled) / (periods * period);
        memory.sampled = error;
        memory.since_sample = 0;
    }
    memory.slope
}

fn velocity_loop(gains: &ServoGains, memory: &mut Memory, command: f64, velocities: [f64; 2], period: f64) -> f64 {
    let [setpoint, actual] = velocities;
    let values = gains.velocity_loop;
    let error = command + values.feedforward * setpoint - actual;
    let grown = memory.velocity_integral + values.integral * error * period;
    memory.velocity_integral = gains.torque_limit.clamp(grown);
    values.proportional * error + memory.velocity_integral
}
