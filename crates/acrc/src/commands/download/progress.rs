//! What a person or a program sees while a download goes on.

use std::io::IsTerminal as _;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use acrc_link::download::{Event, Script, Step, Watcher};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::{Value, json};

use crate::output::{print, tell};

/// Something is being put in order, which Ctrl-C does not end.
static TIDYING: AtomicBool = AtomicBool::new(false);

/// Whether something is being put in order.
pub(super) fn is_tidying() -> bool {
    TIDYING.load(Ordering::Relaxed)
}

/// Watches a download.
pub(super) struct Progress<'a> {
    bar: ProgressBar,
    json: bool,
    script: &'a Script,
}

impl<'a> Progress<'a> {
    pub(super) fn new(json: bool, script: &'a Script) -> Self {
        let bar = ProgressBar::new(0);
        if json || !std::io::stderr().is_terminal() {
            bar.set_draw_target(ProgressDrawTarget::hidden());
        }
        let style = ProgressStyle::with_template("{bar:32} {pos}/{len} lines  {wide_msg}");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        Self { bar, json, script }
    }

    /// Takes the bar away.
    pub(super) fn finish(&self) {
        self.bar.finish_and_clear();
    }

    fn say(&self, value: &Value) {
        if self.json {
            // The reader may have gone; the download goes on.
            let _ = print(|out| writeln!(out, "{value}"));
        }
    }

    fn note(&self, text: &str) {
        if !self.json {
            self.bar.suspend(|| tell(|err| writeln!(err, "{text}")));
        }
    }
}

impl Watcher for Progress<'_> {
    fn event(&mut self, event: Event<'_>) {
        match event {
            Event::Sending { number, of, step } => {
                self.bar.set_length(of as u64);
                self.bar.set_position(number as u64);
                self.bar.set_message(place(step, self.script));
                let at = at(step, self.script);
                self.say(&json!({ "event": "send", "number": number, "of": of, "line": step.line, "at": at }));
            }
            Event::Answered { step, lines } => {
                self.note(&format!("{}: {}", place(step, self.script), lines.join(" | ")));
                self.say(&json!({ "event": "answer", "line": step.line, "lines": lines }));
            }
            Event::Verifying(unit) => {
                self.bar.set_message(format!("verifying {unit}"));
                self.say(&json!({ "event": "verify", "program": unit.to_string() }));
            }
            Event::Saving(save) => {
                self.bar.set_message(format!("saving: {}", save.command()));
                self.say(&json!({ "event": "save", "command": save.command() }));
            }
            Event::Started(unit, running) => {
                let what = if running { "runs" } else { "has ended already, or stopped at an error" };
                self.note(&format!("{unit} {what}"));
                self.say(&json!({ "event": "start", "program": unit.to_string(), "running": running }));
            }
            Event::Tidying => TIDYING.store(true, Ordering::Relaxed),
            Event::Note(text) => {
                self.note(&format!("note: {text}"));
                self.say(&json!({ "event": "note", "text": text }));
            }
        }
    }

    fn interrupted(&mut self) -> bool {
        crate::commands::link::interrupted()
    }

    fn pause(&mut self, time: Duration) {
        std::thread::sleep(time);
    }
}

/// File and line of a step, or that it is ours.
pub(super) fn at(step: &Step, script: &Script) -> Option<String> {
    let place = step.place?;
    Some(format!("{}:{}", script.files.get(place.file)?.name, place.line))
}

fn place(step: &Step, script: &Script) -> String {
    at(step, script).unwrap_or_else(|| step.line.clone())
}
