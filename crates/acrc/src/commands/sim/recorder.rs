//! Records the signals of a run into a trace file and for a plot.

use std::path::PathBuf;

use acrc_controller::View;
use acrc_controller::world::{World, WorldEvent};
use acrc_image::Image;
use acrc_trace::Trace;
use acrc_trace::plot::{self, Event, PlotOptions};

use super::rate::Rate;
use super::signals::Signals;
use super::trace_file::TraceFile;
use crate::cli::SimArguments;
use crate::output::{OutputFile, write_file};

/// Rows kept for a plot. Beyond that every second one is dropped, and from then on half as many are taken.
const PLOT_ROWS: usize = 200_000;

/// Records a run.
pub(super) struct Recorder {
    signals: Signals,
    trace: Option<TraceFile>,
    plot: Option<Plot>,
    rate: Rate,
    /// Tick of the latest row.
    sampled: Option<u64>,
    row: Vec<f64>,
}

struct Plot {
    path: PathBuf,
    trace: Trace,
    events: Vec<Event>,
    /// Every how manieth sample is kept.
    keep: u64,
    samples: u64,
}

impl Recorder {
    /// Opens the files that were asked for.
    pub(super) fn new(arguments: &SimArguments, image: &Image, world: &World) -> anyhow::Result<Self> {
        let signals = Signals::new(&arguments.signals, image, world)?;
        let columns = signals.columns();
        let trace = arguments.trace.as_deref().map(|path| TraceFile::create(path, &columns)).transpose()?;
        let plot = match &arguments.plot {
            Some(path) => {
                // Find out now, not after the run, that the file cannot be written.
                drop(OutputFile::create(path)?);
                let trace = Trace::new(signals.plotted());
                Some(Plot { path: path.clone(), trace, events: Vec::new(), keep: 1, samples: 0 })
            }
            None => None,
        };
        Ok(Self { signals, trace, plot, rate: Rate::new(arguments.rate)?, sampled: None, row: Vec::new() })
    }

    /// Whether anything is recorded.
    pub(super) fn is_active(&self) -> bool {
        self.trace.is_some() || self.plot.is_some()
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
        if self.rate.is_due(view)? { self.sample(view) } else { Ok(()) }
    }

    fn sample(&mut self, view: &View) -> anyhow::Result<()> {
        self.sampled = Some(view.ticks());
        self.signals.sample(view, &mut self.row);
        if let Some(trace) = &mut self.trace {
            trace.row(view.seconds(), &self.row)?;
        }
        if let Some(plot) = &mut self.plot {
            plot.sample(view.seconds(), &self.row)?;
        }
        Ok(())
    }

    /// Marks an event of the world in the plot.
    pub(super) fn event(&mut self, seconds: f64, event: &WorldEvent) {
        if let (Some(plot), Some(note)) = (&mut self.plot, &event.note) {
            plot.events.push(Event { time: seconds, text: note.clone() });
        }
    }

    /// Completes the files; gives back what each is and where.
    pub(super) fn finish(self, name: &str) -> anyhow::Result<Vec<(&'static str, PathBuf)>> {
        let mut files = Vec::new();
        if let Some(trace) = self.trace {
            files.push(("trace", trace.finish()?));
        }
        if let Some(plot) = self.plot {
            let options = PlotOptions {
                title: name.to_owned(),
                events: plot.events,
                paths: self.signals.paths(),
                ..PlotOptions::default()
            };
            let dispensable = self.signals.dispensable();
            let idle: Vec<bool> = (0..)
                .zip(dispensable)
                .map(|(index, dispensable)| dispensable && plot.trace.column(index).iter().all(|value| *value == 0.0))
                .collect();
            let trace = plot.trace.without(|index| idle.get(index) == Some(&true));
            write_file(&plot.path, plot::svg(&trace, &options).as_bytes())?;
            files.push(("plot", plot.path));
        }
        Ok(files)
    }
}

impl Plot {
    fn sample(&mut self, seconds: f64, row: &[f64]) -> anyhow::Result<()> {
        self.samples += 1;
        if !(self.samples - 1).is_multiple_of(self.keep) {
            return Ok(());
        }
        if self.trace.rows() >= PLOT_ROWS {
            self.thin_out()?;
        }
        Ok(self.trace.push(seconds, row)?)
    }

    fn thin_out(&mut self) -> anyhow::Result<()> {
        let full = std::mem::replace(&mut self.trace, Trace::new(Vec::new()));
        let mut thinner = Trace::new(full.signals().to_vec());
        let mut values = Vec::with_capacity(full.signals().len());
        for (index, time) in full.times().iter().enumerate().step_by(2) {
            values.clear();
            values.extend((0..full.signals().len()).filter_map(|signal| full.value(index, signal)));
            thinner.push(*time, &values)?;
        }
        self.trace = thinner;
        self.keep *= 2;
        Ok(())
    }
}
