//! The case of keywords.

use crate::options::KeywordCase;

/// Writes a word of the language.
pub(crate) fn push(out: &mut String, word: &str, case: KeywordCase) {
    let from = out.len();
    out.push_str(word);
    let Some(written) = out.get_mut(from..) else { return };
    match case {
        KeywordCase::Upper => written.make_ascii_uppercase(),
        KeywordCase::Lower => written.make_ascii_lowercase(),
        KeywordCase::Keep => {}
    }
}
