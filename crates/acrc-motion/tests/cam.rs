//! The cam profiler: tables, passes, shift, presets.

use acrc_motion::axis::{Cam, CamError, CamReport, CamSegment, CamSettings};
use proptest::prelude::*;

const TICK: f64 = 0.0005;

/// A cam over 1,000 counts: up to 10 in the first 400, by way of 2, and down again in the other 600.
fn cam() -> Cam {
    let mut cam = Cam::default();
    cam.dim(2);
    cam.set_segment(0, CamSegment { length: 400.0, points: 3 }).unwrap();
    cam.set_segment(1, CamSegment { length: 600.0, points: 2 }).unwrap();
    cam.on();
    cam
}

fn closed(segment: usize, index: usize) -> f64 {
    [&[0.0, 2.0, 10.0][..], &[10.0, 0.0]][segment][index]
}

/// The same, but ending at 4 instead of 0.
fn incremental(segment: usize, index: usize) -> f64 {
    [&[0.0, 2.0, 10.0][..], &[10.0, 4.0]][segment][index]
}

#[test]
fn points_are_met_and_joined_by_straight_lines() {
    let mut x = cam();
    let offsets = [0.0, 100.0, 100.0, 100.0, 100.0, 300.0, 300.0].map(|counts| {
        x.advance(counts, TICK, &closed);
        x.offset()
    });
    assert_eq!(offsets, [0.0, 1.0, 2.0, 6.0, 10.0, 5.0, 0.0]);
    assert_eq!((x.cycles(), x.shift()), (1, 0.0));
    x.advance(-300.0, TICK, &closed);
    assert_eq!((x.offset(), x.cycles()), (5.0, 0));
    assert_eq!(x.velocity(), 5.0 / TICK);
}

#[test]
fn scale_and_offset_act_at_once() {
    let mut x = cam();
    x.advance(400.0, TICK, &closed);
    x.set_settings(CamSettings { scale: -2.0, offset: 3.0, ..CamSettings::default() }).unwrap();
    x.advance(0.0, TICK, &closed);
    assert_eq!(x.offset(), -17.0);
    x.set_settings(CamSettings { source_offset: -200.0, ..CamSettings::default() }).unwrap();
    x.advance(0.0, TICK, &closed);
    assert_eq!(x.offset(), 2.0);
}

#[test]
fn an_incremental_table_builds_up_a_shift() {
    let mut x = cam();
    for _ in 0..25 {
        x.advance(100.0, TICK, &incremental);
    }
    // Two passes of 4, and half of the way from 10 to 4 has 5 of 6 left to go.
    assert_eq!((x.cycles(), x.shift()), (2, 8.0));
    assert_eq!(x.offset(), 8.0 + 9.0);
    let report = x.advance(-2500.0, TICK, &incremental);
    assert_eq!(report, CamReport { cycles: -2, finished: false });
    assert_eq!((x.offset(), x.shift()), (0.0, 0.0));
}

#[test]
fn a_preset_clears_the_shift_and_stays() {
    let mut x = cam();
    x.advance(1200.0, TICK, &incremental);
    assert_eq!((x.offset(), x.shift()), (6.0, 4.0));
    x.preload(1.0).unwrap();
    assert_eq!((x.offset(), x.shift()), (1.0, 0.0));
    x.advance(0.0, TICK, &incremental);
    assert_eq!(x.offset(), 1.0);
    x.advance(200.0, TICK, &incremental);
    assert_eq!(x.offset(), 9.0);
    x.set_shift(100.0).unwrap();
    x.advance(0.0, TICK, &incremental);
    assert_eq!(x.offset(), 109.0);
}

#[test]
fn a_number_of_cycles_ends_it_at_the_end_of_the_table() {
    let mut x = cam();
    x.set_settings(CamSettings { cycles: 2, ..CamSettings::default() }).unwrap();
    let reports = [900.0, 900.0, 900.0, 900.0].map(|counts| x.advance(counts, TICK, &incremental));
    assert_eq!(reports.map(|report| report.cycles), [0, 1, 1, 0]);
    assert!(reports[2].finished && !x.is_on());
    assert_eq!(x.offset(), 8.0);
    x.on();
    x.advance(400.0, TICK, &incremental);
    assert_eq!(x.offset(), 18.0);
}

#[test]
fn off_the_source_is_not_followed() {
    let mut x = cam();
    x.advance(100.0, TICK, &closed);
    x.halt();
    x.advance(100.0, TICK, &closed);
    assert_eq!((x.offset(), x.velocity()), (1.0, 0.0));
    x.on();
    x.advance(100.0, TICK, &closed);
    assert_eq!(x.offset(), 2.0);
}

#[test]
fn tables_are_checked() {
    let mut x = Cam::default();
    x.on();
    assert_eq!(x.advance(5.0, TICK, &closed), CamReport::default());
    assert_eq!(x.set_segment(0, CamSegment { length: 1.0, points: 1 }), Err(CamError::NoSuchSegment(0)));
    x.dim(1);
    assert_eq!(x.set_segment(0, CamSegment { length: 0.0, points: 1 }), Err(CamError::Length(0.0)));
    assert_eq!(x.set_segment(0, CamSegment { length: 1.0, points: 0 }), Err(CamError::NoPoints));
    assert!(x.set_segment(0, CamSegment { length: f64::NAN, points: 1 }).is_err());
    x.set_segment(0, CamSegment { length: 10.0, points: 1 }).unwrap();
    x.on();
    x.advance(25.0, TICK, &|_, _| 7.0);
    assert_eq!((x.offset(), x.cycles()), (7.0, 2));
}

proptest! {
    #[test]
    fn the_output_is_a_function_of_the_source(steps in prop::collection::vec(-700_i32..700, 1..200)) {
        let mut walked = cam();
        for step in &steps {
            walked.advance(f64::from(*step), TICK, &incremental);
        }
        let total: i32 = steps.iter().sum();
        let mut jumped = cam();
        jumped.advance(f64::from(total), TICK, &incremental);
        prop_assert_eq!(walked.cycles(), i64::from(total.div_euclid(1000)));
        prop_assert_eq!(walked.offset(), jumped.offset());
    }

    #[test]
    fn the_output_of_an_incremental_table_never_jumps(start in -5000.0..5000.0_f64, step in -5.0..5.0_f64) {
        let mut x = cam();
        x.advance(start, TICK, &incremental);
        let before = x.offset();
        x.advance(step, TICK, &incremental);
        // The steepest stretch rises 8 in 200 counts.
        prop_assert!((x.offset() - before).abs() <= step.abs() * 0.04 + 1e-9);
    }
}
