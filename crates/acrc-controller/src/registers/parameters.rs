//! Reading and writing parameters by number.

use acrc_catalog::parameter;
use acrc_vm::{Value, format};

use super::map::{Kind, Owner, Parameter, map};
use crate::error::ControllerError;
use crate::flags::{FIRST_WORD, Flags};
use crate::machine::Machine;

impl Machine {
    /// Gives every parameter the value that it has at power-up.
    pub(crate) fn set_defaults(&mut self) {
        for (number, value) in map().defaults() {
            let parameter = map().parameter(*number).filter(|parameter| self.has(parameter.owner, parameter.object));
            if let Some(parameter) = parameter {
                let fits = self.registers.set(*number, parameter.form, &Value::Double(*value));
                debug_assert!(fits, "P{number} cannot be {value}");
            }
        }
    }

    /// The value of a parameter.
    pub(crate) fn read_parameter(&self, number: i64) -> Result<Value, ControllerError> {
        let index = u32::try_from(number).map_err(|_| ControllerError::UnknownParameter(number))?;
        if index < FIRST_WORD {
            let value = self.memory.user(index as usize);
            return value.map(Value::Double).ok_or_else(|| self.outside_user(number));
        }
        if let Some(word) = self.flags.word(index) {
            return Ok(Value::Long(word as i32));
        }
        let Some(Parameter { kind, form, object, .. }) = map().parameter(index) else {
            return Err(ControllerError::UnknownParameter(number));
        };
        let live = match kind {
            Kind::Live(live) => self.live_parameter(live, object),
            Kind::Plain | Kind::Undocumented => None,
        };
        Ok(live.unwrap_or_else(|| self.registers.get(index, form)))
    }

    /// Stores a value in a parameter.
    pub(crate) fn write_parameter(&mut self, number: i64, value: &Value) -> Result<(), ControllerError> {
        let index = u32::try_from(number).map_err(|_| ControllerError::UnknownParameter(number))?;
        let (Ok(real), Ok(long)) = (value.to_f64(), value.to_long()) else {
            return Err(ControllerError::ParameterRange { number, value: format::number(value) });
        };
        if index < FIRST_WORD {
            let outside = self.memory.user_count();
            let place = self.memory.user_mut(index as usize);
            *place.ok_or(ControllerError::UserParameter { number, count: outside })? = real;
            return Ok(());
        }
        let Some(entry) = map().parameter(index) else { return Err(ControllerError::UnknownParameter(number)) };
        if entry.read_only {
            return Err(ControllerError::ReadOnly { name: format!("P{number}"), title: parameter(index).title });
        }
        if self.flags.word(index).is_some() {
            return self.write_word(index, long as u32);
        }
        if self.is_missing(entry.owner, entry.object) {
            return Ok(());
        }
        if let Kind::Live(live) = entry.kind
            && self.write_live_parameter(live, entry.object, real, long)?
        {
            return Ok(());
        }
        if entry.kind == Kind::Undocumented {
            self.note_undocumented(format_args!("P{number}"));
        }
        let acts = entry.owner == Owner::Axis || Self::scales_output(index);
        let before = acts.then(|| self.registers.get(index, entry.form));
        if self.registers.set(index, entry.form, value) {
            match before {
                Some(before) if before == self.registers.get(index, entry.form) => {}
                Some(_) if entry.owner == Owner::Axis => self.motion.touch_axis(entry.object),
                Some(_) => self.motion.touch(),
                None => {}
            }
            return Ok(());
        }
        Err(ControllerError::ParameterRange { number, value: format::number(value) })
    }

    /// Gives a parameter a value from outside, whether programs may write it or not.
    pub(crate) fn script_parameter(&mut self, number: u32, value: f64) {
        let fits = if number < FIRST_WORD {
            self.memory.user_mut(number as usize).map(|place| *place = value).is_some()
        } else {
            map().parameter(number).is_some_and(|entry| self.registers.set(number, entry.form, &Value::Double(value)))
        };
        self.motion.touch();
        if !fits {
            self.notes.insert(format!("an event gives P{number} a value for which the controller has no room"));
        }
    }

    /// Takes note that the run reads a number that no document names.
    pub(crate) fn note_read(&mut self, number: i64) {
        let parameter = u32::try_from(number).ok().and_then(|number| map().parameter(number));
        if parameter.is_some_and(|parameter| parameter.kind == Kind::Undocumented) {
            self.note_undocumented(format_args!("P{number}"));
        }
    }

    /// The same for a flag.
    pub(crate) fn note_read_bit(&mut self, number: i64) {
        if number >= map().documented_flags() && u32::try_from(number).is_ok_and(Flags::contains) {
            self.note_undocumented(format_args!("BIT{number}"));
        }
    }

    #[cold]
    pub(super) fn note_undocumented(&mut self, name: std::fmt::Arguments) {
        self.notes.insert(format!("no document names {name}: it keeps what is written"));
    }

    /// Whether the model has an object.
    pub(crate) fn has(&self, owner: Owner, object: u8) -> bool {
        object < self.count(owner)
    }

    /// Whether a parameter or flag belongs to an object that the model lacks: it stays 0, and the run says so.
    pub(super) fn is_missing(&mut self, owner: Owner, object: u8) -> bool {
        let missing = !self.has(owner, object);
        if missing {
            let (kind, model, last) = (owner.name(), self.model.name, self.count(owner).saturating_sub(1));
            self.notes.insert(format!(
                "parameters and flags of {kind} {object} were written and stay 0: the {model} has {kind} 0 to {last}"
            ));
        }
        missing
    }

    fn count(&self, owner: Owner) -> u8 {
        match owner {
            Owner::None => u8::MAX,
            Owner::Axis => self.model.axes,
            Owner::Master => self.model.masters,
            Owner::Program => self.model.programs,
            Owner::Plc => self.model.plcs,
        }
    }

    pub(crate) fn outside_user(&self, number: i64) -> ControllerError {
        ControllerError::UserParameter { number, count: self.memory.user_count() }
    }
}

impl Owner {
    const fn name(self) -> &'static str {
        match self {
            Self::None => "object",
            Self::Axis => "axis",
            Self::Master => "master",
            Self::Program => "program",
            Self::Plc => "PLC program",
        }
    }
}
