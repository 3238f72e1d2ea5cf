//! Reading back: upload and comparison.

use acrc_link::Console as _;
use acrc_link::download::{Standing, Upload, compare, upload};

use crate::bench::{bring, files, look, project, script};
use crate::support::Machine;

const MACHINE: &str = "' a machine\nSYS\nCLEAR\nDIM PROG0(900)\nDIM PROG1(600)\nDIM P(4) : DIM DEF(3)\n#DEFINE Lamp BIT32\n\
                       PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n\n' to and fro\nPROGRAM\n\n' what it does\n\
                       set  Lamp      ' on\n' forth\nx1 : x0\nIF (BIT33)   ' stopped\nclr Lamp\nENDIF\n' the end\nENDP\n\
                       PROG1\nPROGRAM\nDWL 1 ' wait\nENDP\n";

fn text(upload: &Upload) -> String {
    let files = upload.files.iter();
    let files = files.map(|file| format!("--- {} ({} of {})\n{}", file.name, file.recovered, file.lines, file.text));
    files.chain(upload.notes.iter().map(|note| format!("{note}\n"))).collect()
}

#[test]
fn comments_come_back_where_the_text_is_the_same() {
    let (machine, script) = (Machine::new(), script(&project(MACHINE)));
    bring(&machine, &script);
    let mut connection = machine.connect();
    for line in ["PROG0", "25 X3", "30", "PROG1", "20 DWL 2"] {
        connection.command(line).expect("it is answered");
    }
    drop(connection);
    insta::assert_snapshot!(text(&upload(&look(&machine), Some(&script))));
}

#[test]
fn an_upload_is_a_project_that_gives_the_same_controller() {
    let (machine, original) = (Machine::new(), script(&project(MACHINE)));
    bring(&machine, &original);
    for local in [None, Some(&original)] {
        let upload = upload(&look(&machine), local);
        assert!(upload.notes.is_empty(), "{:?}", upload.notes);
        let written: Vec<(&str, &str)> =
            upload.files.iter().map(|file| (file.name.as_str(), file.text.as_str())).collect();
        let copy = script(&files(&written));
        let other = Machine::new();
        bring(&other, &copy);
        assert_eq!(format!("{:?}", look(&machine)), format!("{:?}", look(&other)));
    }
    insta::assert_snapshot!(text(&upload(&look(&machine), Some(&original))));
}

#[test]
fn a_comparison_names_what_differs() {
    let machine = Machine::new();
    bring(&machine, &script(&project(MACHINE)));
    let same = compare(&script(&project(MACHINE)), &look(&machine));
    assert!(same.is_equal(), "{same:#?}");
    let changed = MACHINE.replace("BIT32", "BIT40").replace("DIM P(4)", "DIM P(5)").replace("DWL 1", "DWL 2");
    let changed = changed.replace("PROG1", "PROG2");
    let other = compare(&script(&project(&changed)), &look(&machine));
    let programs = other.programs.iter().map(|pair| format!("{} {}", pair.unit, pair.standing.as_str()));
    let entries = other.entries.iter().filter(|entry| entry.standing != Standing::Equal);
    let entries = entries.map(|entry| format!("{} {:?} {:?}", entry.name, entry.project, entry.controller));
    insta::assert_snapshot!(programs.chain(entries).collect::<Vec<_>>().join("\n"));
}
