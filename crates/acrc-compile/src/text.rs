//! Texts of programs to the bytes that a controller stores, one a character.

use acrc_image::text;

/// The characters that a typographic one stands for, as word processors and PDF files put them into programs.
fn plain(character: char) -> Option<&'static str> {
    Some(match character {
        '\u{2018}'..='\u{201B}' | '\u{2032}' => "'",
        '\u{201C}'..='\u{201F}' | '\u{2033}' => "\"",
        '\u{2010}'..='\u{2015}' | '\u{2212}' => "-",
        '\u{A0}' | '\u{2002}'..='\u{200A}' | '\u{202F}' => " ",
        '\u{2026}' => "...",
        _ => return None,
    })
}

/// A statement as it can be typed at a controller, which reads one byte a character: typographic characters as what they stand for, and what has
/// no byte, which only remarks can have, as a question mark.
pub fn typed_text(source: &str) -> String {
    let mut typed = String::with_capacity(source.len());
    for character in source.chars() {
        match plain(character) {
            Some(plain) => typed.push_str(plain),
            None => typed.push(if u8::try_from(character).is_ok() { character } else { '?' }),
        }
    }
    typed
}

/// The bytes of a string constant.
///
/// # Errors
/// The first character that has no byte, and its offset. A typographic double quote is one: there is no way to write a quote inside a string.
pub(crate) fn string(source: &str) -> Result<Vec<u8>, (usize, char)> {
    let mut bytes = Vec::with_capacity(source.len());
    for (offset, character) in source.char_indices() {
        match (plain(character), u8::try_from(character)) {
            (Some("\""), _) | (None, Err(_)) => return Err((offset, character)),
            (Some(plain), _) => bytes.extend_from_slice(plain.as_bytes()),
            (None, Ok(byte)) => bytes.push(byte),
        }
    }
    Ok(bytes)
}

/// The bytes of a remark, without blanks at its end. What has no byte becomes a question mark: a remark must not keep a program from running.
pub(crate) fn remark(source: &str) -> Vec<u8> {
    text::encode(typed_text(source).trim_end()).unwrap_or_default()
}
