//! End-of-travel limits (guide, "End-of-Travel Limits", "Limit Detection", "Input Assignment").

use crate::support::{Ran, Sim};

/// The limit inputs of X are on from one second on. A jog at 10 units/s is then at 9.5 units.
const POSITIVE: &str = "[[event]]\nat = 1\nset = [0]\n";
const NEGATIVE: &str = "[[event]]\nat = 1\nset = [1]\n";

fn limited(setup: &str, body: &str, world: &str) -> Ran {
    Sim::jogging(setup, body).world(world).until(3.0).run().clean()
}

/// Which of the flags of a range are set.
fn set(ran: &Ran, flags: std::ops::Range<i64>) -> Vec<i64> {
    flags.filter(|flag| ran.bit(*flag)).collect()
}

#[test]
fn a_hardware_limit_stops_a_jog_with_its_own_ramp() {
    let body = "JOG FWD X\nINH -792\nPRINT P12297, BIT 8467, BIT 8499, BIT 522, BIT 16132";
    // Without a ramp the axis stands at once; the program looks 2 ms later.
    for (ramp, expected) in [(100, "1100 10000"), (50, "1200 10500"), (0, "1002 9500")] {
        let timed = Sim::jogging(&format!("HLIM X3\nHLDEC X{ramp}"), body).world(POSITIVE).timed();
        assert_eq!(timed, [format!("{expected}\t-1\t-1\t-1\t-1")]);
    }
}

#[test]
fn limits_that_are_not_enabled_stop_nothing() {
    for setup in ["", "HLIM X2", "HLIM X3\nHLIM X0", "HLIM Y3"] {
        let ran = limited(setup, "JOG FWD X", POSITIVE);
        assert_eq!((ran.velocity(0), ran.bit(8467), ran.bit(16_132)), (10.0, false, false), "{setup}");
        assert!(ran.bit(16_128), "the input shows all the same");
    }
}

#[test]
fn a_limit_stops_motion_towards_its_side_only() {
    for (statement, world, stops) in [
        ("JOG FWD X", POSITIVE, true),
        ("JOG FWD X", NEGATIVE, false),
        ("JOG REV X", POSITIVE, false),
        ("JOG REV X", NEGATIVE, true),
    ] {
        let ran = limited("HLIM X3", statement, world);
        assert_eq!(ran.velocity(0) == 0.0, stops, "{statement}");
        assert_eq!(ran.bit(8467), stops, "{statement}");
    }
    assert_eq!(set(&limited("HLIM X3", "JOG REV X", NEGATIVE), 16_128..16_136), [16_129, 16_133]);
}

#[test]
fn hlim_and_slim_are_their_enable_flags() {
    let flags = |setup: &str| set(&limited(setup, "END", ""), 16_148..16_152);
    assert_eq!([0, 1, 2, 3].map(|value| flags(&format!("HLIM X{value}")).len()), [0, 1, 1, 2]);
    assert_eq!((flags("HLIM X1"), flags("HLIM X2")), (vec![16_148], vec![16_149]));
    assert_eq!((flags("SLIM X1"), flags("SLIM X2")), (vec![16_150], vec![16_151]));
    assert!(limited("SET 16148", "JOG FWD X", POSITIVE).bit(8467));
    let sim = Sim::jogging("", "HLIM X4");
    assert_eq!(sim.faults(), ["HLIM: 4 is not between 0 and 3"]);
}

#[test]
fn the_lowest_inputs_belong_to_the_lowest_axis() {
    let world = "[[event]]\nat = 1\nset = [3]\n";
    let ran = limited("HLIM X3 Y3\nHLDEC X100 Y100", "JOG FWD Y", world);
    assert_eq!(ran.position(1), 10.0);
    assert_eq!(set(&ran, 16_160..16_168), [16_160, 16_164]);
    assert_eq!(set(&ran, 16_128..16_136), [0; 0]);
}

#[test]
fn the_inputs_can_be_chosen() {
    let moved = |hlbit: &str, input: u32| {
        let world = format!("[[event]]\nat = 1\nset = [{input}]\n");
        limited(&format!("HLBIT {hlbit}\nHLIM X3"), "JOG FWD X", &world)
    };
    assert!(moved("X9", 9).bit(8467) && !moved("X9", 0).bit(8467));
    let ran = moved("X9", 10);
    assert_eq!(set(&ran, 16_128..16_131), [16_129]);
    assert_eq!(set(&moved("X9", 11), 16_128..16_131), [16_130]);
    assert_eq!(set(&moved("X(20, 7, 5)", 5), 16_128..16_131), [16_130]);
    assert_eq!(set(&moved("X(20, 7, 5)", 7), 16_128..16_131), [16_129]);
    assert!(moved("X(20, 7, 5)", 20).bit(8467));
}

#[test]
fn inputs_beyond_their_block_of_32_read_zero() {
    let ran = limited("HLBIT X31\nHLIM X3", "SET 32\nSET 33\nJOG REV X", "[[event]]\nat = 1\nset = [31]\n");
    assert_eq!((ran.velocity(0), set(&ran, 16_128..16_131)), (-10.0, vec![16_128]));
}

#[test]
fn levels_can_be_inverted() {
    let closed = "[[event]]\nat = 0\nset = [0, 1, 2]\n[[event]]\nat = 1\nclear = [0]\n";
    let ran = limited("SET 16144\nSET 16145\nSET 16146\nHLIM X3\nHLDEC X100", "JOG FWD X", closed);
    assert_eq!(ran.position(0), 10.0);
    assert_eq!(set(&ran, 16_128..16_134), [16_128, 16_132]);
    // Without a signal every inverted input is active.
    let ran = limited("SET 16144\nSET 16145\nSET 16146", "DWL 0.01", "");
    assert_eq!(set(&ran, 16_128..16_134), [16_128, 16_129, 16_130]);
}

#[test]
fn a_hardware_limit_stops_the_master_and_its_axes() {
    // X at 8 units/s and Y at 6; each ramps down by itself, and the way is left in the jog offsets.
    let world = "[[event]]\nat = 0.55\nset = [0]\n";
    let body = "X8 Y6\nDWL 1\nPRINT P12288, P12297, P12544, P12553";
    let ran = Sim::jogging("HLIM X3\nHLDEC X100 Y100", body).world(world).run().clean();
    assert_eq!(ran.record.output[0].text, "4000\t320\t3000\t180");
    assert!(!ran.bit(516) && ran.bit(522) && ran.bit(8499));
}

#[test]
fn the_way_of_the_ramp_goes_into_the_coordinated_position() {
    let world = "[[event]]\nat = 0.55\nset = [0]\n[[event]]\nat = 1\nclear = [0]\n";
    let body = "X8 Y6\nDWL 1\nCLR 8467\nCLR 8499\nCLR 522\nCLR 16132\nJOG RES X\nJOG RES Y\nPRINT P12288, P12544\n\
                X0 Y0\nINH -516\nPRINT P12294, P12550, BIT 16132";
    let sim = Sim::jogging("HLIM X3\nHLDEC X100 Y100", body).world(world);
    assert_eq!(sim.prints(), ["4320\t3180", "0\t0\t0"]);
}

#[test]
fn an_axis_leaves_a_limit_but_does_not_go_on_into_it() {
    let recover = "JOG FWD X\nINH -792\nCLR 8467\nCLR 8499\nCLR 522";
    let away = format!("{recover}\nJOG INC X-5\nINH -792\nPRINT P12297, BIT 8467");
    let sim = Sim::jogging("HLIM X3\nHLDEC X100", &away).world(POSITIVE);
    assert_eq!(sim.prints(), ["5000\t0"]);
    let on = format!("{recover}\nJOG INC X5\nINH -792\nPRINT BIT 8467, P12297 < 10010");
    let sim = Sim::jogging("HLIM X3\nHLDEC X100", &on).world(POSITIVE);
    assert_eq!(sim.prints(), ["-1\t-1"]);
}

#[test]
fn the_encountered_flag_stays_until_the_program_clears_it() {
    let world = format!("{POSITIVE}[[event]]\nat = 1.5\nclear = [0]\n");
    let body = "JOG FWD X\nDWL 2\nPRINT BIT 16128; BIT 16132\nCLR 16132\nDWL 0.1\nPRINT BIT 16132";
    assert_eq!(Sim::jogging("HLIM X3", body).world(&world).prints(), ["0-1", "0"]);
    // Its being set is a report, and stops nothing.
    let ran = limited("HLIM X3\nSET 16132", "JOG INC X5\nINH -792", "");
    assert_eq!((ran.position(0), ran.bit(16_132)), (5.0, true));
}

#[test]
fn a_limit_that_an_axis_at_rest_touches_waits_for_motion() {
    let ran = limited("HLIM X3", "DWL 2", POSITIVE);
    assert!(!ran.bit(8467) && !ran.bit(16_132) && ran.bit(16_128));
    assert!(limited("HLIM X3", "DWL 2\nJOG FWD X", POSITIVE).bit(8467));
    assert!(limited("HLIM X3", "DWL 2\nX10", POSITIVE).bit(8467));
}

#[test]
fn limits_may_be_enabled_in_motion() {
    let ran = limited("HLDEC X100", "JOG FWD X\nDWL 2\nHLIM X1", POSITIVE);
    // Seen in the next tick.
    assert_eq!((ran.position(0), ran.bit(8467)), (20.005, true));
}

#[test]
fn settings_that_are_loaded_act_at_once() {
    let body = "SLM X5\nSLIM X3\nESAVE\nSLIM X0\nELOAD\nX20\nDWL 3\nPRINT P12294 < 5010";
    assert_eq!(Sim::jogging("", body).prints(), ["-1"]);
}

const SOFTWARE: &str = "SLM X(10.002, -5.002)\nSLIM X3\nSLDEC X100 Y100";

#[test]
fn a_software_limit_stops_with_its_own_ramp_and_without_a_kill_request() {
    // The first tick behind 10.002 is at 10.005.
    let ran = limited(SOFTWARE, "JOG FWD X", "");
    assert_eq!((ran.position(0), ran.bit(8467), ran.bit(522)), (10.505, false, true));
    assert_eq!(set(&ran, 16_128..16_144), [16_140]);
    let ran = limited(SOFTWARE, "JOG REV X", "");
    assert_eq!((ran.position(0), ran.bit(522)), (-5.505, true));
    assert_eq!(set(&ran, 16_128..16_144), [16_141]);
    let at_once = limited("SLM X(10.002, -5.002)\nSLIM X3", "JOG FWD X", "");
    assert_eq!(at_once.position(0), 10.005);
}

#[test]
fn software_limits_that_are_not_enabled_stop_nothing() {
    for slim in [0, 2] {
        let ran = limited(&format!("SLM X(10, -5)\nSLIM X{slim}"), "JOG FWD X", "");
        assert_eq!((ran.velocity(0), ran.bit(16_140)), (10.0, false));
    }
}

#[test]
fn one_value_is_a_pair_of_software_limits() {
    let setup = "SLM X5.002\nSLIM X3";
    assert_eq!(limited(setup, "JOG FWD X", "").position(0), 5.005);
    assert_eq!(limited(setup, "JOG REV X", "").position(0), -5.005);
}

#[test]
fn an_axis_jogs_back_from_a_software_limit() {
    let body = "JOG FWD X\nINH -792\nPRINT BIT 16140\nJOG INC X-5\nINH -792\nPRINT P12297, BIT 16140";
    assert_eq!(Sim::jogging(SOFTWARE, body).prints(), ["-1", "5505\t0"]);
    let on = "JOG FWD X\nINH -792\nJOG INC X5\nINH -792\nPRINT P12297 < 10510";
    assert_eq!(Sim::jogging(SOFTWARE, on).prints(), ["-1"]);
}

#[test]
fn a_software_limit_stops_the_master_and_its_axes() {
    // At 10 units/s with X and Y alike, Y jogs besides.
    let ran = limited(SOFTWARE, "JOG FWD Y\nX50", "");
    assert_eq!((ran.position(0), ran.velocity(1)), (10.505, 0.0));
    assert!(ran.bit(522) && !ran.bit(516) && !ran.bit(8467) && !ran.bit(8499));
    let faults = Sim::jogging(SOFTWARE, "X50\nINH -516\nDWL 0.5\nX0").faults();
    assert_eq!(faults, ["master 0 has its Kill All Moves flag set (BIT522): it must be cleared before a move"]);
    let body = "X50\nINH -516\nINH -792\nCLR 522\nJOG RES X\nX0\nINH -516\nPRINT P12294, BIT 522";
    assert_eq!(Sim::jogging(SOFTWARE, body).prints(), ["0\t0"]);
}

#[test]
fn a_software_limit_looks_at_the_sum_of_the_profilers() {
    let ran = limited(SOFTWARE, "X6\nINH -516\nJOG FWD X", "");
    assert_eq!((ran.position(0), ran.bit(16_140)), (10.505, true));
    let cancelled = limited(SOFTWARE, "JOG ABS X-4\nINH -792\nX13\nINH -516", "");
    assert_eq!((cancelled.position(0), cancelled.bit(16_140)), (9.0, false));
}

#[test]
fn other_masters_go_on() {
    let other = "PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"A\"\nACC 100 STP 100 VEL 10\nPROGRAM\nA20\nENDP\n";
    let text =
        format!("{}{}HLIM X3\nPROGRAM\nJOG FWD X\nENDP\n{other}", crate::support::TWO_AXES, crate::support::JOGS);
    let ran = Sim::new(&text).start(&[0, 1]).world(POSITIVE).run().clean();
    assert_eq!((ran.position(2), ran.bit(554), ran.bit(8467)), (20.0, false, true));
}
