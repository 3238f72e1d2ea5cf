//! The bytes of a file as text.
//!
//! Programs come from the vendor's tool in the Windows code page, from editors in UTF-8 with or without a byte order
//! mark, and from exports in UTF-16. All of them are read; what was read can be written back byte for byte.

use acrc_diagnostics::{Diagnostic, Span};
use encoding_rs::{UTF_16BE, UTF_16LE, WINDOWS_1252};

use crate::codes;

/// The largest file that is read, in bytes. The memory of a controller is a few megabytes.
pub const MAX_BYTES: usize = 64 << 20;

const UTF8_BOM: [u8; 3] = [0xEF, 0xBB, 0xBF];
const UTF16_LE_BOM: [u8; 2] = [0xFF, 0xFE];
const UTF16_BE_BOM: [u8; 2] = [0xFE, 0xFF];
/// Ctrl-Z, the end of a text in files of CP/M and DOS.
const END_MARK: u8 = 0x1A;

/// A source text decoded from the bytes of a file.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct SourceText {
    /// The text, without a byte order mark.
    pub text: String,
    /// How the bytes were read.
    pub encoding: Encoding,
    /// A Ctrl-Z ends the file, as old editors leave it. It is no part of the text, because on its way to a controller
    /// it would stop all motion there, but it is written back.
    pub end_mark: bool,
}

/// How a text is written as bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// UTF-8, of which ASCII is a part.
    #[default]
    Utf8,
    /// UTF-8 behind a byte order mark.
    Utf8Bom,
    /// The western code page of Windows, for bytes that are not UTF-8.
    Windows1252,
    /// UTF-16, low byte first, behind a byte order mark.
    Utf16Le,
    /// UTF-16, high byte first, behind a byte order mark.
    Utf16Be,
}

/// Why a file is not read as text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
pub enum DecodeError {
    /// A byte that no program text has. Several control characters act on a controller as soon as they arrive, so
    /// they are never passed on.
    #[error("not a text file: byte {offset} is no printable character, tab or line break")]
    Binary {
        /// Offset of the byte in the file.
        offset: usize,
    },
    /// The file is larger than [`MAX_BYTES`].
    #[error("the file has {bytes} bytes; at most {MAX_BYTES} are read")]
    TooLarge {
        /// The size of the file.
        bytes: usize,
    },
}

impl SourceText {
    /// Reads the bytes of a file: by their byte order mark, else as UTF-8, else in the Windows code page. One Ctrl-Z as
    /// the last byte ends the text.
    ///
    /// # Errors
    /// Control characters other than tab, form feed and line breaks, broken UTF-16, and files above [`MAX_BYTES`].
    pub fn decode(bytes: &[u8]) -> Result<Self, DecodeError> {
        if bytes.len() > MAX_BYTES {
            return Err(DecodeError::TooLarge { bytes: bytes.len() });
        }
        if bytes.starts_with(&UTF16_LE_BOM) {
            return decode_utf16(bytes, Encoding::Utf16Le);
        }
        if bytes.starts_with(&UTF16_BE_BOM) {
            return decode_utf16(bytes, Encoding::Utf16Be);
        }
        let marked = bytes.strip_suffix(&[END_MARK]);
        let bytes = marked.unwrap_or(bytes);
        if let Some(offset) = bytes.iter().position(|&byte| is_refused(byte)) {
            return Err(DecodeError::Binary { offset });
        }
        let body = bytes.strip_prefix(&UTF8_BOM);
        let (text, encoding) = match std::str::from_utf8(body.unwrap_or(bytes)) {
            Ok(text) if body.is_some() => (text.to_owned(), Encoding::Utf8Bom),
            Ok(text) => (text.to_owned(), Encoding::Utf8),
            Err(_) => {
                let (text, _) = WINDOWS_1252.decode_without_bom_handling(bytes);
                (text.into_owned(), Encoding::Windows1252)
            }
        };
        Ok(Self { text, encoding, end_mark: marked.is_some() })
    }

    /// The text as bytes: exactly what was read, as long as the text was not changed. A changed text with characters
    /// that the Windows code page lacks is written as UTF-8.
    #[must_use]
    pub fn encode(&self) -> Vec<u8> {
        let mut bytes = self.encoded_text();
        bytes.extend(self.end_mark.then_some(END_MARK));
        bytes
    }

    fn encoded_text(&self) -> Vec<u8> {
        match self.encoding {
            Encoding::Utf8 => self.text.clone().into_bytes(),
            Encoding::Utf8Bom => [UTF8_BOM.as_slice(), self.text.as_bytes()].concat(),
            Encoding::Windows1252 => match WINDOWS_1252.encode(&self.text) {
                (bytes, _, false) => bytes.into_owned(),
                (_, _, true) => self.text.clone().into_bytes(),
            },
            Encoding::Utf16Le => encode_utf16(&self.text, UTF16_LE_BOM, u16::to_le_bytes),
            Encoding::Utf16Be => encode_utf16(&self.text, UTF16_BE_BOM, u16::to_be_bytes),
        }
    }

    /// What is to say about the encoding: a controller takes ASCII, everything else depends on the tool that sends it.
    #[must_use]
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let start = Span::empty(0);
        let said = match self.encoding {
            Encoding::Utf8 => None,
            Encoding::Utf8Bom => Some(Diagnostic::advice(
                codes::ENCODING,
                start,
                "the file starts with a byte order mark, which other tools may send to the controller",
            )),
            Encoding::Windows1252 => {
                let first = self.text.char_indices().find(|(_, character)| !character.is_ascii());
                let span = first.map_or(start, |(at, character)| Span::from(at..at + character.len_utf8()));
                Some(Diagnostic::advice(
                    codes::ENCODING,
                    span,
                    "the file is not UTF-8; it was read in the Windows code page 1252",
                ))
            }
            Encoding::Utf16Le | Encoding::Utf16Be => Some(Diagnostic::warning(
                codes::ENCODING,
                start,
                "the file is UTF-16, two bytes a character, which a controller does not read",
            )),
        };
        let help = "save the file as UTF-8 without a byte order mark";
        said.map(|diagnostic| diagnostic.with_help(help)).into_iter().collect()
    }
}

/// Bytes that no text in an encoding of one byte a character, or in UTF-8, has.
const fn is_refused(byte: u8) -> bool {
    matches!(byte, 0..=0x08 | 0x0B | 0x0E..=0x1F | 0x7F)
}

fn decode_utf16(bytes: &[u8], encoding: Encoding) -> Result<SourceText, DecodeError> {
    let codec = if encoding == Encoding::Utf16Le { UTF_16LE } else { UTF_16BE };
    let body = bytes.get(2..).unwrap_or_default();
    // Half a character at the end, or half of a pair: the text would not be written back as it was.
    let text = codec
        .decode_without_bom_handling_and_without_replacement(body)
        .ok_or(DecodeError::Binary { offset: first_broken_unit(body, encoding) })?;
    let mut offset = 2;
    for character in text.chars() {
        if u8::try_from(character).is_ok_and(is_refused) {
            return Err(DecodeError::Binary { offset });
        }
        offset += 2 * character.len_utf16();
    }
    Ok(SourceText { text: text.into_owned(), encoding, end_mark: false })
}

/// Offset in the file of the first code unit of UTF-16 that is not a character.
fn first_broken_unit(body: &[u8], encoding: Encoding) -> usize {
    let units = body.chunks_exact(2).map(|pair| {
        let pair = [pair[0], pair[1]];
        if encoding == Encoding::Utf16Le { u16::from_le_bytes(pair) } else { u16::from_be_bytes(pair) }
    });
    let mut offset = 2;
    for character in char::decode_utf16(units) {
        match character {
            Ok(character) => offset += 2 * character.len_utf16(),
            Err(_) => break,
        }
    }
    offset
}

fn encode_utf16(text: &str, bom: [u8; 2], to_bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    bom.into_iter().chain(text.encode_utf16().flat_map(to_bytes)).collect()
}
