//! The trees of `test/corpus`, in the format of `tree-sitter test`. `UPDATE_TREES=1` writes what the grammar gives.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use crate::programs::parse;

const RULE: &str = "==================";

struct Case {
    name: String,
    text: String,
    tree: String,
}

fn cases(text: &str) -> Vec<Case> {
    let mut parts = text.split(RULE).map(str::trim).skip(1);
    let mut cases = Vec::new();
    while let (Some(name), Some(body)) = (parts.next(), parts.next()) {
        let (text, tree) = body.split_once("\n---").unwrap_or((body, ""));
        cases.push(Case { name: name.to_owned(), text: text.trim().to_owned(), tree: tree.trim().to_owned() });
    }
    cases
}

/// A tree on one line, as one with a line for each node.
fn pretty(tree: &str) -> String {
    let mut out = String::new();
    let mut depth = 0_usize;
    for (index, part) in tree.split_inclusive([' ', ')']).enumerate() {
        let starts_node = part.starts_with('(') || part.trim_end().ends_with(':');
        let behind_field = out.ends_with(": ");
        if starts_node && index > 0 && !behind_field {
            let _ = write!(out, "\n{:1$}", "", 2 * depth);
        }
        depth += usize::from(part.starts_with('('));
        depth -= usize::from(part.ends_with(')'));
        out.push_str(if part.trim_end().ends_with(':') { part } else { part.trim() });
    }
    out
}

fn folded(tree: &str) -> String {
    tree.split_whitespace().collect::<Vec<_>>().join(" ").replace(" )", ")")
}

fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("test/corpus");
    let entries = std::fs::read_dir(folder).expect("the trees are there");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry of a folder").path()).collect();
    files.sort();
    files
}

#[test]
fn trees_are_as_written() {
    for path in files() {
        let mut updated = String::new();
        let cases = cases(&std::fs::read_to_string(&path).expect("a file of trees"));
        assert!(!cases.is_empty(), "{} has trees", path.display());
        for Case { name, text, tree } in cases {
            let found = parse(&text).root_node().to_sexp();
            let _ = write!(updated, "{RULE}\n{name}\n{RULE}\n\n{text}\n\n---\n\n{}\n\n", pretty(&found));
            if std::env::var_os("UPDATE_TREES").is_none() {
                assert_eq!(folded(&found), folded(&tree), "{}: {name}", path.display());
            }
        }
        if std::env::var_os("UPDATE_TREES").is_some() {
            std::fs::write(&path, updated.trim_end().to_owned() + "\n").expect("the file can be written");
        }
    }
}
