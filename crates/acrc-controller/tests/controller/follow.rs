//! Gear, cam, compensation and gantry lock: axes that follow something.

use crate::support::Sim;

/// A move of X by 10 units takes 1.1 s and counts 10,000 pulses; Y has 100 pulses a unit.
fn follower(body: &str) -> Sim {
    Sim::program(&format!("PPU X1000 Y100\nGEAR SRC Y ENC0\nGEAR PPU Y1000\nCAM SRC Y ENC0\n{body}"))
}

/// Lets the follower, which is a tick behind, take the last count.
const THERE: &str = "INH -516\nDWL 0.01\n";

#[test]
fn a_gear_follows_the_pulses_of_its_source() {
    // 10,000 pulses are 10 units of the source, 25 of the axis and 2,500 of its pulses.
    let sim = follower(&format!(
        "GEAR RATIO Y2.5\nX1\n{THERE}GEAR ON Y\nX/10\n{THERE}PRINT P12544, P12552, P12550, P12546\n\
         GEAR RATIO Y-1\nX/2\n{THERE}PRINT P12552\nGEAR OFF Y\nX/3\n{THERE}PRINT P12552"
    ));
    assert_eq!(sim.prints(), ["0\t2500\t2500\t2500", "2300", "2300"]);
}

#[test]
fn a_gear_offset_can_be_preloaded() {
    let sim = follower(&format!(
        "GEAR RES Y3\nPRINT P12552, P12550, P12544\nGEAR ON Y\nX1\n{THERE}PRINT P12552\nGEAR RES Y\nPRINT P12552"
    ));
    assert_eq!(sim.prints(), ["300\t300\t0", "400", "0"]);
}

#[test]
fn a_gear_engages_with_its_ramp() {
    // X runs at 10 units/s for a second when the gear goes on: Y takes 0.5 s to its speed, and loses half of the way.
    let sim = follower(
        "STP 0\nX10\nSTP 100\nX/20\nGEAR ACC Y20\nINH 516\nDWL 1\nGEAR ON Y\nDWL 1\nPRINT P12552\nDWL 0.5\nPRINT P12552",
    );
    let prints = sim.prints();
    let [first, second] = [&prints[0], &prints[1]].map(|text| text.parse::<f64>().expect("a number"));
    assert!((first - 750.0).abs() < 5.0, "{first}");
    assert!((second - first - 500.0).abs() < 5.0, "{second}");
}

#[test]
fn a_gear_stops_at_its_ends() {
    let sim =
        follower(&format!("GEAR MAX Y2\nGEAR MIN Y-1\nGEAR ON Y\nX5\n{THERE}PRINT P12552\nX-5\n{THERE}PRINT P12552"));
    assert_eq!(sim.prints(), ["200", "-100"]);
}

#[test]
fn an_axis_can_follow_the_jog_of_another_one() {
    let sim = follower(
        "JOG ACC X100\nJOG DEC X100\nJOG VEL X10\nGEAR ON Y\nJOG INC X5\nINH 792\nINH -792\nDWL 0.01\nPRINT P12552",
    );
    assert_eq!(sim.prints(), ["500"]);
}

#[test]
fn a_parameter_can_drive_a_gear() {
    let sim = follower(
        "GEAR SRC Y P5\nGEAR PPU Y1\nP5 = 7\nGEAR ON Y\nP5 = 10\nDWL 0.01\nPRINT P12552\nP5 = 4\nDWL 0.01\nPRINT P12552",
    );
    assert_eq!(sim.prints(), ["300", "-300"]);
}

#[test]
fn a_ratchet_lets_counts_of_one_direction_pass() {
    // Two units back have to be made up for before the axis goes on.
    let sim = follower(&format!(
        "RATCH0 SRC ENC0\nRATCH0 MODE 3\nGEAR SRC Y RATCH0\nGEAR ON Y\nX3\n{THERE}PRINT P12552\nX1\n{THERE}PRINT P12552\nX4\n{THERE}PRINT P12552"
    ));
    assert_eq!(sim.prints(), ["300", "300", "400"]);
}

#[test]
fn a_limiter_passes_counts_later() {
    // 10,000 counts at 5,000 a second take two seconds; the move that makes them takes 1.1.
    let sim = follower(
        "LIMIT0 SRC ENC0\nLIMIT0 FREQ 5000\nGEAR SRC Y LIMIT0\nGEAR ON Y\nX10\nINH -516\nPRINT P12552 < 600\nDWL 1\nPRINT P12552",
    );
    assert_eq!(sim.prints(), ["-1", "1000"]);
}

/// Two segments of 1,000 counts each: 0, 10, 4 and back to 0.
const TABLE: &str = "DIM LA(2)\nDIM LA0(3)\nDIM LA1(2)\nLA0(1) = 10\nLA0(2) = 4\nLA1(0) = 4\nCAM DIM Y2\nCAM SEG Y(0, 1000, LA0)\n\
                     CAM SEG Y(1, 1000, LA1)\n";

#[test]
fn a_cam_interpolates_between_its_points_and_begins_anew() {
    let half = format!("X/0.5\n{THERE}PRINT P12550\n");
    let sim = follower(&format!(
        "{TABLE}CAM ON Y\n{}X/0.25\n{THERE}PRINT P12550\nX/-0.5\n{THERE}PRINT P12550",
        half.repeat(4)
    ));
    assert_eq!(sim.prints(), ["1000", "400", "200", "0", "500", "100"]);
}

#[test]
fn a_cam_has_scale_offset_and_a_start_of_its_own() {
    let sim =
        follower(&format!("{TABLE}CAM SCALE Y0.5\nCAM OFFSET Y1\nCAM FLZ Y250\nCAM ON Y\nX/0.25\n{THERE}PRINT P12550"));
    assert_eq!(sim.prints(), ["600"], "halfway: 10 · 0.5 + 1");
}

#[test]
fn the_points_of_a_cam_can_change_while_it_works() {
    let sim = follower(&format!("{TABLE}CAM ON Y\nX/0.5\n{THERE}PRINT P12550\nLA0(1) = 20\nDWL 0.01\nPRINT P12550"));
    assert_eq!(sim.prints(), ["1000", "2000"]);
}

#[test]
fn an_incremental_cam_builds_up_a_shift() {
    let body = format!(
        "DIM LA(1)\nDIM LA0(2)\nLA0(1) = 5\nCAM DIM Y1\nCAM SEG Y(0, 1000, LA0)\nCAM ON Y\nX3\n{THERE}PRINT P12550\nCAM SHIFT Y\n\
         CAM OFF Y\nCAM RES Y\nCAM SHIFT Y\nPRINT P12550, P12544"
    );
    assert_eq!(follower(&body).prints(), ["1500", "15", "0", "1500\t1500"]);
}

#[test]
fn a_cam_ends_after_its_passes() {
    let sim = follower(&format!("{TABLE}CAM CYCLE Y2\nCAM ON Y\nX5.5\n{THERE}PRINT P12550\nCAM CYCLE Y"));
    assert_eq!(sim.prints(), ["0", "2"]);
}

#[test]
fn a_table_must_have_place() {
    let refused = |statement: &str| follower(&format!("DIM LA(1)\nDIM LA0(2)\n{statement}")).faults();
    assert_eq!(refused("CAM SEG Y(0, 10, LA0)"), ["CAM SEG: segment 0 is outside the 0 segments of its DIM"]);
    assert_eq!(
        refused("CAM DIM Y1\nCAM SEG Y(1, 10, LA0)"),
        ["CAM SEG: segment 1 is outside the 1 segments of its DIM"]
    );
    assert_eq!(refused("CAM DIM Y1\nCAM SEG Y(0, 0, LA0)"), ["CAM SEG: a segment of length 0 holds nothing"]);
    assert_eq!(refused("CAM DIM Y0"), ["CAM DIM: 0 is no number of segments"]);
}

#[test]
fn ballscrew_compensation_changes_the_secondary_setpoint_only() {
    let body = format!(
        "DIM LA(1)\nDIM LA0(2)\nLA0(1) = 1\nBSC DIM Y1\nBSC SEG Y(0, 100000, LA0)\nBSC SRC Y ENC0\nBSC ON Y\nX50\n{THERE}PRINT P12550, P12551"
    );
    assert_eq!(follower(&body).prints(), ["0\t50"]);
}

#[test]
fn backlash_is_added_while_the_setpoint_is_positive() {
    let sim = follower(&format!("BKL X0.5\nX1\n{THERE}PRINT P12294, P12295\nX-1\n{THERE}PRINT P12294, P12295"));
    assert_eq!(sim.prints(), ["1000\t1500", "-1000\t-1000"]);
}

#[test]
fn a_locked_axis_keeps_its_distance() {
    let sim = follower(&format!(
        "X1 Y3\n{THERE}LOCK Y X\nX/10\n{THERE}PRINT P12294, P12550\nUNLOCK Y\nX/1\n{THERE}PRINT P12294, P12550, P12544\nY0\n{THERE}PRINT P12550"
    ));
    assert_eq!(sim.prints(), ["11000\t1300", "12000\t1300\t1300", "0"]);
    assert_eq!(Sim::program("LOCK Y X\nLOCK X Y").faults(), ["LOCK: AXIS0 would follow itself"]);
}

#[test]
fn a_rotary_position_can_be_folded() {
    let sim = follower(&format!("RES X370\nNORM X360\nPRINT P12288, P12290\nX350\n{THERE}NORM X100\nPRINT P12288"));
    assert_eq!(sim.prints(), ["10000\t10000", "50000"]);
}

#[test]
fn a_kill_disconnects_what_follows() {
    let sim = follower(&format!(
        "HLDEC X1000 Y1000\nGEAR ON Y\nX10\nDWL 0.5\nSET 8467\nDWL 0.1\nCLR 8467\nCLR 8499\nCLR 522\nP1 = P12552\nX/5\n{THERE}PRINT P12552 = P1\nSET 8467\nGEAR ON Y"
    ));
    let ran = sim.run();
    assert_eq!(ran.record.output[0].text, "-1");
    assert_eq!(ran.record.faults[0].message, "Associated Slave Kill Motion Request Active");
}

#[test]
fn a_gear_follows_motions_not_the_numbers_of_positions() {
    let sim = follower(&format!(
        "GEAR ON Y\nX10\n{THERE}PRINT P12550\nRES X\n{THERE}PRINT P12550\nENC0 RES 500\n{THERE}PRINT P12550\nX1\n{THERE}PRINT P12550"
    ));
    assert_eq!(sim.prints(), ["1000", "1000", "1000", "1100"]);
}

#[test]
fn a_locked_axis_stays_where_it_is_when_positions_get_other_numbers() {
    let sim = follower(&format!(
        "LOCK Y X\nX10\n{THERE}PRINT P12550\nRES X\n{THERE}PRINT P12294, P12550\nRES Y3\n{THERE}PRINT P12550, P12546\nX1\n{THERE}PRINT P12294, P12550"
    ));
    assert_eq!(sim.prints(), ["1000", "0\t1000", "300\t300", "1000\t400"]);
    let scaled = follower(&format!("LOCK Y X\nX10\n{THERE}PPU X500\n{THERE}PRINT P12294, P12550"));
    assert_eq!(scaled.prints(), ["10000\t1000"]);
}

#[test]
fn a_gantry_finds_its_home_without_a_step() {
    // The edge is 3 units away, and the ramp behind it takes half a unit.
    let world = "[axis.0]\nstart = 5\nswitches = [{ input = 2, from = 0, to = 2 }]\n";
    let sim = follower(
        "LOCK Y X\nJOG VEL X10\nJOG ACC X100\nJOG DEC X100\nJOG HOME X-1\nINH 16134\nPRINT P12294, P12550 < -345, P12550 > -355",
    );
    assert_eq!(sim.world(world).prints(), ["0\t-1\t-1"]);
}

#[test]
fn a_kill_switches_a_hand_wheel_off() {
    let sim = follower(&format!(
        "HDW SRC Y ENC0\nHDW ON Y\nX1\n{THERE}PRINT P12550\nSET 8499\nDWL 0.01\nCLR 8499 : CLR 8467 : CLR 522\nX2\n{THERE}PRINT P12550"
    ));
    assert_eq!(sim.prints(), ["100", "100"]);
}

#[test]
fn a_cam_whose_array_has_gone_leaves_its_offset() {
    let ran = follower(&format!("{TABLE}CAM ON Y\nX/0.5\n{THERE}CLEAR\nX/0.25\n{THERE}PRINT P12550")).run().clean();
    assert_eq!(ran.record.output[0].text, "1000");
    assert!(
        ran.notes().contains(&"AXIS1: an array of its CAM has gone; the offset stays".to_owned()),
        "{:?}",
        ran.notes()
    );
}

#[test]
fn axes_go_on_together_or_not_at_all() {
    let killed = "DETACH SLAVE1\nSET 8499\n";
    for statement in ["GEAR ON X AXIS1", "JOG FWD AXIS0 AXIS1", "JOG HOME AXIS0 1 AXIS1 1"] {
        let ran = follower(&format!("{killed}JOG VEL X10\nGEAR SRC X ENC2\n{statement}")).run();
        assert_eq!(ran.record.faults.len(), 1, "{statement}");
        assert!(!ran.bit(792), "{statement}");
    }
}
