//! Writing to memory by address (guide, "Binary Poke Command", "Binary Mask Command").

use acrc_vm::{Reference, Value};

use super::cell::{Cell, Conversion, Home};
use super::memory::addresses;
use super::{HostError, number, strings};
use crate::controller::{Controller, Observer};
use crate::error::ControllerError;
use crate::watch::Watch;

impl Controller {
    /// Writes the fields of a packet to memory, from an address on. What stands in front of a refused one is written.
    ///
    /// # Errors
    /// When nothing stands at one of the addresses, or something that only `DIM` changes, or something of another type than the
    /// conversion says; when a number would be infinite or none; when a parameter refuses its value.
    pub fn poke(
        &mut self,
        conversion: Conversion,
        address: u32,
        fields: &[u32],
        observer: &mut dyn Observer,
    ) -> Result<(), HostError> {
        for (address, field) in addresses(conversion, address).zip(fields) {
            self.poke_field(conversion, address?, *field, observer)?;
        }
        Ok(())
    }

    /// Clears the bits of `clear` in a long integer in memory, then sets those of `set`.
    ///
    /// # Errors
    /// When no long integer stands there, or it is a parameter that programs may not write.
    pub fn mask(&mut self, address: u32, clear: u32, set: u32, observer: &mut dyn Observer) -> Result<(), HostError> {
        let before = self.cell(address)?.long().ok_or(HostError::NotLongAt(address))?;
        self.poke_field(Conversion::Long, address, before & !clear | set, observer)
    }

    fn poke_field(
        &mut self,
        conversion: Conversion,
        address: u32,
        field: u32,
        observer: &mut dyn Observer,
    ) -> Result<(), HostError> {
        let wrong = HostError::Conversion { address, conversion };
        match self.cell(address)? {
            Cell::Fixed(_) => Err(HostError::Fixed(address)),
            Cell::Length { .. } | Cell::Characters { .. } if conversion != Conversion::Long => Err(wrong),
            Cell::Length { program, text, .. } => self.change_text(program, text, observer, |before, most| {
                let length = field;
                if length > most {
                    Err(HostError::TextLength { length, most })
                } else {
                    Ok(strings::resized(before, length))
                }
            }),
            Cell::Characters { program, text, word, .. } => {
                self.change_text(program, text, observer, |before, _| Ok(strings::replaced(before, word, field)))
            }
            number => {
                let (home, value) = number.converted(conversion, field).ok_or(wrong)?;
                let finite = value.to_f64().is_ok_and(f64::is_finite);
                if !finite {
                    return Err(HostError::NotFinite(number::single(&value).unwrap_or(f32::NAN)));
                }
                self.store_value(home, &value, observer)
            }
        }
    }

    fn change_text(
        &mut self,
        program: u8,
        text: Reference,
        observer: &mut dyn Observer,
        change: impl FnOnce(&acrc_vm::Text, u32) -> Result<acrc_vm::Text, HostError>,
    ) -> Result<(), HostError> {
        let before = self.programs.get(usize::from(program)).and_then(|program| program.locals.text(text));
        let Some((before, most)) = before else { return Ok(()) };
        let after = change(before, most)?;
        self.store_value(Home::Local(program, text), &Value::Text(after), observer)
    }

    fn store_value(&mut self, home: Home, value: &Value, observer: &mut dyn Observer) -> Result<(), HostError> {
        match home {
            Home::Parameter(number) => self.set_parameter_value(number, value, observer),
            Home::Local(program, reference) => {
                let Some(program) = self.programs.get_mut(usize::from(program)) else { return Ok(()) };
                let written = program.locals.write(reference, value).map_err(ControllerError::Program);
                // Nobody else writes the variables of a program, so one that goes round in a circle does not look for that.
                program.watch = Watch::default();
                self.conclude_order(observer);
                Ok(written?)
            }
        }
    }
}
