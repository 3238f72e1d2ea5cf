//! Numbers for people.

/// A number as people read it: `8,420`.
pub fn grouped(value: u64) -> String {
    let digits = value.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::grouped;

    #[test]
    fn thousands_are_set_off() {
        let texts = [0, 7, 999, 1_000, 8_420, 65_536, 1_048_576].map(grouped);
        assert_eq!(texts, ["0", "7", "999", "1,000", "8,420", "65,536", "1,048,576"]);
    }
}
