//! `acrc download`: sends a project to a controller and verifies it.

mod progress;
mod show;

use std::time::{Duration, Instant};

use acrc_analysis::project::LoadedProject;
use acrc_diagnostics::Diagnostic;
use acrc_image::{Image, UnitName};
use acrc_link::download::{
    Cause, Failure, NOTHING_STORED, Objection, Plan, Problem, Save, Script, Settings, State, Survey, send, survey,
};
use acrc_link::{Connection, LinkError, Protocol, Tcp};
use acrc_syntax::units::Level;
use anyhow::bail;

use self::progress::Progress;
use super::build::loadable;
use super::link::{Consent, confirm, failed, watch_interrupt};
use super::project::{check, compile, errors_of, load, show_errors, title};
use crate::cli::{ColorChoice, DownloadArguments, SaveArgument};
use crate::exit::Exit;
use crate::output::{Terminal, tell};

/// What errors leave undone.
const NOT_SENT: &str = "is not sent";

/// Time for a network or a controller to come back.
const BETWEEN_ATTEMPTS: Duration = Duration::from_secs(1);

/// What was seen of a controller longer ago than this is looked at again before anything is sent.
const FRESH: Duration = Duration::from_secs(1);

/// What is to be done.
struct Order<'a> {
    arguments: &'a DownloadArguments,
    project: &'a LoadedProject,
    script: Script,
    settings: Settings,
    terminal: Terminal,
}

/// How an attempt ended that could not go on.
enum Ended {
    /// The connection, before anything was sent.
    Link(LinkError),
    /// Something speaks against it.
    Objections(Vec<Objection>),
    /// It went wrong.
    Failure(Box<Failure>),
    /// Everything is said.
    Exit(Exit),
}

impl From<LinkError> for Ended {
    fn from(error: LinkError) -> Self {
        Self::Link(error)
    }
}

pub(super) fn run(arguments: &DownloadArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let terminal = Terminal::error(color);
    let project = load(&arguments.project)?;
    let Some(script) = sendable(&project, terminal)? else { return Ok(Exit::Findings) };
    let settings = settings(arguments, &project, &script.image)?;
    watch_interrupt()?;
    // Otherwise the plan says so.
    if script.stores_nothing() && arguments.yes && !arguments.plan {
        crate::exit::warn(NOTHING_STORED, terminal);
    }
    let order = Order { arguments, project: &project, script, settings, terminal };
    order.run()
}

/// The lines of a project that a controller is known to take; what speaks against it is shown otherwise.
fn sendable(project: &LoadedProject, terminal: Terminal) -> anyhow::Result<Option<Script>> {
    let Some(image) = compile(project, NOT_SENT, terminal) else { return Ok(None) };
    let errors = errors_of(check(project));
    if !errors.iter().all(Vec::is_empty) {
        show_errors(project, &errors, NOT_SENT, terminal);
        return Ok(None);
    }
    let problems = loadable::problems(project, &image)?;
    if !problems.is_empty() {
        tell(|err| {
            problems.iter().try_for_each(|problem| writeln!(err, "error: {problem}"))?;
            writeln!(err, "{} {NOT_SENT}: a controller cannot load it", title(project))
        });
        return Ok(None);
    }
    let script = match Script::of(project, image) {
        Ok(script) => script,
        Err(problems) => {
            show_problems(project, problems, NOT_SENT, terminal);
            return Ok(None);
        }
    };
    if script.lines.is_empty() {
        bail!("{} holds no statement: there is nothing to send", title(project));
    }
    Ok(Some(script))
}

/// Shows findings of a download at their places.
fn show_problems(project: &LoadedProject, problems: Vec<Problem>, undone: &str, terminal: Terminal) {
    let mut found: Vec<Vec<Diagnostic>> = project.files.iter().map(|_| Vec::new()).collect();
    for problem in problems {
        if let Some(list) = found.get_mut(problem.file) {
            list.push(problem.diagnostic);
        }
    }
    show_errors(project, &found, undone, terminal);
}

fn settings(arguments: &DownloadArguments, project: &LoadedProject, image: &Image) -> anyhow::Result<Settings> {
    let save = arguments.save.iter().map(|memory| match memory {
        SaveArgument::Flash => Save::Flash,
        SaveArgument::Eeprom => Save::Eeprom,
    });
    let settings = Settings {
        halt: arguments.halt,
        with_drives_enabled: arguments.with_drives_enabled,
        everything: arguments.everything,
        unverified: arguments.no_verify && !arguments.verify,
        password: arguments.password.clone(),
        run: to_run(arguments, project, image)?,
        save: save.collect(),
    };
    if settings.save.contains(&Save::Flash) && project.model.name.eq_ignore_ascii_case("ACR8000") {
        bail!("{} has no flash memory for programs: --save eeprom saves its settings", project.model.name);
    }
    Ok(settings)
}

/// The programs of `--run`, else of the project, else those that begin with `PBOOT`.
fn to_run(arguments: &DownloadArguments, project: &LoadedProject, image: &Image) -> anyhow::Result<Vec<UnitName>> {
    let Some(named) = &arguments.run else { return Ok(Vec::new()) };
    let named = Some(named).filter(|named| !named.is_empty());
    let units = match (named, &project.config.sim.run) {
        (Some(names), _) => names
            .split(',')
            .map(|name| crate::cli::parse_text(name.trim()).map_err(|error| anyhow::anyhow!("--run={name}: {error}")))
            .collect::<anyhow::Result<Vec<_>>>()?,
        (None, Some(targets)) => targets.iter().filter_map(|target| unit_of(target.0)).collect(),
        (None, None) => {
            let programs = acrc_controller::Controller::boot_programs(image).into_iter().map(UnitName::Program);
            let plcs = image.programs.iter().filter(|unit| acrc_controller::Controller::boots_as_plc(unit));
            programs.chain(plcs.map(|unit| unit.name)).collect()
        }
    };
    if units.is_empty() {
        bail!("--run: no program begins with PBOOT; --run=PROG0 names one");
    }
    if let Some(missing) = units.iter().find(|unit| !image.programs.iter().any(|own| own.name == **unit)) {
        bail!("--run: the project has no {missing}");
    }
    Ok(units)
}

fn unit_of(level: Level) -> Option<UnitName> {
    acrc_link::download::unit_at(level)
}

/// What Ctrl-C ends: what is waited for, until things are put in order.
fn gives_up() -> bool {
    super::link::interrupted() && !progress::is_tidying()
}

impl Order<'_> {
    /// Attempts until one ends well or nothing more can be done.
    fn run(&self) -> anyhow::Result<Exit> {
        let mut confirmed = self.arguments.yes;
        let mut left = self.arguments.attempts;
        // What is known of the controller since the connection broke.
        let mut broken: Option<Box<Failure>> = None;
        loop {
            let (error, failure) = match self.attempt(&mut confirmed) {
                Ok(exit) | Err(Ended::Exit(exit)) => return Ok(exit),
                Err(Ended::Objections(objections)) => {
                    show::objections(&objections, self, broken.as_deref());
                    return Ok(Exit::Findings);
                }
                Err(Ended::Link(error)) => match broken.take() {
                    None => {
                        show::unreached(&error, self);
                        return Ok(failed(error, self.terminal));
                    }
                    Some(before) => (error.to_string(), before),
                },
                Err(Ended::Failure(failure)) => (failure.cause.to_string(), failure),
            };
            let lost = matches!(&failure.cause, Cause::Link(error) if error.is_broken());
            if !lost || is_interrupted(&failure) || super::link::interrupted() || left == 0 {
                show::failure(&failure, self)?;
                return Ok(exit_of(&failure));
            }
            left -= 1;
            crate::exit::warn(&format!("{error}; the download is taken up again"), self.terminal);
            std::thread::sleep(BETWEEN_ATTEMPTS);
            broken = Some(failure);
        }
    }

    fn connect(&self) -> Result<Connection<Tcp>, LinkError> {
        let to = &self.arguments.to;
        Connection::open(&to.to, to.protocol(Protocol::Text), to.settings(gives_up))
    }

    /// A whole download, from the connection on.
    fn attempt(&self, confirmed: &mut bool) -> Result<Exit, Ended> {
        let mut connection = self.connect()?;
        let (mut seen, mut plan) = self.look(&mut connection)?;
        if self.arguments.plan {
            show::plan(&plan, self).map_err(|error| self.exit(&error))?;
            connection.close();
            return Ok(Exit::Clean);
        }
        while !*confirmed {
            let looked = Instant::now();
            self.ask(&plan)?;
            *confirmed = true;
            if looked.elapsed() > FRESH {
                // Others can change the controller as long as the question stands.
                let (now, new) = self.look(&mut connection)?;
                let changes = now.changes_since(&seen);
                if !changes.is_empty() {
                    crate::exit::warn(&format!("changed meanwhile: {}", changes.join(", ")), self.terminal);
                    *confirmed = false;
                }
                (seen, plan) = (now, new);
            }
        }
        if self.arguments.json {
            crate::output::print(|out| writeln!(out, "{}", show::plan_json(&plan, self)))
                .map_err(|error| self.exit(&error))?;
        }
        let mut progress = Progress::new(self.arguments.json, &self.script);
        let sent = send(&mut connection, &self.script, &plan, &self.settings, &mut progress, self.project.model);
        progress.finish();
        let state: State = sent.map_err(Ended::Failure)?;
        connection.close();
        show::done(&state, &plan, self).map_err(|error| self.exit(&error))?;
        Ok(Exit::Clean)
    }

    /// What the controller has now, and what is to be done with it.
    fn look(&self, connection: &mut Connection<Tcp>) -> Result<(Survey, Plan), Ended> {
        let model = self.project.model;
        let survey = survey(connection, model)?;
        let plan = Plan::new(&self.script, &survey, model, &self.settings).map_err(Ended::Objections)?;
        Ok((survey, plan))
    }

    /// Asks at the terminal whether a plan shall be carried out; an error when not.
    fn ask(&self, plan: &Plan) -> Result<(), Ended> {
        show::summary(plan, self);
        let question = format!("Send {} to {}?", title(self.project), self.arguments.to.to);
        match confirm(&question, "a download changes the controller") {
            Ok(Consent::Given) => Ok(()),
            Ok(Consent::Denied) => Err(self.exit(&anyhow::anyhow!("nothing was sent"))),
            Ok(Consent::Interrupted) => Err(Ended::Exit(Exit::Interrupted)),
            Err(error) => Err(self.exit(&error)),
        }
    }

    fn exit(&self, error: &anyhow::Error) -> Ended {
        crate::exit::say(error, self.terminal);
        Ended::Exit(Exit::Failure)
    }
}

fn is_interrupted(failure: &Failure) -> bool {
    matches!(failure.cause, Cause::Interrupted | Cause::Link(LinkError::Interrupted))
}

fn exit_of(failure: &Failure) -> Exit {
    match &failure.cause {
        _ if is_interrupted(failure) => Exit::Interrupted,
        Cause::Link(error) if error.is_broken() => Exit::Failure,
        _ => Exit::Findings,
    }
}
