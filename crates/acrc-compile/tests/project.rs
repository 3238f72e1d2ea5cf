//! Files and prompts: what becomes the boot unit, what is stored, and where.

mod common;

use acrc_compile::{SourceUnit, compile};
use acrc_image::{Image, Unit, UnitName};
use acrc_syntax::units::Level;
use common::listing;

/// A project of files with a start level; a name that begins with `Prog` and a text without `PROGRAM` is the program itself.
fn project(files: &[(&str, Level, &str)]) -> Image {
    let trees: Vec<_> = files.iter().map(|(_, _, text)| acrc_syntax::parse(text)).collect();
    let units: Vec<_> = files
        .iter()
        .zip(&trees)
        .map(|(&(name, start, text), tree)| SourceUnit {
            name,
            text,
            tree,
            start,
            implicit_program: start != Level::System && !text.contains("PROGRAM"),
        })
        .collect();
    let image = compile(&units, "ACR9000").unwrap_or_else(|errors| panic!("{errors:#?}"));
    image.verify().expect("compiled images are valid");
    image
}

/// The listings of all units.
fn show(image: &Image) -> String {
    let unit = |unit: &Unit| format!("== {} ({} bytes)\n{}", unit.name, unit.memory(), listing(unit, image));
    image.units().map(unit).collect()
}

#[test]
fn setup_and_program_files() {
    let image = project(&[
        (
            "Setup.8K",
            Level::System,
            "DIM PROG0(4096)\nDIM DEF(10)\n#DEFINE Speed P0\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nSYS\nSpeed = 5",
        ),
        ("Prog0.8K", Level::Program(0), "_Start\nVEL (Speed)\nX/10\nGOTO Start"),
        ("PLC0.8K", Level::Plc(0), "PROGRAM\nLD 24\nOUT 32\nENDP\nRUN PLC0"),
    ]);
    insta::assert_snapshot!(show(&image));
    assert_eq!(image.files, ["Setup.8K", "Prog0.8K", "PLC0.8K"]);
    assert_eq!(
        image.programs.iter().map(|unit| unit.name).collect::<Vec<_>>(),
        [UnitName::Program(0), UnitName::Plc(0)]
    );
}

#[test]
fn one_file_with_several_programs() {
    let image = project(&[(
        "all.8K",
        Level::System,
        "CLEAR\nPROG0\nPROGRAM : REM first\nX5 : X6\nENDP : RUN\nPROG 1\nPROGRAM\nEND\nENDP\nPROG0\nPROGRAM\nX7\nENDP",
    )]);
    insta::assert_snapshot!(show(&image));
}

#[test]
fn numbered_lines_take_their_places() {
    let image = project(&[(
        "lines.8K",
        Level::System,
        "PROG0\n20 VEL 20 : X2\n10 VEL 10\n20 VEL 25\n30 VEL 30\nRUN\n30\n15 ACC 5\nLIST\nPROG1\n10 END",
    )]);
    insta::assert_snapshot!(show(&image));
}

#[test]
fn a_numbered_line_goes_between_the_hidden_numbers_of_entered_lines() {
    let image = project(&[(
        "lines.8K",
        Level::System,
        "PROG0\nPROGRAM\nVEL 1\n\n' dropped\nVEL 2\nVEL 3\nENDP\n15 VEL 1.5\n30 VEL 33",
    )]);
    insta::assert_snapshot!(listing(image.programs.last().expect("a stored text"), &image), @r"
    VEL 1
    15 VEL 1.5
    VEL 2
    30 VEL 33
    ");
}

#[test]
fn numbers_between_program_and_endp_order_the_lines_that_have_them() {
    let text = |lines: &str| {
        let image = project(&[("lines.8K", Level::System, &format!("PROG0\nPROGRAM\n{lines}\nENDP\n"))]);
        listing(image.programs.last().expect("a stored text"), &image)
    };
    assert_eq!(text("10 VEL 1\n5 VEL 2\n10 VEL 3"), "5 VEL 2\n10 VEL 3\n");
    // A number that is only there for `GOTO` moves nothing, whatever lines stand above it.
    assert_eq!(text("VEL 1\nVEL 2\n10 VEL 3\nGOTO 10"), "VEL 1\nVEL 2\n10 VEL 3\nGOTO 10\n");
    assert_eq!(text("20 VEL 2\nVEL 3\n30 VEL 4\n25 VEL 5\nVEL 6"), "20 VEL 2\nVEL 3\n25 VEL 5\n30 VEL 4\nVEL 6\n");
}

#[test]
fn statements_lead_back_to_their_lines() {
    let text = "SYS\nPROG0\nPROGRAM\nVEL 5 : X1\n\nEND\nENDP\n";
    let image = project(&[("all.8K", Level::System, text)]);
    let lines = |unit: &Unit| {
        let map = unit.debug.as_ref().expect("compiled units have a map");
        let slice =
            |location: acrc_image::Location| text[location.span.start as usize..location.span.end as usize].to_owned();
        map.entries()
            .iter()
            .map(|entry| (entry.address, entry.location.line, slice(entry.location)))
            .collect::<Vec<_>>()
    };
    let expected = |address, line, text: &str| (address, line, text.to_owned());
    assert_eq!(lines(&image.boot), [expected(0, 1, "SYS"), expected(1, 2, "PROG0"), expected(3, 3, "PROGRAM")]);
    assert_eq!(lines(&image.programs[0]), [expected(0, 4, "VEL 5"), expected(2, 4, "X1"), expected(5, 6, "END")]);
}

#[test]
fn the_same_project_gives_the_same_bytes() {
    let files = [
        ("Setup.8K", Level::System, "#DEFINE B P1\n#DEFINE A P2\nA = B"),
        ("Prog0.8K", Level::Program(0), "B = A\nEND"),
    ];
    let bytes = project(&files).to_bytes().expect("small enough");
    assert_eq!(project(&files).to_bytes().expect("small enough"), bytes);
    assert_eq!(Image::from_bytes(&bytes).expect("written a moment ago"), project(&files));
}

#[test]
fn an_empty_project_is_an_empty_image() {
    let image = project(&[]);
    assert_eq!((image.boot.memory(), image.programs.len(), image.aliases.len()), (0, 0, 0));
}
