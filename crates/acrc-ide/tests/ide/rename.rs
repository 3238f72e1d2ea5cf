//! Renaming, and the proof that it changes nothing but names.

use acrc_analysis::project::{Config, LoadedFile, LoadedProject};
use acrc_analysis::{Database, FileRole, SourceFile};
use acrc_diagnostics::{Fix, apply};
use acrc_ide::{Entity, FilePosition, Occurrence, in_file, prepare_rename, rename};
use acrc_syntax::{Encoding, SourceText};
use proptest::prelude::*;

use crate::fixture::Fixture;

const PROJECT: &str = "\
=== Setup.8K
SYS : DIM DEF(4)
#DEFINE Clamp BIT32
#DEFINE Speed P1
#DEFINE Lift P2
PROG0
ATTACH MASTER0 : ATTACH SLAVE0 AXIS0 \"X\" : ATTACH SLAVE1 AXIS1 \"Y\"
PROG1
ATTACH MASTER1 : ATTACH SLAVE0 AXIS2 \"X\"
=== Prog0.8K
PROGRAM
_Top
SET Clamp:VEL(Speed)
X10Y5 : JOG VEL X5
_10
IF (Clamp AND Speed>2)THEN GOSUB Sub:GOTO10
x/(Lift+1) Y(1)
GOTO Top
_Sub
RETURN
ENDP
=== Prog1.8K
PROGRAM
_Top
CLR Clamp : X(Speed)
GOTO Top
ENDP
";

/// What becomes of the project, only the lines that differ; or why not.
fn renamed(before: &str, behind: &str, name: &str) -> String {
    let whole = format!("{before}{behind}");
    assert_eq!(PROJECT.matches(&whole).count(), 1, "{whole}");
    let fixture = Fixture::new(&PROJECT.replace(&whole, &format!("{before}$0{behind}")));
    match rename(&fixture.db, fixture.cursor(), name) {
        Err(error) => format!("! {error}"),
        Ok(edits) => {
            let mut lines = Vec::new();
            for (file, edits) in edits {
                let before = file.text(&fixture.db);
                let after = apply(before, &[&Fix::safe("", edits)]).expect("the edits fit");
                let changed = before.lines().zip(after.lines()).enumerate().filter(|(_, (a, b))| a != b);
                lines.extend(changed.map(|(at, (_, after))| format!("{}:{}: {after}", file.name(&fixture.db), at + 1)));
            }
            lines.join("\n")
        }
    }
}

#[test]
fn names_change_where_they_are_known() {
    let cases = [
        ("#DEFINE ", "Clamp", "Gripper"),
        ("SET ", "Clamp", "Gripper"),
        ("VEL(", "Speed", "Feed"),
        ("JOG VEL ", "X5", "ROT"),
        ("/(Lift+1) ", "Y(1)", "e"),
        ("AXIS2 \"", "X\"", "ROT"),
        ("GOSUB ", "Sub", "Routine"),
        ("_1", "0\n", "Again"),
        (":GOTO1", "0", "Again"),
    ];
    let shown =
        cases.map(|(before, behind, name)| format!("{before}|{behind} -> {name}\n{}\n", renamed(before, behind, name)));
    insta::assert_snapshot!(shown.join("\n"));
}

#[test]
fn the_rules_forbid_names() {
    let cases = [
        ("#DEFINE ", "Clamp", vec!["", "Vel", "Clamp1", "Speed", "x", "Aaaaaaaaaaaaaaaaaaaaaaaaaa"]),
        ("JOG VEL ", "X5", vec!["", "F", "P", "AB1", "TABLE", "Y", "VEL", "lift"]),
        ("GOSUB ", "Sub", vec!["", "A_b", "1a", "Top", "10", "\u{e4}"]),
        ("SET", " Clamp", vec!["Set"]),
    ];
    let mut shown = Vec::new();
    for (before, behind, names) in cases {
        for name in names {
            shown.push(format!("{before}|{behind} -> `{name}`: {}", renamed(before, behind, name)));
        }
    }
    insta::assert_snapshot!(shown.join("\n"));
}

#[test]
fn what_cannot_be_read_may_hold_the_name() {
    let fixture = Fixture::new("=== Setup.8K\n#DEFINE Clamp BIT32\n=== Prog0.8K\nPROGRAM\nSET Cl$0amp\nSET (\nENDP\n");
    let error = prepare_rename(&fixture.db, fixture.cursor()).expect_err("a line can't be read");
    assert!(error.to_string().starts_with("the name may stand in what can't be read at Prog0.8K:3:"), "{error}");
    let other = Fixture::new("=== Prog1.8K\nSET (\n=== Prog0.8K\nPROGRAM\n_T$0op\nGOTO Top\nENDP\n");
    assert!(prepare_rename(&other.db, other.cursor()).is_ok(), "another program knows no label of this one");
}

fn image(files: &[(String, String)]) -> acrc_image::Image {
    let file = |(name, text): &(String, String)| LoadedFile {
        path: name.clone().into(),
        role: FileRole::of(name),
        source: SourceText { text: text.clone(), encoding: Encoding::Utf8, end_mark: false },
    };
    let project = LoadedProject {
        name: String::new(),
        model: acrc_catalog::default_model(),
        root: "".into(),
        config: Config::default(),
        files: files.iter().map(file).collect(),
    };
    let mut image = project.compile().expect("the project compiles");
    image.strip();
    image
}

fn texts(fixture: &Fixture) -> Vec<(String, String)> {
    let text = |file: &SourceFile| (file.name(&fixture.db).to_owned(), file.text(&fixture.db).to_owned());
    fixture.files.iter().map(text).collect()
}

/// What has a name of its own, in the order of the files.
fn named(fixture: &Fixture) -> impl Iterator<Item = (SourceFile, Occurrence)> {
    let in_file = |file: &SourceFile| {
        let file = *file;
        in_file(&fixture.db, fixture.project, file).into_iter().map(move |occurrence| (file, occurrence))
    };
    let own = |entity: &Entity| matches!(entity, Entity::Alias(_) | Entity::Axis(..) | Entity::Label(..));
    fixture.files.iter().flat_map(in_file).filter(move |(_, occurrence)| own(&occurrence.entity))
}

/// How many words each unit of an image has.
fn shape(image: &acrc_image::Image) -> Vec<usize> {
    image.units().map(|unit| unit.words.len()).collect()
}

/// Renames what stands at the nth place with a name of its own.
fn rename_nth(fixture: &mut Fixture, nth: usize, name: &str) -> Option<(Entity, String)> {
    let db: &Database = &fixture.db;
    let all: Vec<_> = named(fixture).collect();
    let (file, occurrence) = all[nth % all.len()].clone();
    let old = file.text(db)[occurrence.span.range()].to_owned();
    let position = FilePosition { project: fixture.project, file, offset: occurrence.span.start };
    let edits = rename(db, position, name).ok()?;
    for (file, edits) in edits {
        let after = apply(file.text(&fixture.db), &[&Fix::safe("", edits)]).expect("the edits fit");
        fixture.db.edit(file, after);
    }
    // The setup writes the names of axes in capital letters.
    let old = if matches!(occurrence.entity, Entity::Axis(..)) { old.to_ascii_uppercase() } else { old };
    Some((occurrence.entity, old))
}

proptest! {
    #[test]
    fn a_renamed_project_compiles_to_the_same_image(nth in 0_usize..100, name in "[A-Za-z]{1,6}|[eE]|[XYxy]") {
        let mut fixture = Fixture::new(PROJECT);
        let before = image(&texts(&fixture));
        let Some((entity, old)) = rename_nth(&mut fixture, nth, &name) else { return Ok(()) };
        let there = image(&texts(&fixture));
        prop_assert_eq!(shape(&before), shape(&there));
        if old.starts_with(|c: char| c.is_ascii_digit()) {
            // A label that no rename gives.
            return Ok(());
        }
        // Names are part of an image: back again it must be the old one.
        let new = match entity {
            Entity::Axis(level, _) => Entity::Axis(level, name.to_ascii_uppercase().into()),
            Entity::Label(level, _) => Entity::Label(level, name.as_str().into()),
            _ => Entity::Alias(name.as_str().into()),
        };
        let place = named(&fixture).position(|(_, occurrence)| occurrence.entity == new).expect("it has the new name");
        prop_assert!(rename_nth(&mut fixture, place, &old).is_some());
        let after = image(&texts(&fixture));
        prop_assert_eq!(before, after);
    }
}
