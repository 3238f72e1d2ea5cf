//! What is generated from the catalogue and the linter's registry, and the check that it is current.
//!
//! `cargo xtask generate` writes the pages and the grammars, `cargo xtask check` fails when one of them is not what it would
//! write. Both need node for the tree-sitter grammar.

mod grammars;
mod pages;

use std::path::Path;
use std::process::ExitCode;

use anyhow::{Context as _, bail};

fn main() -> ExitCode {
    let task = std::env::args().nth(1);
    let result = match task.as_deref() {
        Some("generate") => generate(),
        Some("check") => check(),
        _ => Err(anyhow::anyhow!("usage: cargo xtask generate | check")),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask lies in the workspace")
}

fn generate() -> anyhow::Result<()> {
    for page in pages::all().into_iter().chain(grammars::pages()) {
        let path = root().join(page.path);
        let folder = path.parent().context("a page lies in a folder")?;
        std::fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
        std::fs::write(&path, page.text).with_context(|| format!("cannot write {}", path.display()))?;
        println!("{}", page.path);
    }
    grammars::generate_parser(root())?;
    println!("the tree-sitter parser");
    Ok(())
}

fn check() -> anyhow::Result<()> {
    let mut stale: Vec<String> = pages::all()
        .into_iter()
        .chain(grammars::pages())
        .filter(|page| std::fs::read_to_string(root().join(page.path)).ok().as_deref() != Some(&page.text))
        .map(|page| page.path.to_owned())
        .collect();
    stale.extend(grammars::stale_parser(root())?);
    if !stale.is_empty() {
        bail!("not current: {}; run `cargo xtask generate`", stale.join(", "));
    }
    println!("generated files are current");
    Ok(())
}
