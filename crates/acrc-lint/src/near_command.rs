//! Command words that a misspelt word may have meant.

use std::sync::LazyLock;

/// The single words that start statements.
static WORDS: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
    let names = acrc_catalog::all_commands().map(|command| command.name);
    names.filter(|name| name.len() > 1 && name.bytes().all(|byte| byte.is_ascii_uppercase())).collect()
});

/// The command word nearest to `word`, if one is near enough.
pub(crate) fn near_command(word: &str) -> Option<&'static str> {
    acrc_analysis::nearest(&word.to_ascii_uppercase(), WORDS.iter().copied())
}

/// The command word that `word` becomes when two neighbouring letters are exchanged: the slip that no axis name
/// explains.
pub(crate) fn exchanged_letters(word: &str) -> Option<&'static str> {
    let mut letters = word.to_ascii_uppercase().into_bytes();
    for at in 1..letters.len() {
        letters.swap(at - 1, at);
        if let Some(command) =
            WORDS.iter().find(|command| command.as_bytes() == letters && !command.eq_ignore_ascii_case(word))
        {
            return Some(command);
        }
        letters.swap(at - 1, at);
    }
    None
}
