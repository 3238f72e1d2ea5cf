//! Takes what a run produces: shows it as it happens and keeps it for the report.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};

use acrc_controller::nonvolatile::Saved;
use acrc_controller::world::WorldEvent;
use acrc_controller::{FaultReport, Observer, Sent, StreamName, View};
use acrc_image::UnitName;

use super::ports::Outputs;
use super::recorder::Recorder;
use crate::commands::nonvolatile::State;
use crate::output::{Terminal, nobody_reads, print};

/// Output kept for the report, at most; later lines are counted only.
const KEPT_OUTPUT: usize = 100_000;

/// A line that a program sent to a device.
#[derive(Debug)]
pub(super) struct Line {
    pub(super) seconds: f64,
    pub(super) unit: UnitName,
    pub(super) device: i32,
    pub(super) stream: Option<StreamName>,
    pub(super) text: String,
}

/// What a run produced.
#[derive(Debug, Default)]
pub(super) struct Record {
    pub(super) output: Vec<Line>,
    /// Lines beyond those that are kept.
    pub(super) dropped: u64,
    pub(super) faults: Vec<FaultReport>,
}

/// Where text comes from and goes to: unit, device, stream.
type Route = (UnitName, i32, Option<StreamName>);

/// The observer of `acrc sim`.
pub(super) struct RunObserver<'a> {
    recorder: &'a mut Recorder,
    outputs: &'a mut Outputs,
    live: bool,
    terminal: Terminal,
    interrupted: &'a AtomicBool,
    /// Where the controller's saved state goes.
    state: Option<&'a mut State>,
    record: Record,
    /// Text of lines that have not ended yet, with the time of their first character.
    open: BTreeMap<Route, (f64, String)>,
    failure: Option<anyhow::Error>,
}

impl<'a> RunObserver<'a> {
    pub(super) fn new(
        (recorder, outputs): (&'a mut Recorder, &'a mut Outputs),
        live: bool,
        terminal: Terminal,
        interrupted: &'a AtomicBool,
        state: Option<&'a mut State>,
    ) -> Self {
        let record = Record::default();
        Self { recorder, outputs, live, terminal, interrupted, state, record, open: BTreeMap::new(), failure: None }
    }

    /// What was recorded, with the lines that never ended; or why it could not be shown or written.
    pub(super) fn finish(mut self) -> anyhow::Result<Record> {
        for ((unit, device, stream), (seconds, text)) in std::mem::take(&mut self.open) {
            self.line(Line { seconds, unit, device, stream, text });
        }
        match self.failure {
            Some(error) => Err(error),
            None => Ok(self.record),
        }
    }

    fn line(&mut self, line: Line) {
        if self.live {
            let source = route(&line);
            self.show(line.seconds, &source, &line.text);
        }
        if self.record.output.len() < KEPT_OUTPUT {
            self.record.output.push(line);
        } else {
            self.record.dropped += 1;
        }
    }

    fn show(&mut self, seconds: f64, source: &str, text: &str) {
        let time = self.terminal.faint(&format!("{seconds:>10.3} s"));
        let visible: String = text.chars().map(printable).collect();
        let written = print(|out| writeln!(out, "{time}  {source:<8}  {visible}"));
        // The run and its files go on without a reader.
        self.live = !nobody_reads();
        self.fail(written);
    }

    fn fail(&mut self, result: anyhow::Result<()>) {
        if let Err(error) = result {
            self.failure.get_or_insert(error);
        }
    }
}

/// Where a line came from.
pub(super) fn source(unit: UnitName) -> String {
    if unit == UnitName::Boot { "setup".to_owned() } else { unit.to_string() }
}

/// Where a line came from, and the stream that it went to. Without a program device 0 is the terminal of the stream.
pub(super) fn route(line: &Line) -> String {
    match (line.unit, line.device, line.stream) {
        (UnitName::Boot, 0, Some(stream)) => stream.to_string(),
        (unit, _, Some(stream)) => format!("{} {stream}", source(unit)),
        (unit, _, None) => source(unit),
    }
}

/// A program may print anything; a terminal shall not act on it.
fn printable(character: char) -> char {
    if character.is_control() && character != '\t' { '\u{fffd}' } else { character }
}

impl Observer for RunObserver<'_> {
    fn output(&mut self, sent: &Sent) {
        let written = self.outputs.write(sent);
        self.fail(written);
        let Sent { seconds, unit, device, stream, text } = *sent;
        let route = (unit, device, stream);
        let mut parts = text.split("\r\n").peekable();
        while let Some(part) = parts.next() {
            let ends = parts.peek().is_some();
            if !ends && part.is_empty() {
                break;
            }
            let open = self.open.entry(route).or_insert_with(|| (seconds, String::new()));
            open.1.push_str(part);
            if ends && let Some((seconds, text)) = self.open.remove(&route) {
                self.line(Line { seconds, unit, device, stream, text });
            }
        }
    }

    fn fault(&mut self, fault: &FaultReport) {
        if self.live {
            let source = self.terminal.error_word(&format!("{:<8}", "fault"));
            self.show(fault.seconds, &source, &fault.to_string());
        }
        self.record.faults.push(fault.clone());
    }

    fn event(&mut self, seconds: f64, event: &WorldEvent, view: &View) {
        if self.live {
            let name = |bit: &u32| view.world().input_name(*bit).map_or_else(|| format!("BIT{bit}"), str::to_owned);
            let on = event.set.iter().map(|bit| format!("{} on", name(bit)));
            let off = event.clear.iter().map(|bit| format!("{} off", name(bit)));
            let values = event.parameters.iter().map(|(number, value)| format!("P{number} = {value}"));
            let typed =
                event.typed.iter().map(|typed| format!("types \"{}\" at {}", typed.text.escape_ascii(), typed.port));
            let changes = on.chain(off).chain(values).chain(typed).collect::<Vec<_>>().join(", ");
            self.show(seconds, "world", &changes);
        }
        self.recorder.event(seconds, event);
    }

    fn saved(&mut self, saved: &Saved) {
        if let Some(state) = &mut self.state {
            let result = state.save(saved);
            self.fail(result);
        }
    }

    fn tick(&mut self, view: &View) {
        let result = self.recorder.tick(view);
        self.fail(result);
    }

    fn watches_every_tick(&self) -> bool {
        self.recorder.is_active()
    }

    fn interrupted(&mut self) -> bool {
        self.interrupted.load(Ordering::Relaxed) || self.failure.is_some()
    }
}
