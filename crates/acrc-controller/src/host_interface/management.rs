//! What clients of connection management ask of the controller (Ethernet specification, "Connection Management").

use std::fmt::Write as _;

use crate::controller::{Controller, Observer};
use crate::nonvolatile::Operation;
use crate::request::Request;

/// Bytes of a configuration file, without its CRC.
pub const CONFIGURATION_BYTES: usize = 1020;

impl Controller {
    /// The configuration file: lines of a name, `=` and a value in ASCII, zeros behind them. No document gives its contents.
    pub fn configuration_file(&self) -> [u8; CONFIGURATION_BYTES] {
        let machine = &self.machine;
        let model = machine.model;
        let mut text = String::new();
        let lines: [(&str, &dyn std::fmt::Display); 8] = [
            ("model", &model.name),
            ("firmware", &machine.version()),
            ("axes", &model.axes),
            ("masters", &model.masters),
            ("programs", &model.programs),
            ("plcs", &model.plcs),
            ("memory", &model.system_memory()),
            ("boards", &machine.hardware()),
        ];
        for (name, value) in lines {
            // Writing to a string cannot fail.
            let _ = write!(text, "{name}={value}\r\n");
        }
        let mut file = [0; CONFIGURATION_BYTES];
        for (place, byte) in file.iter_mut().zip(text.bytes()) {
            *place = byte;
        }
        file
    }

    /// Restarts the controller, as `REBOOT` does. Time goes on.
    pub fn reboot(&mut self, observer: &mut dyn Observer) {
        self.machine.requests.push(Request::Memories(Operation::Reboot));
        self.conclude_order(observer);
    }
}
