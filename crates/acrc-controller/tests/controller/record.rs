//! Programmable limit switches and data sampling.

use crate::support::Sim;

/// Outputs 32 and 33 come on over the second and third of four stretches of a thousand pulses.
const SWITCH: &str = "PPU X1000\nDIM LA(1)\nDIM LA0(4)\nLA0(1) = 1\nLA0(2) = 2\nPLS0 SRC P12294\nPLS0 BASE LA0\nPLS0 DST P4097\n\
                      PLS0 RATIO 0.001\nPLS0 MASK 3\n";

#[test]
fn a_limit_switch_sets_outputs_by_position() {
    let sim = Sim::program(&format!(
        "{SWITCH}SET 34\nPLS0 ON\nX1.5\nINH -516\nPRINT P4097\nX2.5\nINH -516\nPRINT P4097\nX3.5\nINH -516\nPRINT P4097\nX9\nINH -516\nPRINT P4097"
    ));
    // Output 34 is outside the mask; behind the table nothing changes.
    assert_eq!(sim.prints(), ["5", "6", "4", "4"]);
}

#[test]
fn a_limit_switch_that_is_off_leaves_its_outputs() {
    let sim = Sim::program(&format!("{SWITCH}PLS0 ON\nX1.5\nINH -516\nPLS0 OFF\nX2.5\nINH -516\nPRINT P4097"));
    assert_eq!(sim.prints(), ["1"]);
}

#[test]
fn a_limit_switch_can_wrap_and_begin_elsewhere() {
    let sim = Sim::program(&format!(
        "{SWITCH}PLS0 ROTARY 4\nPLS0 FLZ 500\nPLS0 ON\nX5.6\nINH -516\nPRINT P4097\nX6.4\nINH -516\nPRINT P4097"
    ));
    assert_eq!(sim.prints(), ["1", "1"]);
}

#[test]
fn a_limit_switch_follows_a_user_parameter() {
    let sim = Sim::program(&format!("{SWITCH}PLS0 SRC P3\nPLS0 RATIO 1\nPLS0 ON\nP3 = 2\nDWL 0.01\nPRINT P4097"));
    assert_eq!(sim.prints(), ["2"]);
}

#[test]
fn samples_are_taken_from_the_trigger_until_the_array_is_full() {
    // 100 u/s^2 from rest: after n periods of 0.5 ms at 1,000,000 pulses a unit.
    let sim = Sim::program(
        "PPU X1000000\nDIM LA(2)\nDIM LA0(4)\nDIM LA1(2)\nSAMP0 SRC P12288\nSAMP0 BASE LA0\nSAMP1 SRC P6916\nSAMP1 BASE LA1\nSAMP TRG 1930\n\
         X10\nPRINT LA0(3)\nDWL 0.2\nSET 1930\nINH -516\nPRINT LA0(1) - LA0(0), LA0(3) - LA0(2), LA1(1) - LA1(0) <= 1\n\
         LA0(0) = 7\nCLR 1930\nDWL 0.01\nSET 1930\nDWL 0.01\nPRINT LA0(0)",
    );
    assert_eq!(sim.prints(), ["0", "5000\t5000\t-1", "10000000"]);
}

#[test]
fn nothing_is_sampled_once_the_setup_is_cleared() {
    let sim = Sim::program(
        "DIM LA(1)\nDIM LA0(2)\nP5 = 9\nSAMP0 SRC P5\nSAMP0 BASE LA0\nSAMP TRG 1930\nSAMP CLEAR\nSET 1930\nDWL 0.01\nPRINT LA0(0)",
    );
    assert_eq!(sim.prints(), ["0"]);
}

#[test]
fn motion_can_trigger_samples() {
    // A sample each period from the moment at which X begins to move: 100 units/s^2 for 10 ms are 0.005 units.
    let body = "PPU X1000000\nDIM LA(1)\nDIM LA0(100)\nSAMP0 SRC P12288\nSAMP0 BASE LA0\nSAMP TRG 516\nDWL 1\nX10\nDWL 1\n\
                PRINT LA0(0) < LA0(1); LA0(20) - LA0(0) > 4900";
    assert_eq!(Sim::program(body).prints(), ["-1-1"]);
}

#[test]
fn a_program_that_goes_round_in_a_circle_sees_samples() {
    let body = "DIM LA(1)\nDIM LA0(2)\nP5 = 9\nSAMP0 SRC P5\nSAMP0 BASE LA0\nSAMP TRG 1930\nWHILE (LA0(1) = 0)\nWEND\nPRINT LA0(1)";
    let world = "[[event]]\nat = 5.0\nset = [1930]\n";
    assert_eq!(Sim::program(body).watched(false).world(world).prints(), ["9"]);
}
