//! The system parameters: what `ESAVE` takes and `ELOAD` and power-up give back (guide, "Velocity Profile Setup", "Saved Parameters").

use std::collections::BTreeMap;
use std::sync::LazyLock;

use acrc_catalog::law;
use acrc_vm::Value;

use super::saved::{AxisParameters, MasterParameters, Slave, SystemParameters};
use crate::axis::{Axis, SlaveSlot};
use crate::error::ControllerError;
use crate::flags::{FIRST_WORD, Flags};
use crate::machine::Machine;
use crate::master::{Master, SLOTS};
use crate::registers::map::{Form, Kind, map};
use crate::settings::setting_flags;

/// The first of the retained user parameters of each kind, which controllers without battery keep in flash memory.
const RETAINED_WITHOUT_BATTERY: u32 = 64;

/// The first parameter that is no flag word.
const BEHIND_FLAGS: u32 = FIRST_WORD + Flags::WORDS;

impl Machine {
    /// The system parameters as they are now.
    pub(crate) fn system_parameters(&self) -> SystemParameters {
        let axis =
            |axis: &Axis| AxisParameters { pulses_per_unit: axis.pulses_per_unit, signals: axis.signals.clone() };
        let there = |number: u32| map().parameter(number).is_some_and(|entry| self.has(entry.owner, entry.object));
        let changed = plain_parameters().filter(|(number, _)| {
            there(*number) && self.registers.number(*number) as f32 != default_value(*number) as f32
        });
        let changed = changed.map(|(number, form)| (number, self.registers.get(number, form)));
        SystemParameters {
            period: self.clock.period(),
            axes: self.axes.iter().map(axis).collect(),
            masters: self.masters.iter().map(|master| self.master_parameters(master)).collect(),
            settings: self.settings.all().collect(),
            parameters: changed.filter(|(number, _)| retained_place(*number).is_none()).collect(),
            flags: setting_flags().filter(|flag| self.flags.get(*flag)).collect(),
        }
    }

    fn master_parameters(&self, master: &Master) -> MasterParameters {
        let names = master.program.map(|program| &self.attachments[usize::from(program)].names);
        let slaves = master.attached().filter_map(|(slot, axis)| {
            let name = names?[slot]?;
            Some(Slave { slot: slot as u8, axis, name, weight: master.profiler.weight(slot) })
        });
        MasterParameters {
            program: master.program,
            slaves: slaves.collect(),
            settings: master.settings,
            vector: master.vector,
            feedrate_override: master.profiler.feedrate_override(),
        }
    }

    /// Makes saved system parameters those in use. Nothing may move.
    pub(crate) fn load_system_parameters(&mut self, saved: &SystemParameters) -> Result<(), ControllerError> {
        if self.in_motion() {
            return Err(ControllerError::InMotion);
        }
        if self.clock.ticks() == 0 && saved.period > 0.0 {
            self.clock.set_period(saved.period);
        }
        self.detach_all()?;
        self.forget_parameters();
        for (number, value) in &saved.parameters {
            if !is_plain(*number) {
                return Err(ControllerError::UnknownParameter(i64::from(*number)));
            }
            self.write_parameter(i64::from(*number), value)?;
        }
        self.settings.replace(&saved.settings);
        for flag in setting_flags() {
            self.flags.set(flag, saved.flags.contains(&flag));
        }
        for (number, axis) in (0..).zip(&saved.axes) {
            Self::object("AXIS", number, self.model.axes)?;
            self.set_pulses_per_unit(number as u8, axis.pulses_per_unit)?;
            self.axes[number as usize].signals.clone_from(&axis.signals);
        }
        for (number, master) in (0..).zip(&saved.masters) {
            let number = Self::object("MASTER", number, self.model.masters)?;
            self.load_master(number, master)?;
        }
        self.motion.touch();
        Ok(())
    }

    fn load_master(&mut self, number: u8, saved: &MasterParameters) -> Result<(), ControllerError> {
        let refused = |error: acrc_motion::SettingError| ControllerError::Move(error.to_string());
        let master = &mut self.masters[usize::from(number)];
        master.settings = saved.settings;
        master.vector = saved.vector;
        master.profiler.set_vector(saved.vector).map_err(refused)?;
        master.profiler.set_feedrate_override(saved.feedrate_override).map_err(refused)?;
        self.restore_master(usize::from(number))?;
        let Some(program) = saved.program else { return Ok(()) };
        let program = Self::object("PROG", i64::from(program), self.model.programs)?;
        self.attach_master(program, number)?;
        for slave in &saved.slaves {
            let slot = Self::object("SLAVE", i64::from(slave.slot), self.model.slaves.min(SLOTS as u8))?;
            let axis = Self::object("AXIS", i64::from(slave.axis), self.model.axes)?;
            self.attach_slave(program, SlaveSlot { master: number, slot }, axis, slave.name)?;
            let profiler = &mut self.masters[usize::from(number)].profiler;
            profiler.set_weight(usize::from(slot), slave.weight).map_err(refused)?;
        }
        Ok(())
    }

    /// The retained user parameters that outlast a reset: all of them with a battery, else the first of each kind.
    pub(crate) fn retained(&self, battery: bool) -> Vec<(u32, Value)> {
        let kept =
            |number: u32| retained_place(number).is_some_and(|place| battery || place < RETAINED_WITHOUT_BATTERY);
        let set = plain_parameters().filter(|(number, _)| kept(*number) && self.registers.number(*number) != 0.0);
        set.map(|(number, form)| (number, self.registers.get(number, form))).collect()
    }

    /// Gives every parameter that `ESAVE` saves its default.
    fn forget_parameters(&mut self) {
        for (number, form) in plain_parameters().filter(|(number, _)| retained_place(*number).is_none()) {
            // Defaults fit the form of their parameter.
            let _ = self.registers.set(number, form, &Value::Double(default_value(number)));
        }
    }
}

/// The parameters that programs may write and that follow from nothing else, with their forms.
fn plain_parameters() -> impl Iterator<Item = (u32, Form)> {
    (FIRST_WORD..FIRST_WORD + map().parameters() as u32).filter_map(|number| {
        let parameter = map().parameter(number)?;
        let plain = !matches!(parameter.kind, Kind::Live(_)) && !parameter.read_only && number >= BEHIND_FLAGS;
        plain.then_some((number, parameter.form))
    })
}

fn is_plain(number: u32) -> bool {
    let parameter = map().parameter(number).filter(|_| number >= BEHIND_FLAGS);
    parameter.is_some_and(|parameter| !matches!(parameter.kind, Kind::Live(_)))
}

/// The value of a parameter at power-up.
fn default_value(number: u32) -> f64 {
    static DEFAULTS: LazyLock<BTreeMap<u32, f64>> = LazyLock::new(|| map().defaults().iter().copied().collect());
    DEFAULTS.get(&number).copied().unwrap_or(0.0)
}

/// Which of the retained user parameters of its kind a number is.
pub(crate) fn retained_place(number: u32) -> Option<u32> {
    law::USER_LONG.index_of(number).or_else(|| law::USER_FLOAT.index_of(number))
}
