//! Records the signals of a run into a trace file, for a plot and for a report.

use std::path::PathBuf;

use acrc_controller::View;
use acrc_controller::world::{World, WorldEvent};
use acrc_image::Image;
use acrc_trace::plot::{self, Event, PlotOptions};

use super::page::Page;
use super::rate::Rate;
use super::signals::Signals;
use super::summary::Report;
use super::thinned::Thinned;
use super::trace_file::TraceFile;
use crate::cli::SimArguments;
use crate::output::{OutputFile, write_file};

/// Rows kept for a plot.
const PLOT_ROWS: usize = 200_000;

/// Records a run.
pub(super) struct Recorder {
    signals: Signals,
    trace: Option<TraceFile>,
    plot: Option<Plot>,
    page: Option<Page>,
    /// What happened in the world, for people.
    events: Vec<Event>,
    rate: Rate,
    /// Tick of the latest row.
    sampled: Option<u64>,
    row: Vec<f64>,
}

struct Plot {
    path: PathBuf,
    samples: Thinned,
}

impl Recorder {
    /// Opens the files that were asked for.
    pub(super) fn new(arguments: &SimArguments, image: &Image, world: &World) -> anyhow::Result<Self> {
        let signals = Signals::new(&arguments.signals, image, world)?;
        let rate = Rate::new(arguments.rate)?;
        // Find out now, not after the run, that a file cannot be written.
        for path in arguments.plot.iter().chain(&arguments.report) {
            drop(OutputFile::create(path)?);
        }
        let columns = signals.columns();
        let trace = arguments.trace.as_deref().map(|path| TraceFile::create(path, &columns)).transpose()?;
        let plot = arguments.plot.clone().map(|path| {
            let samples = Thinned::new(signals.plotted(), PLOT_ROWS);
            Plot { path, samples }
        });
        let page = arguments.report.clone().map(|path| Page::new(path, &signals));
        Ok(Self { signals, trace, plot, page, events: Vec::new(), rate, sampled: None, row: Vec::new() })
    }

    /// Whether anything is recorded.
    pub(super) fn is_active(&self) -> bool {
        self.trace.is_some() || self.plot.is_some() || self.page.is_some()
    }

    /// The state in which a run ended, when no row has it yet.
    pub(super) fn last(&mut self, view: &View) -> anyhow::Result<()> {
        if self.is_active() && self.sampled != Some(view.ticks()) { self.sample(view) } else { Ok(()) }
    }

    /// Samples when a row is due.
    pub(super) fn tick(&mut self, view: &View) -> anyhow::Result<()> {
        if !self.is_active() {
            return Ok(());
        }
        if let Some(page) = &mut self.page {
            page.follow(view);
        }
        if self.rate.is_due(view)? { self.sample(view) } else { Ok(()) }
    }

    fn sample(&mut self, view: &View) -> anyhow::Result<()> {
        self.sampled = Some(view.ticks());
        self.signals.sample(view, &mut self.row);
        let seconds = view.seconds();
        if let Some(trace) = &mut self.trace {
            trace.row(seconds, &self.row)?;
        }
        if let Some(plot) = &mut self.plot {
            plot.samples.sample(seconds, &self.row)?;
        }
        if let Some(page) = &mut self.page {
            page.sample(seconds, &self.row)?;
        }
        Ok(())
    }

    /// Marks an event of the world.
    pub(super) fn event(&mut self, seconds: f64, event: &WorldEvent) {
        if let (true, Some(note)) = (self.plot.is_some() || self.page.is_some(), &event.note) {
            self.events.push(Event { time: seconds, text: note.clone() });
        }
    }

    /// Completes the files; gives back what each is and where.
    pub(super) fn finish(self, run: &Report) -> anyhow::Result<Vec<(&'static str, PathBuf)>> {
        let mut files = Vec::new();
        if let Some(trace) = self.trace {
            files.push(("trace", trace.finish()?));
        }
        if let Some(page) = self.page {
            files.push(("report", page.finish(&self.signals, &self.events, run)?));
        }
        if let Some(Plot { path, samples }) = self.plot {
            let trace = samples.into_trace();
            let dispensable = self.signals.dispensable();
            let is_idle = |index: usize| trace.column(index).iter().all(|value| *value == 0.0);
            let idle: Vec<bool> = (0..).zip(dispensable).map(|(index, can_go)| can_go && is_idle(index)).collect();
            let trace = trace.without(|index| idle.get(index) == Some(&true));
            let (title, paths) = (run.title.to_owned(), self.signals.paths());
            let options = PlotOptions { title, events: self.events, paths, ..PlotOptions::default() };
            write_file(&path, plot::svg(&trace, &options).as_bytes())?;
            files.push(("plot", path));
        }
        Ok(files)
    }
}
