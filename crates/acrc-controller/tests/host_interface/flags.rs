//! Flags at once.

use crate::support::{Bench, TWO_AXES};

const IN_MOTION: u32 = 516;
const KILL_ALL_MOVES: u32 = 522;
const FEEDHOLD_REQUEST: u32 = 520;
const KILL_ALL_MOTION_X: u32 = 8467;
const DRIVE_ENABLE_X: u32 = 8465;
const RUN_REQUEST: u32 = 1032;

#[test]
fn an_output_is_set_and_cleared() {
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(bench.set_flag(32, true), Ok(()));
    assert_eq!(bench.ask("? BIT32"), "-1");
    assert_eq!(bench.set_flag(32, false), Ok(()));
    assert_eq!(bench.ask("? BIT32"), "0");
}

#[test]
fn a_flag_acts_before_what_waits_in_the_channel() {
    let mut bench = Bench::new(TWO_AXES);
    bench.ask("PROG0");
    bench.ask("X 100");
    bench.pass(1.0);
    assert!(bench.flag(IN_MOTION));
    assert_eq!(bench.set_flag(FEEDHOLD_REQUEST, true), Ok(()));
    bench.pass(1.0);
    let held = bench.position(0);
    bench.pass(1.0);
    assert_eq!(bench.position(0), held);
}

#[test]
fn kill_flags_stop_a_motion_until_they_are_cleared() {
    let mut bench = Bench::new(TWO_AXES);
    bench.ask("PROG0");
    bench.ask("X 100");
    bench.pass(1.0);
    assert_eq!(bench.set_flag(KILL_ALL_MOTION_X, true), Ok(()));
    bench.pass(1.0);
    assert!(bench.flag(KILL_ALL_MOVES) && !bench.flag(IN_MOTION));
    // The other axis of the master was killed with it.
    for flag in [KILL_ALL_MOTION_X, KILL_ALL_MOTION_X + 32] {
        assert!(bench.flag(flag));
        assert_eq!(bench.set_flag(flag, false), Ok(()));
    }
    assert_eq!(bench.set_flag(KILL_ALL_MOVES, false), Ok(()));
    assert_eq!(bench.ask("X 0"), "");
    bench.pass(20.0);
    assert_eq!(bench.position(0), 0.0);
}

#[test]
fn a_drive_is_enabled_and_disabled() {
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(bench.set_flag(DRIVE_ENABLE_X, true), Ok(()));
    assert!(bench.flag(DRIVE_ENABLE_X));
    assert_eq!(bench.set_flag(DRIVE_ENABLE_X, false), Ok(()));
    assert!(!bench.flag(DRIVE_ENABLE_X));
}

#[test]
fn a_run_request_starts_a_program_at_once() {
    let mut bench = Bench::new(&format!("{TWO_AXES}PROGRAM\nP1 = 5\nENDP\n"));
    assert_eq!(bench.set_flag(RUN_REQUEST, true), Ok(()));
    bench.pass(0.1);
    assert_eq!(bench.controller.parameter_long(1), Some(5));
}

#[test]
fn what_programs_may_not_set_is_refused() {
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(bench.set_flag(70_000, true), Err("BIT70000 is no flag of this controller".to_owned()));
    assert!(bench.set_flag(IN_MOTION, true).is_err());
    assert!(!bench.flag(IN_MOTION));
}
