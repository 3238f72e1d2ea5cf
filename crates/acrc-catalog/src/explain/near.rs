//! Names similar to one that does not exist.

use crate::{
    Keyword, ObjectKind, OperandClass, Operator, all_bits, all_commands, all_functions, all_operators, all_parameters,
    models,
};

/// Most suggestions for one name.
const MOST: usize = 5;

/// Topics similar to one that does not exist, the most similar first.
pub(super) fn topics(topic: &str) -> Vec<&'static str> {
    let names = all_commands().flat_map(|command| [command.name, command.word]);
    let names = names.chain(all_functions().map(|function| function.name));
    let names = names.chain(all_operators().map(Operator::name));
    let names = names.chain(OperandClass::ALL.iter().map(|class| class.name()));
    let names = names.chain(Keyword::ALL.iter().map(|keyword| keyword.name()));
    let names = names.chain(ObjectKind::ALL.iter().map(|kind| kind.name()));
    let names = names.chain(all_parameters().flat_map(|row| row.also.iter().copied().chain([row.field])));
    let names = names.chain(all_bits().flat_map(|row| row.also.iter().copied().chain([row.field])));
    let names = names.chain(models().iter().map(|model| model.name));
    nearest(topic, names).into_iter().take(MOST).collect()
}

/// The word most similar to one that starts no statement, if any is similar: `VEL` for `VLE`.
pub fn nearest_command(word: &str) -> Option<&'static str> {
    let words =
        all_commands().filter(|command| command.parent.is_none() && !command.clause).map(|command| command.name);
    let words = words.filter(|name| name.bytes().all(|byte| byte.is_ascii_alphabetic()));
    nearest(word, words).first().copied()
}

/// Names within a third of their length, by distance and then by name.
fn nearest(word: &str, names: impl Iterator<Item = &'static str>) -> Vec<&'static str> {
    let letters = |text: &str| text.bytes().map(|byte| byte.to_ascii_uppercase()).collect::<Vec<u8>>();
    let word = letters(word);
    let limit = (word.len() / 3).clamp(1, 3);
    let mut found: Vec<(usize, &str)> = names
        .filter(|name| name.len().abs_diff(word.len()) <= limit && name.len() > limit)
        .map(|name| (distance(&word, &letters(name)), name))
        .filter(|(distance, _)| *distance <= limit)
        .collect();
    found.sort_unstable();
    found.dedup();
    found.into_iter().map(|(_, name)| name).collect()
}

/// Insertions, deletions, replacements and exchanges of neighbours that turn one word into the other.
fn distance(left: &[u8], right: &[u8]) -> usize {
    let mut before: Vec<usize> = Vec::new();
    let mut row: Vec<usize> = (0..=right.len()).collect();
    for (i, letter) in left.iter().enumerate() {
        let mut next = vec![i + 1];
        for (j, other) in right.iter().enumerate() {
            let replaced = row[j] + usize::from(letter != other);
            let mut best = replaced.min(row[j + 1] + 1).min(next[j] + 1);
            if i > 0 && j > 0 && *letter == right[j - 1] && left[i - 1] == *other {
                best = best.min(before[j - 1] + 1);
            }
            next.push(best);
        }
        before = std::mem::replace(&mut row, next);
    }
    row[right.len()]
}
