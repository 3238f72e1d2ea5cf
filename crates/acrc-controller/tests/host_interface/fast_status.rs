//! Fast status.

use acrc_controller::{FAST_STATUS_GROUPS, FastStatus};

use crate::support::{Bench, TWO_AXES};

const NOTHING: FastStatus = [[0; 8]; FAST_STATUS_GROUPS];

#[test]
fn nothing_is_shown_before_groups_are_chosen() {
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(bench.controller.fast_status(), NOTHING);
}

#[test]
fn a_group_has_a_parameter_of_eight_axes_or_eight_in_a_row() {
    let mut bench = Bench::new(&format!("{TWO_AXES}FSTAT0 (48, 2)\nFSTAT9 (16, 1)\nFSTAT1 (48, 87)\n"));
    bench.ask("PROG0");
    bench.ask("X 1.5 Y -2");
    bench.ask("SET 33");
    bench.pass(2.0);
    let status = bench.controller.fast_status();
    assert_eq!(status[0], [1500, (-2000_i32).cast_unsigned(), 0, 0, 0, 0, 0, 0]);
    assert_eq!(status[1][..3], [1000.0_f32.to_bits(), 1000.0_f32.to_bits(), 1.0_f32.to_bits()]);
    assert_eq!(status[9][..2], [2, 0]);
    assert_eq!(status[2], [0; 8]);
    let parameters = bench.controller.fast_status_parameters();
    assert_eq!(parameters[0], [12290, 12546, 12802, 13058, 13314, 13570, 13826, 14082].map(Some));
    assert_eq!(parameters[9], [4097, 4098, 4099, 4100, 4101, 4102, 4103, 4104].map(Some));
    assert_eq!(parameters[2], [None; 8]);
}

#[test]
fn a_group_that_does_not_exist_is_zero() {
    let mut bench = Bench::new(&format!("{TWO_AXES}FSTAT0 (255, 0)\nFSTAT1 (-1, 0)\nFSTAT2 (48, 300)\n"));
    assert_eq!(bench.controller.fast_status(), NOTHING);
}

#[test]
fn fstat_off_keeps_what_was_there_last() {
    let mut bench = Bench::new(&format!("{TWO_AXES}FSTAT0 (16, 1)\n"));
    assert_eq!(bench.controller.fast_status()[0][0], 0);
    bench.ask("FSTAT OFF");
    bench.ask("SET 32");
    assert_eq!(bench.controller.fast_status()[0][0], 0);
    bench.ask("FSTAT ON");
    assert_eq!(bench.controller.fast_status()[0][0], 1);
    bench.ask("FSTAT CLEAR");
    assert_eq!(bench.controller.fast_status(), NOTHING);
}

#[test]
fn fstat_period_is_the_time_between_two_updates() {
    let mut bench = Bench::new(&format!("{TWO_AXES}FSTAT0 (16, 1)\nFSTAT PERIOD 1000\n"));
    assert_eq!(bench.controller.fast_status()[0][0], 0);
    bench.set_flag(32, true).expect("an output");
    bench.pass(0.9);
    assert_eq!(bench.controller.fast_status()[0][0], 0);
    bench.pass(0.2);
    assert_eq!(bench.controller.fast_status()[0][0], 1);
}
