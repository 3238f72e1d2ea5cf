//! The values of all parameters that are plain memory, by number.

use acrc_vm::Value;

use super::map::{Form, map};
use crate::flags::FIRST_WORD;

/// The memory. Every parameter has a place, so that reading one costs no search.
#[derive(Clone, Debug)]
pub(crate) struct Registers {
    /// From [`FIRST_WORD`] on; the places of the flag words are not used.
    values: Vec<f64>,
}

impl Registers {
    /// Every parameter is 0.
    pub(crate) fn new() -> Self {
        Self { values: vec![0.0; map().parameters()] }
    }

    /// The value of a parameter; 0 for those without a place.
    pub(crate) fn number(&self, number: u32) -> f64 {
        let place = number.checked_sub(FIRST_WORD);
        place.and_then(|place| self.values.get(place as usize)).copied().unwrap_or(0.0)
    }

    /// The value of a parameter in its form.
    pub(crate) fn get(&self, number: u32, form: Form) -> Value {
        let value = self.number(number);
        match form {
            Form::Long => Value::Long(value as i32),
            Form::Unknown if is_long(value) => Value::Long(value as i32),
            Form::Single | Form::Unknown => Value::Single(value as f32),
        }
    }

    /// Stores a value in the form of the parameter. False when it is beyond the range of that form.
    #[must_use]
    pub(crate) fn set(&mut self, number: u32, form: Form, value: &Value) -> bool {
        let stored = match (form, value) {
            (Form::Long, _) | (Form::Unknown, Value::Long(_)) => value.to_long().map(f64::from),
            (Form::Single | Form::Unknown, _) => value.to_f64().map(|real| f64::from(real as f32)),
        };
        let place = number.checked_sub(FIRST_WORD).and_then(|place| self.values.get_mut(place as usize));
        match (place, stored) {
            (Some(place), Ok(stored)) if stored.is_finite() => *place = stored,
            _ => return false,
        }
        true
    }
}

fn is_long(value: f64) -> bool {
    value.trunc() == value && (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&value)
}
