//! Moving the axes of a program from outside.

mod support;

use acrc_link::Console as _;
use acrc_link::motion::{Group, MoveError, Target};
use support::Machine;

const TWO_AXES: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS3 \"TILT\"\n\
                        AXIS0 PPU 1000 : AXIS3 PPU 100\nACC 100 DEC 100 STP 100 VEL 10\n";

fn targets(texts: &[&str]) -> Vec<Target> {
    texts.iter().map(|text| text.parse().expect("a target")).collect()
}

#[test]
fn a_move_goes_to_its_targets() {
    let machine = Machine::with(TWO_AXES);
    let mut console = machine.connect();
    let group = Group::find(&mut console, 0).expect("it has a master");
    let targets = targets(&["X10", "tilt/-2.5"]);
    let axes = group.moved(&targets).expect("it has them");
    assert_eq!(axes.iter().map(|axis| axis.number).collect::<Vec<_>>(), [0, 3]);
    assert!(group.obstacles(&mut console).expect("an answer").is_empty());
    assert_eq!(group.set_velocity(&mut console, 20.0).ok(), Some(10.0));
    group.start(&mut console, &targets).expect("it starts");
    assert!(group.is_moving(&mut console).expect("an answer"));
    machine.pass(3.0);
    assert!(!group.is_moving(&mut console).expect("an answer"));
    let positions: Vec<f64> = axes.iter().map(|axis| group.position(&mut console, axis).expect("an answer")).collect();
    assert_eq!(positions, [10.0, -2.5]);
}

#[test]
fn a_stop_ramps_down_and_blocks() {
    let machine = Machine::with(TWO_AXES);
    let mut console = machine.connect();
    let group = Group::find(&mut console, 0).expect("it has a master");
    group.start(&mut console, &targets(&["X100"])).expect("it starts");
    machine.pass(1.0);
    group.stop(&mut console).expect("it is set");
    machine.pass(1.0);
    assert!(!group.is_moving(&mut console).expect("an answer"));
    assert!(group.is_killed(&mut console).expect("an answer"));
    let position = group.position(&mut console, &group.axes[0]).expect("an answer");
    assert!((5.0..15.0).contains(&position), "{position}");
    let obstacles = group.obstacles(&mut console).expect("an answer");
    let first = obstacles.first().map(ToString::to_string).unwrap_or_default();
    assert_eq!(
        first,
        "BIT522 (Kill All Moves Request, master 0) is set: the master does not move; acrc reset-kamr clears it"
    );
    console.send_key(0x19).expect("it is sent");
    assert!(group.obstacles(&mut console).expect("an answer").is_empty());
}

#[test]
fn what_cannot_be_moved_is_named() {
    let mut console = Machine::with(TWO_AXES).connect();
    let error = Group::find(&mut console, 1).expect_err("it has none");
    assert_eq!(error.to_string(), "program 1 has no master: ATTACH shows none");
    let group = Group::find(&mut console, 0).expect("it has a master");
    let error = group.moved(&targets(&["Z1"])).expect_err("it has no Z");
    assert_eq!(error.to_string(), "program 0 has no axis named Z; it has X, TILT");
    assert!(matches!(group.moved(&targets(&["X1", "x2"])), Err(MoveError::Twice(_))));
    assert!(matches!(Group::find(&mut console, 77), Err(MoveError::Link(_))));
}
