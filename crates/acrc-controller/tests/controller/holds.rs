//! Feedhold, cycle start, Kill All Moves, Stop All Moves (guide, "Kill All Moves", "Using Parameters and Bits").

use crate::support::{Sim, TWO_AXES};

/// Program 0 makes a move of 10 units; program 1 does something to it from 0.5 s on.
fn disturbed(body: &str, disturbance: &str) -> Sim {
    Sim::new(&format!("{TWO_AXES}PROGRAM\n{body}\nENDP\nPROG1\nPROGRAM\nDWL 0.5\n{disturbance}\nENDP\n")).start(&[0, 1])
}

#[test]
fn feedhold_brakes_with_dec_and_cycle_start_goes_on() {
    let ran = disturbed("X10", "SET 520").until(2.0).run().clean();
    // 4.5 units at 0.5 s (program 1 has its slice 1 ms later), then 0.5 units of ramp.
    assert!((ran.position(0) - 5.0).abs() < 0.05, "{}", ran.position(0));
    assert!(ran.bit(519) && !ran.bit(518) && !ran.bit(520) && ran.bit(516));
    let ran = disturbed("X10\nINH -516\nPRINT \"there\"", "SET 520\nDWL 5\nSET 521").run().clean();
    assert_eq!((ran.position(0), ran.bit(519)), (10.0, false));
    // Cycle start at 5.501 s, half of the way to go: 0.1 s up, 4 units at 10 u/s, 0.1 s down.
    assert_eq!(ran.milliseconds(), 6101.0);
}

#[test]
fn a_held_master_takes_moves_and_does_not_begin_them() {
    let ran = Sim::program("SET 520\nX10\nPRINT \"given\"\nDWL 1\nPRINT P12288\nSET 521\nINH -516\nPRINT P12288");
    assert_eq!(ran.prints(), ["given", "0", "10"]);
}

#[test]
fn kill_all_moves_stops_without_a_ramp_and_refuses_moves_until_it_is_cleared() {
    let ran = disturbed("X10\nX20\nINH -516\nX30\nPRINT \"no\"", "SET 522").run();
    assert!((ran.position(0) - 4.5).abs() < 0.05, "{}", ran.position(0));
    assert!(ran.bit(522) && !ran.bit(516));
    assert_eq!(
        ran.record.faults[0].message,
        "master 0 has its Kill All Moves flag set (BIT522): it must be cleared before a move"
    );
    let ran = Sim::program("SET 522\nCLR 522\nX10\nINH -516").run().clean();
    assert_eq!(ran.position(0), 10.0);
}

#[test]
fn kill_all_moves_halts_no_program() {
    let ran = disturbed("X10\nDWL 1\nPRINT \"on\"", "SET 522").run().clean();
    assert_eq!(ran.record.output[0].text, "on");
}

#[test]
fn after_a_kill_the_next_move_starts_where_the_axes_are() {
    let sim = disturbed("X10\nINH 522\nCLR 522\nX/1\nINH -516\nPRINT P12288", "SET 522");
    assert_eq!(sim.prints(), ["6"]);
}

#[test]
fn stop_all_moves_ramps_down_sets_the_kill_flag_and_clears_itself() {
    let braking = disturbed("X10\nX20", "SET 523\nPRINT BIT(523); BIT(522)").until(0.55).run().clean();
    assert_eq!(braking.record.output[0].text, "-10");
    assert!(braking.bit(523) && !braking.bit(522) && braking.bit(516));
    let ran = disturbed("X10\nX20", "SET 523\nINH -523\nPRINT \"stopped\"").run().clean();
    assert!(ran.bit(522) && !ran.bit(523) && !ran.bit(516));
    assert!((ran.position(0) - 5.0).abs() < 0.05, "{}", ran.position(0));
    assert!((ran.record.output[0].milliseconds - 600.0).abs() < 5.0);
}

#[test]
fn stop_all_moves_at_rest_sets_the_kill_flag_at_once() {
    let ran = Sim::program("SET 523\nPRINT BIT(522)\nPRINT BIT(523)").prints();
    assert_eq!(ran, ["-1", "0"]);
}

#[test]
fn stop_all_moves_in_feedhold_ends_the_hold() {
    let ran = disturbed("X10\nX20", "SET 520\nDWL 1\nSET 523\nINH 522\nCLR 522\nPRINT BIT(519)").run().clean();
    assert_eq!(ran.record.output[0].text, "0");
    assert!(!ran.bit(516));
}

#[test]
fn drive_on_clears_kill_all_moves_when_the_drive_was_off() {
    let ran = Sim::program("SET 522\nDRIVE ON X\nPRINT BIT(522)\nSET 522\nDRIVE ON X\nPRINT BIT(522)\nDRIVE X Y");
    assert_eq!(ran.prints(), ["0", "-1", "DRIVE ON AXIS0", "DRIVE OFF AXIS1"]);
}

#[test]
fn drives_are_not_switched_in_motion() {
    assert_eq!(Sim::program("DRIVE ON X\nX10\nDRIVE OFF X").faults(), ["Not valid while in motion"]);
}

#[test]
fn an_axis_that_moved_without_its_drive_is_reported() {
    let ran = Sim::program("DRIVE ON X\nX10 Y10\nINH -516").run().clean();
    let moved: Vec<_> = ran.controller.axes().iter().map(|axis| (axis.axis, axis.moved_disabled)).collect();
    assert_eq!(moved, [(0, false), (1, true)]);
    let by_flag = Sim::program("SET 8465\nX10\nINH -516\nDRIVE X").run().clean();
    assert!(!by_flag.controller.axes()[0].moved_disabled);
    assert_eq!(by_flag.record.output[0].text, "DRIVE ON AXIS0");
}

#[test]
fn an_order_to_a_master_that_the_model_does_not_have_does_nothing() {
    assert_eq!(Sim::program("SET 7434\nPRINT BIT(7434)\nPRINT BIT(522)").prints(), ["0", "0"]);
}

#[test]
fn flags_of_axes_beyond_the_eighth_are_no_flags_of_programs() {
    let ran = Sim::new("SYS\n").model("ACR9040").run().clean();
    let set: Vec<i64> = (0..17_664).filter(|bit| ran.bit(*bit)).collect();
    let not_excess_error = (0..8).map(|axis| 769 + 32 * axis).chain((0..8).map(|axis| 7681 + 32 * axis));
    assert_eq!(set, not_excess_error.collect::<Vec<i64>>(), "those of axes 8 to 15 have words of their own");
}
