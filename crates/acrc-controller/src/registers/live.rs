//! Parameters that follow from the state of the machine: positions, scaling, velocity, the clock.

use acrc_catalog::{Law, law};
use acrc_vm::Value;

use super::map::{Kind, map};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::motion::Preload;

/// What a parameter follows from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Live {
    /// Where the coordinated profiler has the axis, in pulses.
    Coordinated,
    /// Where it is, in pulses.
    Actual,
    /// The sum of its profilers, in pulses.
    PrimarySetpoint,
    /// The same with compensation.
    SecondarySetpoint,
    /// Its gear offset, in pulses.
    GearOffset,
    /// Its jog offset, in pulses.
    JogOffset,
    /// Its velocity, in units/s.
    Velocity,
    /// Its acceleration, in units/s^2.
    Acceleration,
    /// The velocity of its jog profiler, in units/s.
    JogVelocity,
    /// The acceleration of its jog profiler, in units/s^2.
    JogAcceleration,
    /// Where the moves given so far will leave it, in pulses.
    Target,
    /// Setpoint minus actual position, in pulses; an ideal machine keeps it at 0.
    FollowingError,
    PulsesPerUnit,
    /// The count of the encoder that measures the axis.
    Encoder,
    VectorVelocity,
    /// Milliseconds since power-up, or since it was set.
    Clock,
    /// Ten times the cyclic period of the `CANopen` network.
    HealthPeriod,
}

const LIVE: [(Law, Live); 18] = [
    (law::CURRENT_POSITION, Live::Coordinated),
    (law::ACTUAL_POSITION, Live::Actual),
    (law::PRIMARY_SETPOINT, Live::PrimarySetpoint),
    (law::SECONDARY_SETPOINT, Live::SecondarySetpoint),
    (law::GEAR_OFFSET, Live::GearOffset),
    (law::JOG_OFFSET, Live::JogOffset),
    (law::VELOCITY, Live::Velocity),
    (law::ACCELERATION, Live::Acceleration),
    (law::JOG_VELOCITY_CURRENT, Live::JogVelocity),
    (law::JOG_ACCELERATION_CURRENT, Live::JogAcceleration),
    (law::TARGET_POSITION, Live::Target),
    (law::FOLLOWING_ERROR, Live::FollowingError),
    (law::PPU, Live::PulsesPerUnit),
    (law::ENCODER_POSITION, Live::Encoder),
    (law::VECTOR_VELOCITY, Live::VectorVelocity),
    (law::MASTER_SPEED, Live::VectorVelocity),
    (law::CLOCK_MS, Live::Clock),
    (law::HEALTH_PERIOD, Live::HealthPeriod),
];

/// The health period in cyclic periods.
const CYCLES_OF_HEALTH: i32 = 10;

impl Live {
    /// What a parameter follows from, if it does.
    pub(crate) fn of(number: u32) -> Option<Self> {
        LIVE.iter().find(|(law, _)| law.index_of(number).is_some()).map(|(_, live)| *live)
    }
}

impl Machine {
    /// Whether a parameter changes although nothing happens.
    pub(crate) fn follows_time(number: i64) -> bool {
        let parameter = u32::try_from(number).ok().and_then(|number| map().parameter(number));
        parameter.is_some_and(|parameter| parameter.kind == Kind::Live(Live::Clock))
    }

    /// The value of a parameter of an object. `None` when the model has no such object.
    pub(super) fn live_parameter(&self, live: Live, object: u8) -> Option<Value> {
        let axis = self.axes.get(usize::from(object));
        Some(match live {
            Live::Coordinated => Value::Long(axis?.pulses(self.position(object))),
            Live::Actual => Value::Long(axis?.pulses(self.registers_of(object).actual)),
            Live::PrimarySetpoint => Value::Long(axis?.pulses(self.registers_of(object).primary_setpoint())),
            Live::SecondarySetpoint => Value::Long(axis?.pulses(self.registers_of(object).secondary_setpoint())),
            Live::GearOffset => Value::Long(axis?.pulses(self.registers_of(object).gear)),
            Live::JogOffset => Value::Long(axis?.pulses(axis?.profilers.jog.offset())),
            Live::Velocity => Value::Single(axis.map(|_| self.motion(object).0)? as f32),
            Live::Acceleration => Value::Single(axis.map(|_| self.motion(object).1)? as f32),
            Live::JogVelocity => Value::Single(axis?.profilers.jog.state().velocity as f32),
            Live::JogAcceleration => Value::Single(axis?.profilers.jog.state().acceleration as f32),
            Live::Target => Value::Long(axis?.pulses(self.target(object))),
            Live::FollowingError => Value::Long(axis?.pulses(self.registers_of(object).following_error())),
            Live::PulsesPerUnit => Value::Single(axis?.pulses_per_unit as f32),
            Live::Encoder => Value::Long(self.encoder_count(object)?),
            Live::VectorVelocity => Value::Single(self.masters.get(usize::from(object))?.vector_velocity() as f32),
            Live::Clock => Value::Long(self.clock_milliseconds()),
            Live::HealthPeriod => {
                let cycle = self.registers.number(law::CYCLIC_PERIOD.at(0)) as i32;
                Value::Long(cycle.saturating_mul(CYCLES_OF_HEALTH))
            }
        })
    }

    /// Changes the state of the machine that a parameter follows from. False when a write changes nothing of it.
    pub(super) fn write_live_parameter(
        &mut self,
        live: Live,
        object: u8,
        real: f64,
        long: i32,
    ) -> Result<bool, ControllerError> {
        let axis = self.axes.get(usize::from(object));
        match live {
            Live::Coordinated | Live::Target => {
                if let Some(units) = axis.map(|axis| axis.units(real)) {
                    self.preload(object, Preload::Coordinated(units))?;
                }
            }
            Live::Actual | Live::PrimarySetpoint | Live::SecondarySetpoint => {
                if let Some(units) = axis.map(|axis| axis.units(real)) {
                    self.preload(object, Preload::Actual(units))?;
                }
            }
            Live::GearOffset => {
                if let Some(units) = axis.map(|axis| axis.units(real)) {
                    self.preload(object, Preload::Gear(units))?;
                }
            }
            Live::JogOffset => {
                if let Some(units) = axis.map(|axis| axis.units(real)) {
                    self.preload(object, Preload::Jog(units))?;
                }
            }
            Live::PulsesPerUnit => self.set_pulses_per_unit(object, real)?,
            Live::Encoder if axis.is_some() => self.set_encoder(object, long),
            Live::Clock => self.clock_base = (self.clock.ticks(), long),
            Live::Encoder => return Ok(false),
            Live::FollowingError
            | Live::Velocity
            | Live::Acceleration
            | Live::JogVelocity
            | Live::JogAcceleration
            | Live::VectorVelocity
            | Live::HealthPeriod => {}
        }
        Ok(true)
    }

    /// The count of an encoder. `None` when the model has no such object.
    pub(crate) fn encoder_count(&self, encoder: u8) -> Option<i32> {
        let offset = *self.encoder_offsets.get(usize::from(encoder))?;
        Some(self.axes.get(usize::from(encoder))?.pulses(self.registers_of(encoder).actual).wrapping_add(offset))
    }

    /// Gives an encoder's register another count without moving its axis.
    pub(crate) fn set_encoder(&mut self, axis: u8, count: i32) {
        let actual = self.axes[usize::from(axis)].pulses(self.registers_of(axis).actual);
        let before = std::mem::replace(&mut self.encoder_offsets[usize::from(axis)], count.wrapping_sub(actual));
        self.renumber_encoder(axis, before, count.wrapping_sub(actual));
    }

    /// The count of an encoder is another one without a motion.
    pub(crate) fn renumber_encoder(&mut self, axis: u8, before: i32, after: i32) {
        let renumbered = &mut self.renumbered[usize::from(axis)];
        *renumbered = renumbered.wrapping_add(after).wrapping_sub(before);
    }

    /// What an encoder has counted of motions alone. `None` when the model has no such object.
    pub(crate) fn encoder_travel(&self, encoder: u8) -> Option<i32> {
        let renumbered = *self.renumbered.get(usize::from(encoder))?;
        Some(self.encoder_count(encoder)?.wrapping_sub(renumbered))
    }
}
