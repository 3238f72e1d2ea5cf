//! A bar that shows how much of something is used.

/// A full cell.
const FULL: char = '█';
/// An empty cell.
const EMPTY: char = '░';

/// A bar of so many cells. What is used shows, however little it is, and so does what is free.
pub(super) fn bar(used: u64, total: u64, cells: usize) -> (String, String) {
    let full = if used == 0 {
        0
    } else if used >= total {
        cells
    } else {
        let exact = used as f64 / total as f64 * cells as f64;
        (exact.round() as usize).min(cells.saturating_sub(1)).max(cells.min(1))
    };
    (FULL.to_string().repeat(full), EMPTY.to_string().repeat(cells - full))
}

/// A share in percent, with a digit behind the point below ten.
pub(super) fn percent(used: u64, total: u64) -> String {
    if total == 0 {
        return String::new();
    }
    let percent = used as f64 / total as f64 * 100.0;
    match used {
        0 => "0 %".to_owned(),
        _ if percent < 0.1 => "< 0.1 %".to_owned(),
        _ if percent < 9.95 => format!("{percent:.1} %"),
        // What is not full is not said to be.
        _ if used < total => format!("{:.0} %", percent.min(99.0)),
        _ => format!("{percent:.0} %"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn full(used: u64, total: u64) -> usize {
        bar(used, total, 10).0.chars().count()
    }

    #[test]
    fn a_little_shows_and_nearly_all_is_not_all() {
        assert_eq!([full(0, 100), full(1, 1000), full(50, 100), full(999, 1000), full(1000, 1000)], [0, 1, 5, 9, 10]);
        assert_eq!([full(2000, 1000), full(5, 0), full(0, 0)], [10, 10, 0]);
        assert_eq!(bar(1, 2, 0), (String::new(), String::new()));
        assert_eq!(bar(1, 2, 1).0.chars().count(), 1);
    }

    #[test]
    fn percent_of_little_and_of_much() {
        let texts = [(0, 9), (1, 100_000), (1, 100), (1, 8), (999, 1000), (8, 8), (12, 8)].map(|(a, b)| percent(a, b));
        assert_eq!(texts, ["0 %", "< 0.1 %", "1.0 %", "12 %", "99 %", "100 %", "150 %"]);
    }
}
