//! Several threads find what one finds.

use std::fmt::Write as _;

use acrc_analysis::project::Config;
use acrc_analysis::{Database, FileRole, Project, SourceFile};
use acrc_diagnostics::Diagnostic;

/// A project of many files that lean on each other.
fn files() -> Vec<(String, String)> {
    let mut setup = "SYS\n".to_owned();
    for letter in 'A'..='Z' {
        let _ = writeln!(setup, "#DEFINE Lamp{letter} BIT{}", u32::from(letter));
    }
    setup.push_str("PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n");
    let part = |number: usize| {
        let lamp = char::from(b'A' + (number % 30) as u8);
        format!("PROG0\nPROGRAM\n_Part{number}\nSET Lamp{lamp}\nX{number} Y{number}\nGOTO Part{}\nENDP\n", number % 7)
    };
    let parts = (0..60).map(|number| (format!("part{number:02}.8K"), part(number)));
    std::iter::once(("Setup.8K".to_owned(), setup)).chain(parts).collect()
}

fn project(db: &Database) -> Project {
    let inputs = files().into_iter().map(|(name, text)| {
        let role = FileRole::of(&name);
        SourceFile::new(db, name, text, role, Vec::new())
    });
    Project::new(db, inputs.collect(), acrc_catalog::default_model(), Config::default())
}

fn findings(found: Vec<(SourceFile, Vec<Diagnostic>)>) -> Vec<Vec<Diagnostic>> {
    found.into_iter().map(|(_, found)| found).collect()
}

#[test]
fn several_threads_find_what_one_finds() {
    let (one, many) = (Database::new(), Database::new());
    let serial = findings(acrc_lint::check(&one, project(&one)));
    let parallel = findings(acrc_lint::check_in_parallel(&many, project(&many)));
    assert!(serial.iter().flatten().count() > 60);
    assert_eq!(serial, parallel);
}
