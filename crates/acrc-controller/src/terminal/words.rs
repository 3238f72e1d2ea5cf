//! The controller's own words in a message of this project.

use acrc_catalog::all_messages;

/// What a controller says instead of `text`: its own words where they are known, without what this project adds behind them.
pub(crate) fn known_words(text: &str) -> &str {
    let known = all_messages().filter(|message| message.is_known());
    known.map(|message| message.text).find(|words| text.starts_with(words)).unwrap_or(text)
}
