//! `acrc build`: compiles a project into an image, with a listing and a map of it.

mod listing;
pub(super) mod loadable;
mod map;

use std::io::{Write, stderr};
use std::path::Path;

use acrc_image::Image;
use anyhow::{Context as _, bail};

use super::project::{check, compile, errors_of, inputs, load, show_errors, title};
use crate::cli::{BuildArguments, ColorChoice};
use crate::exit::Exit;
use crate::output::{OutputFile, Terminal, is_standard_output, print, refuse_clashes, tell};

/// What errors leave undone.
const NOT_BUILT: &str = "is not built";

pub(super) fn run(arguments: &BuildArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let project = load(&arguments.project)?;
    let outputs: Vec<&Path> = [&arguments.output, &arguments.listing, &arguments.map]
        .into_iter()
        .filter_map(|output| output.as_deref())
        .collect();
    refuse_clashes(&outputs, &inputs(&project))?;
    let terminal = Terminal::error(color);
    let Some(mut image) = compile(&project, NOT_BUILT, terminal) else { return Ok(Exit::Findings) };
    // An image is for a controller: what is known to fail there is not put into one.
    let errors = errors_of(check(&project));
    if !errors.iter().all(Vec::is_empty) {
        show_errors(&project, &errors, NOT_BUILT, terminal);
        return Ok(Exit::Findings);
    }
    let problems = loadable::problems(&project, &image)?;
    if !problems.is_empty() {
        let title = title(&project);
        tell(|err| {
            problems.iter().try_for_each(|problem| writeln!(err, "error: {problem}"))?;
            writeln!(err, "{title} {NOT_BUILT}: a controller cannot load it")
        });
        return Ok(Exit::Findings);
    }
    if image.boot.words.is_empty() && image.programs.is_empty() {
        bail!("{} holds no statement: there is nothing to build", arguments.project.display());
    }

    let listing = arguments.listing.as_ref().map(|_| listing::text(&project, &image)).transpose()?;
    let places = arguments.map.as_ref().map(|_| map::Places::of(&image)).transpose()?;
    if arguments.strip {
        image.strip();
    }
    let bytes = image.to_bytes()?;
    let map = match (&arguments.map, &places) {
        (Some(path), Some(places)) => Some(map::write(title(&project), &image, &bytes, places, path)?),
        _ => None,
    };
    write_all(&[
        (arguments.output.as_deref(), Some(&bytes)),
        (arguments.listing.as_deref(), listing.as_deref().map(str::as_bytes)),
        (arguments.map.as_deref(), map.as_deref().map(str::as_bytes)),
    ])?;
    report(arguments, title(&project), &image, outputs.iter().any(|path| is_standard_output(path)))?;
    Ok(Exit::Clean)
}

/// Writes all files, and gives none its name before all of them are complete.
fn write_all(outputs: &[(Option<&Path>, Option<&[u8]>)]) -> anyhow::Result<()> {
    let mut files = Vec::new();
    for &(path, bytes) in outputs {
        let (Some(path), Some(bytes)) = (path, bytes) else { continue };
        let mut file = OutputFile::create(path)?;
        file.write_all(bytes).with_context(|| format!("cannot write {}", path.display()))?;
        files.push(file);
    }
    files.into_iter().try_for_each(OutputFile::finish)
}

/// Says what was built, on standard error when standard output is taken.
fn report(arguments: &BuildArguments, title: &str, image: &Image, taken: bool) -> anyhow::Result<()> {
    let write = |out: &mut dyn Write| {
        for unit in &image.programs {
            writeln!(out, "{:<6} {:>7} bytes of program memory", unit.name.to_string(), unit.memory())?;
        }
        match &arguments.output {
            Some(path) => writeln!(out, "{title} for {}: {}", image.model, path.display()),
            None => writeln!(out, "{title} for {}", image.model),
        }
    };
    if taken { Ok(write(&mut stderr().lock())?) } else { print(write) }
}
