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

use acrc_controller::nonvolatile::Saved;
use acrc_controller::{Controller, Options};
use acrc_image::Image;
use anyhow::Context as _;

use self::session::Session;
use super::nonvolatile::State;
use super::project::{compile, load, title};
use super::sim::{angles, backlash, load_world, plc_scan, read_world};
use crate::cli::{ColorChoice, ReplArguments, Speed};
use crate::exit::Exit;
use crate::output::Terminal;

pub(super) fn run(arguments: &ReplArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let state = arguments.state.as_deref().map(State::open).transpose()?;
    let kept = state.as_ref().and_then(|state| state.saved.as_ref());
    let Some((name, image, options)) = prepare(arguments, kept, color)? else { return Ok(Exit::Findings) };
    let mut start = Controller::boot_programs(&image);
    let mut controller = Controller::with_memory(Arc::new(image), options, !arguments.no_battery, kept)
        .with_context(|| State::cannot_power_up(state.as_ref()))?;
    start.extend(controller.kept_boot_programs());
    start.sort_unstable();
    start.dedup();
    controller.start_after_setup(&start);
    let first = || controller.model().streams.first().and_then(|name| name.parse().ok());
    let stream = arguments.stream.or_else(first).context("this model has no communication stream")?;
    let channel = controller.open_channel(stream)?;

    let interactive = std::io::stdin().is_terminal();
    let speed = arguments.speed.unwrap_or(if interactive { Speed::Factor(1.0) } else { Speed::Max });
    let mut session = Session::new(controller, (channel, stream), speed, state, Terminal::error(color));
    session.power_up();
    if interactive {
        editor::run(&mut session, &name, Terminal::output(color))?;
    } else {
        pipe::run(&mut session, arguments.linger)?;
    }
    session.power_off()?;
    Ok(Exit::Clean)
}

/// What the controller is called, what it has, and how it runs: of the project, or factory settings. `None` when the project does not
/// compile.
fn prepare(
    arguments: &ReplArguments,
    kept: Option<&Saved>,
    color: ColorChoice,
) -> anyhow::Result<Option<(String, Image, Options)>> {
    let options = |world| Options { world, seed: arguments.seed, ..Options::default() };
    let Some(path) = &arguments.project else {
        let of_state = || kept.map_or(acrc_catalog::default_model().name, |saved| &saved.model);
        let model = arguments.model.map_or_else(of_state, |model| model.name);
        let name = if kept.is_some() { "stored programs" } else { "factory settings" };
        let world = arguments.world.as_deref().map(read_world).transpose()?.unwrap_or_default();
        let options = options(world);
        return Ok(Some((name.to_owned(), Image::empty(model), options)));
    };
    let mut project = load(path)?;
    project.model = arguments.model.unwrap_or(project.model);
    let world = load_world(arguments.world.as_deref(), &project)?;
    let image = compile(&project, "is not started", Terminal::error(color));
    let options = Options {
        angles: angles(None, Some(&project)),
        plc_scan: plc_scan(&project),
        backlash: backlash(&project),
        ..options(world)
    };
    Ok(image.map(|image| (title(&project).to_owned(), image, options)))
}
