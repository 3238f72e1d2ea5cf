//! `acrc list`: prints the programs of an image as the controller lists them.

use acrc_image::list::{ListOptions, list};
use acrc_image::{Image, UnitName};
use anyhow::{Context as _, bail};

use crate::cli::ListArguments;
use crate::exit::Exit;
use crate::output::print;

pub(super) fn run(arguments: &ListArguments) -> anyhow::Result<Exit> {
    let path = arguments.image.display();
    let bytes = std::fs::read(&arguments.image).with_context(|| format!("cannot read {path}"))?;
    let image = Image::from_bytes(&bytes).with_context(|| format!("{path} is no image that can be listed"))?;
    let wanted = |name: UnitName| match name {
        UnitName::Program(number) => arguments.programs.is_empty() || arguments.programs.contains(&number),
        UnitName::Boot | UnitName::Plc(_) => arguments.programs.is_empty(),
    };
    let units: Vec<_> = image.programs.iter().filter(|unit| wanted(unit.name)).collect();
    if let Some(missing) =
        arguments.programs.iter().find(|number| !units.iter().any(|unit| unit.name == UnitName::Program(**number)))
    {
        bail!("{path} holds no program {missing}");
    }
    let options = ListOptions { line_numbers: arguments.line_numbers };
    let listings = units.iter().map(|unit| Ok((unit, list(unit, &image.aliases, &options)?)));
    let listings = listings.collect::<anyhow::Result<Vec<_>>>().with_context(|| format!("{path} is damaged"))?;
    print(|out| {
        for (index, (unit, text)) in listings.iter().enumerate() {
            let gap = if index == 0 { "" } else { "\n" };
            write!(out, "{gap}' {} - {} bytes\n{text}", unit.name, unit.memory())?;
        }
        Ok(())
    })?;
    Ok(Exit::Clean)
}
