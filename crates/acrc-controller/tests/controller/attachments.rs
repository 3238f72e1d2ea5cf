//! Masters, slaves and axis names (guide, "Attachments").

use crate::support::{Sim, TWO_AXES};

#[test]
fn programs_with_masters_of_their_own_move_at_once() {
    let text = format!(
        "{TWO_AXES}PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"X\"\nACC 100 DEC 100 STP 100 VEL 20\n\
         PROG0\nPROGRAM\nX10\nINH -516\nPRINT 0\nENDP\nPROG1\nPROGRAM\nX10\nINH -548\nPRINT 1\nENDP\n"
    );
    let ran = Sim::new(&text).start(&[0, 1]).run().clean();
    assert_eq!((ran.position(0), ran.position(2)), (10.0, 10.0), "X is an axis of its own in each program");
    assert_eq!(ran.record.output.iter().map(|line| &*line.text).collect::<Vec<_>>(), ["1", "0"]);
    let names: Vec<_> = ran.controller.axes().into_iter().map(|axis| (axis.axis, axis.name.unwrap())).collect();
    assert_eq!(names, [(0, "X".to_owned()), (1, "Y".to_owned()), (2, "X".to_owned())]);
    let masters: Vec<_> =
        ran.controller.masters().iter().map(|master| (master.master, master.statistics.moves)).collect();
    assert_eq!(masters, [(0, 1), (1, 1)]);
}

#[test]
fn attachments_that_contradict_each_other_are_refused() {
    for (statements, fault) in [
        ("ATTACH MASTER1", "program 0 is attached already, to MASTER0"),
        ("ATTACH SLAVE2 AXIS0 \"Z\"", "AXIS0 is attached already, to SLAVE0 of MASTER0"),
        ("ATTACH SLAVE0 AXIS2 \"Z\"", "SLAVE0 is attached already, to AXIS0"),
        ("ATTACH SLAVE2 AXIS2 \"X\"", "the name X is attached already, to another axis of this program"),
        ("PROG1\nATTACH MASTER0", "MASTER0 is attached already, to program 0"),
        ("PROG1\nATTACH SLAVE0 AXIS2 \"Z\"", "program 1 has no master: ATTACH MASTER comes first"),
        ("PROG1\nATTACH MASTER8", "MASTER8 does not exist: this controller has MASTER0 to MASTER7"),
        ("ATTACH SLAVE8 AXIS2 \"Z\"", "SLAVE8 does not exist: this controller has SLAVE0 to SLAVE7"),
        ("ATTACH SLAVE2 AXIS8 \"Z\"", "AXIS8 does not exist: this controller has AXIS0 to AXIS7"),
        ("DETACH MASTER1", "program 0 is not attached to MASTER1"),
    ] {
        assert_eq!(Sim::new(&format!("{TWO_AXES}{statements}\n")).faults(), [fault], "{statements}");
    }
}

#[test]
fn attaching_the_same_master_again_changes_nothing() {
    assert_eq!(Sim::program("ATTACH MASTER0\nX10\nINH -516").run().clean().position(0), 10.0);
}

#[test]
fn an_axis_is_attached_elsewhere_after_it_was_detached() {
    let text = format!(
        "{TWO_AXES}X10\nINH -516\nDETACH SLAVE0\nATTACH SLAVE3 AXIS0 \"A\"\nA/5\nINH -516\nDETACH\nPROG1\nATTACH MASTER0\n\
         ATTACH SLAVE0 AXIS0 \"B\"\nB/5\nINH -516\nPRINT P12288\nVEL\n"
    );
    assert_eq!(Sim::new(&text).prints(), ["20", "10"], "position and the settings of the master stay");
}

#[test]
fn a_name_is_free_after_its_slave_was_detached() {
    let text = format!("{TWO_AXES}DETACH SLAVE0\nATTACH SLAVE0 AXIS5 \"X\"\nX3\nINH -516\n");
    assert_eq!(Sim::new(&text).run().clean().position(5), 3.0);
}

#[test]
fn nothing_is_detached_in_motion() {
    let text = format!("{TWO_AXES}X10\nDETACH\nDETACH SLAVE0\nSYS\nDETACH ALL\nPROG0\nINH -516\nDETACH\n");
    assert_eq!(Sim::new(&text).faults(), ["Not valid while in motion"; 3]);
}

#[test]
fn detaching_nothing_is_no_mistake() {
    Sim::new("SYS\nDETACH ALL\nPROG0\nDETACH\n").run().clean();
}

#[test]
fn axes_beyond_the_model_have_no_attachment() {
    assert_eq!(Sim::new("SYS\nATTACH AXIS9 ENC9 DAC9 ENC9\n").faults().len(), 1);
    Sim::new("SYS\nATTACH AXIS7 ENC7 DAC7 ENC7\n").run().clean();
}
