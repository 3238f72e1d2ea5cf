//! `acrc build`: compiles a project into an image.

use anyhow::bail;

use super::project::{check, compile, errors_of, inputs, load, show_errors, title};
use crate::cli::{BuildArguments, ColorChoice};
use crate::exit::Exit;
use crate::output::{Terminal, print, refuse_clashes, write_file};

/// What errors leave undone.
const NOT_BUILT: &str = "is not built";

pub(super) fn run(arguments: &BuildArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let project = load(&arguments.project)?;
    refuse_clashes(&[&arguments.output], &inputs(&project))?;
    let terminal = Terminal::error(color);
    let Some(mut image) = compile(&project, NOT_BUILT, terminal) else { return Ok(Exit::Findings) };
    // An image is for a controller: what is known to fail there is not put into one.
    let errors = errors_of(check(&project));
    if !errors.iter().all(Vec::is_empty) {
        show_errors(&project, &errors, NOT_BUILT, terminal);
        return Ok(Exit::Findings);
    }
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
