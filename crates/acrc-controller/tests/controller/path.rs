//! What bends, shifts and turns paths: `ROTARY`, `FLZ`, `OFFSET`, `ROTATE`, `SCALE`, `TANG`, `LOOK`.

use crate::support::{Sim, TWO_AXES};

/// Where X and Y are when the moves of a program are over, to a millionth.
fn end(body: &str) -> (f64, f64) {
    let ran = Sim::program(&format!("{body}\nINH -516")).run().clean();
    (ran.position(0), ran.position(1))
}

#[test]
fn a_rotary_axis_goes_the_short_way() {
    assert_eq!(end("ROTARY X360\nX350").0, -10.0);
    assert_eq!(end("ROTARY X360\nX350\nX10").0, 10.0);
    assert_eq!(end("ROTARY X360\nX725").0, 5.0);
    assert_eq!(end("ROTARY X360\nX/350").0, 350.0, "a distance is a distance");
    assert_eq!(end("ROTARY X360\nROTARY X0\nX350").0, 350.0);
    assert_eq!(Sim::program("ROTARY X360\nROTARY X Y\nAXIS1 ROTARY 36\nROTARY Y").prints(), ["360", "0", "36"]);
    assert_eq!(Sim::program("ROTARY X-1").faults(), ["ROTARY: -1 is negative"]);
}

#[test]
fn the_rotary_length_belongs_to_the_axis() {
    let body = "ROTARY X360\nDETACH\nATTACH MASTER0\nATTACH SLAVE1 AXIS0 \"X\"\nX350";
    assert_eq!(end(body).0, -10.0);
}

#[test]
fn an_offset_shifts_what_is_programmed() {
    assert_eq!(end("OFFSET X5 Y-2\nX10 Y10"), (15.0, 8.0));
    assert_eq!(end("X10\nOFFSET X5\nX/3").0, 13.0, "a distance is not shifted");
    assert_eq!(end("OFFSET X5\nOFFSET X0\nX10").0, 10.0);
    assert_eq!(Sim::program("OFFSET X5\nOFFSET X\nOFFSET").prints(), ["5", "5", "0"]);
}

#[test]
fn a_floating_zero_lies_where_the_last_move_ends() {
    assert_eq!(end("X10\nFLZ X0\nX5").0, 15.0);
    assert_eq!(end("X10\nFLZ X2\nX5").0, 17.0);
    assert_eq!(Sim::program("X10\nFLZ X2\nFLZ X Y").prints(), ["12", "0"]);
}

#[test]
fn a_scale_is_about_its_centre() {
    assert_eq!(end("SCALE X2\nX10 Y10"), (20.0, 10.0));
    assert_eq!(end("SCALE X(2, 10)\nX15").0, 20.0);
    assert_eq!(end("SCALE X-1\nX10\nX/5").0, -15.0);
    assert_eq!(Sim::program("SCALE X(2, 10)\nSCALE X Y").prints(), ["2", "1"]);
    assert_eq!(Sim::program("SCALE X0").faults(), ["a scale factor of zero makes every path a point"]);
}

#[test]
fn a_rotation_turns_about_its_centre() {
    assert_eq!(end("ROTATE 90\nX10"), (0.0, 10.0));
    assert_eq!(end("ROTATE 90 X5 Y0\nX10 Y0"), (5.0, 5.0));
    assert_eq!(end("ROTATE 90 Y0 X0\nX10"), (0.0, -10.0), "from the first axis toward the second");
    assert_eq!(end("ROTATE 90\nROTATE 0\nX10"), (10.0, 0.0));
    assert_eq!(Sim::program("ROTATE 30\nROTATE").prints(), ["30"]);
    let fault = "ROTATE expects an angle, and no axis or two with their centres";
    assert_eq!(Sim::program("ROTATE 30 X5").faults(), [fault]);
}

#[test]
fn transformations_follow_each_other() {
    // Twice as far, then a quarter turn, then the shift.
    assert_eq!(end("SCALE X2\nROTATE 90\nOFFSET X1 Y1\nX10 Y0"), (1.0, 21.0));
}

#[test]
fn an_arc_is_transformed_as_a_whole() {
    let body = "ROTATE 90\nOFFSET X100\nX0 Y0\nCIRCCW X(10, 5) Y(0, 0)";
    assert_eq!(end(body), (100.0, 10.0));
    let ran = Sim::program(body).until(11.0).run().clean();
    let view = ran.controller.view();
    assert!(((view.position(0) - 100.0).hypot(view.position(1) - 5.0) - 5.0).abs() < 1e-9);
    assert!(view.position(0) > 100.0, "round the same way");
}

#[test]
fn another_attachment_knows_no_transformation() {
    let again = "DETACH\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"";
    assert_eq!(end(&format!("OFFSET X5\nSCALE X2\nROTATE 90\nX0 Y0\nINH -516\nRES\n{again}\nX10")), (10.0, 0.0));
}

#[test]
fn a_tangential_axis_points_along_the_path() {
    let z = |body: &str| Sim::in_space(&format!("{body}\nINH -516")).run().clean().position(2);
    assert_eq!(z("TANG ON X Y Z\nY10"), 90.0);
    assert_eq!(z("TANG ON Z\nX10 Y10"), 45.0, "alone it follows the first two slots");
    assert_eq!(z("TANG ON X Y Z5\nX10"), 5.0);
    assert_eq!(z("ROTARY Z1\nTANG ON X Y Z\nY10"), 0.25);
    // The circle begins downward and turns once.
    assert_eq!(z("TANG ON X Y Z\nCIRCCW X(0, 5) Y(0, 0)"), 270.0);
    assert_eq!(z("TANG ON X Y Z\nY10\nTANG OFF\nX10"), 90.0);
    let faults = Sim::in_space("TANG ON X Y").faults();
    assert_eq!(faults, ["TANG ON expects two axes of a path and the axis that turns"]);
}

#[test]
fn looking_ahead_slows_down_for_corners_and_for_the_end() {
    let straight = "STP 0\nLOOK ON\nX10\nX20\nINH -516";
    let ran = Sim::program(straight).run().clean();
    assert_eq!((ran.milliseconds(), ran.notes()), (2100.0, vec![]));
    // A right angle is a stop, unless the angles say otherwise.
    let corner = |angles: &str| {
        Sim::program(&format!("STP 0\n{angles}\nLOOK ON\nX10\nY10\nINH -516")).run().clean().milliseconds()
    };
    assert_eq!(corner(""), 2200.0);
    assert_eq!(corner("LOOK ANG 90 180"), 2100.0);
    assert!((2100.0..2200.0).contains(&corner("LOOK ANG 0 180")));
    assert_eq!(Sim::program("LOOK ANG\nLOOK ANG 10 45\nLOOK ANG").prints(), ["0", "90", "10", "45"]);
    let fault = "LOOK ANG: 50 and 40 are no angles that rise from 0 to 180";
    assert_eq!(Sim::program("LOOK ANG 50 40").faults(), [fault]);
}

#[test]
fn without_looking_ahead_a_move_without_stop_ramp_keeps_its_velocity() {
    let ran = Sim::program("STP 0\nLOOK ON\nLOOK OFF\nX10\nINH -516").run().clean();
    assert!(ran.notes()[0].contains("dropped to zero at once"), "{:?}", ran.notes());
}

#[test]
fn the_rapid_override_is_for_rapid_moves_which_no_statement_makes() {
    let ran = Sim::program("ROV 0.5\nX10\nROV\nINH -516").run().clean();
    assert_eq!((ran.record.output[0].text.as_str(), ran.milliseconds()), ("0.5", 1100.0));
}

#[test]
fn times_of_moves_are_switched_off_and_on() {
    let time = |body: &str| Sim::program(&format!("{body}\nX10\nINH -516")).run().clean().milliseconds();
    assert_eq!(time("TMOV 5"), 5000.0);
    assert_eq!(time("TMOV 5\nTMOV OFF"), 1100.0);
    assert_eq!(time("TMOV 5\nTMOV OFF\nTMOV ON"), 5000.0);
    let text = format!("{TWO_AXES}SYS\nMASTER0 ROV 0.5\nMASTER0 ROV\n");
    assert_eq!(Sim::new(&text).prints(), ["0.5"]);
}

#[test]
fn the_final_velocity_only_slows_down() {
    let time = |body: &str| Sim::program(&format!("{body}\nINH -516")).run().clean().milliseconds();
    // FVEL above VEL changes nothing: the move ends with the velocity it has.
    let faster = Sim::program("FVEL 20\nX10\nSTP 100 FVEL 0\nX20\nINH -516").run().clean();
    assert_eq!(faster.milliseconds(), 2100.0);
    // 0.1 s up, 9.125 units at 10 u/s, 0.05 s down to 5 u/s; 0.05 s up, 9.125 units, 0.1 s down.
    let expected = (0.1 + 0.9125 + 0.05 + 0.05 + 0.9125 + 0.1) * 1000.0;
    assert!((time("FVEL 5\nX10\nFVEL 0\nX20") - expected).abs() < 2.0);
}

#[test]
fn no_move_makes_an_axis_faster_than_its_highest_velocity() {
    let time = |body: &str| Sim::program(&format!("{body}\nINH -516")).run().clean().milliseconds();
    // Y has 4/5 of the velocity along the path, which is 5 u/s then.
    assert_eq!(time("MAXVEL Y4\nX6 Y8"), 2050.0);
    assert_eq!(time("MAXVEL Y4\nX10"), 1100.0);
    assert_eq!(time("MAXVEL Y4\nFOV 2\nX6 Y8"), 2050.0);
    assert_eq!(time("MAXVEL Y4\nMAXVEL Y0\nX6 Y8"), 1100.0);
    assert_eq!(Sim::program("MAXVEL X5\nMAXVEL X Y").prints(), ["5", "0"]);
    assert_eq!(Sim::program("MAXVEL X-5").faults(), ["MAXVEL: -5 is negative"]);
}
