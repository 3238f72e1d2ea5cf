//! Fast status: the controller sends what is watched by itself (Ethernet specification, "Fast Status").
//!
//! Ten groups of eight parameters come in each datagram; `FSTAT0` to `FSTAT9` say which. All clients get the same groups,
//! so changing them changes what others get.

use std::io;
use std::net::UdpSocket;
use std::time::Duration;

use acrc_catalog::{FLAGS_PER_WORD, ValueType, bit, parameter};
use acrc_wire::binary::{DataRequest, Group};
use acrc_wire::ethernet::{FAST_STATUS_PORT, FastStatus, Subscription};
use thiserror::Error;

use crate::values::{Register, Value};
use crate::{Console, Endpoint, LinkError};

/// The groups that a controller sends: code and index of each, `None` for one that is not chosen.
pub type Groups = [Option<(u8, u8)>; FastStatus::GROUPS];

/// Why something cannot be watched by fast status.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum LayoutError {
    /// No group holds the parameter, or its type is not known.
    #[error("{0} cannot be sent by fast status: the catalogue knows no group or no type of it")]
    NoGroup(Register),
    /// None of the ten groups holds it as they are set.
    #[error("{0} is in none of the groups FSTAT0 to FSTAT9 as they are set")]
    NotSent(Register),
    /// Ten groups do not hold everything.
    #[error("that takes {0} groups, and fast status has ten")]
    TooMany(usize),
}

/// Where a register stands in a datagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Place {
    group: usize,
    field: usize,
    form: Form,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Long,
    Single,
    Flag(u32),
}

/// Where registers stand in the datagrams.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout(Vec<Place>);

impl Layout {
    /// Finds registers among the groups that are sent.
    ///
    /// # Errors
    /// When one of them is not sent.
    pub fn find(registers: &[Register], groups: &Groups) -> Result<Self, LayoutError> {
        let place = |register: &Register| {
            let (word, form) = word(*register)?;
            let sent = groups.iter().enumerate().find_map(|(group, chosen)| {
                let (code, index) = (*chosen)?;
                let chosen = Group::of(code)?;
                let field = (0..FastStatus::GROUP).find(|field| chosen.parameter(index, *field as u8) == Some(word))?;
                Some(Place { group, field, form })
            });
            sent.ok_or(LayoutError::NotSent(*register))
        };
        registers.iter().map(place).collect::<Result<_, _>>().map(Self)
    }

    /// The values in a datagram, in the order of the registers.
    pub fn values(&self, status: &FastStatus) -> Vec<Value> {
        let value = |place: &Place| {
            let field = status.0.get(place.group).and_then(|group| group.get(place.field)).copied().unwrap_or_default();
            match place.form {
                Form::Long => Value::Long(field.long()),
                Form::Single => Value::Single(field.single()),
                Form::Flag(index) => Value::Flag(field.long() >> index & 1 != 0),
            }
        };
        self.0.iter().map(value).collect()
    }
}

/// The parameter that holds a register, and how.
fn word(register: Register) -> Result<(u16, Form), LayoutError> {
    let unknown = LayoutError::NoGroup(register);
    let (number, form) = match register {
        Register::Bit(number) => (bit(number).word, Form::Flag(number % FLAGS_PER_WORD)),
        Register::Parameter(number) => match parameter(number).ty {
            Some(ValueType::Long) => (Some(number), Form::Long),
            Some(ValueType::Single) => (Some(number), Form::Single),
            _ => (None, Form::Long),
        },
    };
    number.and_then(|number| u16::try_from(number).ok()).map(|number| (number, form)).ok_or(unknown)
}

/// The groups that registers take.
///
/// # Errors
/// When they take more than ten, or one has no group.
pub fn groups_for(registers: &[Register]) -> Result<Groups, LayoutError> {
    let mut taken: Vec<(u8, u8)> = Vec::new();
    for register in registers {
        let (number, _) = word(*register)?;
        let request = DataRequest::of(number).ok_or(LayoutError::NoGroup(*register))?;
        if !taken.contains(&(request.group, request.index)) {
            taken.push((request.group, request.index));
        }
    }
    let mut groups = Groups::default();
    if taken.len() > groups.len() {
        return Err(LayoutError::TooMany(taken.len()));
    }
    for (place, group) in groups.iter_mut().zip(taken) {
        *place = Some(group);
    }
    Ok(groups)
}

/// Asks which groups a controller sends. A group whose report is not two numbers counts as not chosen.
///
/// # Errors
/// When the controller does not answer.
pub fn read_groups(console: &mut impl Console) -> Result<Groups, LinkError> {
    let mut groups = Groups::default();
    for (number, group) in groups.iter_mut().enumerate() {
        let answer = console.command(&format!("FSTAT{number}"))?;
        // No document shows the report: two lines, or one with the command in front of the numbers.
        let text = answer.report()?.join(" ").replace(&format!("FSTAT{number}"), " ");
        let numbers = text.split(|character: char| !character.is_ascii_digit()).filter(|digits| !digits.is_empty());
        let numbers: Vec<u8> = numbers.filter_map(|digits| digits.parse().ok()).collect();
        *group = match numbers[..] {
            [0, 0] => None,
            [code, index] => Some((code, index)),
            _ => None,
        };
    }
    Ok(groups)
}

/// Lets a controller send groups. Those that are not chosen stay as they are.
///
/// # Errors
/// When the controller refuses one.
pub fn set_groups(console: &mut impl Console, groups: &Groups) -> Result<(), LinkError> {
    for (number, group) in groups.iter().enumerate() {
        if let Some((code, index)) = group {
            console.command(&format!("FSTAT{number} ({code},{index})"))?.silence()?;
        }
    }
    Ok(())
}

/// A subscription. It ends with this value.
#[derive(Debug)]
pub struct Subscriber {
    socket: UdpSocket,
}

impl Subscriber {
    /// Asks for status at an interval in milliseconds.
    ///
    /// # Errors
    /// When the system has no socket for it, or the host has no address.
    pub fn new(endpoint: &Endpoint, port: Option<u16>, milliseconds: u32) -> io::Result<Self> {
        let any = if endpoint.host.contains(':') { "[::]:0" } else { "0.0.0.0:0" };
        let socket = UdpSocket::bind(any)?;
        socket.connect((endpoint.host.as_str(), port.unwrap_or(FAST_STATUS_PORT)))?;
        socket.send(&Subscription::every(milliseconds).encode())?;
        Ok(Self { socket })
    }

    /// The next datagram; `None` when none comes for so long. What is no status is left out.
    ///
    /// # Errors
    /// When nobody listens there.
    pub fn receive(&self, longest: Duration) -> io::Result<Option<FastStatus>> {
        self.socket.set_read_timeout(Some(longest.max(Duration::from_millis(1))))?;
        let mut datagram = [0; 2 * FastStatus::LEN];
        match self.socket.recv(&mut datagram) {
            Ok(count) => Ok(FastStatus::decode(datagram.get(..count).unwrap_or_default()).ok()),
            Err(error) if matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut) => Ok(None),
            Err(error) => Err(error),
        }
    }
}

impl Drop for Subscriber {
    fn drop(&mut self) {
        // The controller drops a subscriber that is gone, too.
        let _ = self.socket.send(&Subscription::end().encode());
    }
}

#[cfg(test)]
mod tests {
    use acrc_wire::Field;

    use super::*;

    #[test]
    fn registers_are_found_in_the_groups_that_they_take() {
        let registers = [Register::Parameter(12290), Register::Parameter(12546), Register::Bit(516)];
        let groups = groups_for(&registers).expect("they fit");
        assert_eq!(groups.iter().flatten().count(), 2);
        let layout = Layout::find(&registers, &groups).expect("they are sent");
        let mut status = FastStatus::default();
        status.0[0][0] = Field::from(1000);
        status.0[0][1] = Field::from(-2);
        status.0[1].fill(Field::from(1 << 4));
        assert_eq!(layout.values(&status), [Value::Long(1000), Value::Long(-2), Value::Flag(true)]);
    }

    #[test]
    fn what_is_not_sent_is_named() {
        let position = Register::Parameter(12290);
        assert_eq!(Layout::find(&[position], &Groups::default()), Err(LayoutError::NotSent(position)));
        assert_eq!(groups_for(&[Register::Parameter(5)]), Err(LayoutError::NoGroup(Register::Parameter(5))));
        let many: Vec<Register> = (0..11).map(|place| Register::Parameter(12288 + place)).collect();
        assert!(matches!(groups_for(&many), Err(LayoutError::TooMany(_) | LayoutError::NoGroup(_))));
    }
}
