//! A project, a controller, and downloads between them.

use std::path::Path;
use std::time::Duration;

use acrc_analysis::project::{self, LoadedProject};
use acrc_link::download::{Event, Failure, Objection, Plan, Script, Settings, State, Survey, Watcher, send, survey};
use acrc_link::{Connection, LinkError};
use camino::Utf8Path;

use crate::support::{Line, Machine};

/// Keeps what it is told.
#[derive(Default)]
pub(crate) struct Notes {
    pub(crate) sent: Vec<String>,
    /// Gives up before the line with this number, from 1.
    pub(crate) give_up_at: Option<usize>,
    pub(crate) said: Vec<String>,
}

impl Watcher for Notes {
    fn event(&mut self, event: Event<'_>) {
        match event {
            Event::Sending { step, .. } => self.sent.push(step.line.clone()),
            Event::Answered { lines, .. } => self.said.extend_from_slice(lines),
            Event::Note(text) => self.said.push(text.to_owned()),
            Event::Started(unit, running) => self.said.push(format!("{unit} {running}")),
            Event::Verifying(_) | Event::Saving(_) | Event::Tidying => {}
        }
    }

    fn interrupted(&mut self) -> bool {
        self.give_up_at.is_some_and(|number| self.sent.len() + 1 >= number)
    }

    fn pause(&mut self, _: Duration) {}
}

/// A project of one file with this text.
pub(crate) fn project(text: &str) -> LoadedProject {
    files(&[("machine.8K", text)])
}

/// A project of several files.
pub(crate) fn files(files: &[(&str, &str)]) -> LoadedProject {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).expect("written");
    }
    let path = match files {
        [(name, _)] => folder.path().join(name),
        _ => folder.path().to_owned(),
    };
    load(&path)
}

/// A project of the repository.
pub(crate) fn load(path: &Path) -> LoadedProject {
    project::load(Utf8Path::from_path(path).expect("UTF-8"))
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The lines of a project.
pub(crate) fn script(project: &LoadedProject) -> Script {
    let image = project.compile().unwrap_or_else(|errors| panic!("{errors:#?}"));
    Script::of(project, image).unwrap_or_else(|problems| panic!("{problems:#?}"))
}

/// How a download ended.
#[derive(Debug)]
pub(crate) enum Ended {
    Well(State),
    Refused(Vec<Objection>),
    /// The connection broke before the first line.
    #[expect(dead_code, reason = "shown when a test fails")]
    Early(LinkError),
    Failed(Box<Failure>),
}

impl Ended {
    #[track_caller]
    pub(crate) fn well(self) -> State {
        match self {
            Self::Well(state) => state,
            other => panic!("{other:#?}"),
        }
    }

    #[track_caller]
    pub(crate) fn failure(self) -> Failure {
        match self {
            Self::Failed(failure) => *failure,
            other => panic!("{other:#?}"),
        }
    }

    #[track_caller]
    pub(crate) fn objections(self) -> Vec<String> {
        match self {
            Self::Refused(objections) => objections.iter().map(ToString::to_string).collect(),
            other => panic!("{other:#?}"),
        }
    }
}

/// A whole download over a line.
pub(crate) fn download(line: Line, script: &Script, settings: &Settings, notes: &mut Notes) -> Ended {
    let mut connection = match line.try_connect() {
        Ok(connection) => connection,
        Err(error) => return Ended::Early(error),
    };
    over(&mut connection, script, settings, notes)
}

pub(crate) fn over(
    connection: &mut Connection<Line>,
    script: &Script,
    settings: &Settings,
    notes: &mut Notes,
) -> Ended {
    let model = acrc_catalog::default_model();
    let survey = match survey(connection, model) {
        Ok(survey) => survey,
        Err(error) => return Ended::Early(error),
    };
    let plan = match Plan::new(script, &survey, model, settings) {
        Ok(plan) => plan,
        Err(objections) => return Ended::Refused(objections),
    };
    match send(connection, script, &plan, settings, notes, model) {
        Ok(state) => Ended::Well(state),
        Err(failure) => Ended::Failed(failure),
    }
}

/// A download with usual settings that has to work.
#[track_caller]
pub(crate) fn bring(machine: &Machine, script: &Script) -> (State, Notes) {
    let mut notes = Notes::default();
    let state = download(machine.line(), script, &Settings::default(), &mut notes).well();
    (state, notes)
}

/// What a controller has.
pub(crate) fn look(machine: &Machine) -> Survey {
    survey(&mut machine.connect(), acrc_catalog::default_model()).expect("it answers")
}
