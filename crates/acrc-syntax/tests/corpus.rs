//! Every program of the guide is read as the people who wrote it meant it.
//!
//! The programs are not part of this project; the test reads them in place when they are there.

mod support;

use std::fs;
use std::path::{Path, PathBuf};

use acrc_diagnostics::{LineIndex, Severity};
use acrc_syntax::{SourceText, Tree, codes, debug_tree};

/// What the reader must say about the guide's own slips: file, line, code. Everything else in the corpus is clean.
const KNOWN: [(&str, u32, &str); 6] = [
    ("02-", 3, codes::REMARK_ON_LABEL_LINE.id),
    ("18-gosub.raw", 2, codes::SYNTAX_ERROR.id),
    ("55-", 118, codes::DETACHED_LABEL.id),
    ("62-", 1, codes::REMARK_WITHOUT_COLON.id),
    ("63-", 14, codes::SYNTAX_ERROR.id),
    ("65-", 84, codes::DIM_WITHOUT_PARENTHESES.id),
];

fn corpus() -> Option<PathBuf> {
    let root = std::env::var_os("ACRC_CORPUS")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus"), PathBuf::from);
    if root.is_dir() {
        return Some(root);
    }
    eprintln!("skipped: no corpus at {}", root.display());
    None
}

fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the corpus has this folder");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry of a folder").path()).collect();
    files.retain(|path| path.to_string_lossy().ends_with(ending));
    files.sort();
    files
}

fn read(path: &Path) -> (String, Tree) {
    let bytes = fs::read(path).expect("a file of the corpus");
    let source = SourceText::decode(&bytes).expect("the corpus is text");
    assert_eq!(source.encode(), bytes, "{} is written back as it was", path.display());
    let tree = support::checked(&source.text);
    (source.text, tree)
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

#[test]
fn programs_of_the_guide_have_only_their_known_slips() {
    let Some(corpus) = corpus() else { return };
    let files = files(&corpus.join("guide"), ".8K");
    assert!(files.len() > 80, "the corpus is complete");
    let mut found = Vec::new();
    for path in files {
        let (text, tree) = read(&path);
        let lines = LineIndex::new(&text);
        let name = name(&path);
        let is_raw = name.contains(".raw.");
        for error in tree.errors() {
            let line = lines.position(error.span.start).line;
            let known =
                KNOWN.iter().find(|(file, at, code)| name.starts_with(file) && *at == line && *code == error.code.id);
            match known {
                Some(known) => found.push(*known),
                None if is_raw && error.code == codes::TYPOGRAPHIC_CHARACTER => {}
                None => panic!("{name}:{line}: {}", error.message),
            }
        }
    }
    for known in KNOWN {
        assert!(found.contains(&known), "not reported: {known:?}");
    }
}

#[test]
fn typographic_characters_do_not_change_the_program() {
    let Some(corpus) = corpus() else { return };
    for raw in files(&corpus.join("guide"), ".raw.8K") {
        let plain = raw.with_file_name(name(&raw).replace(".raw.", "."));
        let (raw_text, raw_tree) = read(&raw);
        let (plain_text, plain_tree) = read(&plain);
        // One listing has an ellipsis where the other has an empty line.
        let raw_dump = debug_tree(&raw_tree, &raw_text).replace("line 2\n  error \"…\"\n", "");
        let dump = debug_tree(&plain_tree, &plain_text);
        assert_eq!(without_remarks(&raw_dump), without_remarks(&dump), "{}", raw.display());
        let warned = raw_tree.errors().iter().filter(|error| error.code == codes::TYPOGRAPHIC_CHARACTER);
        let is_fixed = warned.clone().all(|error| error.severity == Severity::Warning && error.fixes.len() == 1);
        assert!(is_fixed, "each typographic character has a fix");
    }
}

/// The text of a remark is no part of the program.
fn without_remarks(dump: &str) -> String {
    dump.lines().filter(|line| !line.contains("remark \"")).collect::<Vec<_>>().join("\n")
}

#[test]
fn lines_typed_at_a_terminal_are_read() {
    let Some(corpus) = corpus() else { return };
    for path in files(&corpus.join("terminal"), ".txt") {
        let text = fs::read_to_string(&path).expect("a transcript");
        for line in text.lines().filter_map(|line| line.strip_prefix("> ")) {
            // A key, or a word that the transcript shows being refused.
            if line.starts_with('<') || line == "DMODE" {
                continue;
            }
            let tree = support::checked(line);
            assert!(support::errors(&tree).is_empty(), "{}: {line}: {:?}", path.display(), tree.errors());
        }
    }
}
