//! Writing parameters and flags.

use thiserror::Error;

use super::read::read_text;
use super::{Register, Value};
use crate::answer::parse_number;
use crate::{Console, LinkError};

/// Why a register was not written.
#[derive(Debug, Error)]
pub enum WriteError {
    /// The connection failed, or the controller refused.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// What was read back is something else.
    #[error("{register} was set to {set} and is {found}: the controller, a program or an input decides it")]
    Differs {
        /// The register.
        register: Register,
        /// What was written.
        set: f64,
        /// What it is now.
        found: Value,
    },
}

/// Reads a value as a person writes it: a number; for a flag also `on`, `off`, `set`, `clear`, `true`, `false`.
///
/// # Errors
/// What values the register takes.
pub fn parse_value(register: Register, text: &str) -> Result<f64, String> {
    let text = text.trim();
    let lower = text.to_ascii_lowercase();
    match (register, lower.as_str()) {
        (Register::Bit(_), "on" | "set" | "true" | "1" | "-1") => Ok(-1.0),
        (Register::Bit(_), "off" | "clear" | "clr" | "false" | "0") => Ok(0.0),
        (Register::Bit(_), _) => Err(format!("{register} = {text}: a flag is 1 or 0")),
        (Register::Parameter(_), _) => {
            let number = parse_number(text).filter(|number| number.is_finite());
            number.ok_or_else(|| format!("{register} = {text}: a parameter takes a number"))
        }
    }
}

/// Writes a register and reads it back.
///
/// It is written as text, by `SET`, `CLR` and an assignment: packets that write are not answered, and the controller says
/// nothing about what it does not take.
///
/// # Errors
/// When the controller refuses it, or has another value then.
pub fn write(console: &mut impl Console, register: Register, value: f64) -> Result<Value, WriteError> {
    let line = match register {
        Register::Bit(number) if value != 0.0 => format!("SET {number}"),
        Register::Bit(number) => format!("CLR {number}"),
        Register::Parameter(number) => format!("P{number} = {value}"),
    };
    console.command(&line)?.silence()?;
    let found = read_text(console, register)?;
    let is_equal = match found {
        Value::Flag(set) => set == (value != 0.0),
        Value::Single(single) => single == value as f32,
        other => is_near(other.number(), value),
    };
    if is_equal { Ok(found) } else { Err(WriteError::Differs { register, set: value, found }) }
}

/// A controller may print fewer digits than a number has.
fn is_near(printed: f64, value: f64) -> bool {
    (printed - value).abs() <= 1e-6 * value.abs()
}
