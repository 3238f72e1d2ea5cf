//! Positions that marks and inputs capture (guide, "Homing": `MSEEK`; command list: `INTCAP`, `HSINT`).

use crate::support::Sim;

const MARKS: &str = "[axis.0]\nmarker = { every = 10, at = 2.5 }\ncapture_inputs = [24, 25]\n";

#[test]
fn a_mark_captures_the_position() {
    let body = "AXIS0 PPU 1000\nINTCAP X0\nPRINT BIT 777\nX10\nINH 777\nPRINT P12292; \" \"; P12290 - P12292 < 10\nINH -516\n\
                X11\nINH -516\nX20\nINH -516\nPRINT P12292\nINTCAP X0\nX0\nINH 777\nPRINT P12292";
    assert_eq!(Sim::program(body).world(MARKS).prints(), ["0", "2500 -1", "2500", "12500"]);
}

#[test]
fn inputs_capture_at_their_edges() {
    let world = format!(
        "{MARKS}[[event]]\nat = 0.5\nset = [24]\n[[event]]\nat = 0.6\nclear = [24]\n[[event]]\nat = 0.7\nset = [25]\n"
    );
    let run = |mode: u8| {
        let body = format!("AXIS0 PPU 1000\nAXIS0 INTCAP {mode}\nX10\nINH -516\nPRINT BIT 777; P12292");
        Sim::program(&body).world(&world).prints()
    };
    // The move begins behind its statement, in the second slice: 10 units/s after a ramp of 0.1 s.
    let captured =
        |prints: Vec<String>| prints[0].strip_prefix("-1").and_then(|text| text.parse::<f64>().ok()).unwrap_or(0.0);
    let at = [2, 6, 3].map(|mode| captured(run(mode)));
    assert!(at.iter().zip([4500.0, 5500.0, 6500.0]).all(|(at, near)| (at - near).abs() < 50.0), "{at:?}");
    assert_eq!(run(7), ["00"]);
}

#[test]
fn another_encoder_may_be_captured() {
    let world = format!("{MARKS}[axis.1]\nmarker = {{ at = 1 }}\n");
    let body =
        "AXIS0 PPU 1000 : AXIS1 PPU 1000\nINTCAP X 0 ENC1\nX10 Y5\nINH -516\nPRINT BIT 777; P12292; \" \"; BIT 809";
    assert_eq!(Sim::program(body).world(&world).prints(), ["-11000 0"]);
}

#[test]
fn the_mark_that_is_sought_becomes_zero() {
    let body = "AXIS0 PPU 1000\nX1\nINH -516\nMSEEK X(11, 0)\nX0 Y1\nINH -516\nPRINT BIT 777; P12292; \" \"; P12290; \" \"; P12289\nRES X7";
    let ran = Sim::program(body).world(MARKS).run().clean();
    assert_eq!(ran.record.output[0].text, "-12500 0 0");
    assert!(ran.notes().is_empty(), "{:?}", ran.notes());
}

#[test]
fn a_search_ramps_down_behind_the_mark_and_returns_to_it() {
    let body = "AXIS0 PPU 1000\nMSEEK X(11, 0)\nINH 777\nDWL 0.098\nPRINT P12290\nINH -516\nPRINT P12290";
    let prints = Sim::program(body).world(MARKS).prints();
    // It sees the capture a tick later, and a ramp from 10 with 100 takes 0.5 units.
    let beyond: f64 = prints[0].parse().expect("a number");
    assert!((2995.0..=3012.0).contains(&beyond) && prints[1] == "0", "{prints:?}");
}

#[test]
fn a_search_without_a_mark_goes_all_the_way() {
    let body = "MSEEK X(3, 0)\nINH -516\nPRINT BIT 777; P12290";
    let ran = Sim::program(body).run().clean();
    assert_eq!(ran.record.output[0].text, "03");
    assert_eq!(
        ran.notes(),
        [
            "AXIS0 moved with its drive off",
            "MSEEK met no marker on the way of axis 0",
            "capture mode 0 of axis 0: the world gives axis 0 no marker for it, so nothing is captured"
        ][1..]
    );
    let ran = Sim::program("MSEEK X(1, 0)\nINH -516\nPRINT BIT 777").world(MARKS).run().clean();
    assert_eq!(ran.notes(), ["MSEEK met no marker on the way of axis 0"]);
}

#[test]
fn axes_that_are_sought_together_stop_when_all_have_their_marks() {
    let world = "[axis.0]\nmarker = { at = 2 }\n[axis.1]\nmarker = { at = 4 }\n";
    let body = "AXIS0 PPU 1000 : AXIS1 PPU 1000\nMSEEK X(20, 0) Y(20, 0)\nINH -516\nPRINT P12292; \" \"; P12548; \" \"; P12290; P12546";
    assert_eq!(Sim::program(body).world(world).prints(), ["2000 4000 00"]);
}

#[test]
fn a_killed_search_leaves_the_registers_alone() {
    let world = format!("{MARKS}[[event]]\nat = 0.2\nset = [3]\n");
    let body = "AXIS0 PPU 1000\nMSEEK X(20, 0)\nINH 3\nSET 522\nINH -516\nP0 = P12290\nCLR 522\nX0\nINH -516\nPRINT P0 > 0; P12290";
    assert_eq!(Sim::program(body).world(&world).prints(), ["-10"]);
}

#[test]
fn modes_that_mean_nothing_are_said() {
    assert_eq!(Sim::program("INTCAP X16").faults(), ["INTCAP: 16 is no capture mode: they are numbered 0 to 15"]);
    let ran = Sim::program("INTCAP X9").world(MARKS).run().clean();
    assert_eq!(ran.notes(), ["capture mode 9 of axis 0: what it waits for is not known; nothing is captured"]);
}

#[test]
fn an_input_redirects_a_move() {
    let world = format!("{MARKS}[[event]]\nat = 0.5\nset = [24]\n");
    let body = "AXIS0 PPU 1000\nHSINT X(2, 100, 3)\nINH -516\nPRINT BIT 798; BIT 777; P12290 - P12292";
    assert_eq!(Sim::program(body).world(&world).prints(), ["-1-13000"]);
}

#[test]
fn a_search_is_not_ended_by_what_the_one_before_captured() {
    let body =
        "AXIS0 PPU 1000\nMSEEK X(11, 0)\nX5\nINH -516\nMSEEK X(11, 0)\nX0\nINH -516\nPRINT P12292; \" \"; P12290";
    let ran = Sim::program(body).world(MARKS).run().clean();
    // The second mark is 10 units behind the first one, 5 behind the move.
    assert_eq!(ran.record.output[0].text, "10000 0");
    assert!(ran.notes().is_empty(), "{:?}", ran.notes());
}
