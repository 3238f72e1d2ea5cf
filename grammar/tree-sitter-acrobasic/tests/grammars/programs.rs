//! The programs that the grammars are tested with, and what the compiler says about their tokens.

use std::path::{Path, PathBuf};

use acrc_catalog::{ObjectKind, Shape};
use acrc_syntax::SourceText;
use tree_sitter::{Node, Parser, Tree};

/// A text and where it comes from.
pub(crate) struct Program {
    pub(crate) name: String,
    pub(crate) text: String,
}

/// What may stand behind a command.
const ARGUMENTS: [&str; 14] = [
    "",
    " 5",
    "5",
    " -2.5 : X5",
    " (P0 + 1)",
    " (24, 0)",
    " P0 P1=5",
    " Speed",
    " Speed = 5",
    " X5 Y/3Z(1,-1)",
    " X Y VEL 5",
    " -BIT 32",
    " ENC0 : P0 = 1",
    " AXIS1",
];

/// The examples, the programs of the tests, every command of the catalogue, and the corpus where it is.
pub(crate) fn programs() -> Vec<Program> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = Vec::new();
    for folder in ["examples", "tests/programs", "grammar/tree-sitter-acrobasic/tests"] {
        collect(&root.join(folder), &mut files);
    }
    assert!(files.len() > 20, "the programs of the project are there");
    let mut programs = vec![catalogue()];
    if let Some(corpus) = corpus() {
        collect(&corpus.join("guide"), &mut files);
        programs.extend(transcripts(&corpus.join("terminal")));
        assert!(programs.len() > 5 && files.len() > 100, "the corpus is complete");
    }
    programs.extend(files.iter().map(|path| Program { name: path.display().to_string(), text: read(path) }));
    programs
}

/// Every command of the catalogue with whatever the compiler takes behind it, one a line.
fn catalogue() -> Program {
    let lines = commands().flat_map(|name| ARGUMENTS.map(|arguments| format!("{name}{arguments}\n")));
    Program { name: "the catalogue".to_owned(), text: lines.filter(|line| is_read(line)).collect() }
}

/// The same behind each object, as its prefix or as a statement before it.
pub(crate) fn behind_objects() -> Program {
    // These may stand alone, and the grammar does not know which of the daughters are theirs.
    let is_prefix = |kind: &&ObjectKind| !matches!(kind, ObjectKind::Fstat | ObjectKind::Samp);
    let lines = ObjectKind::ALL.iter().filter(is_prefix).flat_map(|kind| {
        // `CMT1 ENC RES` could be two things.
        let is_clear = move |name: &&str| *kind != ObjectKind::Cmt || !["ENC", "DAC"].contains(&first_word(name));
        let line = move |name| ["", " 5", " X5"].map(|arguments| format!("{}1 {name}{arguments}\n", kind.name()));
        commands().filter(is_clear).flat_map(line)
    });
    Program { name: "the catalogue behind objects".to_owned(), text: lines.filter(|line| is_read(line)).collect() }
}

/// Not the forms without a word of their own, and not what is no statement alone.
fn commands() -> impl Iterator<Item = &'static str> {
    let rows = acrc_catalog::all_commands().filter(|row| {
        let is_object = ["CMT ENC", "CMT DAC"].contains(&row.name);
        !is_object && !matches!(row.shape, Shape::Assignment | Shape::Target)
    });
    rows.map(|row| row.name).filter(|name| name.starts_with(|first: char| first.is_ascii_uppercase()))
}

fn first_word<'n>(name: &&'n str) -> &'n str {
    name.split(' ').next().unwrap_or_default()
}

fn is_read(line: &str) -> bool {
    acrc_syntax::parse(line).errors().is_empty()
}

fn corpus() -> Option<PathBuf> {
    let root = std::env::var_os("ACRC_CORPUS")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus"), PathBuf::from);
    if root.is_dir() {
        return Some(root);
    }
    eprintln!("no corpus at {}", root.display());
    None
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry of a folder").path()).collect();
    paths.sort();
    paths
}

fn collect(folder: &Path, into: &mut Vec<PathBuf>) {
    for path in entries(folder) {
        if path.is_dir() {
            collect(&path, into);
        } else if path.extension().is_some_and(|extension| extension == "8K") {
            into.push(path);
        }
    }
}

fn read(path: &Path) -> String {
    SourceText::decode(&std::fs::read(path).expect("a file of a program")).expect("a program is text").text
}

/// What was typed at a terminal, as one text a transcript.
fn transcripts(folder: &Path) -> impl Iterator<Item = Program> {
    entries(folder).into_iter().map(|path| {
        let transcript = read(&path);
        // `<` is a key that was pressed.
        let typed = transcript.lines().filter_map(|line| line.strip_prefix("> ")).filter(|line| !line.starts_with('<'));
        Program { name: path.display().to_string(), text: typed.collect::<Vec<_>>().join("\n") }
    })
}

/// The tree that the grammar gives.
pub(crate) fn parse(text: &str) -> Tree {
    let mut parser = Parser::new();
    parser.set_language(&tree_sitter_acrobasic::LANGUAGE.into()).expect("a grammar of a version that is known");
    parser.parse(text, None).expect("a language is set")
}

/// Reports a node and all below it.
pub(crate) fn visit(node: Node, report: &mut impl FnMut(Node)) {
    report(node);
    for child in (0..node.child_count()).filter_map(|index| node.child(index)) {
        visit(child, report);
    }
}
