//! The account of memory: the guide's own numbers, bounds and exact bytes of texts, and reports computed by hand.

use std::fs;
use std::path::{Path, PathBuf};

use acrc_analysis::memory::{Calls, Report, SectionBytes, SystemBlock, project_memory, report, text_bytes};
use acrc_analysis::project::{Config, LoadedFile, LoadedProject};
use acrc_analysis::{Database, FileRole, SourceFile};
use acrc_catalog::{CommandId, command};
use acrc_compile::{Scope, encode_statement};
use acrc_image::TextCost;
use acrc_syntax::SourceText;
use acrc_syntax::units::Level;
use proptest::prelude::*;
use serde::Deserialize;

/// A project of files, each a name and a text.
fn loaded(files: &[(&str, &str)]) -> LoadedProject {
    let file = |(name, text): &(&str, &str)| LoadedFile {
        path: (*name).into(),
        role: FileRole::of(name),
        source: SourceText::decode(text.as_bytes()).expect("a text"),
    };
    LoadedProject {
        name: "machine".to_owned(),
        model: acrc_catalog::default_model(),
        root: camino::Utf8PathBuf::new(),
        config: Config::default(),
        files: files.iter().map(file).collect(),
    }
}

fn report_of(files: &[(&str, &str)]) -> Report {
    let loaded = loaded(files);
    let image = loaded.compile().unwrap_or_else(|errors| panic!("{errors:?}"));
    let db = Database::new();
    let project = loaded.add_to(&db);
    report(&db, project, &image).expect("a compiled image can be read")
}

/// Every name is known, as where a fragment is taken from.
struct AnyNames;

impl Scope for AnyNames {
    fn alias(&self, _name: &str) -> Option<u16> {
        Some(0)
    }

    fn label(&self, _name: &str) -> Option<u16> {
        Some(0)
    }
}

/// What each statement of a text costs.
fn costs(text: &str) -> Vec<(CommandId, TextCost)> {
    let tree = acrc_syntax::parse(text);
    let of = |statement| {
        let (command, items) = encode_statement(text, statement, &AnyNames).ok()?;
        Some((command, TextCost::of(command, &items)))
    };
    tree.statements().iter().filter_map(of).collect()
}

fn total(text: &str) -> u64 {
    costs(text).iter().map(|(_, cost)| cost.total()).sum()
}

/// The bytes that a `DIM` takes, of the system or of program 0.
fn dim_bytes(statement: &str) -> u64 {
    let (name, _) = statement.split_once('(').expect("a size");
    if ["DIM P", "DIM DEF"].contains(&name) {
        return report_of(&[("test.8K", &format!("SYS\nCLEAR\n{statement}\n"))]).used();
    }
    // An element needs its reference, which costs a word beside a word for each.
    let class = name.trim_start_matches("DIM ").trim_end_matches(|c: char| c.is_ascii_digit());
    let is_element = name.ends_with(|c: char| c.is_ascii_digit());
    let reference = if is_element { format!("DIM {class}(1)\n") } else { String::new() };
    let report = report_of(&[("test.8K", &format!("PROG0\n{reference}{statement}\nPROGRAM\nENDP\n"))]);
    let all = report.programs[0].variable_bytes();
    if is_element { all - (4 + 4) } else { all }
}

#[derive(Deserialize)]
struct Description {
    #[serde(default)]
    memory: Vec<Fact>,
}

#[derive(Deserialize)]
struct Fact {
    what: String,
    bytes: u64,
}

fn guide() -> Option<PathBuf> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
    let folder = std::env::var_os("ACRC_CORPUS").map_or(beside, PathBuf::from).join("guide");
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!("the listings of the guide are not there ({}): nothing is checked", folder.display());
    None
}

/// What the analysis makes of a fact of the corpus.
fn measured(what: &str, listing: &str) -> Option<u64> {
    let strings = || costs(listing).into_iter().map(|(_, cost)| cost.strings).filter(|bytes| *bytes > 0);
    let words: Vec<&str> = what.split([' ', ',']).collect();
    Some(match words.as_slice() {
        ["DIM", ..] => {
            let statement = what.split(", as").next()?.replace("(LV1) with LV1 = 3", "(3)");
            dim_bytes(&statement)
        }
        ["the", "sixteen", "DIM", "PROG", "lines"] => {
            let report = report_of(&[("test.8K", listing)]);
            let programs = report.system.iter().filter(|line| matches!(line.block, SystemBlock::Program(_)));
            programs.filter_map(|line| line.bytes).sum()
        }
        ["one", "GOSUB", "level", ..] => {
            let db = Database::new();
            let whole = listing.contains("PROGRAM\n");
            let text = if whole { format!("PROG0\n{listing}") } else { format!("PROG0\nPROGRAM\n{listing}ENDP\n") };
            let file = SourceFile::new(&db, "test.8K".to_owned(), text, FileRole::Any, Vec::new());
            text_bytes(&db, file).iter().map(|section| section.calls.bytes()).max()?
        }
        ["all", _, "string", "constants", ..] => strings().sum(),
        ["string", "constant", "of", "the", "PRINT"] => strings().next()?,
        ["string", "constant", text @ ..] => total(&format!("PRINT \"{}\"", text.join(" "))) - 4,
        ["the", "apostrophe", "line"] => total(listing.lines().find(|line| line.starts_with('\''))?),
        ["the", "six", "SET", ..] => {
            let wanted = [command::SET, command::CLR, command::DWL];
            let own = costs(listing).into_iter().filter(|(command, _)| wanted.contains(command));
            own.map(|(_, cost)| cost.total()).sum()
        }
        _ => total(&what.split(" (").next()?.replace(',', " ")),
    })
}

#[test]
fn every_memory_fact_of_the_guide() {
    let Some(folder) = guide() else { return };
    let mut checked = 0;
    for entry in fs::read_dir(&folder).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let text = fs::read_to_string(&path).expect("a description");
        let description: Description = toml::from_str(&text).expect("a description");
        let listing = fs::read_to_string(path.with_extension("8K")).unwrap_or_default();
        for Fact { what, bytes } in description.memory {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            assert_eq!(measured(&what, &listing), Some(bytes), "{name}: {what}");
            checked += 1;
        }
    }
    assert!(checked >= 50, "only {checked} facts");
}

/// The exact bytes of the stored texts of one file, beside the compiled image and the bound.
fn assert_counts(text: &str) -> Result<bool, TestCaseError> {
    let project = loaded(&[("test.8K", text)]);
    let Ok(image) = project.compile() else { return Ok(false) };
    let db = Database::new();
    let input = project.add_to(&db);
    let sections = text_bytes(&db, input.files(&db)[0]);
    let counted: Vec<u64> = sections.iter().filter(|s| !s.statements.is_empty()).map(SectionBytes::total).collect();
    let stored: Vec<u64> =
        image.programs.iter().map(|unit| u64::from(unit.memory())).filter(|bytes| *bytes > 0).collect();
    prop_assert_eq!(counted, stored, "{}", text);
    Ok(true)
}

/// A statement that programs have, in one of its spellings.
fn statement() -> impl Strategy<Value = String> {
    let number = prop_oneof![
        (0..40_000_u64).prop_map(|n| n.to_string()),
        Just("4294967295".to_owned()),
        Just("0.25".to_owned()),
        Just("3.14159265358979".to_owned()),
        Just("-17".to_owned()),
    ];
    let term = prop_oneof![
        number.clone(),
        (0..100_u8).prop_map(|n| format!("P{n}")),
        (0..9_u8).prop_map(|n| format!("LA0({n})")),
        Just("SQRT(P1)".to_owned()),
        Just("BIT 24".to_owned()),
    ];
    let value = (term.clone(), "[+*/-]| MOD | AND ", term.clone()).prop_map(|(a, op, b)| format!("({a}{op}{b})"));
    prop_oneof![
        value.clone().prop_map(|value| format!("P5 = {value}")),
        term.clone().prop_map(|term| format!("LV(LV0) = {term}")),
        number.clone().prop_map(|n| format!("X{n} Y/{n}")),
        (term.clone(), value.clone()).prop_map(|(a, b)| format!("MOV X({b}) Y(P1) Z1 A2 B3 C{}", a.len())),
        "[ -!#-~]{0,30}".prop_map(|text| format!("PRINT \"{text}\"; LV0, $V0;")),
        "[a-z ]{0,30}".prop_map(|text| format!("REM {text}")),
        (0..9000_u32).prop_map(|n| format!("SET {n} : CLR BIT{n}")),
        value.prop_map(|value| format!("IF {value} THEN DWL 0.5 : SINE X(1,2,3,4)")),
        "[A-Z][a-z]{0,23}".prop_map(|name| format!("_{name}")),
        (1..9_u32).prop_map(|n| format!("GOSUB {n}0")),
        Just("DIM $V(10, 80)".to_owned()),
        Just("ACC10 DEC10 STP 5 VEL(P7)".to_owned()),
        Just("ADC 1 2 3 4 5 6.5 7 8 9 10 11 12 13 14 15 16 17".to_owned()),
        Just("?P1".to_owned()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bytes_of_a_text_are_those_of_its_image(lines in proptest::collection::vec(statement(), 0..30), numbered in any::<bool>()) {
        let number = |place: usize| if numbered { format!("{}0 ", place + 1) } else { String::new() };
        let lines: Vec<_> = lines.iter().enumerate().map(|(place, line)| number(place) + line).collect();
        let text = format!("PROG0\nPROGRAM\n{}\nENDP\n", lines.join("\n"));
        // A label may be there twice by chance.
        prop_assume!(assert_counts(&text)?);
    }

    #[test]
    fn a_program_that_fits_exactly_is_accepted_and_a_byte_less_is_not(lines in proptest::collection::vec(statement(), 1..30)) {
        let program = format!("PROGRAM\n{}\nENDP\n", lines.join("\n"));
        let needed = loaded(&[("Prog0.8K", &program)]).compile().ok().map(|image| image.programs[0].memory());
        prop_assume!(needed.is_some());
        let needed = needed.unwrap_or_default();
        let issues = |size: u32| {
            let db = Database::new();
            let setup = format!("SYS\nCLEAR\nDIM PROG0({size})\n");
            let project = loaded(&[("Setup.8K", &setup), ("Prog0.8K", &program)]).add_to(&db);
            let memory = project_memory(&db, project);
            memory.issues.iter().filter(|(_, issue)| matches!(
                issue.kind,
                acrc_analysis::memory::IssueKind::TooLarge { certain: true, variables: 0, .. }
            )).count()
        };
        prop_assert_eq!(issues(needed), 0, "{}", program);
        prop_assert_eq!(issues(needed - 1), 2, "at the DIM and at the statement: {}", program);
    }
}

#[test]
fn listings_of_the_guide_are_counted_as_they_are_stored() {
    let Some(folder) = guide() else { return };
    for entry in fs::read_dir(&folder).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        if path.extension().is_some_and(|extension| extension == "8K") {
            let bytes = fs::read(&path).expect("a listing");
            let text = SourceText::decode(&bytes).expect("a text").text;
            assert_counts(&format!("PROG0\n{text}")).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        }
    }
}

/// A setup and two programs whose bytes are counted by hand.
const SETUP: &str =
    "SYS\nCLEAR\nDIM PROG0(200)\nDIM PROG1(100)\nDIM P(10)\nDIM DEF(2)\n#DEFINE Lamp BIT33\nPROG1\nDIM LV(2)\n";
const FIRST: &str = "PROGRAM\nCLEAR\nDIM $V(2,10)\nDIM DA(1)\nDIM DA0(3)\nGOSUB Blink\nEND\n_Blink\nSET Lamp\nGOSUB Wait\nCLR Lamp\nRETURN\n_Wait\nDWL 0.5\nRETURN\nENDP\n";
const SECOND: &str = "PROGRAM\nREM counts\nP5 = P5 + 1\nLV1 = 2\nENDP\n";

#[test]
fn a_report_that_is_counted_by_hand() {
    let report = report_of(&[("Setup.8K", SETUP), ("Prog0.8K", FIRST), ("Prog1.8K", SECOND)]);
    // 200 + 100 + 10 * 8 + 2 * 48 + 16
    assert_eq!(report.used(), 492);
    assert_eq!((report.total, report.free()), (1_048_576, 1_048_084));
    assert_eq!((report.aliases, report.parameters.count, report.parameters.computed), (1, 6, false));

    let first = &report.programs[0];
    assert_eq!(first.level, Level::Program(0));
    // CLEAR, 3 DIM, 2 GOSUB, END, SET, CLR, 2 RETURN, DWL
    assert_eq!(first.text.commands, 12 * 4);
    // the labels behind 2 GOSUB, the alias of SET and CLR
    assert_eq!(first.text.operators, 4 * 4);
    // 2 and 10; 1; array 0 and 3; 0.5
    assert_eq!(first.text.constants, 6 * 4);
    // _Blink and _Wait: a command and a string of 5 and 4 characters
    assert_eq!(first.text.labels, (8 + 5) + (8 + 4));
    assert_eq!((first.text.strings, first.text.remarks), (0, 0));
    // $V: 2 * (4 + 10); DA: 4 + 4; DA0: 3 * 8 + 4
    assert_eq!(first.variable_bytes(), 28 + 8 + 28);
    assert_eq!(first.calls, Calls::Depth(2));
    assert_eq!(first.needed(), 48 + 16 + 24 + 25 + 64 + 8);
    assert_eq!(first.excess(), 0);
    // beginning: CLEAR 4, DIM $V 12, DIM DA 8, DIM DA0 12, GOSUB 8, END 4
    let parts: Vec<_> = first.parts.iter().map(|part| (part.label.as_deref(), part.bytes)).collect();
    assert_eq!(parts, [(None, 48), (Some("Blink"), 13 + 8 + 8 + 8 + 4), (Some("Wait"), 12 + 8 + 4)]);

    let second = &report.programs[1];
    // REM: 4 + 4 + 7 characters with the blank behind the word
    assert_eq!(second.text.remarks, 8 + 7);
    // P5 = P5 + 1: command, operand, operator, operand; LV1 = 2: command, operand. Each operand has its number.
    assert_eq!((second.text.commands, second.text.operators, second.text.constants), (8, 16, 5 * 4));
    assert_eq!(second.variable_bytes(), 2 * 4, "from the prompt");
    assert_eq!(second.needed(), 15 + 8 + 16 + 20 + 8);
    let exact: Vec<_> = report.exact().iter().map(|exact| (exact.block.to_string(), exact.count)).collect();
    let expected = [("PROG0", 185), ("PROG1", 67), ("P", 6), ("DEF", 1)].map(|(name, count)| (name.to_owned(), count));
    assert_eq!(exact, expected);
    assert!(!report.is_over());
}

#[test]
fn sizes_that_are_computed_are_not_guessed() {
    let text = "SYS\nCLEAR\nDIM PROG0(500)\nPROG0\nPROGRAM\nCLEAR\nDIM LV(2)\nDIM DA(1)\nDIM DA0(LV1)\nENDP\n";
    let report = report_of(&[("test.8K", text)]);
    let program = &report.programs[0];
    assert!(program.is_open());
    assert_eq!(program.variable_bytes(), 8 + 8);
    assert!(report.exact()[0].open.is_some());
}

#[test]
fn a_text_that_is_entered_again_replaces_the_one_before() {
    let text = "PROG0\nPROGRAM\nSET 1\nSET 2\nENDP\nPROGRAM\nSET 3\nENDP\n5 SET 4\n";
    let report = report_of(&[("test.8K", text)]);
    // SET 3, and 5 SET 4 with its line number
    assert_eq!(report.programs[0].text.total(), 8 + 8 + 8);
    let erased = report_of(&[("test.8K", &format!("{text}NEW ALL\n"))]);
    assert_eq!(erased.programs.len(), 0);
}

#[test]
fn what_the_controller_refuses_is_listed() {
    let text = "SYS\nDIM PROG0(10)\nDIM P(2)\nDIM PROG9(600000)\nDIM DEF(1)\n#DEFINE A BIT1\n#DEFINE B BIT2\n";
    let report = report_of(&[("test.8K", text)]);
    let lines: Vec<u32> = report.refused.iter().map(|(_, line, _)| *line).collect();
    assert_eq!(lines, [2, 4, 7]);
    assert!(report.is_over());
}

#[test]
fn a_project_of_no_memory_statement_has_factory_settings() {
    let report = report_of(&[("test.8K", "PROG9\nPROGRAM\nSET 1\nENDP\n")]);
    assert_eq!(report.system.len(), 8);
    assert_eq!(report.used(), 524_288);
    assert_eq!(report.programs[0].excess(), 8, "program 9 has no memory");
}
