//! A whole axis in ticks: nothing is allocated, and the bits are the same on every machine and with every feature.

use acrc_motion::axis::{
    AxisProfilers, Backlash, BacklashRule, CamSegment, CamSettings, Gear, GearSettings, HomeInputs, HomingOptions,
    JogSettings, Side, SourceCounts, TravelLimits,
};
use acrc_motion::servo::{Dac, Drive, Encoder, Motor, MotorModel, Plant, Servo, ServoGains, ServoInputs};

const TICK: f64 = 0.0005;
const PULSES_PER_UNIT: f64 = 4000.0;

/// Of everything below. It changes only when the motion does.
const DIGEST: u64 = 0xf2a9_0228_86bf_de47;

/// Adds the bits of a number to a digest (FNV-1a).
fn digest(seed: u64, value: f64) -> u64 {
    value.to_le_bytes().iter().fold(seed, |digest, byte| (digest ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

struct Machine {
    profilers: AxisProfilers,
    limits: TravelLimits,
    servo: Servo,
    dac: Dac,
    plant: Plant,
    digest: u64,
}

impl Machine {
    fn new() -> Self {
        let mut profilers = AxisProfilers::default();
        let settings = JogSettings {
            velocity: 3.0,
            acceleration: 20.0,
            deceleration: 30.0,
            jerk: 400.0,
            home_velocity: 0.2,
            ..JogSettings::default()
        };
        profilers.jog.set_settings(settings).unwrap();
        profilers.gear = Gear::default();
        let gear = GearSettings { pulses_per_unit: 3000.0, ratio: -0.7, acceleration: 9.0, ..GearSettings::default() };
        profilers.gear.set_settings(gear).unwrap();
        profilers.hand_wheel.set_settings(settings, 0.001).unwrap();
        profilers.cam.dim(2);
        profilers.cam.set_segment(0, CamSegment { length: 700.0, points: 5 }).unwrap();
        profilers.cam.set_segment(1, CamSegment { length: 300.0, points: 3 }).unwrap();
        profilers.cam.set_settings(CamSettings { scale: 0.3, ..CamSettings::default() }).unwrap();
        profilers.backlash = Backlash::new(0.01, BacklashRule::PositiveTravel);
        let mut servo = Servo::new(TICK).unwrap();
        let gains = ServoGains {
            proportional: 0.005,
            integral: 0.01,
            integral_limit: 0.5,
            derivative: 3e-5,
            velocity_feedforward: 2e-6,
            notch: (180.0, 30.0),
            low_pass: 400.0,
            ..ServoGains::default()
        };
        servo.set_gains(gains).unwrap();
        let motor = Motor::new(MotorModel {
            inertia: 2e-5,
            torque_per_volt: 0.63,
            viscous_friction: 4e-4,
            coulomb_friction: 0.002,
            load_torque: 0.01,
            encoder: Encoder::new(1000.0, 4).unwrap(),
        });
        let plant = Plant::Motor(motor.unwrap());
        let digest = 0xcbf2_9ce4_8422_2325;
        Self { profilers, limits: TravelLimits::default(), servo, dac: Dac::default(), plant, digest }
    }

    fn tick(&mut self, tick: u32) {
        match tick {
            100 => self.profilers.jog.to_offset(2.5).unwrap(),
            900 => self.profilers.jog.run(Side::Negative),
            1000 => self.profilers.gear.on(),
            1300 => self.profilers.hand_wheel.on(),
            1500 => self.profilers.jog.off(),
            1700 => self.profilers.cam.on(),
            2400 => self.profilers.gear.off(),
            3000 => self.profilers.stop(0.3, 25.0).unwrap(),
            4000 => {
                let AxisProfilers { homing, jog, .. } = &mut self.profilers;
                let options = HomingOptions { backup: true, ..HomingOptions::default() };
                homing.start(jog, Side::Positive, options, HomeInputs::default(), 100.0).unwrap();
            }
            _ => {}
        }
        let counts = SourceCounts {
            gear: f64::from(tick % 7),
            hand_wheel: f64::from(tick % 3),
            cam: f64::from(tick % 5),
            ..SourceCounts::clock(TICK)
        };
        self.profilers.advance(&counts, TICK, &|segment, index| (segment + 2 * index) as f64 / 7.0, &|_, _| 0.0);
        let actual = self.plant.counted();
        let registers = self.profilers.registers(0.1, actual / PULSES_PER_UNIT);
        let setpoint = registers.secondary_setpoint() * PULSES_PER_UNIT;
        let output = self.servo.update(&ServoInputs { setpoint, actual, moving: self.profilers.active() });
        self.plant.advance(&Drive { volts: self.dac.terminal(output.volts), setpoint, enabled: true }, TICK);
        let home = registers.primary_setpoint() > 0.5 && registers.primary_setpoint() < 0.9;
        let levels = HomeInputs { home, ..HomeInputs::default() };
        self.limits.update(levels, registers.primary_setpoint(), self.profilers.velocity(), false);
        let AxisProfilers { homing, jog, .. } = &mut self.profilers;
        homing.update(jog, self.limits.homing_inputs());
        self.digest = [setpoint, actual, output.volts, self.profilers.velocity()].into_iter().fold(self.digest, digest);
    }
}

#[test]
fn a_tick_of_an_axis_allocates_nothing() {
    let counts = allocation_counter::measure(|| drop(Machine::new()));
    assert!(counts.count_total > 0, "the counter counts");
    let mut machine = Machine::new();
    let measured = allocation_counter::measure(|| (0..8000).for_each(|tick| machine.tick(tick)));
    assert_eq!(measured.count_total, 0, "{measured:?}");
}

#[test]
fn an_axis_has_the_same_bits_everywhere() {
    let mut machine = Machine::new();
    (0..8000).for_each(|tick| machine.tick(tick));
    assert!(machine.plant.counted().abs() < 1e6 && machine.profilers.jog.offset() != 0.0);
    assert_eq!(machine.digest, DIGEST, "{:#018x}", machine.digest);
}
