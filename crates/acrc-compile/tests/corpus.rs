//! The examples of the guide, where they are at hand: every one compiles, and its listing compiles to the same words.

mod common;

use std::fmt::Write;
use std::path::{Path, PathBuf};

use acrc_catalog::command;
use acrc_compile::{CompileErrorKind, SourceUnit, compile};
use acrc_image::{Image, Node};
use acrc_syntax::units::Level;
use common::{PROGRAM, definitions, listing};

/// The folder of the corpus, if there is one.
fn corpus() -> Option<PathBuf> {
    let default = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
    let folder = std::env::var_os("ACRC_CORPUS").map_or(default, PathBuf::from).join("guide");
    if folder.is_dir() {
        return Some(folder);
    }
    println!("skipped: there is no corpus at {}", folder.display());
    None
}

/// Names and texts of the programs, in the order of names.
fn programs() -> Vec<(String, String)> {
    let Some(folder) = corpus() else { return Vec::new() };
    let mut programs: Vec<(String, String)> = std::fs::read_dir(folder)
        .expect("the folder can be read")
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "8K"))
        .map(|path| {
            let bytes = std::fs::read(&path).expect("the file can be read");
            let text = acrc_syntax::SourceText::decode(&bytes).expect("the file is a text").text;
            (path.file_name().expect("a file has a name").to_string_lossy().into_owned(), text)
        })
        .collect();
    programs.sort();
    programs
}

/// Compiles a text after definitions of the aliases and labels that it only refers to.
fn compile_fragment(text: &str, start: Level) -> Result<Image, Vec<CompileErrorKind>> {
    let mut names = String::new();
    loop {
        let whole = format!("{names}{text}");
        let tree = acrc_syntax::parse(&whole);
        let source = SourceUnit { name: "fragment.8K", text: &whole, tree: &tree, start, implicit_program: false };
        let errors = match compile(&[source], "ACR9000") {
            Ok(image) => return Ok(image),
            Err(errors) => errors,
        };
        let before = names.len();
        for error in &errors {
            match &error.kind {
                CompileErrorKind::UndefinedAlias(name) if !names.contains(&format!(" {name} ")) => {
                    let number = names.len();
                    let _ = writeln!(names, "#DEFINE {name} P{number}");
                }
                CompileErrorKind::UndefinedLabel(name) if !names.contains(&format!("_{name}\n")) => {
                    let _ = writeln!(names, "_{name}");
                }
                _ => {}
            }
        }
        if names.len() == before {
            return Err(errors.into_iter().map(|error| error.kind).collect());
        }
    }
}

/// The statement lists that cannot compile, for the mistakes that the guide itself has in them.
const BROKEN: [&str; 2] = ["18-gosub.raw.8K", "63-inverse-kinematics.8K"];

#[test]
fn examples_compile_and_their_listings_give_the_same_words() {
    for (name, text) in programs() {
        let image = match compile_fragment(&text, PROGRAM) {
            Ok(image) => image,
            Err(errors) if BROKEN.contains(&name.as_str()) => {
                assert!(errors.contains(&CompileErrorKind::Syntax), "{name}: {errors:?}");
                continue;
            }
            Err(errors) => panic!("{name}: {errors:?}"),
        };
        assert!(!BROKEN.contains(&name.as_str()), "{name} compiles");
        image.verify().unwrap_or_else(|error| panic!("{name}: {error}"));
        for unit in &image.programs {
            let listed = format!("{}PROG 0\nPROGRAM\n{}ENDP\n", definitions(&image), listing(unit, &image));
            let again = compile_fragment(&listed, Level::System)
                .unwrap_or_else(|errors| panic!("{name}: {errors:?}\n{listed}"));
            let again = again.programs.last().expect("a stored text");
            assert_eq!((&again.words, &again.strings), (&unit.words, &unit.strings), "{name}\n{listed}");
        }
        if image.programs.is_empty() {
            let listed = listing(&image.boot, &image);
            let again = compile_fragment(&listed, Level::System)
                .unwrap_or_else(|errors| panic!("{name}: {errors:?}\n{listed}"));
            assert_eq!(
                (again.boot.words, again.boot.strings),
                (image.boot.words, image.boot.strings),
                "{name}\n{listed}"
            );
        }
    }
}

#[test]
fn typographic_characters_do_not_change_the_words() {
    let programs = programs();
    for (name, raw) in programs.iter().filter(|(name, _)| name.ends_with(".raw.8K") && !BROKEN.contains(&name.as_str()))
    {
        let plain = name.replace(".raw.8K", ".8K");
        let (_, text) = programs.iter().find(|(other, _)| *other == plain).expect("a main variant");
        let [raw, text] = [raw, text].map(|text| compile_fragment(text, PROGRAM).expect("compiles"));
        for (raw, text) in raw.units().zip(text.units()) {
            assert_eq!((&raw.words, &raw.strings), (&text.words, &text.strings), "{name}");
        }
    }
}

/// What a memory fact of the corpus is about, and the bytes it states.
fn memory_facts(folder: &Path, program: &str) -> Vec<(String, u64)> {
    let description = folder.join(program.replace(".8K", ".toml"));
    let text = std::fs::read_to_string(description).unwrap_or_default();
    let value = |fact: &str, key: &str| {
        let line = fact.lines().find_map(|line| line.strip_prefix(key)?.trim_start().strip_prefix('='));
        line.map(|value| value.trim().trim_matches('"').to_owned())
    };
    let facts = text.split("[[memory]]").skip(1);
    facts.filter_map(|fact| Some((value(fact, "what")?, value(fact, "bytes")?.parse().ok()?))).collect()
}

/// Sizes of the string constants of an image, remarks and labels left out.
fn string_constants(image: &Image) -> Vec<(String, u64)> {
    fn below(node: &Node, found: &mut Vec<(String, u64)>) {
        if let Node::String { bytes, .. } = node {
            found.push((acrc_image::text::decode(bytes), 4 + bytes.len() as u64));
        }
        node.children().into_iter().for_each(|child| below(child, found));
    }
    let mut found = Vec::new();
    for instruction in image.units().flat_map(|unit| unit.decode().expect("compiled units decode")) {
        if ![command::REM, command::LABEL].contains(&instruction.command) {
            instruction.items.iter().for_each(|item| below(&item.node, &mut found));
        }
    }
    found
}

#[test]
fn memory_is_what_the_corpus_says() {
    let (Some(folder), mut checked) = (corpus(), 0) else { return };
    for (name, text) in programs() {
        for (what, bytes) in memory_facts(&folder, &name) {
            let constants = || string_constants(&compile_fragment(&text, PROGRAM).expect("compiles"));
            let words: Vec<&str> = what.split([' ', ',']).collect();
            let found = match words.as_slice() {
                ["all", count, "string", "constants", ..] => {
                    let constants = constants();
                    assert_eq!(constants.len().to_string(), *count, "{name}: {constants:?}");
                    constants.into_iter().map(|(_, bytes)| bytes).sum()
                }
                ["string", "constant", "of", "the", "PRINT"] => constants().first().map_or(0, |&(_, bytes)| bytes),
                ["string", "constant", text @ ..] => constants()
                    .into_iter()
                    .find(|(constant, _)| *constant == text.join(" "))
                    .map_or(0, |(_, bytes)| bytes),
                [command, ..] if ["ACC", "ACC10", "VEL", "SET", "INH"].contains(command) => {
                    let (statements, _) = what.split_once(" (").unwrap_or((&what, ""));
                    let image = compile_fragment(&statements.replace(',', ""), Level::System).expect("compiles");
                    u64::from(image.boot.memory())
                }
                _ => continue,
            };
            assert_eq!(found, bytes, "{name}: {what}");
            checked += 1;
        }
    }
    assert!(checked >= 20, "only {checked} facts were about code");
}
