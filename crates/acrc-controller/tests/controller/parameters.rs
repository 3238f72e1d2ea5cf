//! Parameters: positions, scaling, encoders, user parameters (guide, "System Parameters and Flags", "Primary Setpoint").

use crate::support::{Sim, TWO_AXES};

#[test]
fn positions_are_whole_pulses() {
    let sim = Sim::program(
        "PPU X1000\nX1.5\nPRINT P12289\nINH -516\nPRINT P12288, P12289, P12290, P12291, P12294, P12295\nPRINT P12544",
    );
    assert_eq!(sim.prints(), ["1500", "1500\t1500\t1500\t0\t1500\t1500", "0"]);
}

#[test]
fn pulses_per_unit_keep_the_pulses() {
    let sim =
        Sim::program("PPU X1000\nX1\nINH -516\nPPU X500\nPRINT P12288, P12375\nX3\nINH -516\nPRINT P12288\nPPU X");
    assert_eq!(sim.prints(), ["1000\t500", "1500", "500"]);
    assert_eq!(Sim::program("P12375 = 200\nPPU X\nPPU X100\nPRINT P12375").prints(), ["200", "100"]);
}

#[test]
fn pulses_per_unit_are_above_zero() {
    for statement in ["PPU X0", "PPU X-1", "P12375 = 0"] {
        let fault = Sim::program(statement).faults();
        assert!(fault.len() == 1 && fault[0].contains("is not above 0"), "{fault:?}");
    }
    // The position in units would be beyond the range of numbers.
    assert_eq!(Sim::program("RES X1e300\nPPU X1e-300").faults().len(), 1);
    assert_eq!(Sim::new("SYS\nAXIS5 RES 1e300\nAXIS5 PPU 1e-300\n").faults().len(), 1);
}

#[test]
fn scaling_and_position_stay_while_an_axis_moves() {
    for statement in ["PPU X2", "RES X", "P12288 = 5", "REN X"] {
        assert_eq!(Sim::program(&format!("X10\n{statement}")).faults().len(), 1, "{statement}");
    }
}

#[test]
fn res_sets_every_register_of_an_axis() {
    let sim =
        Sim::program("X10 Y10\nINH -516\nRES X4\nPRINT P12288, P12289, P12290, P12544\nRES\nPRINT P12288, P12544");
    assert_eq!(sim.prints(), ["4\t4\t4\t10", "0\t0"]);
    assert_eq!(Sim::new("SYS\nAXIS5 RES 7\nPRINT P13568\n").prints(), ["7"]);
}

#[test]
fn a_written_position_is_taken_over() {
    let sim = Sim::program("PPU X100\nP12288 = 250\nPRINT P12288, P12289, P12290\nX/1\nINH -516\nPRINT P12290");
    assert_eq!(sim.prints(), ["250\t250\t250", "350"]);
}

#[test]
fn a_copy_of_the_position_in_the_target_changes_nothing() {
    let sim = Sim::program("X10\nINH -516\nREN X\nP12289 = P12288\nX/5\nINH -516\nPRINT P12288, P12289");
    assert_eq!(sim.prints(), ["15\t15"]);
}

#[test]
fn ren_changes_nothing_on_an_ideal_axis() {
    assert_eq!(Sim::program("X10\nINH -516\nREN X Y\nPRINT P12288").prints(), ["10"]);
}

#[test]
fn encoders_have_a_count_of_their_own() {
    let sim = Sim::program(
        "PPU X100\nX1\nINH -516\nPRINT P6144, P6160\nENC0 RES 7\nPRINT P6144, P12290\nX2\nINH -516\nPRINT P6144, P12290\n\
         ENC0 RES\nPRINT P6144\nP6144 = 3\nPRINT P6144",
    );
    assert_eq!(sim.prints(), ["100\t0", "7\t100", "107\t200", "0", "3"]);
}

#[test]
fn the_vector_velocity_can_be_read() {
    assert_eq!(Sim::program("X8 Y6\nDWL 0.5\nPRINT P8193\nINH -516\nPRINT P8193").prints(), ["10", "0"]);
}

#[test]
fn user_parameters_exist_as_far_as_dim_p_says() {
    assert_eq!(Sim::program("P9 = 1.5\nPRINT P9").prints(), ["1.5"]);
    assert_eq!(Sim::program("P10 = 1").faults(), ["P10 is outside DIM P(10)"]);
    assert_eq!(Sim::program("PRINT P4095").faults(), ["P4095 is outside DIM P(10)"]);
    assert_eq!(Sim::new("PROG0\nPROGRAM\nP0 = 1\nENDP\n").start(&[0]).faults(), ["P0 is outside DIM P(0)"]);
}

#[test]
fn user_parameters_belong_to_all_programs() {
    let text = format!("{TWO_AXES}PROGRAM\nP0 = 42\nENDP\nPROG1\nPROGRAM\nDWL 0.1\nPRINT P0\nENDP\n");
    assert_eq!(Sim::new(&text).start(&[0, 1]).prints(), ["42"]);
}

#[test]
fn numbers_that_are_no_parameter_are_refused() {
    for number in [-1, 99_999_999] {
        let fault = format!("P{number} is no parameter of this controller");
        assert_eq!(Sim::program(&format!("PRINT P({number})")).faults(), [&*fault]);
        assert_eq!(Sim::program(&format!("P({number}) = 1")).faults(), [fault]);
    }
}

#[test]
fn read_only_parameters_keep_their_value() {
    assert_eq!(Sim::program("P12291 = 1").faults(), ["P12291 (Following Error) is read-only"]);
    assert_eq!(Sim::program("P12294 = 1").faults(), ["P12294 (Primary Setpoint) is read-only"]);
}

#[test]
fn a_parameter_without_behaviour_keeps_what_is_written() {
    assert_eq!(Sim::program("P12348 = 2.5\nPRINT P12348\nPRINT P12350").prints(), ["2.5", "0"]);
}

#[test]
fn a_written_value_takes_the_form_of_the_parameter() {
    assert_eq!(
        Sim::program("P28672 = 1.9\nP12304 = 0.1\nP38912 = 2.5\nP39168 = 2.5\nPRINT P28672, P12304, P38912, P39168")
            .prints(),
        ["1\t0.1\t2\t2.5"]
    );
    // The form of P12400 is in no document: whole numbers are longs.
    assert_eq!(Sim::program("P12400 = 2.5\nPRINT P12400\nP12400 = 3\nPRINT P12400").prints(), ["2.5", "3"]);
    assert_eq!(Sim::program("P12304 = 1E300").faults(), ["P12304 cannot hold 1e+300"]);
}

#[test]
fn parameters_have_their_documented_values_at_power_up() {
    let printed = "PRINT P12304, P12336, P12337, P6402, P6410, P32768, P32773, P33024, P33040";
    assert_eq!(Sim::program(printed).prints(), ["0.002441406\t10\t-10\t3276.8\t10\t5\t500\t1\t0"]);
    assert_eq!(Sim::program("P32772 = 20\nPRINT P32773").prints(), ["200"]);
}

#[test]
fn a_mask_clears_bits_and_then_sets_others() {
    assert_eq!(Sim::program("P4097 = 15\nMASK P4097 (3, 48)\nPRINT P4097").prints(), ["60"]);
    assert_eq!(Sim::program("P0 = 7\nMASK P0 (2, 8)\nPRINT P0").prints(), ["13"]);
    assert_eq!(Sim::program("MASK P4096 (0, 1)").faults().len(), 1);
}
