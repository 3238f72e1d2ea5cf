//! Texts of the stored form are Latin-1: one byte a character, as the guide charges them ("String Constants").

/// The text as characters.
pub fn decode(bytes: &[u8]) -> String {
    bytes.iter().copied().map(char::from).collect()
}

/// The text as bytes.
///
/// # Errors
/// The first character above U+00FF and its offset in `text`.
pub fn encode(text: &str) -> Result<Vec<u8>, (usize, char)> {
    text.char_indices().map(|(offset, character)| u8::try_from(character).map_err(|_| (offset, character))).collect()
}
