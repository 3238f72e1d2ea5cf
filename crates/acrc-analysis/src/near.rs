//! "Did you mean": the nearest of a list of names.

/// The candidate nearest to `name`, if it is near enough to be what was meant: one typing error for up to four
/// letters, two for longer words. The first of equally near ones wins.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = if name.chars().count() <= 4 { 1 } else { 2 };
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        // The difference in length is a lower bound of the distance, and much cheaper.
        if candidate.len().abs_diff(name.len()) > limit || candidate == name {
            continue;
        }
        let distance = strsim::osa_distance(name, candidate);
        if distance <= limit && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn nearest_takes_one_slip_in_a_short_word_and_two_in_a_long_one() {
        let words = ["VEL", "ACC", "DRIVE", "PROGRAM"];
        assert_eq!(nearest("VLE", words), Some("VEL"));
        assert_eq!(nearest("VL", words), Some("VEL"));
        assert_eq!(nearest("PORGARM", words), Some("PROGRAM"));
        assert_eq!(nearest("X", words), None);
        assert_eq!(nearest("GANTRY", words), None);
    }
}
