//! The log of statements: exact as long as there is room, and right to within its resolution beyond that.

use acrc_trace::{Entry, Place, StatementLog};
use proptest::prelude::*;

fn entry(time: f64, line: u32, state: &'static str) -> Entry {
    Entry { time, place: Place { file: Some(0), line, statement: 1 }, state }
}

/// Where a program stood at a time, as the log has it.
fn at(log: &StatementLog, name: &str, time: f64) -> Option<(u32, &'static str)> {
    let program = log.programs().find(|program| program.name == name)?;
    program.entries.iter().rev().find(|entry| entry.time <= time).map(|entry| (entry.place.line, entry.state))
}

#[test]
fn only_changes_are_kept() {
    let mut log = StatementLog::new(100);
    for millisecond in 0..1000 {
        let line = if millisecond < 600 { 4 } else { 5 };
        log.record(0, || "PROG0".to_owned(), entry(f64::from(millisecond) * 0.001, line, "waiting"));
    }
    log.record(0, || unreachable!("the name is known"), entry(1.0, 5, "ended"));
    let entries = &log.programs().next().expect("a program").entries;
    assert_eq!(entries[..], [entry(0.0, 4, "waiting"), entry(0.6, 5, "waiting"), entry(1.0, 5, "ended")]);
    assert_eq!(log.resolution(), 0.0);
}

#[test]
fn programs_have_logs_of_their_own() {
    let mut log = StatementLog::new(100);
    log.record(2, || "PLC0".to_owned(), entry(0.0, 1, "running"));
    log.record(0, || "PROG3".to_owned(), entry(0.5, 7, "running"));
    assert_eq!(log.programs().map(|program| program.name.as_str()).collect::<Vec<_>>(), ["PROG3", "PLC0"]);
    assert_eq!((at(&log, "PROG3", 1.0), at(&log, "PLC0", 1.0)), (Some((7, "running")), Some((1, "running"))));
}

#[test]
fn a_busy_program_makes_the_log_coarser_and_long_statements_stay() {
    let mut log = StatementLog::new(50);
    log.record(1, || "PROG1".to_owned(), entry(0.0, 3, "waiting"));
    for millisecond in 0_u32..10_000 {
        let line = if (4000..6000).contains(&millisecond) { 99 } else { 10 + millisecond % 4 };
        log.record(0, || "PROG0".to_owned(), entry(f64::from(millisecond) * 0.001, line, "running"));
    }
    log.record(1, || "PROG1".to_owned(), entry(7.777, 4, "waiting"));
    let entries: usize = log.programs().map(|program| program.entries.len()).sum();
    assert!(entries <= 50, "{entries}");
    let resolution = log.resolution();
    assert!(resolution > 0.0 && resolution <= 1.024, "{resolution}");
    assert_eq!(at(&log, "PROG0", 4.0 + resolution), Some((99, "running")));
    assert_eq!(at(&log, "PROG0", 5.999), Some((99, "running")));
    assert_eq!((at(&log, "PROG1", 7.7), at(&log, "PROG1", 8.0)), (Some((3, "waiting")), Some((4, "waiting"))));
}

proptest! {
    #[test]
    fn the_log_is_right_to_within_its_resolution(
        steps in prop::collection::vec((1_u32..2000, 0_u32..5), 1..300),
        limit in 4_usize..40,
    ) {
        let mut log = StatementLog::new(limit);
        let mut truth: Vec<(f64, u32)> = Vec::new();
        let mut now = 0;
        for (step, line) in steps {
            now += step;
            let time = f64::from(now) * 0.001;
            log.record(0, || "PROG0".to_owned(), entry(time, line, "running"));
            truth.push((time, line));
        }
        let entries = &log.programs().next().expect("a program").entries;
        prop_assert!(entries.len() <= limit);
        // Whatever the log says of a time was true at some time within the resolution.
        for pair in entries.windows(2) {
            let probe = pair[1].time - 1e-9;
            let said = at(&log, "PROG0", probe).map(|(line, _)| line);
            let near = truth.windows(2).filter(|pair| pair[0].0 <= probe && pair[1].0 >= probe - log.resolution());
            prop_assert!(near.map(|pair| Some(pair[0].1)).any(|line| line == said));
        }
    }
}
