//! The programs that the grammars are tested with, and what the compiler says about their tokens.

use std::path::{Path, PathBuf};

use acrc_syntax::SourceText;
use tree_sitter::{Node, Parser, Tree};

/// A text and where it comes from.
pub(crate) struct Program {
    pub(crate) name: String,
    pub(crate) text: String,
}

/// The examples, the programs of the tests, and the corpus where it is.
pub(crate) fn programs() -> Vec<Program> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = Vec::new();
    for folder in ["examples", "tests/programs", "grammar/tree-sitter-acrobasic/tests"] {
        collect(&root.join(folder), &mut files);
    }
    assert!(files.len() > 20, "the programs of the project are there");
    let mut programs = Vec::new();
    if let Some(corpus) = corpus() {
        collect(&corpus.join("guide"), &mut files);
        programs.extend(transcripts(&corpus.join("terminal")));
        assert!(programs.len() > 5 && files.len() > 100, "the corpus is complete");
    }
    programs.extend(files.iter().map(|path| Program { name: path.display().to_string(), text: read(path) }));
    programs
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
