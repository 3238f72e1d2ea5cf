//! The bytes of a state: a first line with version, checksum and length, and behind it TOML.

use acrc_controller::nonvolatile::Saved;

use crate::error::{ReadError, StoreError};
use crate::store::VERSION;
use crate::wire;

const MAGIC: &str = "acrc-state";

/// The bytes of a state. The same state gives the same bytes.
///
/// # Errors
/// [`StoreError::Unwritable`] when a program is too large for the format of images.
pub fn encode(saved: &Saved) -> Result<Vec<u8>, StoreError> {
    let state = wire::State::new(saved).map_err(|error| StoreError::Unwritable(error.to_string()))?;
    let text = toml::to_string(&state).map_err(|error| StoreError::Unwritable(error.to_string()))?;
    let checksum = crc32fast::hash(text.as_bytes());
    Ok(format!("{MAGIC} {VERSION} crc32={checksum:08x} bytes={}\n{text}", text.len()).into_bytes())
}

/// Reads the bytes of a state.
///
/// # Errors
/// [`ReadError`], a reason of its own for each way the bytes can be wrong. That the values suit a controller is checked when one takes
/// them ([`acrc_controller::Controller::restore`]).
pub fn decode(bytes: &[u8]) -> Result<Saved, ReadError> {
    let end = bytes.iter().take(100).position(|byte| *byte == b'\n').ok_or(ReadError::Foreign)?;
    let (line, body) = (&bytes[..end], &bytes[end + 1..]);
    let line = str::from_utf8(line).map_err(|_| ReadError::Foreign)?;
    let mut words = line.split(' ');
    if words.next() != Some(MAGIC) {
        return Err(ReadError::Foreign);
    }
    let version: u32 = words.next().and_then(|word| word.parse().ok()).ok_or(ReadError::Foreign)?;
    if version > VERSION {
        return Err(ReadError::NewerVersion { found: version, newest: VERSION });
    }
    let stored = words.next().and_then(|word| u32::from_str_radix(word.strip_prefix("crc32=")?, 16).ok());
    let expected = words.next().and_then(|word| word.strip_prefix("bytes=")?.parse().ok());
    let (Some(stored), Some(expected), None, 1..) = (stored, expected, words.next(), version) else {
        return Err(ReadError::Foreign);
    };
    if body.len() != expected {
        return Err(ReadError::Length { expected, found: body.len() });
    }
    let computed = crc32fast::hash(body);
    if computed != stored {
        return Err(ReadError::Altered { stored, computed });
    }
    let text = str::from_utf8(body).map_err(|error| ReadError::Malformed(error.to_string()))?;
    let state: wire::State = toml::from_str(text).map_err(|error| ReadError::Malformed(error.message().to_owned()))?;
    state.read().map_err(ReadError::Malformed)
}
