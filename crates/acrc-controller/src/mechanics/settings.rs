//! The settings of the servo loop and of the bands, as the mechanics take them.

use acrc_catalog::{CommandId, command, law};
use acrc_motion::axis::Bands;
use acrc_motion::servo::{Dac, DeadZone, Encoder, Plant, Servo, ServoGains, VelocityLoop};

use super::Mechanism;
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::motion::refused;
use crate::world::PlantWorld;

impl Machine {
    /// Gives the mechanics of an axis the settings of now.
    pub(crate) fn refresh_mechanism(&mut self, axis: u8) -> Result<(), ControllerError> {
        if self.mechanics.of(axis).is_none() {
            return Ok(());
        }
        let bands = Bands {
            in_position: self.axis_window(command::IPB, axis),
            excess_error: self.axis_window(command::EXC, axis),
            torque: self.axis_window(command::ITB, axis),
            stroke_a: self.axis_window(command::ALM, axis),
            stroke_b: self.axis_window(command::BLM, axis),
        };
        let (encoder, dac_number) = self.attached_signals(axis);
        let dac = Dac {
            gain: self.first_setting(command::DAC_GAIN, u16::from(dac_number)),
            offset: self.first_setting(command::DAC_OFFSET, u16::from(dac_number)),
        };
        let gains = self.servo_gains(axis);
        let multiplier = self.multiplier(axis, encoder);
        let period = self.clock.period();
        let Some(mechanism) = self.mechanics.of_mut(axis) else { return Ok(()) };
        bands.validate().map_err(refused)?;
        (mechanism.bands, mechanism.dac, mechanism.dac_number) = (bands, dac, dac_number);
        mechanism.multiply(multiplier).map_err(refused)?;
        let Some(servo) = &mut mechanism.servo else { return Ok(()) };
        if servo.period() != period {
            *servo = Servo::new(period).map_err(refused)?;
        }
        if *servo.gains() == gains { Ok(()) } else { servo.set_gains(gains).map_err(refused) }
    }

    /// Whether a parameter says how an analog output is scaled.
    pub(crate) fn scales_output(parameter: u32) -> bool {
        [law::DAC_GAIN, law::DAC_OFFSET].iter().any(|law| law.index_of(parameter).is_some())
    }

    fn servo_gains(&self, axis: u8) -> ServoGains {
        let value = |command: CommandId| self.axis_setting(command, axis);
        // Errors are in pulses, the ends of the dead zone in units.
        let scale = self.axes[usize::from(axis)].pulses_per_unit;
        let notch = self.axis_window(command::NOTCH, axis);
        ServoGains {
            proportional: value(command::PGAIN),
            integral: value(command::IGAIN),
            integral_limit: value(command::ILIMIT),
            integral_delay: value(command::IDELAY),
            derivative: value(command::DGAIN),
            derivative_width: value(command::DWIDTH),
            velocity_feedforward: value(command::FFVEL),
            acceleration_feedforward: value(command::FFACC),
            velocity_feedback: value(command::FBVEL),
            velocity_loop: VelocityLoop {
                proportional: value(command::KVP),
                integral: value(command::KVI),
                feedforward: value(command::KVF),
            },
            dead_zone: DeadZone {
                inner: value(command::DZL) * scale,
                outer: value(command::DZU) * scale,
                positive: value(command::DIP),
                negative: value(command::DIN),
            },
            notch: (notch.positive, notch.negative),
            low_pass: value(command::LOPASS),
            torque_limit: self.axis_window(command::TLM, axis),
        }
    }

    /// The encoder and the analog output of `ATTACH AXIS`; those with the number of the axis if it names none.
    fn attached_signals(&self, axis: u8) -> (u8, u8) {
        let signals = self.axes[usize::from(axis)].signals.as_deref().unwrap_or("");
        let number = |kind: &str| {
            let mut numbers = signals.split_whitespace().filter_map(|word| word.strip_prefix(kind)?.parse().ok());
            numbers.next().unwrap_or(axis)
        };
        (number("ENC"), number("DAC"))
    }

    /// The multiplier of an encoder: `ENC MULT`, or `MULT` of its axis where that says nothing.
    fn multiplier(&self, axis: u8, encoder: u8) -> i8 {
        match self.first_setting(command::ENC_MULT, u16::from(encoder)) as i8 {
            1 => self.axis_setting(command::MULT, axis) as i8,
            multiplier => multiplier,
        }
    }
}

impl Mechanism {
    /// Sets the multiplier of the encoder of a motor. What it has counted is counted anew, and the actual position stays.
    fn multiply(&mut self, multiplier: i8) -> Result<(), acrc_motion::InvalidValue> {
        let (PlantWorld::Motor(world), Plant::Motor(motor)) = (&self.world.plant, &mut self.plant) else {
            return Ok(());
        };
        let encoder = Encoder::new(world.lines, multiplier)?;
        if *motor.encoder() == encoder {
            return Ok(());
        }
        motor.set_encoder(encoder);
        let before = self.place;
        self.place = motor.counted();
        let change = self.place - before;
        (self.origin, self.load, self.looked) = (self.origin + change, self.load + change, self.place);
        Ok(())
    }
}
