//! Reading parameters and flags.

use std::fmt;

use acrc_catalog::{FLAGS_PER_WORD, ValueType, bit, parameter};
use acrc_wire::{Reply, Request};

use super::Register;
use crate::{Connection, Console, LinkError, Transport};

/// The last parameter that packets cannot carry in full: user variables have 64 bits.
const LAST_USER_PARAMETER: u32 = acrc_catalog::memory::USER_PARAMETERS - 1;

/// The value of a parameter or flag.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Of a flag: set or clear.
    Flag(bool),
    /// Of a parameter that is a long integer.
    Long(i32),
    /// Of a parameter that is an IEEE single.
    Single(f32),
    /// Of another parameter, or what a text says.
    Number(f64),
}

impl Value {
    /// As a number; a flag that is set is -1, as the controller prints it.
    pub fn number(self) -> f64 {
        match self {
            Self::Flag(set) => f64::from(-i8::from(set)),
            Self::Long(value) => f64::from(value),
            Self::Single(value) => f64::from(value),
            Self::Number(value) => value,
        }
    }
}

/// As the controller prints it: -1 and 0 for flags, the shortest text that reads back.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flag(set) => f.pad(if *set { "-1" } else { "0" }),
            Self::Long(value) => value.fmt(f),
            Self::Single(value) => value.fmt(f),
            Self::Number(value) => value.fmt(f),
        }
    }
}

/// How a register is read by packets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Packet {
    Long(u16),
    Single(u16),
    /// The word that a flag lies in, and where.
    Flag(u16, u32),
}

impl Packet {
    /// `None` for what goes as text.
    fn of(register: Register) -> Option<Self> {
        match register {
            Register::Bit(number) => {
                let word = bit(number).word?;
                u16::try_from(word).ok().map(|word| Self::Flag(word, number % FLAGS_PER_WORD))
            }
            Register::Parameter(number) => {
                let info = parameter(number);
                let word = u16::try_from(number).ok().filter(|_| number > LAST_USER_PARAMETER)?;
                match info.ty {
                    Some(ValueType::Long) => Some(Self::Long(word)),
                    Some(ValueType::Single) => Some(Self::Single(word)),
                    // As a single a long integer would lose digits, and as a long a single its fraction.
                    _ => None,
                }
            }
        }
    }

    fn request(self) -> Request<'static> {
        match self {
            Self::Long(parameter) | Self::Flag(parameter, _) => Request::GetLong { parameter },
            Self::Single(parameter) => Request::GetSingle { parameter },
        }
    }

    fn value(self, reply: &Reply<'_>) -> Option<Value> {
        match (self, reply) {
            (Self::Flag(_, index), Reply::Long { value, .. }) => Some(Value::Flag(value >> index & 1 != 0)),
            (Self::Long(_), Reply::Long { value, .. }) => Some(Value::Long(*value)),
            (Self::Single(_), Reply::Single { value, .. }) => Some(Value::Single(*value)),
            _ => None,
        }
    }
}

/// Reads registers: by packets where the connection and the register allow that, as text otherwise.
///
/// # Errors
/// When an answer does not come or is no number. Nothing is known of the others then.
pub fn read<T: Transport>(connection: &mut Connection<T>, registers: &[Register]) -> Result<Vec<Value>, LinkError> {
    let mut values: Vec<Option<Value>> = vec![None; registers.len()];
    if connection.has_packets() {
        read_packets(connection, registers, &mut values)?;
    }
    let mut all = Vec::with_capacity(registers.len());
    for (register, value) in registers.iter().zip(values) {
        all.push(match value {
            Some(value) => value,
            None => read_text(connection, *register)?,
        });
    }
    Ok(all)
}

fn read_packets<T: Transport>(
    connection: &mut Connection<T>,
    registers: &[Register],
    values: &mut [Option<Value>],
) -> Result<(), LinkError> {
    let packets = registers.iter().enumerate().filter_map(|(place, register)| Some((place, Packet::of(*register)?)));
    let packets: Vec<(usize, Packet)> = packets.collect();
    let requests: Vec<Request<'_>> = packets.iter().map(|(_, packet)| packet.request()).collect();
    connection.ask(&requests, |asked, reply| {
        if let Some((place, packet)) = packets.get(asked)
            && let Some(value) = values.get_mut(*place)
        {
            *value = packet.value(reply);
        }
    })
}

/// Asks with `?`, which prints -1 or 0 for a flag and a number for a parameter.
pub(super) fn read_text(console: &mut impl Console, register: Register) -> Result<Value, LinkError> {
    let number = console.command(&format!("?{register}"))?.number()?;
    Ok(match register {
        Register::Bit(_) => Value::Flag(number != 0.0),
        Register::Parameter(parameter) => match acrc_catalog::parameter(parameter).ty {
            Some(ValueType::Long) if number.fract() == 0.0 && number.abs() < 2_147_483_648.0 => {
                Value::Long(number as i32)
            }
            Some(ValueType::Single) => Value::Single(number as f32),
            _ => Value::Number(number),
        },
    })
}
