//! Programmable limit switches: outputs that follow a parameter through a table (guide, command list: `PLS`).

use acrc_catalog::{CommandId, command};
use acrc_motion::source::LimitSwitch;
use acrc_vm::{Reference, Source, Value};

use super::tables::{ArrayPlace, Arrays};
use crate::machine::Machine;
use crate::settings::Item;

/// Limit switches of a controller.
pub(super) const LIMIT_SWITCHES: usize = 8;

/// One limit switch.
#[derive(Clone, Debug, Default)]
pub(super) struct Switch {
    on: bool,
    rule: LimitSwitch,
    source: Option<i64>,
    destination: Option<i64>,
    table: Option<ArrayPlace>,
}

impl Machine {
    /// Gives every limit switch the settings of now.
    pub(super) fn refresh_limit_switches(&mut self) {
        let mut switches = std::mem::take(&mut self.motion.limit_switches);
        for (number, switch) in (0..).zip(&mut switches) {
            switch.rule = LimitSwitch {
                source_offset: self.first_setting(command::PLS_FLZ, number),
                ratio: self.first_setting(command::PLS_RATIO, number),
                rotary: self.first_setting(command::PLS_ROTARY, number),
                mask: self.first_setting(command::PLS_MASK, number) as i64 as u32,
            };
            switch.source = self.parameter_setting(command::PLS_SRC, number);
            switch.destination = self.parameter_setting(command::PLS_DST, number);
        }
        self.motion.limit_switches = switches;
    }

    /// The parameter that a setting names.
    pub(super) fn parameter_setting(&self, command: CommandId, object: u16) -> Option<i64> {
        match self.setting(command, object).unwrap_or_default().first() {
            Some(Item::Source(Source::Reference(Reference::Parameter(number)))) => Some(*number),
            Some(Item::Factory(name)) => name.strip_prefix('P').and_then(|number| number.parse().ok()),
            _ => None,
        }
    }

    /// Names the array of a limit switch (`PLS BASE`).
    pub(crate) fn set_limit_switch_table(&mut self, number: usize, table: ArrayPlace) {
        if let Some(switch) = self.motion.limit_switches.get_mut(number) {
            switch.table = Some(table);
        }
    }

    /// Switches a limit switch on or off.
    pub(crate) fn set_limit_switch(&mut self, number: usize, on: bool) {
        if let Some(switch) = self.motion.limit_switches.get_mut(number) {
            switch.on = on;
        }
        self.motion.touch();
    }

    /// Lets the limit switches follow their sources.
    pub(super) fn advance_limit_switches(&mut self, arrays: &dyn Arrays) {
        for number in 0..self.motion.limit_switches.len() {
            let switch = &self.motion.limit_switches[number];
            if !switch.on {
                continue;
            }
            self.motion.awake = true;
            if let (Some(source), Some(destination), Some(table)) = (switch.source, switch.destination, switch.table) {
                let rule = switch.rule;
                self.switch_outputs(&rule, source, destination, |place| arrays.read(table, place));
            }
        }
    }

    fn switch_outputs(
        &mut self,
        rule: &LimitSwitch,
        source: i64,
        destination: i64,
        table: impl Fn(usize) -> Option<f64>,
    ) {
        let number = |value: Value| value.to_f64().ok();
        let value = self.read_parameter(source).ok().and_then(number);
        let Some(outputs) = value.and_then(|value| rule.place(value)).and_then(table) else { return };
        let Ok(before) = self.read_parameter(destination).map(|value| value.to_long().unwrap_or(0) as u32) else {
            return;
        };
        let after = (before & !rule.mask) | (outputs as i64 as u32 & rule.mask);
        if after != before {
            // A destination that cannot be written stays as it is.
            let _ = self.write_parameter(destination, &Value::Long(after as i32));
        }
    }
}
