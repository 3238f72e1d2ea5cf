//! Checks the data files and generates the constant tables of the catalogue.

#![allow(
    unreachable_pub,
    dead_code,
    reason = "the vocabularies are shared with the library, which exports and uses all of them"
)]

#[macro_use]
#[path = "src/named.rs"]
mod named;
#[path = "src/address.rs"]
mod address;
#[path = "build/mod.rs"]
mod catalogue;
#[path = "src/hash.rs"]
mod hash;
#[path = "src/vocabulary/mod.rs"]
mod vocabulary;

use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    for watched in ["data", "build", "build.rs", "src/named.rs", "src/address.rs", "src/hash.rs", "src/vocabulary"] {
        println!("cargo::rerun-if-changed={watched}");
    }
    match generate() {
        Ok(()) => ExitCode::SUCCESS,
        Err(errors) => {
            for error in errors {
                println!("cargo::error={error}");
            }
            ExitCode::FAILURE
        }
    }
}

fn generate() -> Result<(), Vec<String>> {
    let catalogue = catalogue::read::read(&PathBuf::from("data"))?;
    let errors = catalogue::check::check(&catalogue);
    if !errors.is_empty() {
        return Err(errors);
    }
    let directory =
        std::env::var_os("OUT_DIR").map(PathBuf::from).ok_or_else(|| vec!["OUT_DIR is not set".to_owned()])?;
    for (name, text) in catalogue::emit::files(&catalogue) {
        std::fs::write(directory.join(name), text).map_err(|error| vec![format!("{name}: {error}")])?;
    }
    Ok(())
}
