//! The settings of the axes as their profilers take them. Parameters, flags and kept settings stay the only memory; this reads them when one of them
//! has been written.

use acrc_catalog::{CommandId, command, law};
use acrc_motion::axis::{CamSettings, GearSettings, JogSettings, LimitSettings, Sides, Window, limit_inputs};

use super::word_bit;
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::settings::Item;

impl Machine {
    /// Gives the profilers of which a setting was written the settings of now.
    pub(crate) fn refresh_axes(&mut self) {
        let stale = std::mem::take(&mut self.motion.stale);
        for axis in (0..self.model.axes).filter(|axis| stale >> axis & 1 == 1) {
            // A value that a profiler does not take leaves it with what it has.
            let refreshed = [self.refresh_axis(axis), self.refresh_followers(axis), self.refresh_mechanism(axis)];
            for error in refreshed.into_iter().filter_map(Result::err) {
                self.notes.insert(format!("AXIS{axis}: {error}; the value before stays in force"));
            }
        }
        if stale != 0 {
            let inputs = self.axes.iter().flat_map(|axis| axis.switches).flatten();
            self.motion.switch_words = inputs.fold(0, |words, input| words | word_bit(input));
            let guarded = self.axes.iter().zip(0..).map(|(axis, number)| u32::from(axis.is_guarded()) << number);
            self.motion.guarded = guarded.fold(0, |axes, axis| axes | axis);
        }
        if std::mem::take(&mut self.motion.objects_stale) {
            self.refresh_gates();
            self.refresh_limit_switches();
            self.refresh_sampling();
        }
    }

    /// Gear, hand wheel, cam and compensation.
    fn refresh_followers(&mut self, axis: u8) -> Result<(), ControllerError> {
        let mut followers = self.axes[usize::from(axis)].followers;
        for (follower, source) in [
            (&mut followers.jog, command::JOG_SRC),
            (&mut followers.gear, command::GEAR_SRC),
            (&mut followers.hand_wheel, command::HDW_SRC),
            (&mut followers.cam, command::CAM_SRC),
            (&mut followers.ballscrew, command::BSC_SRC),
        ] {
            self.refollow(follower, source, u16::from(axis));
        }
        self.axes[usize::from(axis)].followers = followers;
        let value = |command| self.axis_setting(command, axis);
        let gear = GearSettings {
            pulses_per_unit: value(command::GEAR_PPU),
            ratio: value(command::GEAR_RATIO),
            acceleration: value(command::GEAR_ACC),
            deceleration: value(command::GEAR_DEC),
            limits: Window { positive: value(command::GEAR_MAX), negative: value(command::GEAR_MIN) },
        };
        let wheel = JogSettings {
            velocity: value(command::HDW_VEL),
            acceleration: value(command::HDW_ACC),
            deceleration: value(command::HDW_DEC),
            jerk: value(command::HDW_JRK),
            ..JogSettings::default()
        };
        let cam = |scale, offset, source_offset| CamSettings {
            scale: value(scale),
            offset: value(offset),
            source_offset: value(source_offset),
            cycles: 0,
        };
        let cams = (
            cam(command::CAM_SCALE, command::CAM_OFFSET, command::CAM_FLZ),
            cam(command::BSC_SCALE, command::BSC_OFFSET, command::BSC_FLZ),
        );
        let backlash = value(command::BKL);
        let rule = self.backlash;
        let profilers = &mut self.axes[usize::from(axis)].profilers;
        let cycles = profilers.cam.settings().cycles;
        (profilers.backlash.value, profilers.backlash.rule) = (backlash, rule);
        profilers.gear.set_settings(gear).map_err(refused)?;
        profilers.hand_wheel.set_settings(wheel, 1.0 / gear.pulses_per_unit).map_err(refused)?;
        profilers.cam.set_settings(CamSettings { cycles, ..cams.0 }).map_err(refused)?;
        profilers.ballscrew.set_settings(cams.1).map_err(refused)
    }

    /// Passes after which the cam of an axis goes off; 0 for none.
    pub(crate) fn set_cam_cycles(&mut self, axis: u8, cycles: u32) {
        let cam = &mut self.axes[usize::from(axis)].profilers.cam;
        let changed = cam.set_settings(CamSettings { cycles, ..*cam.settings() });
        debug_assert!(changed.is_ok(), "the other settings were taken before");
    }

    fn refresh_axis(&mut self, axis: u8) -> Result<(), ControllerError> {
        let jog = JogSettings {
            velocity: self.axis_setting(command::JOG_VEL, axis),
            acceleration: self.axis_setting(command::JOG_ACC, axis),
            deceleration: self.axis_setting(command::JOG_DEC, axis),
            jerk: self.axis_setting(command::JOG_JRK, axis),
            home_velocity: self.axis_setting(command::JOG_HOMVF, axis),
            limits: self.axis_window(command::JLM, axis),
        };
        let limits = LimitSettings {
            hardware: self.sides(law::POS_LIMIT_ENABLE, law::NEG_LIMIT_ENABLE, axis),
            software: self.sides(law::POS_SOFT_LIMIT_ENABLE, law::NEG_SOFT_LIMIT_ENABLE, axis),
            inverted: self.sides(law::POS_LIMIT_INVERT, law::NEG_LIMIT_INVERT, axis),
            home_inverted: self.flags.get(law::HOME_INVERT.at(u32::from(axis))),
            travel: self.axis_window(command::SLM, axis),
            hardware_deceleration: self.axis_setting(command::HLDEC, axis),
            software_deceleration: self.axis_setting(command::SLDEC, axis),
        };
        let latched = self.sides(law::POS_LIMIT_HIT, law::NEG_LIMIT_HIT, axis);
        let switches = self.switches(axis);
        let state = &mut self.axes[usize::from(axis)];
        state.switches = switches;
        state.limits.set_latched(latched);
        state.limits.set_settings(limits).map_err(refused)?;
        state.profilers.jog.set_settings(jog).map_err(refused)
    }

    /// The inputs of the limits of an axis: three in a row, or each by itself.
    fn switches(&self, axis: u8) -> [Option<u32>; 3] {
        let input = |value: f64| (0.0..=f64::from(u32::MAX)).contains(&value).then_some(value as u32);
        let mut values = self.axis_settings(command::HLBIT, axis).map(input);
        match [values.next(), values.next(), values.next()] {
            [positive, Some(negative), home] => [positive.flatten(), negative, home.flatten()],
            [first, ..] => first.flatten().map_or([None; 3], limit_inputs),
        }
    }

    /// The first value of a setting; 0 if it is none.
    pub(crate) fn axis_setting(&self, command: CommandId, axis: u8) -> f64 {
        self.axis_settings(command, axis).next().unwrap_or(0.0)
    }

    /// The two ends that a setting gives, the upper one first.
    pub(crate) fn axis_window(&self, command: CommandId, axis: u8) -> Window {
        let mut ends = self.axis_settings(command, axis);
        Window { positive: ends.next().unwrap_or(0.0), negative: ends.next().unwrap_or(0.0) }
    }

    /// The first value of a setting of any object; 0 if it is none.
    pub(crate) fn first_setting(&self, command: CommandId, object: u16) -> f64 {
        self.numbers(command, object).next().unwrap_or(0.0)
    }

    fn axis_settings(&self, command: CommandId, axis: u8) -> impl Iterator<Item = f64> + use<> {
        self.numbers(command, u16::from(axis))
    }

    fn numbers(&self, command: CommandId, object: u16) -> impl Iterator<Item = f64> + use<> {
        let items = self.setting(command, object).unwrap_or_default();
        items.into_iter().filter_map(|item| match item {
            Item::Number(value) => value.to_f64().ok(),
            Item::Source(_) | Item::Factory(_) => None,
        })
    }

    fn sides(&self, positive: acrc_catalog::Law, negative: acrc_catalog::Law, axis: u8) -> Sides {
        let flag = |law: acrc_catalog::Law| self.flags.get(law.at(u32::from(axis)));
        Sides { positive: flag(positive), negative: flag(negative) }
    }
}

pub(crate) fn refused(error: acrc_motion::InvalidValue) -> ControllerError {
    ControllerError::Move(error.to_string())
}
