//! `acrc build`: compiles a project into an image.

use anyhow::bail;

use super::project::{compile, load, title};
use crate::cli::{BuildArguments, ColorChoice};
use crate::exit::Exit;
use crate::output::{Terminal, print, write_file};

pub(super) fn run(arguments: &BuildArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let project = load(&arguments.project)?;
    let Some(mut image) = compile(&project, Terminal::error(color))? else { return Ok(Exit::Findings) };
    if image.boot.words.is_empty() && image.programs.is_empty() {
        bail!("{} holds no statement: there is nothing to build", arguments.project.display());
    }
    if arguments.strip {
        image.strip();
    }
    write_file(&arguments.output, &image.to_bytes()?)?;
    print(|out| {
        for unit in &image.programs {
            writeln!(out, "{:<6} {:>7} bytes of program memory", unit.name.to_string(), unit.memory())?;
        }
        writeln!(out, "{} for {}: {}", title(&project), image.model, arguments.output.display())
    })?;
    Ok(Exit::Clean)
}
