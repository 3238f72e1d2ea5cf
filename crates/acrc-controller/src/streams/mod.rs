//! Devices: what `#0` to `#3` of the programs stand for, and the characters typed there (guide, "Character I/O" and "Communication Stream Buffers").
//!
//! Devices 1 to 3 belong to the whole controller, device 0 to each program. While a device has a stream, the characters of the stream go to the
//! programs and not to the terminal. Device 0 without a stream is the terminal that listens to the program.

mod device;
mod input;
mod port;

use std::collections::BTreeMap;

pub use device::DeviceError;
pub(crate) use device::device_stream;
use input::Input;
pub(crate) use input::{Reading, as_typed};
pub use port::Port;

use crate::terminal::StreamName;

/// A device as a program names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Device {
    /// `#0` of a program.
    Own(u8),
    /// `#1` to `#3`.
    Shared(u8),
}

impl Device {
    /// The device that a number means, in a program or at a prompt of the system.
    pub(crate) fn of(number: i32, program: Option<u8>) -> Option<Self> {
        match (u8::try_from(number).ok()?, program) {
            (0, Some(program)) => Some(Self::Own(program)),
            (number @ 1..=3, _) => Some(Self::Shared(number)),
            _ => None,
        }
    }

    /// The number behind `#`.
    pub(crate) fn number(self) -> u8 {
        match self {
            Self::Own(_) => 0,
            Self::Shared(number) => number,
        }
    }
}

/// The devices that are open, and what was typed.
#[derive(Debug, Default)]
pub(crate) struct Streams {
    open: BTreeMap<Device, StreamName>,
    inputs: BTreeMap<Port, Input>,
    /// Where the command that was executed last has to wait for characters.
    pub(crate) awaited: Option<Port>,
}

impl Streams {
    /// Gives a device its stream.
    pub(crate) fn open(&mut self, device: Device, stream: StreamName) {
        self.open.insert(device, stream);
    }

    /// Takes the stream of a device away. What had arrived there and was not read is lost: gives how many characters.
    pub(crate) fn close(&mut self, device: Device) -> Option<(StreamName, usize)> {
        let stream = self.open.remove(&device)?;
        let lost = self.inputs.get_mut(&Port::Stream(stream)).map_or(0, Input::clear);
        Some((stream, lost))
    }

    /// Closes every device. Whoever types at a port goes on with what is left to type.
    pub(crate) fn restart(&mut self) {
        self.open.clear();
        for input in self.inputs.values_mut() {
            input.clear();
        }
    }

    /// The stream of a device.
    pub(crate) fn stream(&self, device: Device) -> Option<StreamName> {
        self.open.get(&device).copied()
    }

    /// The device that has a stream.
    pub(crate) fn device(&self, stream: StreamName) -> Option<Device> {
        self.open.iter().find(|(_, open)| **open == stream).map(|(device, _)| *device)
    }

    /// Where the characters of a device come from. `None` when it is not open.
    pub(crate) fn port(&self, device: Device) -> Option<Port> {
        match (self.stream(device), device) {
            (Some(stream), _) => Some(Port::Stream(stream)),
            (None, Device::Own(program)) => Some(Port::Listener(program)),
            (None, Device::Shared(_)) => None,
        }
    }

    /// Whether characters typed at a port go to programs.
    pub(crate) fn takes(&self, port: Port) -> bool {
        match port {
            Port::Stream(stream) => self.device(stream).is_some(),
            Port::Listener(_) => true,
        }
    }

    /// Characters arrive for the programs. Gives how many wait now.
    pub(crate) fn arrive(&mut self, port: Port, bytes: &[u8]) -> usize {
        self.input(port).arrive(bytes)
    }

    /// How many characters wait at a port.
    pub(crate) fn unread(&self, port: Port) -> usize {
        self.inputs.get(&port).map_or(0, Input::unread)
    }

    /// Lines that will be typed at a port, each as soon as a program asks for it.
    pub(crate) fn offer(&mut self, port: Port, bytes: &[u8]) {
        self.input(port).offer(bytes);
    }

    /// Whether no whole line has arrived at a port.
    pub(crate) fn lacks_line(&mut self, port: Port) -> bool {
        self.input(port).lacks_line()
    }

    /// Whether a character waits at a port.
    pub(crate) fn waits(&mut self, port: Port) -> bool {
        self.input(port).waits()
    }

    /// The next character of a port.
    pub(crate) fn take(&mut self, port: Port) -> Option<u8> {
        self.input(port).take()
    }

    /// Reads on towards the end of a line.
    pub(crate) fn read(&mut self, port: Port) -> Reading {
        self.input(port).read()
    }

    fn input(&mut self, port: Port) -> &mut Input {
        self.inputs.entry(port).or_default()
    }
}
