//! Downloads that are not begun, or that a controller does not take.

use acrc_link::Console as _;
use acrc_link::download::{Cause, Fate, NOTHING_STORED, Plan, Script, Settings};

use crate::bench::{Notes, bring, download, look, project, script};
use crate::support::Machine;

const SLEEPER: &str = "SYS\nCLEAR\nDIM PROG0(500)\nPROG0\nPROGRAM\n_On\nDWL 1\nGOTO On\nENDP\n";

fn usual(machine: &Machine, text: &str) -> Vec<String> {
    download(machine.line(), &script(&project(text)), &Settings::default(), &mut Notes::default()).objections()
}

#[test]
fn running_programs_stop_it_and_halt_lets_it_go_on() {
    let machine = Machine::new();
    bring(&machine, &script(&project(SLEEPER)));
    machine.connect_and_type("RUN PROG0");
    machine.pass(0.1);
    assert_eq!(usual(&machine, SLEEPER), ["PROG0 runs or is paused on the controller"]);
    let settings = Settings { halt: true, ..Settings::default() };
    let mut notes = Notes::default();
    download(machine.line(), &script(&project(SLEEPER)), &settings, &mut notes).well();
    assert_eq!(notes.sent.first().map(String::as_str), Some("HALT ALL"));
    assert!(look(&machine).running.is_empty());
}

#[test]
fn motion_and_enabled_drives_stop_it() {
    let machine = Machine::with(
        "SYS\nCLEAR\nDIM PROG0(500)\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nACC 10 DEC 10 STP 10 VEL 1\n",
    );
    for line in ["PROG0", "DRIVE ON X", "X100"] {
        machine.connect_and_type(&format!("PROG0 : {line}"));
    }
    machine.pass(0.5);
    assert_eq!(usual(&machine, SLEEPER), ["MASTER0 in motion", "the drive of AXIS0 is enabled"]);
    let settings = Settings { halt: true, with_drives_enabled: true, ..Settings::default() };
    download(machine.line(), &script(&project(SLEEPER)), &settings, &mut Notes::default()).well();
    assert!(look(&machine).moving.is_empty());
}

#[test]
fn programs_without_room_stop_it() {
    let machine = Machine::new();
    assert_eq!(
        usual(
            &machine,
            "SYS\nCLEAR\nDIM PROG0(20)\nPROG0\nPROGRAM\nDWL 1 : DWL 2\nX10\nENDP\nPROG1\nPROGRAM\nDWL 1\nENDP\n"
        ),
        ["PROG0 needs 28 bytes, and it has 20", "PROG1 needs 8 bytes, and the project gives it none"]
    );
    assert_eq!(
        usual(&machine, "PROG9\nPROGRAM\nDWL 1\nENDP\n"),
        ["PROG9 needs 8 bytes, and neither the controller nor the project gives it any"]
    );
    assert!(look(&machine).programs.is_empty());
}

#[test]
fn a_refused_line_is_reported_at_its_place() {
    let machine = Machine::new();
    let script =
        script(&project("SYS\nCLEAR\nDIM PROG0(500)\nAXIS0 PPU 1000\nDIM P(5000)\nPROG0\nPROGRAM\nDWL 1\nENDP\n"));
    let failure = download(machine.line(), &script, &Settings::default(), &mut Notes::default()).failure();
    assert!(matches!(failure.cause, Cause::Refused(_)), "{failure:?}");
    let problem = failure.problem().expect("it has a place");
    let text = script.files[problem.file].text.get(problem.diagnostic.span.range());
    assert_eq!(text, Some("DIM P(5000)"));
    insta::assert_snapshot!(failure.state, @"
    5 of 11 lines were sent and answered
    PROG0: not there
    ");
}

#[test]
fn a_protected_controller_stops_it() {
    let machine = Machine::new();
    machine.connect_and_type("PASSWORD ON \"key\"");
    assert_eq!(
        usual(&machine, SLEEPER),
        ["the programs of the controller are protected from being listed (Program is protected)"]
    );
    let with = |password: &str| Settings { password: Some(password.to_owned()), ..Settings::default() };
    let script: Script = script(&project(SLEEPER));
    let failure = download(machine.line(), &script, &with("wrong"), &mut Notes::default()).failure();
    assert!(matches!(&failure.cause, Cause::Refused(text) if text == "Wrong password"), "{failure:?}");
    let state = download(machine.line(), &script, &with("key"), &mut Notes::default()).well();
    assert!(script.units().all(|unit| state.programs[&unit.name] == Fate::Verified));
}

#[test]
fn what_cannot_be_sent_is_said_before() {
    let project = project(&format!(
        "SYS\nLRUN PROG0\nREBOOT\nIF (BIT24)\nSET 32\nENDIF\nIF (BIT24) THEN NEW ALL\nPRINT \"{}\"\n",
        "x".repeat(1100)
    ));
    let image = project.compile().expect("it compiles");
    let problems = Script::of(&project, image).expect_err("it cannot be sent");
    let texts: Vec<&str> = problems.iter().map(|problem| problem.diagnostic.message.as_str()).collect();
    insta::assert_snapshot!(texts.join("\n"), @"
    LRUN cannot be sent: it shows the output of a program and gives the prompt back only at ESC
    REBOOT cannot be sent: it restarts the controller in the middle of the download
    a block over several lines cannot be typed: each line is executed by itself
    what this erases cannot be told before the download, since a condition stands before it
    the line has 1108 characters, and a controller takes 1024
    ");
}

#[test]
fn what_others_change_meanwhile_is_seen() {
    let machine = Machine::new();
    bring(&machine, &script(&project(SLEEPER)));
    let mut before = look(&machine);
    assert_eq!(look(&machine).changes_since(&before), [""; 0]);
    let other = "PROG0 : PROGRAM\nDWL 2\nENDP";
    for (typed, changes) in [
        (other, &["the text of PROG0"][..]),
        ("SYS : DIM P(7)", &["what DIM reports"]),
        ("SYS : DIM DEF(2)\n#DEFINE Lamp BIT32", &["what DIM reports", "what DEF reports"]),
        ("PROG0 : ATTACH MASTER0", &["what ATTACH reports"]),
        ("RUN PROG0", &["which programs run"]),
    ] {
        let mut connection = machine.connect();
        for line in typed.lines() {
            connection.command(line).expect("it is answered");
        }
        let now = look(&machine);
        assert_eq!(now.changes_since(&before), changes, "{typed}");
        before = now;
    }
}

#[test]
fn settings_without_a_program_are_noted() {
    let machine = Machine::new();
    let model = acrc_catalog::default_model();
    for (text, noted) in [("SYS\nDIM P(9)\nP1=3\n", true), (SLEEPER, false)] {
        let plan = Plan::new(&script(&project(text)), &look(&machine), model, &Settings::default()).expect("a plan");
        assert_eq!(plan.notes.iter().any(|(_, note)| note == NOTHING_STORED), noted, "{text}");
    }
}
