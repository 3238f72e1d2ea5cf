//! A controller for somebody to talk to, as `acrc repl` and `acrc serve` have it: of a project, of a state, or with factory settings.

use std::path::Path;
use std::sync::Arc;

use acrc_catalog::Model;
use acrc_controller::nonvolatile::Saved;
use acrc_controller::{Controller, Options, Sent, StreamName};
use acrc_image::{Image, UnitName};
use anyhow::Context as _;

use super::nonvolatile::State;
use super::project::{compile, load, title};
use super::sim::{angles, backlash, load_world, plc_scan, read_world};
use crate::cli::ColorChoice;
use crate::output::Terminal;

/// What the command line says about it.
pub(super) struct Wanted<'a> {
    pub(super) project: Option<&'a Path>,
    pub(super) model: Option<&'static Model>,
    pub(super) world: Option<&'a Path>,
    pub(super) battery: bool,
    pub(super) seed: u64,
    /// The parameter whose changes are user alarms.
    pub(super) user_alarm: Option<u32>,
    /// The flag Enable Rapid Move Modes of master 0.
    pub(super) rapid_move_modes: Option<u32>,
}

/// Powers a controller up, and says what it is called. Nothing is executed yet. `None` when the project does not compile.
pub(super) fn power_up(
    wanted: &Wanted,
    state: Option<&State>,
    color: ColorChoice,
) -> anyhow::Result<Option<(String, Controller)>> {
    let kept = state.and_then(|state| state.saved.as_ref());
    let Some((name, image, options)) = prepare(wanted, kept, color)? else { return Ok(None) };
    let mut start = Controller::boot_programs(&image);
    let mut controller = Controller::with_memory(Arc::new(image), options, wanted.battery, kept)
        .with_context(|| State::cannot_power_up(state))?;
    start.extend(controller.kept_boot_programs());
    start.sort_unstable();
    start.dedup();
    controller.start_after_setup(&start);
    Ok(Some((name, controller)))
}

/// What the controller is called, what it has, and how it runs.
fn prepare(
    wanted: &Wanted,
    kept: Option<&Saved>,
    color: ColorChoice,
) -> anyhow::Result<Option<(String, Image, Options)>> {
    let options = |world| Options {
        world,
        seed: wanted.seed,
        user_alarm: wanted.user_alarm,
        rapid_move_modes: wanted.rapid_move_modes,
        ..Options::default()
    };
    let Some(path) = wanted.project else {
        let of_state = || kept.map_or(acrc_catalog::default_model().name, |saved| &saved.model);
        let model = wanted.model.map_or_else(of_state, |model| model.name);
        let name = if kept.is_some() { "stored programs" } else { "factory settings" };
        let world = wanted.world.map(read_world).transpose()?.unwrap_or_default();
        let options = options(world);
        return Ok(Some((name.to_owned(), Image::empty(model), options)));
    };
    let mut project = load(path)?;
    project.model = wanted.model.unwrap_or(project.model);
    let world = load_world(wanted.world, &project)?;
    let image = compile(&project, "is not started", Terminal::error(color));
    let options = Options {
        angles: angles(None, Some(&project)),
        plc_scan: plc_scan(&project),
        backlash: backlash(&project),
        ..options(world)
    };
    Ok(image.map(|image| (title(&project).to_owned(), image, options)))
}

/// The programs that are stored, and what they do.
pub(super) fn describe_programs(controller: &Controller) -> String {
    let stored = controller.programs();
    let programs: Vec<String> =
        stored.iter().map(|program| format!("{} {}", program.unit, program.state.name())).collect();
    if programs.is_empty() { "no program is stored".to_owned() } else { programs.join(", ") }
}

/// Text that no channel shows, for the log: setup code has no terminal, and who has which stream is for the caller to say.
pub(super) fn unseen(sent: &Sent, shows: impl Fn(StreamName) -> bool) -> Option<String> {
    let source = match (sent.unit, sent.stream) {
        (_, Some(stream)) if shows(stream) => return None,
        // What a program prints on device 0 is for those who listen to it.
        (UnitName::Program(_), None) => return None,
        (UnitName::Boot, None) => "setup".to_owned(),
        // Setup code, or somebody at a terminal.
        (UnitName::Boot, Some(stream)) => stream.to_string(),
        (unit, None) => unit.to_string(),
        (unit, Some(stream)) => format!("{unit} {stream}"),
    };
    let text = sent.text.trim_end_matches(['\r', '\n']).escape_debug();
    Some(format!("{source}: {text}"))
}
