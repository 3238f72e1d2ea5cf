//! The grammars for editors, in `grammar/`.

mod emacs;
mod textmate;
mod tree_sitter;
mod words;

use std::path::Path;

use anyhow::Context as _;

use crate::pages::Page;

/// What is made from the catalogue alone: the `TextMate` grammar, and what `grammar.js`, its scanner
/// and `acrobasic-mode` of Emacs read.
pub(crate) fn pages() -> Vec<Page> {
    vec![
        Page { path: "grammar/acrobasic.tmLanguage.json", text: textmate::json() },
        Page { path: "editors/emacs/acrobasic-words.el", text: emacs::lisp() },
        Page { path: "grammar/tree-sitter-acrobasic/words.json", text: words::json() },
        Page { path: "grammar/tree-sitter-acrobasic/src/words.h", text: words::header() },
    ]
}

/// Makes the tree-sitter parser from `grammar.js` and the words beside it.
pub(crate) fn generate_parser(root: &Path) -> anyhow::Result<()> {
    tree_sitter::generate(root, &root.join(tree_sitter::FOLDER).join("src"))
}

/// The files of the tree-sitter parser that are not what would be generated.
pub(crate) fn stale_parser(root: &Path) -> anyhow::Result<Vec<String>> {
    let fresh = tempfile::tempdir().context("cannot create a folder for the parser")?;
    tree_sitter::generate(root, fresh.path())?;
    let source = root.join(tree_sitter::FOLDER).join("src");
    let stale = tree_sitter::FILES.into_iter().filter(|file| {
        let [old, new] = [source.join(file), fresh.path().join(file)].map(|path| std::fs::read(path).ok());
        old != new
    });
    Ok(stale.map(|file| format!("{}/src/{file}", tree_sitter::FOLDER)).collect())
}
