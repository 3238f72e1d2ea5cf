//! Scripted inputs.

use crate::support::Sim;

#[test]
fn an_event_at_zero_is_there_before_the_first_statement() {
    let world = "[[event]]\nat = 0\nset = [3]\nnote = \"start\"\n";
    let ran = Sim::new("PRINT BIT(3)\n").world(world).run().clean();
    assert_eq!((&*ran.record.output[0].text, &*ran.record.events), ("-1", &[(0.0, "start".to_owned())][..]));
}

#[test]
fn an_event_at_the_time_of_a_slice_comes_before_it() {
    let world = "[[event]]\nat = \"100ms\"\nset = [3]\n[[event]]\nat = \"200.2ms\"\nclear = [3]\n";
    let sim = Sim::program("INH 3\nPRINT \"on\"\nINH -3\nPRINT \"off\"").world(world);
    assert_eq!(sim.timed(), ["100 on", "202 off"]);
    assert_eq!(sim.watched(false).timed(), ["100 on", "202 off"]);
}

#[test]
fn events_are_told_in_their_order() {
    let world = "[[event]]\nat = 0.2\nset = [1]\nnote = \"b\"\n[[event]]\nat = 0.1\nset = [1]\nnote = \"a\"\n[[event]]\nat = 0.2\nclear = [1]\nnote = \"c\"\n";
    let ran = Sim::program("DWL 1").world(world).watched(false).run().clean();
    let expected = [(100.0, "a"), (200.0, "b"), (200.0, "c")].map(|(time, note)| (time, note.to_owned()));
    assert_eq!(ran.record.events, expected);
    assert!(!ran.bit(1));
}

#[test]
fn events_after_the_end_of_all_programs_do_not_happen() {
    let ran = Sim::program("PRINT 1").world("[[event]]\nat = 5\nset = [1]\n").run().clean();
    assert_eq!(ran.record.events.len(), 0);
}

#[test]
fn events_give_parameters_a_value() {
    let world =
        "[[event]]\nat = 1\nparameters = { P6408 = 2.5, P1 = 7 }\n[[event]]\nat = 2\nparameters = { P4095 = 1 }\n";
    let sim = Sim::program("PRINT P6408\nIHPOS P6408 (2, 0)\nPRINT P6408, P1\nDWL 2").world(world);
    let ran = sim.run().clean();
    assert_eq!(ran.record.output.iter().map(|line| &*line.text).collect::<Vec<_>>(), ["0", "2.5\t7"]);
    assert_eq!(ran.notes(), ["an event gives P4095 a value for which the controller has no room"]);
}

#[test]
fn flags_of_networks_and_hardware_come_from_outside() {
    let world = "[inputs]\npart = 11520\n[[event]]\nat = 0.5\nset = [\"part\", 5646, 128]\n[[event]]\nat = 1.5\nclear = [5646]\n";
    let program = "WHILE (P6916 < 2000)\nPRINT BIT 11520; BIT 5646; BIT 128\nDWL 0.9\nWEND";
    let ran = Sim::program(program).world(world).run().clean();
    let lines: Vec<&str> = ran.record.output.iter().map(|line| line.text.as_str()).collect();
    assert_eq!(lines, ["000", "-1-1-1", "-10-1"]);
}

#[test]
fn what_the_world_holds_outlasts_a_restart() {
    let world = "[[event]]\nat = 0.1\nset = [4, 11520]\n";
    let ran = Sim::new("PROG0\nPROGRAM\nSET 40\nDWL 0.5\nREBOOT\nENDP\n").start(&[0]).world(world).until(1.0).run();
    assert_eq!([4, 11_520, 40].map(|flag| ran.bit(flag)), [true, true, false]);
}
