//! The page of `--report`: collects what a run does, in bounded memory, and writes it.

use std::path::PathBuf;

use acrc_analysis::project::LoadedProject;
use acrc_controller::{Controller, Standing, Stopped, View};
use acrc_image::UnitName;
use acrc_image::list::{ListOptions, list};
use acrc_trace::plot::Event;
use acrc_trace::report::{self, OutputLine, SourceText};
use acrc_trace::{Entry, Envelope, Place, StatementLog, Trace};

use super::observer::route;
use super::signals::Signals;
use super::summary::{self, Report};
use super::thinned::Thinned;
use crate::output::write_file;

/// Numbers kept of all signals together: some ten megabytes in the page.
const VALUES: usize = 1 << 20;
/// Rows kept for the paths of tools.
const PATH_ROWS: usize = 50_000;
/// Changes of statement kept for all programs together.
const STATEMENTS: usize = 100_000;

/// What a page needs of a run.
pub(super) struct Page {
    path: PathBuf,
    envelope: Envelope,
    positions: Thinned,
    /// Which columns the positions are.
    axes: Vec<usize>,
    statements: StatementLog,
    /// Where each program stood when it was last looked at, in the order of the log.
    standings: Vec<Standing>,
    row: Vec<f64>,
}

impl Page {
    pub(super) fn new(path: PathBuf, signals: &Signals) -> Self {
        let columns = signals.plotted();
        let paths = signals.paths();
        let named = |name: &String| paths.iter().flatten().any(|axis| axis == name);
        let axes: Vec<usize> = (0..columns.len()).filter(|index| named(&columns[*index].name)).collect();
        let positions = axes.iter().map(|index| columns[*index].clone()).collect();
        Self {
            path,
            envelope: Envelope::new(columns, VALUES),
            positions: Thinned::new(positions, PATH_ROWS),
            axes,
            statements: StatementLog::new(STATEMENTS),
            standings: Vec::new(),
            row: Vec::new(),
        }
    }

    pub(super) fn sample(&mut self, seconds: f64, row: &[f64]) -> anyhow::Result<()> {
        self.envelope.push(seconds, row)?;
        self.row.clear();
        self.row.extend(self.axes.iter().filter_map(|index| row.get(*index)));
        Ok(self.positions.sample(seconds, &self.row)?)
    }

    /// Takes note of where the programs stand now.
    pub(super) fn follow(&mut self, view: &View) {
        for standing in view.standings() {
            let known = self.standings.iter().position(|known| known.unit == standing.unit);
            if known.is_some_and(|index| self.standings.get(index) == Some(&standing)) {
                continue;
            }
            let number = known.unwrap_or_else(|| {
                self.standings.push(standing);
                self.standings.len() - 1
            });
            self.standings[number] = standing;
            let Standing { unit, state, file, line, statement } = standing;
            let entry = Entry { time: view.seconds(), place: Place { file, line, statement }, state: state.name() };
            self.statements.record(number, || unit.to_string(), entry);
        }
    }

    /// Writes the page; gives back where it is.
    pub(super) fn finish(self, signals: &Signals, events: &[Event], run: &Report) -> anyhow::Result<PathBuf> {
        let dispensable = signals.dispensable();
        let bands = self.envelope.bands();
        let idle: Vec<bool> = dispensable.iter().zip(bands).map(|(can_go, band)| *can_go && band.is_zero()).collect();
        let envelope = self.envelope.without(|index| idle.get(index) == Some(&true));
        let positions: Trace = self.positions.into_trace();
        let output = run.record.output.iter().map(|line| OutputLine {
            time: line.seconds,
            source: route(line),
            text: &line.text,
        });
        let faults = run.record.faults.iter().map(|fault| Event { time: fault.seconds, text: fault.to_string() });
        let page = report::html(&report::Report {
            title: run.title,
            facts: facts(run),
            signals: &envelope,
            positions: &positions,
            paths: signals.paths(),
            events,
            statements: &self.statements,
            files: run.project.map(texts).unwrap_or_default(),
            listings: listings(run.controller),
            output: output.collect(),
            faults: faults.collect(),
            notes: run.notes,
        });
        write_file(&self.path, page.as_bytes())?;
        Ok(self.path)
    }
}

/// What is to be known of a run at a glance.
fn facts(run: &Report) -> Vec<(String, String)> {
    let stopped = match run.stopped {
        Stopped::Ended => "no program runs and nothing moves",
        Stopped::Until => "the time given was over",
        Stopped::Interrupted => "interrupted",
    };
    let plain = |name: &str, value: String| (name.to_owned(), value);
    let mut facts = vec![
        plain("controller", run.controller.model().name.to_owned()),
        plain("virtual time", format!("{:.3} s", run.controller.seconds())),
        plain("end", stopped.to_owned()),
    ];
    facts.extend(run.controller.masters().iter().map(|master| {
        let moves = master.statistics.moves;
        plain(&format!("MASTER{}", master.master), format!("{moves} moves in {:.3} s of motion", master.motion_seconds))
    }));
    facts.extend(run.controller.axes().iter().map(|axis| {
        let peaks =
            [axis.position, axis.statistics.travel, axis.statistics.peak_velocity].map(|value| summary::trim(value, 4));
        let [position, travel, peak] = peaks;
        plain(&summary::axis_title(axis), format!("at {position}, travelled {travel}, peak velocity {peak}"))
    }));
    facts
}

/// The files of a project, in the order of the image.
fn texts(project: &LoadedProject) -> Vec<SourceText> {
    let files = project.files.iter().map(|file| SourceText {
        name: file.path.strip_prefix(&project.root).unwrap_or(&file.path).to_string(),
        text: file.source.text.clone(),
    });
    files.collect()
}

/// The texts of programs whose source nobody knows: those that the controller has kept.
fn listings(controller: &Controller) -> Vec<SourceText> {
    let stored = controller.stored_programs();
    let unknown = stored.programs.iter().filter(|unit| unit.debug.is_none() && unit.name != UnitName::Boot);
    let texts = unknown.filter_map(|unit| {
        let text = list(unit, &stored.aliases, &ListOptions::default()).ok()?;
        Some(SourceText { name: unit.name.to_string(), text })
    });
    texts.collect()
}
