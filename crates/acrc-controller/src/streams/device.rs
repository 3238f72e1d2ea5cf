//! The string behind `OPEN`: a stream, a colon sign, and for serial ports how they are set (guide, "Character I/O").

use thiserror::Error;

use crate::terminal::{StreamError, StreamName};

/// What a serial port is set to: the values that each place may have.
const SERIAL: [(&str, &[&str]); 4] = [
    ("baud rate", &["300", "600", "1200", "2400", "9600", "19200", "38400"]),
    ("parity", &["N", "E", "O"]),
    ("number of data bits", &["5", "6", "7", "8"]),
    ("number of stop bits", &["1", "2"]),
];

/// Why a string names no device.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DeviceError {
    /// No stream of the language, or none of the model.
    #[error(transparent)]
    Stream(#[from] StreamError),
    /// Settings behind the name of something that is no serial port.
    #[error("{0} has no settings: nothing follows its colon")]
    NoSettings(StreamName),
    /// Too many or too few settings.
    #[error("{0} takes baud rate, parity, data bits and stop bits: \"{0}:9600,n,8,1\"")]
    Count(StreamName),
    /// A setting that is not possible.
    #[error("{value} is no {setting} of {stream}: there are {}", known.join(", "))]
    Setting {
        /// The serial port.
        stream: StreamName,
        /// Which setting.
        setting: &'static str,
        /// What was given.
        value: String,
        /// What is possible.
        known: &'static [&'static str],
    },
}

/// The stream that a device string names: `COM1:9600,n,8,1`, `STREAM2:`. A serial port without settings keeps those it has. The colon may be
/// missing.
pub(crate) fn device_stream(text: &str) -> Result<StreamName, DeviceError> {
    let (name, settings) = text.split_once(':').unwrap_or((text, ""));
    let stream: StreamName = name.parse()?;
    if settings.trim().is_empty() {
        return Ok(stream);
    }
    if !matches!(stream, StreamName::Com(_)) {
        return Err(DeviceError::NoSettings(stream));
    }
    let values: Vec<&str> = settings.split(',').map(str::trim).collect();
    if values.len() != SERIAL.len() {
        return Err(DeviceError::Count(stream));
    }
    for ((setting, known), value) in SERIAL.into_iter().zip(values) {
        if !known.iter().any(|known| known.eq_ignore_ascii_case(value)) {
            return Err(DeviceError::Setting { stream, setting, value: value.to_owned(), known });
        }
    }
    Ok(stream)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn device_strings_name_a_stream() {
        for (text, expected) in [
            ("COM1:38400,n,8,1", StreamName::Com(1)),
            ("com2: 9600 , E, 7, 2 ", StreamName::Com(2)),
            ("COM1:", StreamName::Com(1)),
            ("Stream3:", StreamName::Stream(3)),
            ("FIFO", StreamName::Fifo),
        ] {
            assert_eq!(device_stream(text), Ok(expected), "{text}");
        }
    }

    #[test]
    fn bad_device_strings_say_what_is_wrong() {
        for (text, expected) in [
            ("COM3:", "`COM3` is no stream"),
            ("", "`` is no stream"),
            ("STREAM1:9600,n,8,1", "STREAM1 has no settings"),
            ("COM1:9600", "COM1 takes baud rate, parity, data bits and stop bits"),
            ("COM1:9601,n,8,1", "9601 is no baud rate of COM1: there are 300, 600,"),
            ("COM1:9600,x,8,1", "x is no parity of COM1: there are N, E, O"),
        ] {
            let message = device_stream(text).expect_err(text).to_string();
            assert!(message.contains(expected), "{text}\n{message}");
        }
    }
}
