//! The time of a master: `SRC`, `TOV` (guide, "Coordinated Moves Profiler": the clock is the usual time base).

use crate::support::{Sim, TWO_AXES};

#[test]
fn moves_follow_the_counts_of_a_source() {
    // 2200 counts are 1.1 s of servo periods.
    let body =
        "SRC P0\nX10\nPRINT P12288\nP0 = 1100\nDWL 0.01\nPRINT P12288\nP0 = 2200\nDWL 0.01\nPRINT P12288; BIT(516)";
    assert_eq!(Sim::program(body).prints(), ["0", "5", "100"]);
}

#[test]
fn counts_back_take_the_move_back() {
    let body = "SRC P0\nX10\nP0 = 1100\nDWL 0.01\nP0 = 200\nDWL 0.01\nPRINT P12288; BIT(516)";
    assert_eq!(Sim::program(body).prints(), ["1-1"]);
    // 200 periods are 0.1 s: the end of the ramp, at half a unit.
    let sim = Sim::program(body).until(0.02).run().clean();
    assert_eq!(sim.position(0), 0.5);
}

#[test]
fn a_source_that_stands_lets_no_time_pass() {
    let ran = Sim::program("SRC NONE\nX10\nDWL 5\nPRINT P12288; BIT(516)\nSRC CLOCK\nINH -516").run().clean();
    assert_eq!(ran.record.output[0].text, "0-1");
    assert!((ran.milliseconds() - 6100.0).abs() < 5.0, "{}", ran.milliseconds());
    // A move that never comes to its end lasts as long as the run.
    let stuck = Sim::program("SRC P0\nX10\nINH -516").until(7.0).run().clean();
    assert_eq!((stuck.milliseconds(), stuck.bit(516)), (7000.0, true));
}

#[test]
fn a_master_follows_the_encoder_of_another() {
    // A runs 20 units at 10 u/s with 200 pulses each: 2000 counts/s, as fast as the clock.
    let attach = "ATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"A\"\nAXIS2 PPU 200\nACC 0 DEC 0 STP 0 VEL 10\n";
    let text = format!("{TWO_AXES}PROGRAM\nSRC ENC2\nX10\nENDP\nPROG1\n{attach}PROGRAM\nDWL 1\nA20\nENDP\n");
    let ran = Sim::new(&text).start(&[0, 1]).run().clean();
    assert_eq!(ran.position(0), 10.0);
    assert!((ran.milliseconds() - 3000.0).abs() < 5.0, "{}", ran.milliseconds());
    let half = Sim::new(&text).start(&[0, 1]).until(1.551).run().clean();
    assert!((half.position(0) - 5.0).abs() < 0.03, "{}", half.position(0));
    let velocity = half.controller.view().motion(0).0;
    assert!((velocity - 10.0).abs() < 1e-9, "{velocity}");
}

#[test]
fn only_counts_during_the_move_count() {
    let body = "SRC P0\nP0 = 5000\nX10\nDWL 0.1\nPRINT P12288\nP0 = 6100\nDWL 0.01\nPRINT P12288";
    assert_eq!(Sim::program(body).prints(), ["0", "5"]);
}

#[test]
fn a_time_override_stretches_moves() {
    let ran = Sim::program("TOV 0.5\nX10\nDWL 1\nPRINT P8193\nTOV\nINH -516").run().clean();
    assert_eq!(ran.milliseconds(), 2200.0);
    let output: Vec<_> = ran.record.output.iter().map(|line| line.text.as_str()).collect();
    assert_eq!(output, ["5", "0.5"], "half as fast along the path");
    let ran = Sim::program("TOV 0.5\nX10\nINH -516").run().clean();
    let axis = &ran.controller.axes()[0].statistics;
    assert_eq!((axis.peak_velocity, axis.peak_acceleration), (5.0, 25.0));
    let held = Sim::program("TOV 0\nX10\nDWL 1\nPRINT P12288\nTOV 1\nINH -516").run().clean();
    assert_eq!(held.record.output[0].text, "0");
}

#[test]
fn sources_are_reported_as_they_are_written() {
    let body = "SRC\nSRC ENC1\nSRC\nSRC P12290\nSRC\nSRC NONE\nSRC";
    assert_eq!(Sim::program(body).prints(), ["CLOCK", "ENC1", "P12290", "NONE"]);
    assert_eq!(Sim::program("SRC DAC0").faults(), ["SRC: DAC0 is no source that the dry run can follow"]);
    assert_eq!(Sim::program("SRC P99999").faults(), ["P99999 is no parameter of this controller"]);
    assert_eq!(Sim::program("TOV -1").faults(), ["TOV: -1 is negative"]);
}

#[test]
fn moves_can_follow_a_ratchet_and_a_limiter() {
    // The move takes 2,200 periods; counts back have to be made up for.
    let ratchet = "RATCH0 SRC P0\nRATCH0 MODE 3\nSRC RATCH0\nX10\nP0 = 1200\nDWL 0.01\nPRINT P12288\nP0 = 1000\nDWL 0.01\n\
                   PRINT P12288\nP0 = 2400\nDWL 0.01\nPRINT P12288, BIT(516)";
    assert_eq!(Sim::program(ratchet).prints(), ["6", "6", "10\t0"]);
    // At 1,000 counts/s they take 2.2 s, whatever the source does at once.
    let limiter = "LIMIT0 SRC P0\nLIMIT0 FREQ 1000\nSRC LIMIT0\nX10\nP0 = 5000\nINH -516";
    let milliseconds = Sim::program(limiter).run().clean().milliseconds();
    assert!((2200.0..2205.0).contains(&milliseconds), "{milliseconds}");
}

#[test]
fn feedhold_acts_in_the_time_of_the_source() {
    let body = "SRC P0\nX10\nP0 = 1000\nDWL 0.01\nSET 520\nDWL 1\nPRINT BIT(519)\nP0 = 1300\nDWL 0.01\nPRINT BIT(519)";
    assert_eq!(Sim::program(body).until(5.0).prints(), ["0", "-1"]);
}
