//! Downloads that work.

use std::path::{Path, PathBuf};

use acrc_image::UnitName;
use acrc_link::download::{Fate, Save, Settings};

use crate::bench::{Notes, bring, download, files, load, look, project, script};
use crate::support::Machine;

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The projects of the repository.
fn projects() -> Vec<PathBuf> {
    let folder = repository().join("tests/programs");
    let entries = std::fs::read_dir(folder).expect("programs").map(|entry| entry.expect("an entry").path());
    let mut projects: Vec<PathBuf> = entries.filter(|path| path.is_dir()).map(|path| path.join("program.8K")).collect();
    projects.push(repository().join("examples/gantry"));
    projects.sort();
    projects
}

#[test]
fn every_project_arrives_and_a_second_time_too() {
    for path in projects() {
        let script = script(&load(&path));
        let machine = Machine::new();
        let (state, _) = bring(&machine, &script);
        assert!(state.programs.values().all(|fate| *fate == Fate::Verified), "{path:?}: {state}");
        let first = look(&machine);
        let (_, notes) = bring(&machine, &script);
        let erasing = |line: &String| ["CLEAR", "NEW", "PROGRAM"].contains(&line.as_str()) || line.starts_with("DIM");
        assert!(!notes.sent.iter().any(erasing), "{path:?}: {:#?}", notes.sent);
        assert_eq!(format!("{first:?}"), format!("{:?}", look(&machine)), "{path:?}");
    }
}

#[test]
fn everything_is_sent_again_where_that_is_wanted() {
    let script = script(&load(&repository().join("examples/gantry")));
    let machine = Machine::new();
    bring(&machine, &script);
    let mut notes = Notes::default();
    let settings = Settings { everything: true, ..Settings::default() };
    download(machine.line(), &script, &settings, &mut notes).well();
    assert_eq!(notes.sent.iter().filter(|line| *line == "PROGRAM").count(), 2);
    assert_eq!(notes.sent.iter().filter(|line| line.as_str() == "NEW ALL").count(), 1);
}

#[test]
fn what_a_project_does_not_say_itself_comes_first() {
    let machine = Machine::new();
    bring(&machine, &script(&project("SYS\nCLEAR\nDIM PROG3(1000)\nPROG3\nPROGRAM\nX1\nENDP\n")));
    let second = script(&project(
        "SYS\nDIM PROG0(1000)\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nX10 ' there\nENDP\n",
    ));
    let (state, notes) = bring(&machine, &second);
    insta::assert_snapshot!(notes.sent.join("\n"), @r#"
    NEW ALL
    CLEAR
    DETACH ALL
    SYS
    DIM PROG0(1000)
    PROG0
    ATTACH MASTER0
    ATTACH SLAVE0 AXIS0 "X"
    PROGRAM
    X10
    ENDP
    SYS
    "#);
    insta::assert_snapshot!(state, @"
    12 of 12 lines were sent and answered
    PROG3: erased
    PROG0: new, verified
    ");
}

#[test]
fn programs_that_a_partial_project_does_not_have_stay() {
    let machine = Machine::new();
    bring(
        &machine,
        &script(&project(
            "SYS\nDIM PROG0(500) DIM PROG1(500) DIM DEF(3)\n#DEFINE Lamp BIT32\nPROG0\nPROGRAM\nSET Lamp\nENDP\n\
             PROG1\nPROGRAM\nDWL 1\nENDP\n",
        )),
    );
    let changed = script(&project("PROG1\nPROGRAM\nDWL 2\nENDP\n"));
    let (state, notes) = bring(&machine, &changed);
    insta::assert_snapshot!(notes.sent.join("\n"), @"
    PROG1
    NEW
    SYS
    PROG1
    PROGRAM
    DWL 2
    ENDP
    SYS
    ");
    assert_eq!(state.with(Fate::Old).collect::<Vec<_>>(), [UnitName::Program(0)]);
    assert_eq!(look(&machine).programs.len(), 2);
}

#[test]
fn a_program_whose_names_mean_something_else_is_sent_again() {
    let text = |bit: u32| format!("#DEFINE Lamp BIT{bit}\nPROG0\nPROGRAM\nSET Lamp\nENDP\n");
    let machine = Machine::with("SYS\nCLEAR\nDIM PROG0(500)\nDIM DEF(3)\n");
    bring(&machine, &script(&project(&text(32))));
    let (_, notes) = bring(&machine, &script(&project(&text(33))));
    assert!(notes.sent.contains(&"SET Lamp".to_owned()), "{:?}", notes.sent);
    let (_, notes) = bring(&machine, &script(&project(&text(33))));
    assert!(!notes.sent.contains(&"SET Lamp".to_owned()), "{:?}", notes.sent);
}

#[test]
fn numbered_lines_remarks_and_typographic_characters_arrive() {
    let machine = Machine::new();
    let script = script(&project(
        "SYS : CLEAR : DIM PROG0(3000)\nPROG0\n10 REM “quoted” – and more\n30 PRINT \"it’s\" ' a comment\n20 X1 : Y2\n40 X3\n40\n\
         PROGRAM\nREM again\n100 _Loop\nIF (BIT32)\nX1 Y2 : DWL 0.5\nENDIF\nGOTO Loop\nENDP\n50 DWL 1\n",
    ));
    let (_, notes) = bring(&machine, &script);
    insta::assert_snapshot!(notes.sent.join("\n"));
    insta::assert_snapshot!(look(&machine).programs[&UnitName::Program(0)].text());
}

#[test]
fn numbers_of_all_lines_make_no_difference() {
    let machine = Machine::new();
    let script = script(&load(&repository().join("examples/gantry")));
    bring(&machine, &script);
    machine.connect_and_type("SET 5651");
    let (_, notes) = bring(&machine, &script);
    assert!(!notes.sent.contains(&"PROGRAM".to_owned()));
    assert!(machine.look(|controller| controller.bit(5651).expect("a flag")));
}

#[test]
fn a_protected_controller_is_opened_and_closed_again() {
    let machine = Machine::new();
    let script = script(&project(
        "SYS\nNEW ALL\nCLEAR\nPASSWORD ON \"key\"\nDIM PROG0(500)\nPROG0\nPROGRAM\nDWL 1\nENDP\nPROG0\nPASSWORD ON \"key\"\n",
    ));
    bring(&machine, &script);
    assert_eq!(look(&machine).protected.as_deref(), Some("Program is protected"));
    bring(&machine, &script);
    assert!(look(&machine).protected.is_some());
}

#[test]
fn what_is_started_and_saved_comes_last() {
    let machine = Machine::new();
    let script = script(&project("SYS\nCLEAR\nDIM PROG0(500)\nPROG0\nPROGRAM\nDWL 100\nENDP\n"));
    let mut notes = Notes::default();
    let settings =
        Settings { run: vec![UnitName::Program(0)], save: [Save::Eeprom, Save::Flash].into(), ..Settings::default() };
    download(machine.line(), &script, &settings, &mut notes).well();
    assert_eq!(notes.said, ["PROG0 true"]);
    machine.connect_and_type("REBOOT");
    machine.pass(1.0);
    assert_eq!(look(&machine).programs.len(), 1);
}

#[test]
fn a_folder_of_files_is_sent_in_its_order() {
    let machine = Machine::new();
    let script = script(&files(&[
        ("Prog1.8K", "PROGRAM\nDWL 1\nENDP\n"),
        ("Setup.8K", "SYS\nCLEAR\nDIM PROG0(500)\nDIM PROG1(500)\n"),
        ("Prog0.8K", "REM the whole text\nDWL 2\n"),
    ]));
    let (_, notes) = bring(&machine, &script);
    insta::assert_snapshot!(notes.sent.join(" | "));
}

#[test]
fn what_an_earlier_project_has_attached_elsewhere_is_detached() {
    let attached = |program: u8| {
        format!(
            "SYS\nCLEAR\nDIM PROG0(500)\nPROG{program}\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROG0\nPROGRAM\nDWL 1\nENDP\n"
        )
    };
    let machine = Machine::new();
    bring(&machine, &script(&project(&attached(5))));
    let (_, notes) = bring(&machine, &script(&project(&attached(0))));
    assert!(!notes.sent.contains(&"PROGRAM".to_owned()), "{:?}", notes.sent);
    assert_eq!(look(&machine).attachments.keys().collect::<Vec<_>>(), [&UnitName::Program(0)]);
}

#[test]
fn a_servo_period_can_be_sent_again() {
    let script = script(&project("SYS\nPERIOD 0.0005\nCLEAR\nDIM PROG0(500)\nPROG0\nPROGRAM\nDWL 1\nENDP\n"));
    let machine = Machine::new();
    bring(&machine, &script);
    bring(&machine, &script);
}
