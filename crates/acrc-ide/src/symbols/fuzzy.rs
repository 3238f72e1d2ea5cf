//! How well a name fits what somebody typed to find it.

/// The rank of a name that holds the characters of `pattern` in their order, in any case; a lower one is better. `None` for
/// a name that does not hold them. Blanks in the pattern do not count.
pub(super) fn rank(pattern: &str, name: &str) -> Option<u32> {
    let mut rank = 0;
    let mut at = 0;
    let characters: Vec<char> = name.chars().collect();
    let wanted: Vec<char> = pattern.chars().filter(|character| !character.is_whitespace()).collect();
    for (place, character) in wanted.iter().enumerate() {
        let found = (at..characters.len())
            .find(|&index| characters.get(index).is_some_and(|other| other.eq_ignore_ascii_case(character)))?;
        let skipped = found - at;
        // A gap that ends where a word of the name begins is what people mean by initials.
        let initial = characters.get(found).is_some_and(|other| other.is_uppercase() || other.is_ascii_digit());
        let cost = match (skipped, place) {
            (0, _) => 0,
            _ if initial => 2,
            (_, 0) => 6,
            _ => 4 + skipped,
        };
        rank += cost as u32 * 8;
        rank += u32::from(characters.get(found) != Some(character));
        at = found + 1;
    }
    // Of names that fit alike the shorter one is nearer.
    Some(rank + (characters.len() - at).min(7) as u32)
}

#[cfg(test)]
mod tests {
    use super::rank;

    #[test]
    fn better_fits_have_lower_ranks() {
        let order = |pattern: &str, names: &[&str]| {
            let ranks: Vec<u32> = names.iter().map(|name| rank(pattern, name).expect("it fits")).collect();
            assert!(ranks.is_sorted(), "{pattern}: {names:?} {ranks:?}");
        };
        order("clamp", &["clamp", "Clamp", "ClampOpen", "OpenClamp", "CrateLamp"]);
        order("co", &["Co", "ClampOpen", "Second"]);
        order("", &["A", "Ab"]);
    }

    #[test]
    fn what_is_missing_does_not_fit() {
        assert_eq!(rank("clamps", "Clamp"), None);
        assert_eq!(rank("pm", "Clamp"), None);
        assert!(rank("c p", "Clamp").is_some());
    }
}
