//! `acrc sim`: runs a project in virtual time.

mod json;
mod observer;
mod page;
mod ports;
mod rate;
mod recorder;
mod signals;
mod summary;
mod thinned;
mod trace_file;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use acrc_analysis::project::{Angles as ConfigAngles, Backlash, LoadedProject};
use acrc_controller::world::World;
use acrc_controller::{AngleUnit, BacklashRule, Controller, Options, Stopped};
use acrc_image::{Image, UnitName};
use acrc_syntax::units::Level;
use anyhow::{Context as _, bail};

use self::observer::RunObserver;
use self::ports::Outputs;
use self::recorder::Recorder;
use super::nonvolatile::State;
use super::project::{check, compile, errors_of, inputs, load, title};
use crate::cli::{Angles, ColorChoice, Register, SimArguments, SimFormat};
use crate::exit::Exit;
use crate::output::{Terminal, refuse_clashes};

/// Virtual time of a run when nothing else is said, in seconds.
const DEFAULT_UNTIL: f64 = 60.0;

/// The names of the axes that the text of a project attaches.
pub(super) fn attached_axes(image: &Image) -> Vec<(String, u8)> {
    signals::attached_axes(image)
}

/// What is to be run.
struct Setup {
    image: Arc<Image>,
    world: World,
    angles: AngleUnit,
    plc_scan: Option<f64>,
    backlash: BacklashRule,
    start: Vec<u8>,
    plcs: Vec<u8>,
    until: f64,
    title: String,
    notes: Vec<String>,
}

pub(super) fn run(arguments: &SimArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let project = if arguments.stored { None } else { Some(load(&arguments.project)?) };
    let sent = arguments.output.iter().map(|output| &output.path);
    let outputs: Vec<&Path> = arguments
        .trace
        .iter()
        .chain(&arguments.plot)
        .chain(&arguments.report)
        .chain(sent)
        .map(PathBuf::as_path)
        .collect();
    let typed = arguments.input.iter().map(|input| input.path.clone());
    let inputs: Vec<PathBuf> = project.iter().flat_map(inputs).chain(arguments.world.clone()).chain(typed).collect();
    refuse_clashes(&outputs, &inputs)?;
    let mut state = arguments.state.as_deref().map(State::open).transpose()?;
    let setup = match &project {
        Some(project) => of_project(arguments, project, color)?,
        None => of_state(arguments, state.as_ref())?,
    };
    let Setup { image, world, angles, plc_scan, backlash, mut start, plcs, until, title, mut notes } = setup;
    let options = Options { world, seed: arguments.seed, angles, plcs, plc_scan, backlash, ..Options::default() };
    let kept = state.as_ref().and_then(|state| state.saved.as_ref());
    let mut controller = Controller::with_memory(Arc::clone(&image), options, !arguments.no_battery, kept)
        .with_context(|| State::cannot_power_up(state.as_ref()))?;
    let mut recorder = recorder(arguments, &image, &controller)?;
    start.extend(kept_programs_to_start(arguments, &controller, &image)?);
    check_registers(&controller, &arguments.read)?;
    ports::check(arguments, &controller)?;
    ports::offer(&arguments.input, &mut controller)?;
    let mut sent = Outputs::create(&arguments.output)?;

    let interrupted = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&interrupted);
    ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed)).context("cannot watch for Ctrl-C")?;
    let live = arguments.format == SimFormat::Text;
    let files = (&mut recorder, &mut sent);
    let mut observer = RunObserver::new(files, live, Terminal::output(color), &interrupted, state.as_mut());
    let begun = Instant::now();
    let stopped = controller.run(&start, until, &mut observer);
    let wall = begun.elapsed();
    let record = observer.finish()?;
    recorder.last(&controller.view())?;
    if let Some(state) = &mut state {
        state.save(&controller.saved())?;
    }

    let exit = exit_of(stopped, &controller);
    notes.extend(summary::notes_of(&controller, &record));
    let report = summary::Report {
        title: &title,
        project: project.as_ref(),
        controller: &controller,
        record: &record,
        stopped,
        read: &arguments.read,
        notes: &notes,
    };
    let files = match stopped {
        Stopped::Interrupted => Vec::new(),
        Stopped::Ended | Stopped::Until => [recorder.finish(&report)?, sent.finish()?].concat(),
    };
    match arguments.format {
        SimFormat::Text => summary::print(&report, wall, until, &files, Terminal::output(color))?,
        SimFormat::Json => json::print(&report)?,
    }
    Ok(exit)
}

/// Records a run of a project, or of the programs that the controller has kept.
fn recorder(arguments: &SimArguments, image: &Image, controller: &Controller) -> anyhow::Result<Recorder> {
    let view = controller.view();
    if arguments.stored {
        Recorder::new(arguments, &controller.stored_programs(), view.world())
    } else {
        Recorder::new(arguments, image, view.world())
    }
}

/// A project that is sent to the controller.
fn of_project(arguments: &SimArguments, project: &LoadedProject, color: ColorChoice) -> anyhow::Result<Setup> {
    let world = load_world(arguments.world.as_deref(), project)?;
    let Some(image) = compile(project, "is not run", Terminal::error(color)) else {
        bail!("{} cannot be run before that is mended", title(project));
    };
    if image.boot.words.is_empty() && image.programs.is_empty() {
        bail!("{} holds no statement: there is nothing to run", arguments.project.display());
    }
    let plcs = plcs_to_start(project, &image)?;
    let (start, mut notes) = programs_to_start(arguments, project, &image)?;
    refuse_unsupported(&image, &start, &plcs)?;
    let until = arguments.until.or(project.config.sim.until.map(|time| time.0.as_secs_f64())).unwrap_or(DEFAULT_UNTIL);
    let errors: usize = errors_of(check(project)).iter().map(Vec::len).sum();
    if errors > 0 {
        let plural = if errors == 1 { "error" } else { "errors" };
        notes.push(format!("the linter finds {errors} {plural} in this project; acrc lint shows them"));
    }
    let angles = angles(arguments.angles, Some(project));
    let backlash = backlash(project);
    Ok(Setup {
        image: Arc::new(image),
        world,
        angles,
        plc_scan: plc_scan(project),
        backlash,
        start,
        plcs,
        until,
        title: title(project).to_owned(),
        notes,
    })
}

/// A controller that is only switched on.
fn of_state(arguments: &SimArguments, state: Option<&State>) -> anyhow::Result<Setup> {
    let Some(saved) = state.and_then(|state| state.saved.as_ref()) else {
        bail!("nothing was saved yet: run a project with --state first, without --stored");
    };
    Ok(Setup {
        image: Arc::new(Image::empty(&saved.model)),
        world: arguments.world.as_deref().map_or_else(|| Ok(World::default()), read_world)?,
        angles: angles(arguments.angles, None),
        plc_scan: None,
        backlash: BacklashRule::default(),
        start: Vec::new(),
        plcs: Vec::new(),
        until: arguments.until.unwrap_or(DEFAULT_UNTIL),
        title: "stored programs".to_owned(),
        notes: Vec::new(),
    })
}

/// The programs that the controller has kept and that are started: those of `--run` when no project is sent, else those that begin with
/// `PBOOT`, unless the project replaces them.
fn kept_programs_to_start(arguments: &SimArguments, controller: &Controller, image: &Image) -> anyhow::Result<Vec<u8>> {
    let stored = controller.stored_programs();
    let holds = |image: &Image, number: u8| image.programs.iter().any(|unit| unit.name == UnitName::Program(number));
    let mut start = Vec::new();
    if arguments.run.is_empty() {
        start = controller.kept_boot_programs();
        start.retain(|number| !holds(image, *number));
    } else if arguments.stored {
        start.clone_from(&arguments.run);
        if let Some(missing) = start.iter().find(|number| !holds(&stored, **number)) {
            bail!("PROG{missing} has no text in the controller");
        }
    }
    refuse_unsupported(&stored, &start, &[])?;
    Ok(start)
}

/// When a project adds backlash compensation.
pub(super) fn backlash(project: &LoadedProject) -> BacklashRule {
    match project.config.sim.backlash {
        Some(Backlash::Travel) => BacklashRule::PositiveTravel,
        Some(Backlash::Position) | None => BacklashRule::PositiveSetpoint,
    }
}

/// The unit of angles of the command line, else of the project.
pub(super) fn angles(chosen: Option<Angles>, project: Option<&LoadedProject>) -> AngleUnit {
    let configured = project.and_then(|project| project.config.sim.angles).map(|angles| match angles {
        ConfigAngles::Radians => Angles::Radians,
        ConfigAngles::Degrees => Angles::Degrees,
    });
    match chosen.or(configured) {
        Some(Angles::Degrees) => AngleUnit::Degrees,
        Some(Angles::Radians) | None => AngleUnit::Radians,
    }
}

/// Seconds from one scan of the PLC programs to the next, if the project says it.
pub(super) fn plc_scan(project: &LoadedProject) -> Option<f64> {
    project.config.sim.plc_scan.map(|time| time.0.as_secs_f64())
}

fn exit_of(stopped: Stopped, controller: &Controller) -> Exit {
    match stopped {
        Stopped::Interrupted => Exit::Interrupted,
        _ if controller.faulted() => Exit::Findings,
        Stopped::Ended | Stopped::Until => Exit::Clean,
    }
}

/// The world of the command line, else of the project, else an ideal machine.
pub(super) fn load_world(given: Option<&Path>, project: &LoadedProject) -> anyhow::Result<World> {
    let configured = project.config.sim.world.as_ref().map(|path| project.root.join(path).into_std_path_buf());
    let Some(path) = given.map(Path::to_owned).or(configured) else { return Ok(World::default()) };
    read_world(&path)
}

/// Reads a world.
pub(super) fn read_world(path: &Path) -> anyhow::Result<World> {
    let text = std::fs::read_to_string(path).with_context(|| format!("cannot read the world {}", path.display()))?;
    World::parse(&text).with_context(|| format!("{} is no valid world", path.display()))
}

/// The programs of `--run`, else of the project, else those that begin with `PBOOT`.
fn programs_to_start(
    arguments: &SimArguments,
    project: &LoadedProject,
    image: &Image,
) -> anyhow::Result<(Vec<u8>, Vec<String>)> {
    let mut asked = arguments.run.clone();
    if let (true, Some(targets)) = (asked.is_empty(), &project.config.sim.run) {
        for target in targets {
            match target.0 {
                Level::Program(number) => asked.push(number),
                Level::Plc(_) | Level::System => {}
            }
        }
    }
    let stored: Vec<u8> = image.programs.iter().filter_map(|unit| program_number(unit.name)).collect();
    if asked.is_empty() {
        asked = Controller::boot_programs(image);
        if asked.is_empty() && !stored.is_empty() && !starts_programs(image) && !starts_plcs(project, image) {
            bail!("no program starts by itself: none begins with PBOOT. --run {} starts one", list(&stored));
        }
    }
    let mut notes = Vec::new();
    for number in asked.iter().filter(|number| !stored.contains(number)) {
        if !switches_to(image, *number) {
            let there = if stored.is_empty() { "no program".to_owned() } else { list(&stored) };
            bail!("PROG{number} has no text: {} holds {there}", arguments.project.display());
        }
        notes.push(format!(
            "PROG{number} has no PROGRAM .. ENDP: its statements were executed once, as typed at its prompt"
        ));
    }
    asked.retain(|number| stored.contains(number));
    asked.sort_unstable();
    asked.dedup();
    Ok((asked, notes))
}

/// The PLC programs that the project names; those that begin with `PBOOT` start by themselves.
fn plcs_to_start(project: &LoadedProject, image: &Image) -> anyhow::Result<Vec<u8>> {
    let targets = project.config.sim.run.iter().flatten();
    let numbers = targets.filter_map(|target| if let Level::Plc(number) = target.0 { Some(number) } else { None });
    let numbers: Vec<u8> = numbers.collect();
    let stored = |number: u8| image.programs.iter().any(|unit| unit.name == UnitName::Plc(number));
    match numbers.iter().find(|number| !stored(**number)) {
        Some(number) => bail!("PLC{number} has no text, so it cannot be started"),
        None => Ok(numbers),
    }
}

/// Whether a PLC program runs from the beginning.
fn starts_plcs(project: &LoadedProject, image: &Image) -> bool {
    let named = project.config.sim.run.iter().flatten().any(|target| matches!(target.0, Level::Plc(_)));
    named || image.programs.iter().any(Controller::boots_as_plc)
}

/// Whether setup code switches to the prompt of a program.
fn switches_to(image: &Image, program: u8) -> bool {
    let to_it = |instruction: &acrc_image::Instruction| {
        let number = instruction.items.first().map(|item| &item.node);
        instruction.command == acrc_catalog::command::PROG
            && number == Some(&acrc_image::Node::Long(i32::from(program)))
    };
    image.boot.decode().unwrap_or_default().iter().any(to_it)
}

/// Whether setup code runs programs.
fn starts_programs(image: &Image) -> bool {
    use acrc_catalog::command::{LRUN, RUN};
    let instructions = image.boot.decode().unwrap_or_default();
    instructions.iter().any(|instruction| matches!(instruction.command, RUN | LRUN))
}

fn program_number(name: UnitName) -> Option<u8> {
    match name {
        UnitName::Program(number) => Some(number),
        UnitName::Boot | UnitName::Plc(_) => None,
    }
}

fn list(programs: &[u8]) -> String {
    programs.iter().map(|number| format!("PROG{number}")).collect::<Vec<_>>().join(",")
}

/// A run that would have to leave something out does not begin.
fn refuse_unsupported(image: &Image, start: &[u8], plcs: &[u8]) -> anyhow::Result<()> {
    let unsupported = Controller::unsupported(image, start, plcs);
    if unsupported.is_empty() {
        return Ok(());
    }
    let mut lines: Vec<String> = unsupported
        .iter()
        .map(|item| {
            let file = item.file.clone().unwrap_or_else(|| item.unit.to_string());
            let line = item.line.map_or_else(String::new, |line| format!(":{line}"));
            format!("  {file}{line}: {}", item.command.info().name)
        })
        .collect();
    lines.dedup();
    bail!("the dry run does not simulate these commands, so it does not begin:\n{}", lines.join("\n"))
}

/// `--read` is checked before the run, which may be long.
fn check_registers(controller: &Controller, registers: &[Register]) -> anyhow::Result<()> {
    for register in registers {
        match register {
            Register::Bit(number) => controller.bit(i64::from(*number)).map(drop)?,
            // User parameters get their memory while the setup code runs.
            Register::Parameter(number) if *number < 4096 => {}
            Register::Parameter(number) => controller.parameter(i64::from(*number)).map(drop)?,
        }
    }
    Ok(())
}
