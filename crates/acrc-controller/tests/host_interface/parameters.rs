//! Parameters by number.

use acrc_controller::Override;

use crate::support::{Bench, TWO_AXES};

const CURRENT_POSITION_X: u32 = 12288;
const PPU_X: u32 = 12375;

#[test]
fn positions_are_long_integers_in_pulses() {
    let mut bench = Bench::new(TWO_AXES);
    bench.ask("PROG0");
    bench.ask("X 1.5");
    bench.pass(1.0);
    assert_eq!(bench.controller.parameter_long(CURRENT_POSITION_X), Some(1500));
    assert_eq!(bench.controller.parameter_single(CURRENT_POSITION_X), Some(1500.0));
    assert_eq!(bench.controller.parameter_field(CURRENT_POSITION_X), Some(1500));
}

#[test]
fn a_single_goes_over_the_line_in_its_own_form() {
    let bench = Bench::new(TWO_AXES);
    assert_eq!(bench.controller.parameter_field(PPU_X), Some(1000.0_f32.to_bits()));
    assert_eq!(bench.controller.parameter_long(PPU_X), Some(1000));
}

#[test]
fn user_parameters_are_converted_to_what_is_asked_for() {
    let mut bench = Bench::new(TWO_AXES);
    for (value, long, single) in [
        ("-2.75", -2, -2.75),
        ("3000000000", -1_294_967_296, 3e9),
        ("1E12", i32::MAX, 1e12),
        ("-1E12", i32::MIN, -1e12),
        ("1E300", i32::MAX, f32::MAX),
        ("-1E300", i32::MIN, f32::MIN),
        ("0.1", 0, 0.1),
    ] {
        bench.ask(&format!("P3 = {value}"));
        assert_eq!(bench.controller.parameter_long(3), Some(long), "{value}");
        assert_eq!(bench.controller.parameter_single(3), Some(single), "{value}");
        assert_eq!(bench.controller.parameter_field(3), Some(single.to_bits()), "{value}");
    }
}

#[test]
fn what_does_not_exist_has_no_value() {
    let bench = Bench::new(TWO_AXES);
    for parameter in [10, 4095, 60_000, u32::MAX] {
        assert_eq!(bench.controller.parameter_long(parameter), None, "P{parameter}");
        assert_eq!(bench.controller.parameter_single(parameter), None, "P{parameter}");
        assert_eq!(bench.controller.parameter_field(parameter), None, "P{parameter}");
    }
}

#[test]
fn a_parameter_is_set_as_a_program_sets_it() {
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(bench.set_single(9, -0.5), Ok(()));
    assert_eq!(bench.ask("? P9"), "-0.5");
    assert_eq!(bench.set_long(CURRENT_POSITION_X, 2500), Ok(()));
    assert_eq!(bench.position(0), 2.5);
    assert_eq!(bench.set_long(PPU_X, 500), Ok(()));
    assert_eq!((bench.position(0), bench.ask("? P12288")), (5.0, "2500".to_owned()));
}

#[test]
fn what_a_program_may_not_set_is_refused() {
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(bench.set_long(10, 1), Err("P10 is outside DIM P(10)".to_owned()));
    assert_eq!(bench.set_long(60_000, 1), Err("P60000 is no parameter of this controller".to_owned()));
    assert_eq!(bench.set_single(1, f32::INFINITY), Err("inf is no finite number".to_owned()));
    assert_eq!(bench.set_single(1, f32::NAN), Err("NaN is no finite number".to_owned()));
    assert_eq!(bench.controller.parameter_single(1), Some(0.0));
}

#[test]
fn a_mask_clears_bits_and_then_sets_bits() {
    let mut bench = Bench::new(TWO_AXES);
    // The guide's own example: all outputs off, then output 32 on.
    bench.ask("SET 33 : SET 63");
    assert_eq!(bench.mask(4097, 0xFFFF_FFFF, 1), Ok(()));
    assert_eq!(bench.controller.parameter_long(4097), Some(1));
    assert!(bench.flag(32) && !bench.flag(33) && !bench.flag(63));
    assert_eq!(bench.mask(4097, 1, 0b101), Ok(()));
    assert_eq!(bench.controller.parameter_long(4097), Some(0b101));
}

#[test]
fn a_mask_is_for_long_integers_only() {
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(bench.mask(PPU_X, 1, 1), Err("P12375 is no long integer, so it has no bits to mask".to_owned()));
    assert_eq!(bench.mask(0, 1, 1), Err("P0 is no long integer, so it has no bits to mask".to_owned()));
}

#[test]
fn a_waiting_program_sees_what_a_host_sets() {
    let mut bench = Bench::new(&format!("{TWO_AXES}PROGRAM\nWHILE (P1 = 0)\nWEND\nP2 = 7\nENDP\nRUN\n"));
    bench.pass(1.0);
    assert_eq!(bench.set_long(1, 1), Ok(()));
    bench.pass(0.1);
    assert_eq!(bench.controller.parameter_long(2), Some(7));
}

#[test]
fn overrides_act_on_the_masters_of_a_mask_at_once() {
    let mut bench = Bench::new(TWO_AXES);
    let mut set = |kind, masters, factor| {
        let set = bench.controller.set_override(kind, masters, factor, &mut bench.log);
        set.map_err(|error| error.to_string())
    };
    assert_eq!(set(Override::Feedrate, 0b1, 0.5), Ok(()));
    assert_eq!(set(Override::Rapid, 0b1, 0.25), Ok(()));
    assert_eq!(set(Override::Feedrate, 0b1, -1.0), Err("FOV: -1 is negative".to_owned()));
    assert_eq!(set(Override::Feedrate, 0b1, f32::NAN), Err("NaN is no finite number".to_owned()));
    let missing = "MASTER15 does not exist: this controller has MASTER0 to MASTER7".to_owned();
    assert_eq!(set(Override::Feedrate, 0x8002, 0.75), Err(missing));
    bench.ask("PROG0");
    assert_eq!((bench.ask("FOV"), bench.ask("ROV")), ("0.5".to_owned(), "0.25".to_owned()));
    bench.ask("PROG1");
    bench.ask("ATTACH MASTER1");
    assert_eq!(bench.ask("FOV"), "0.75");
}

#[test]
fn a_moving_master_follows_its_override() {
    let mut bench = Bench::new(TWO_AXES);
    bench.ask("PROG0");
    bench.ask("X 100");
    bench.pass(1.0);
    bench.controller.set_override(Override::Feedrate, 1, 0.5, &mut bench.log).expect("a factor");
    bench.pass(1.0);
    assert_eq!(bench.controller.view().motion(0).0, 5.0);
}

#[test]
fn reading_needs_no_memory() {
    let bench = Bench::new(TWO_AXES);
    let read = || {
        [3, 10, 4097, CURRENT_POSITION_X, PPU_X, 60_000].map(|parameter| {
            let controller = &bench.controller;
            (controller.parameter_long(parameter), controller.parameter_single(parameter))
        })
    };
    read();
    let allocated = allocation_counter::measure(|| {
        std::hint::black_box(read());
    });
    assert_eq!(allocated.count_total, 0);
}
