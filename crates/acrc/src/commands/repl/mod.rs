//! `acrc repl`: the terminal of a virtual controller.
//!
//! With a terminal, lines are edited here and sent when they are complete, and the channel neither echoes nor prompts. With a pipe the bytes go to
//! the channel and come back as they are.

mod complete;
mod editor;
mod pipe;
mod session;
mod watch;

use std::io::IsTerminal as _;
use std::sync::Arc;

use acrc_catalog::Model;
use acrc_controller::{AngleUnit, Controller, Options};
use acrc_image::{Image, UnitBuilder, UnitName, VERSION};
use anyhow::Context as _;

use self::session::Session;
use super::project::{compile, load, title};
use super::sim::{angles, load_world, read_world};
use crate::cli::{ColorChoice, ReplArguments, Speed};
use crate::exit::Exit;
use crate::output::Terminal;

pub(super) fn run(arguments: &ReplArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let Some((name, image, options)) = prepare(arguments, color)? else { return Ok(Exit::Findings) };
    let image = Arc::new(image);
    let mut controller = Controller::new(Arc::clone(&image), options).context("the compiled program does not load")?;
    controller.start_after_setup(&Controller::boot_programs(&image));
    let first = || controller.model().streams.first().and_then(|name| name.parse().ok());
    let stream = arguments.stream.or_else(first).context("this model has no communication stream")?;
    let channel = controller.open_channel(stream)?;

    let interactive = std::io::stdin().is_terminal();
    let speed = arguments.speed.unwrap_or(if interactive { Speed::Factor(1.0) } else { Speed::Max });
    let mut session = Session::new(controller, (channel, stream), speed, Terminal::error(color));
    session.power_up();
    if interactive {
        editor::run(&mut session, &name, Terminal::output(color))?;
    } else {
        pipe::run(&mut session, arguments.linger)?;
    }
    Ok(Exit::Clean)
}

/// What the controller is called, what it has, and how it runs: of the project, or factory settings. `None` when the project does not
/// compile.
fn prepare(arguments: &ReplArguments, color: ColorChoice) -> anyhow::Result<Option<(String, Image, Options)>> {
    let options = |world, angles| Options { world, seed: arguments.seed, angles };
    let Some(path) = &arguments.project else {
        let model = arguments.model.unwrap_or_else(acrc_catalog::default_model);
        let world = arguments.world.as_deref().map(read_world).transpose()?.unwrap_or_default();
        let options = options(world, AngleUnit::default());
        return Ok(Some(("factory settings".to_owned(), factory(model)?, options)));
    };
    let mut project = load(path)?;
    project.model = arguments.model.unwrap_or(project.model);
    let world = load_world(arguments.world.as_deref(), &project)?;
    let image = compile(&project, "is not started", Terminal::error(color));
    Ok(image.map(|image| (title(&project).to_owned(), image, options(world, angles(None, Some(&project))))))
}

/// An image without setup code and programs.
fn factory(model: &Model) -> anyhow::Result<Image> {
    let boot = UnitBuilder::new(UnitName::Boot).finish()?;
    let model = model.name.to_owned();
    Ok(Image { model, aliases: Vec::new(), boot, programs: Vec::new(), files: Vec::new(), version: VERSION })
}
