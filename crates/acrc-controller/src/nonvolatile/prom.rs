//! `PROM`: the stored programs for an EPROM programmer.
//!
//! No document says what the command sends. Programmers read Intel HEX, so that is what it sends here: the bytes of an `.acrx` file with
//! the programs and nothing else (`docs/image-format.md`).

use std::fmt::Write as _;

use acrc_image::UnitName;

use crate::controller::{Controller, Observer, Sent};

/// Data bytes of a record.
const RECORD: usize = 16;
/// Bytes that a record can address without another upper half.
const SEGMENT: usize = 1 << 16;

impl Controller {
    pub(super) fn dump_programs(&mut self, observer: &mut dyn Observer) {
        self.machine.notes.insert(
            "PROM sent the programs as Intel HEX of this project's own form: what the controller sends is unconfirmed"
                .to_owned(),
        );
        let mut image = self.stored_programs();
        image.strip();
        let seconds = self.machine.clock.seconds();
        match image.to_bytes() {
            Ok(bytes) => {
                let text = intel_hex(&bytes);
                observer.output(&Sent { seconds, unit: UnitName::Boot, device: 0, stream: None, text: &text });
            }
            Err(error) => {
                self.machine.notes.insert(format!("PROM sent nothing: {error}"));
            }
        }
    }
}

/// Intel HEX, a line a record.
fn intel_hex(bytes: &[u8]) -> String {
    let mut text = String::new();
    for (place, data) in (0..).step_by(RECORD).zip(bytes.chunks(RECORD)) {
        if place % SEGMENT == 0 {
            record(&mut text, 0, 4, &((place / SEGMENT) as u16).to_be_bytes());
        }
        record(&mut text, place as u16, 0, data);
    }
    record(&mut text, 0, 1, &[]);
    text
}

fn record(text: &mut String, address: u16, kind: u8, data: &[u8]) {
    let head = [data.len() as u8, (address >> 8) as u8, address as u8, kind];
    let sum = head.iter().chain(data).fold(0_u8, |sum, byte| sum.wrapping_add(*byte));
    text.push(':');
    for byte in head.iter().chain(data).chain([&sum.wrapping_neg()]) {
        let _ = write!(text, "{byte:02X}");
    }
    text.push_str("\r\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_are_those_of_the_format() {
        assert_eq!(intel_hex(b"AB"), ":020000040000FA\r\n:0200000041427B\r\n:00000001FF\r\n");
        let long = intel_hex(&vec![0xFF; SEGMENT + 1]);
        assert!(long.ends_with(":020000040001F9\r\n:01000000FF00\r\n:00000001FF\r\n"), "{}", &long[long.len() - 80..]);
    }
}
