//! The parser in C that tree-sitter makes from `grammar.js`.
//!
//! `grammar.js` is JavaScript, as all grammars of tree-sitter: `node` runs it.

use std::path::Path;

use anyhow::Context as _;
use tree_sitter_generate::{OptLevel, generate_parser_in_directory};

/// Where the grammar lies.
pub(super) const FOLDER: &str = "grammar/tree-sitter-acrobasic";
/// The version of the parser's tables: the newest one that Neovim reads from 0.7 to 0.10, and every later one, too.
const PARSER_VERSION: usize = 14;
/// What is generated, in the folder `src` of the grammar.
pub(super) const FILES: [&str; 6] = [
    "grammar.json",
    "node-types.json",
    "parser.c",
    "tree_sitter/alloc.h",
    "tree_sitter/array.h",
    "tree_sitter/parser.h",
];

/// Writes the parser of the grammar in `root` to `out`.
pub(super) fn generate(root: &Path, out: &Path) -> anyhow::Result<()> {
    let mut notes = Vec::new();
    generate_parser_in_directory(
        root.join(FOLDER),
        Some(out),
        None::<&Path>,
        PARSER_VERSION,
        None,
        None,
        true,
        OptLevel::default(),
        &mut notes,
    )
    .context("tree-sitter can't make a parser of grammar.js (is node installed?)")?;
    anyhow::ensure!(notes.is_empty(), "grammar.js: {notes:?}");
    Ok(())
}
