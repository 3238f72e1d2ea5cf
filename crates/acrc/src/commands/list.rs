//! `acrc list`: prints the programs of an image as the controller lists them.

use acrc_image::list::{ListOptions, list, list_annotated};
use acrc_image::{Image, UnitName};
use anyhow::{Context as _, bail};

use crate::cli::ListArguments;
use crate::exit::Exit;
use crate::output::print;

pub(super) fn run(arguments: &ListArguments) -> anyhow::Result<Exit> {
    let path = arguments.image.display();
    let bytes = std::fs::read(&arguments.image).with_context(|| format!("cannot read {path}"))?;
    let image = Image::from_bytes(&bytes).with_context(|| format!("{path} is no image that can be listed"))?;
    let damaged = || format!("{path} is damaged");
    match (image.password().with_context(damaged)?, &arguments.password) {
        (Some(_), None) => bail!("{path} is protected by PASSWORD: its programs are listed with --password only"),
        (Some(password), Some(given)) if password != *given => bail!("{path} is protected by another password"),
        _ => {}
    }
    let wanted = |name: &UnitName| arguments.programs.is_empty() || arguments.programs.contains(name);
    let units: Vec<_> = image.programs.iter().filter(|unit| wanted(&unit.name)).collect();
    if let Some(missing) = arguments.programs.iter().find(|name| !units.iter().any(|unit| unit.name == **name)) {
        bail!("{path} holds no {missing}");
    }
    let options = ListOptions { line_numbers: arguments.line_numbers };
    let write = if arguments.annotate { list_annotated } else { list };
    let listings = units.iter().map(|unit| Ok((unit, write(unit, &image.aliases, &options)?)));
    let listings = listings.collect::<anyhow::Result<Vec<_>>>().with_context(damaged)?;
    print(|out| {
        for (place, (unit, text)) in listings.iter().enumerate() {
            let gap = if place == 0 { "" } else { "\n" };
            let replaced = listings.iter().skip(place + 1).any(|(later, _)| later.name == unit.name);
            let fate = if replaced { ", replaced by a text below" } else { "" };
            write!(out, "{gap}' {} - {} bytes{fate}\n{text}", unit.name, unit.memory())?;
        }
        Ok(())
    })?;
    Ok(Exit::Clean)
}
