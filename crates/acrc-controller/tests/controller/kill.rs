//! Kill All Motion Request and Kill All Moves (guide, "Kill All Motion Request vs. Kill All Moves").

use crate::support::{JOGS, Sim, TWO_AXES};

const KILLED: &str = "Associated Slave Kill Motion Request Active";

fn killing(body: &str) -> Sim {
    Sim::jogging("HLDEC X50 Y100", body)
}

#[test]
fn a_request_stops_a_jog_with_hldec_and_leaves_an_offset() {
    let body = "JOG FWD X\nDWL 1\nSET 8467\nPRINT BIT 796\nINH -792\nPRINT P12297, P12288";
    assert_eq!(killing(body).timed(), ["1000 0", "1200 10500\t0"]);
}

#[test]
fn a_request_stops_a_move_through_the_jog_profiler() {
    // At 5 units of path, X moves at 8 units/s and Y at 6.
    let body =
        "X8 Y6\nDWL 0.55\nSET 8467\nPRINT BIT 516; BIT 522; BIT 8499\nDWL 1\nPRINT P12288, P12297, P12544, P12553";
    assert_eq!(killing(body).prints(), ["0-1-1", "4000\t640\t3000\t180"]);
    let at_once = Sim::jogging("", "X10\nDWL 0.55\nSET 8467\nDWL 1\nPRINT P12288, P12297");
    assert_eq!(at_once.prints(), ["5000\t0"]);
}

#[test]
fn a_request_stops_what_move_and_jog_do_together() {
    // 20 units/s from both: 4 units of ramp.
    let body = "X10\nJOG FWD X\nDWL 0.5\nSET 8467\nDWL 1\nPRINT P12288, P12297, P12294";
    assert_eq!(killing(body).prints(), ["4500\t8500\t13000"]);
}

#[test]
fn the_setpoint_goes_on_without_a_step() {
    let at = |ticks: u32| {
        let ran = killing("X10\nDWL 0.55\nSET 8467").until(f64::from(ticks) * 0.0005).run();
        ran.controller.view().position(0)
    };
    let steps: Vec<f64> = (1095..1110).map(|tick| at(tick + 1) - at(tick)).collect();
    assert!(steps.windows(2).all(|pair| (pair[1] - pair[0]).abs() < 50.0 * 0.0005_f64.powi(2) + 1e-9), "{steps:?}");
}

#[test]
fn a_request_spreads_over_its_master_only() {
    let setup = "HLDEC X50\nPROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"A\"\nJOG ACC A100\nJOG VEL A10\nPROG0";
    let body = "AXIS2 JOG FWD\nSET 8467\nPRINT BIT 8467; BIT 8499; BIT 8531; BIT 522; BIT 554";
    let ran = Sim::jogging(setup, body).until(1.0).run().clean();
    assert_eq!((&*ran.record.output[0].text, ran.velocity(2)), ("-1-10-10", 10.0));
}

#[test]
fn a_request_of_an_axis_without_a_master_is_its_own() {
    let setup = "AXIS3 JOG ACC 100\nAXIS3 JOG VEL 10";
    let body = "AXIS3 JOG FWD\nJOG FWD X\nDWL 0.5\nSET 8563\nPRINT BIT 8563; BIT 8467; BIT 522";
    let ran = Sim::jogging(setup, body).until(1.0).run().clean();
    assert_eq!((&*ran.record.output[0].text, ran.velocity(3), ran.velocity(0)), ("-100", 0.0, 10.0));
    assert_eq!(Sim::jogging(setup, "SET 8563\nAXIS3 JOG FWD").faults(), [KILLED]);
}

#[test]
fn a_request_halts_no_program() {
    let text = format!(
        "{TWO_AXES}{JOGS}PROGRAM\nJOG FWD X\nDWL 1\nPRINT 1\nENDP\nPROG1\nPROGRAM\nSET 8467\nDWL 1\nPRINT 2\nENDP\n"
    );
    assert_eq!(Sim::new(&text).start(&[0, 1]).prints(), ["1", "2"]);
}

#[test]
fn every_motion_is_refused_while_an_axis_of_the_master_is_killed() {
    for statement in ["X1", "Y1", "JOG ABS Y1", "JOG INC X1", "JOG FWD Y", "JOG REV X", "JOG HOME Y1", "AXIS1 JOG FWD"]
    {
        for request in [8467, 8499] {
            let ran = killing(&format!("SET {request}\n{statement}")).run();
            assert_eq!(ran.record.faults.len(), 1, "{statement}");
            assert_eq!(ran.record.faults[0].message, KILLED, "{statement}");
            assert!(!ran.bit(792) && !ran.bit(824) && !ran.bit(516), "{statement}");
        }
    }
}

#[test]
fn what_starts_no_motion_is_accepted_while_killed() {
    let body = "SET 8467\nJOG OFF X\nJOG VEL X5\nHLDEC X10\nRES X5\nREN X\nJOG REN X\nJOG RES X\nPRINT P12294";
    assert_eq!(killing(body).prints(), ["5000"]);
}

#[test]
fn a_flag_that_asks_to_home_in_vain_leaves_a_note() {
    let ran = killing("SET 8467\nSET 17160\nDWL 0.1").run().clean();
    assert_eq!(ran.notes(), [format!("BIT17160 asked for motion in vain: {KILLED}")]);
}

#[test]
fn motion_resumes_when_requests_and_kill_all_moves_are_cleared() {
    let body = "SET 8467\nCLR 8467\nCLR 8499\nCLR 522\nX1 Y1\nINH -516\nJOG INC X1\nINH -792\nPRINT P12294";
    assert_eq!(killing(body).prints(), ["2000"]);
    assert_eq!(killing("SET 8467\nCLR 8467\nX1").faults(), [KILLED], "Y is killed still");
    let left = "master 0 has its Kill All Moves flag set (BIT522): it must be cleared before a move";
    assert_eq!(killing("SET 8467\nCLR 8467\nCLR 8499\nX1").faults(), [left]);
    assert_eq!(killing("SET 8467\nCLR 522\nX1").faults(), [KILLED]);
    assert_eq!(killing("SET 8467\nCLR 8467\nCLR 8499\nJOG INC X1\nINH -792\nPRINT P12297").prints(), ["1000"]);
}

#[test]
fn enabling_a_drive_clears_the_request_of_its_axis_and_kill_all_moves() {
    let flags = "PRINT BIT 8467; BIT 8499; BIT 522";
    assert_eq!(killing(&format!("SET 8467\nDRIVE ON X\n{flags}\nDRIVE ON Y\n{flags}")).prints(), ["0-10", "000"]);
    assert_eq!(killing("SET 8467\nDRIVE ON X Y\nX1\nINH -516\nPRINT P12294").prints(), ["1000"]);
    let enabled = format!("DRIVE ON X Y\nSET 8467\nDRIVE ON X Y\n{flags}\nDRIVE OFF X Y\nDRIVE ON X Y\n{flags}");
    assert_eq!(killing(&enabled).prints(), ["-1-1-1", "000"]);
}

#[test]
fn a_kill_after_a_recovery_stops_as_the_first_did() {
    let once = "X10\nDWL 0.55\nSET 8467\nDWL 1\nPRINT BIT 516; P12294\nCLR 8467\nCLR 8499\nCLR 522\nRES X Y";
    assert_eq!(killing(&format!("{once}\n{once}")).prints(), ["06000", "06000"]);
    let order = "X10\nDWL 0.55\nSET 8467\nDWL 1\nPRINT BIT 516; P12294\nCLR 522\nCLR 8467\nCLR 8499\nRES X Y";
    assert_eq!(killing(&format!("{order}\n{order}")).prints(), ["06000", "06000"]);
}

#[test]
fn a_request_that_is_set_already_stops_nothing_anew() {
    let body = "JOG FWD X\nDWL 1\nSET 8467\nDWL 0.1\nSET 8467\nINH -792\nPRINT P12297";
    assert_eq!(killing(body).timed(), ["1200 10500"]);
}

#[test]
fn a_word_of_flags_kills_as_the_flag_does() {
    let body = "JOG FWD X\nDWL 1\nP4360 = P4360 OR 524288\nINH -792\nPRINT P12297, BIT 8499";
    assert_eq!(killing(body).prints(), ["10500\t-1"]);
}

#[test]
fn a_stopped_move_takes_those_behind_it_along() {
    let body = "X10\nX20\nDWL 0.55\nSET 8467\nDWL 1\nCLR 8467\nCLR 8499\nCLR 522\nDWL 1\nPRINT P12288, P12289, BIT 516";
    assert_eq!(killing(body).prints(), ["5000\t5000\t0"]);
}

#[test]
fn kill_all_moves_neither_stops_nor_prevents_jogs() {
    let ran =
        killing("X10\nJOG ABS X10\nDWL 0.5\nSET 522\nINH -792\nPRINT P12288, P12297, BIT 8467\nJOG INC X1\nINH -792")
            .run();
    assert_eq!(ran.record.output[0].text, "4500\t10000\t0");
    assert_eq!((ran.position(0), ran.record.faults.len()), (15.5, 0));
}

#[test]
fn a_killed_axis_at_rest_stays_where_it_is() {
    assert_eq!(killing("X1\nINH -516\nSET 8467\nDWL 1\nPRINT P12288, P12297, BIT 792").prints(), ["1000\t0\t0"]);
}

#[test]
fn a_motion_command_during_the_ramp_is_refused_and_the_ramp_goes_on() {
    let ran = killing("JOG FWD X\nDWL 1\nSET 8467\nJOG REV X").run();
    assert_eq!((ran.position(0), &*ran.record.faults[0].message), (10.5, KILLED));
}

#[test]
fn jog_off_does_not_replace_the_ramp_of_a_kill() {
    let body = "JOG FWD X\nDWL 1\nSET 8467\nJOG OFF X\nINH -792\nPRINT P12297";
    assert_eq!(killing(body).timed(), ["1200 10500"]);
}
