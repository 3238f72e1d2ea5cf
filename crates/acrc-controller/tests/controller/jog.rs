//! Jogs (guide, "Jog Profiler", "JOG REN Details", "JOG RES Details").

use crate::support::{JOGS, Ran, Sim, TWO_AXES};

fn jogging(body: &str) -> Sim {
    Sim::jogging("", body)
}

/// Which of the flags 792 to 797 are set.
fn flags(ran: &Ran) -> Vec<i64> {
    (792..798).filter(|flag| ran.bit(*flag)).collect()
}

#[test]
fn a_jog_goes_to_an_offset_and_the_program_goes_on() {
    let timed = jogging("JOG ABS X10\nPRINT 1\nINH -792\nPRINT P12297, P12288, P12294, P12295, P12290").timed();
    assert_eq!(timed, ["0 1", "1100 10000\t0\t10000\t10000\t10000"]);
}

#[test]
fn an_incremental_jog_counts_from_the_offset_of_the_moment() {
    let ran = jogging("JOG INC X10\nINH -792\nJOG INC X-4\nINH -792\nPRINT P12297").prints();
    assert_eq!(ran, ["6000"]);
    // 4.5 units at 0.5 s.
    assert_eq!(jogging("JOG INC X10\nDWL 0.5\nJOG INC X10\nINH -792\nPRINT P12297").prints(), ["14500"]);
}

#[test]
fn a_running_jog_takes_a_new_target() {
    let ran = jogging("JOG ABS X10\nDWL 0.5\nJOG ABS X0\nINH -792\nPRINT P12297").timed();
    // 0.1 s and 0.5 units of ramp beyond 4.5, and 5 units back.
    assert_eq!(ran, ["1200 0"]);
}

#[test]
fn a_continuous_jog_runs_until_it_is_switched_off() {
    let timed = jogging("JOG FWD X\nDWL 1\nJOG OFF X\nINH -792\nPRINT P12297").timed();
    assert_eq!(timed, ["1100 10000"]);
    let timed = jogging("JOG REV X\nDWL 1\nJOG OFF X\nINH -792\nPRINT P12297").timed();
    assert_eq!(timed, ["1100 -10000"]);
}

#[test]
fn a_continuous_jog_outlasts_its_program() {
    let ran = jogging("JOG FWD X").until(2.0).run().clean();
    assert_eq!((ran.position(0), ran.milliseconds()), (19.5, 2000.0));
}

#[test]
fn a_jog_turns_round_with_both_ramps() {
    let at = |seconds: f64| jogging("JOG FWD X\nDWL 1\nJOG REV X").until(seconds).run().clean();
    assert_eq!((at(1.05).velocity(0), at(1.1).velocity(0), at(1.1).position(0)), (5.0, 0.0, 10.0));
    assert_eq!((at(1.2).velocity(0), at(1.2).position(0)), (-10.0, 9.5));
}

#[test]
fn the_axes_of_a_statement_jog_by_themselves() {
    let sim = jogging("JOG ABS X10 Y2\nINH -824\nPRINT BIT 792\nINH -792\nPRINT BIT 824");
    assert_eq!(sim.timed(), ["300 -1", "1100 0"]);
}

#[test]
fn a_statement_with_an_axis_that_is_not_attached_jogs_none() {
    let ran = jogging("JOG ABS X10 Z10").run();
    assert_eq!(ran.record.faults[0].message, "program 0 has no axis named Z");
    assert_eq!(ran.position(0), 0.0);
}

#[test]
fn velocity_changes_on_the_fly() {
    let at = |seconds: f64| jogging("JOG FWD X\nDWL 1\nJOG VEL X20\nDWL 1\nJOG VEL X5").until(seconds).run().clean();
    assert_eq!([1.0, 1.05, 1.1, 2.0].map(|seconds| at(seconds).velocity(0)), [10.0, 15.0, 20.0, 20.0]);
    assert_eq!([2.1, 2.2].map(|seconds| at(seconds).velocity(0)), [10.0, 5.0]);
}

#[test]
fn acceleration_changes_on_the_fly() {
    let at = |seconds: f64| Sim::jogging("JOG ACC X10", "JOG FWD X\nDWL 0.5\nJOG ACC X100").until(seconds).run();
    assert_eq!([0.5, 0.525, 0.55, 0.6].map(|seconds| at(seconds).velocity(0)), [5.0, 7.5, 10.0, 10.0]);
}

#[test]
fn deceleration_changes_on_the_fly() {
    let body = "JOG FWD X\nDWL 1\nJOG DEC X10\nJOG OFF X\nDWL 0.5\nJOG DEC X100\nINH -792\nPRINT P12297";
    // 9.5 before, half a second from 10 to 5, and 0.05 s.
    assert_eq!(jogging(body).timed(), ["1550 13375"]);
}

#[test]
fn a_jerk_rounds_the_ramps() {
    // A ramp of 10/100 + 100/1000 seconds, and 8 units between the two.
    let sim = Sim::jogging("JOG JRK X1000", "JOG ABS X10\nINH -792\nPRINT P12297");
    assert_eq!(sim.timed(), ["1200 10000"]);
    let at = Sim::jogging("JOG JRK X1000", "JOG ABS X10").until(0.1).run().clean();
    assert_eq!((at.velocity(0), at.position(0)), (5.0, 0.166_667));
}

#[test]
fn ramps_of_zero_are_steps() {
    let sim = Sim::jogging("JOG ACC X0\nJOG DEC X0", "JOG ABS X10\nINH -792\nPRINT P12297");
    assert_eq!(sim.timed(), ["1000 10000"]);
}

#[test]
fn a_jog_without_velocity_waits_for_one() {
    let body = "JOG ABS X10\nDWL 0.5\nJOG VEL X0\nDWL 1\nPRINT P12297, BIT 792\nJOG VEL X10\nINH -792\nPRINT P12297";
    assert_eq!(jogging(body).prints(), ["5000\t-1", "10000"]);
    let ran = jogging("JOG VEL X0\nJOG ABS X10\nDWL 0.1").run().clean();
    assert_eq!(ran.notes(), ["AXIS0 was told to jog while JOG VEL is 0: it waits for a velocity"]);
    assert_eq!((ran.position(0), ran.milliseconds()), (0.0, 100.0));
    assert!(ran.bit(792));
}

#[test]
fn registers_are_not_preloaded_under_a_jog_that_waits() {
    for statement in ["RES X5", "REN X", "JOG RES X5", "JOG REN X5", "P12288 = 5", "P12297 = 5", "PPU X10"] {
        let ran = jogging(&format!("JOG VEL X0\nJOG ABS X10\n{statement}")).run();
        assert_eq!(ran.record.faults.len(), 1, "{statement}");
        assert_eq!(ran.position(0), 0.0, "{statement}");
    }
}

#[test]
fn a_jog_ends_behind_its_limits() {
    let run = |body: &str| Sim::jogging("JLM X(5.002, -2.002)", body).until(5.0).run().clean();
    // The first tick behind the limit, and 0.5 units of ramp.
    assert_eq!((run("JOG FWD X").position(0), run("JOG FWD X").bit(792)), (5.505, false));
    assert_eq!(run("JOG ABS X-10").position(0), -2.505);
    assert_eq!(run("JOG ABS X4").position(0), 4.0);
    assert_eq!(run("JOG FWD X\nINH -792\nJOG FWD X\nDWL 1").position(0), 5.505);
    assert_eq!(run("JOG FWD X\nINH -792\nJOG REV X\nDWL 0.5\nJOG OFF X").position(0), 0.505);
    // It bounds the jog offset and nothing else.
    assert_eq!(run("X20\nINH -516").position(0), 20.0);
}

#[test]
fn jog_flags_follow_the_velocity_profile() {
    let body = "JOG FWD X\nDWL 1\nJOG OFF X";
    let at = |seconds: f64| flags(&jogging(body).until(seconds).run().clean());
    assert_eq!(at(0.05), [792, 796]);
    assert_eq!(at(0.5), [792, 794, 796]);
    assert_eq!(at(1.05), [792, 795]);
    assert_eq!(at(1.2), [0; 0]);
    let body = "JOG REV X\nDWL 1\nJOG OFF X";
    let at = |seconds: f64| flags(&jogging(body).until(seconds).run().clean());
    assert_eq!(at(0.05), [792, 793, 797]);
    assert_eq!(at(0.5), [792, 793, 794, 797]);
    assert_eq!(at(1.05), [792, 793, 795]);
    assert_eq!(at(1.2), [0; 0]);
}

#[test]
fn jogs_to_a_place_set_no_direction_flag() {
    let at = |seconds: f64| flags(&jogging("JOG ABS X10").until(seconds).run().clean());
    assert_eq!(at(0.05), [792]);
    assert_eq!(at(0.5), [792, 794]);
    assert_eq!(at(1.05), [792, 795]);
    assert_eq!(at(1.2), [0; 0]);
}

#[test]
fn flags_start_and_stop_jogs() {
    assert_eq!(jogging("SET 796\nDWL 1\nCLR 796\nINH -792\nPRINT P12297").timed(), ["1100 10000"]);
    assert_eq!(jogging("SET 797\nDWL 1\nCLR 797\nINH -792\nPRINT P12297").timed(), ["1100 -10000"]);
    assert_eq!(jogging("SET 796\nDWL 1\nSET 795\nINH -792\nPRINT P12297").timed(), ["1100 10000"]);
    assert_eq!(flags(&jogging("SET 796\nDWL 1\nSET 797").until(1.5).run().clean()), [792, 793, 794, 797]);
}

#[test]
fn flags_that_are_written_again_change_nothing() {
    assert_eq!(jogging("JOG ABS X10\nDWL 0.5\nCLR 796\nCLR 797\nINH -792\nPRINT P12297").timed(), ["1100 10000"]);
    let body = "JOG FWD X\nDWL 0.5\nCLR 797\nSET 796\nDWL 0.5\nCLR 796\nINH -792\nPRINT P12297";
    assert_eq!(jogging(body).prints(), ["10000"]);
}

#[test]
fn a_flag_that_asks_for_motion_in_vain_leaves_a_note() {
    let ran = jogging("SET 8467\nSET 796\nDWL 0.1").run().clean();
    assert_eq!(ran.notes(), ["BIT796 asked for motion in vain: Associated Slave Kill Motion Request Active"]);
    assert!(!ran.bit(796) && ran.position(0) == 0.0);
}

#[test]
fn the_flags_of_the_second_axis_follow_those_of_the_first() {
    let ran = jogging("JOG FWD Y").until(0.5).run().clean();
    assert_eq!((792..832).filter(|flag| ran.bit(*flag)).collect::<Vec<_>>(), [800, 801, 824, 826, 828]);
}

#[test]
fn an_axis_is_not_in_position_while_it_jogs() {
    let sim = jogging("JOG INC X10\nPRINT BIT 768; BIT 516\nINH -768\nPRINT P12297");
    assert_eq!(sim.timed(), ["0 -10", "1100 10000"]);
}

#[test]
fn the_setpoint_is_the_sum_of_jog_and_coordinated_move() {
    let sim = jogging("X10\nJOG ABS X5\nDWL 0.5\nPRINT P12288, P12297, P12294\nINH -516\nPRINT P12288, P12297, P12294");
    assert_eq!(sim.prints(), ["4500\t4500\t9000", "10000\t5000\t15000"]);
    let ran = jogging("X10\nJOG REV X").until(0.5).run().clean();
    assert_eq!((ran.velocity(0), ran.position(0)), (0.0, 0.0));
}

#[test]
fn an_axis_that_stands_because_its_profilers_cancel_out_has_not_travelled() {
    let ran = jogging("X10\nJOG ABS X-10\nINH -516").run().clean();
    let statistics = ran.controller.axes()[0].statistics;
    assert!(statistics.travel < 1e-9 && statistics.peak_velocity < 1e-9, "{statistics:?}");
    let ran = jogging("X10\nJOG ABS X10\nINH -516").run().clean();
    let statistics = ran.controller.axes()[0].statistics;
    assert!((statistics.travel - 20.0).abs() < 1e-9 && (statistics.peak_velocity - 20.0).abs() < 1e-9);
}

#[test]
fn a_jog_without_its_drive_is_reported() {
    let moved = |body: &str| jogging(body).run().clean().controller.axes()[0].moved_disabled;
    assert!(moved("JOG INC X1"));
    assert!(!moved("DRIVE ON X\nJOG INC X1"));
}

#[test]
fn jog_ren_and_jog_res_move_positions_between_registers() {
    let sum = "PRINT P12288, P12297, P12294, P12290";
    for (start, statement, expected) in [
        ("P12288 = 2000\nP12297 = 2000", "JOG REN X", "0\t4000\t4000\t4000"),
        ("P12288 = 5000\nP12297 = 1000", "JOG REN X2", "2000\t4000\t6000\t6000"),
        ("P12288 = 2000\nP12297 = 2000", "JOG RES X", "4000\t0\t4000\t4000"),
        ("P12288 = 1000\nP12297 = 5000", "JOG RES X2", "4000\t2000\t6000\t6000"),
        ("P12288 = 2000\nP12297 = 9000", "REN X", "2000\t9000\t11000\t11000"),
        ("P12288 = 2000\nP12297 = 9000", "RES X10", "10000\t0\t10000\t10000"),
        ("P12288 = 2000\nP12297 = 9000", "RES", "0\t0\t0\t0"),
        ("P12297 = 9000", "P12290 = 11000", "2000\t9000\t11000\t11000"),
    ] {
        assert_eq!(jogging(&format!("{start}\n{statement}\n{sum}")).prints(), [expected], "{statement}");
    }
}

#[test]
fn jog_targets_are_offsets() {
    // From a coordinated position of 3 to an offset of 10.
    assert_eq!(jogging("X3\nINH -516\nJOG ABS X10\nINH -792\nPRINT P12294").prints(), ["13000"]);
    assert_eq!(jogging("JOG ABS X10\nINH -792\nX3\nINH -516\nPRINT P12294, P12289").prints(), ["13000\t3000"]);
}

#[test]
fn registers_are_not_preloaded_in_motion() {
    for statement in ["RES X", "REN X", "JOG RES X", "JOG REN X", "PPU X1", "P12297 = 1", "P12288 = 1", "P12290 = 1"] {
        let faults = jogging(&format!("JOG FWD X\n{statement}")).until(0.1).faults();
        assert_eq!(faults, ["Not valid while in motion"], "{statement}");
    }
}

#[test]
fn drives_and_attachments_are_not_changed_in_motion() {
    for statement in ["DRIVE ON X", "DRIVE OFF X", "DETACH", "DETACH AXIS0", "DETACH SLAVE0"] {
        let faults = jogging(&format!("JOG FWD X\n{statement}")).until(0.1).faults();
        assert_eq!(faults, ["Not valid while in motion"], "{statement}");
    }
    assert_eq!(jogging("JOG FWD X\nDRIVE ON Y").until(0.1).run().clean().velocity(0), 10.0);
}

#[test]
fn an_offset_outlasts_a_detachment() {
    let body =
        "JOG ABS X10\nINH -792\nDETACH\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nX3\nINH -516\nPRINT P12297, P12294";
    assert_eq!(jogging(body).prints(), ["10000\t13000"]);
}

#[test]
fn an_axis_jogs_without_a_master() {
    let setup = "AXIS3 PPU 1000\nAXIS3 JOG ACC 100\nAXIS3 JOG DEC 100\nAXIS3 JOG VEL 10";
    let sim = Sim::jogging(setup, "AXIS3 JOG ABS 10\nINH -888\nPRINT P13065, P13062");
    assert_eq!(sim.timed(), ["1100 10000\t10000"]);
}

#[test]
fn pulses_per_unit_scale_jogs_and_keep_the_pulses() {
    let body =
        "PPU X500\nJOG ABS X10\nINH -792\nPRINT P12297\nPPU X1000\nPRINT P12297\nJOG ABS X10\nINH -792\nPRINT P12297";
    // The offset of 5000 pulses is one of 5 units now.
    assert_eq!(jogging(body).timed(), ["1100 5000", "1100 5000", "1700 10000"]);
}

#[test]
fn setup_code_may_jog() {
    let ran = Sim::new(&format!("{TWO_AXES}{JOGS}JOG ABS X10\n")).run().clean();
    assert_eq!((ran.position(0), ran.milliseconds()), (10.0, 1100.0));
}

#[test]
fn a_plc_program_may_jog() {
    let plc = "SYS\nDIM PLC0(400)\nPLC0\nPROGRAM\nLD 128\nOUT 796\nENDP\nRUN\nPROG0\n";
    let ran = Sim::jogging(plc, "SET 128\nDWL 1\nCLR 128\nINH 792\nINH -792\nPRINT P12297").run().clean();
    // One scan later in each case.
    assert_eq!(ran.record.output[0].text, "10000");
    // A rung that stays off does not stop other jogs.
    let ran = Sim::jogging(plc, "JOG ABS X10\nINH -792\nPRINT P12297").run().clean();
    assert_eq!((ran.record.output[0].milliseconds, &*ran.record.output[0].text), (1100.0, "10000"));
}

#[test]
fn two_programs_jog_their_axes() {
    let other = "PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"A\"\nPPU A1000\nJOG ACC A50\nJOG DEC A50\nJOG VEL A5\n\
                 PROGRAM\nJOG ABS A5\nAXIS1 JOG ABS 1\nINH -856\nPRINT P12809\nENDP\n";
    let text = format!("{TWO_AXES}{JOGS}PROGRAM\nJOG ABS X10\nINH -792\nPRINT P12297\nENDP\n{other}");
    let ran = Sim::new(&text).start(&[0, 1]).run().clean();
    let prints: Vec<_> = ran.record.output.iter().map(|line| (line.program, &*line.text)).collect();
    assert_eq!(prints, [(Some(0), "10000"), (Some(1), "5000")]);
    assert_eq!([0, 1, 2].map(|axis| ran.position(axis)), [10.0, 1.0, 5.0]);
}

#[test]
fn halt_and_feedhold_leave_jogs_alone() {
    for statement in ["HALT PROG0", "PAUSE PROG0", "SET 520", "SET 522", "SET 523"] {
        let text = format!(
            "{TWO_AXES}{JOGS}PROGRAM\nJOG ABS X10\nX10\nDWL 1\nENDP\nPROG1\nPROGRAM\nDWL 0.2\n{statement}\nENDP\n"
        );
        let ran = Sim::new(&text).start(&[0, 1]).until(3.0).run().clean();
        let offset = ran.controller.parameter(12_297).expect("a parameter");
        assert_eq!(offset, acrc_vm::Value::Long(10_000), "{statement}");
    }
}

#[test]
fn velocity_and_acceleration_can_be_read() {
    let ran = jogging("JOG FWD X\nDWL 0.05\nPRINT P12346, P12347").until(0.1).run().clean();
    assert_eq!(ran.record.output[0].text, "5\t100");
}

#[test]
fn a_setting_that_comes_from_outside_acts_on_the_fly() {
    let world = "[[event]]\nat = 1\nparameters = { P12348 = 20 }\n";
    let ran = jogging("JOG FWD X").world(world).until(2.0).run().clean();
    assert_eq!(ran.velocity(0), 20.0);
}

#[test]
fn a_restart_ends_jogs() {
    let ran = jogging("JOG FWD X\nDWL 1\nREBOOT").until(3.0).run().clean();
    assert_eq!((ran.bit(792), ran.position(0)), (false, 0.0));
}

#[test]
fn jog_commands_take_what_they_need() {
    for (statement, fault) in [
        ("JOG ABS X", "JOG ABS expects one value behind each axis"),
        ("JOG HOME X", "JOG HOME expects a direction behind each axis: 1 or -1"),
        ("JOG HOME X0", "JOG HOME expects a direction behind each axis: 1 or -1"),
    ] {
        assert_eq!(jogging(statement).faults(), [fault], "{statement}");
    }
}
