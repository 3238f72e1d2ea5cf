//! The log of a server. Nobody waits for whoever reads it: what it cannot take is left out and counted.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::Duration;

use acrc_server::{Event, Histogram, Statistics};
use serde_json::{Value, json};

use super::SERVICES;
use crate::exit::{note, say};
use crate::output::{Terminal, print};

/// What may wait to be written.
const WAITING: usize = 4096;
/// When nothing more was read for so long at the end, nobody reads any more.
const PATIENCE: Duration = Duration::from_secs(1);

/// A line of the log.
enum Line {
    Note(String),
    /// Something has happened on the network.
    Event(Event),
    /// Something could not be saved.
    Failure(String),
    Statistics(Box<Statistics>),
}

/// Takes lines, and never waits.
#[derive(Clone)]
pub(super) struct Log {
    lines: SyncSender<Line>,
    /// Lines that were left out and not told of yet.
    left_out: Arc<AtomicU64>,
}

impl Log {
    pub(super) fn note(&self, text: String) {
        self.put(Line::Note(text));
    }

    pub(super) fn event(&self, event: &Event) {
        self.put(Line::Event(event.clone()));
    }

    pub(super) fn failure(&self, text: String) {
        self.put(Line::Failure(text));
    }

    pub(super) fn statistics(&self, statistics: Statistics) {
        self.put(Line::Statistics(Box::new(statistics)));
    }

    fn put(&self, line: Line) {
        if self.lines.try_send(line).is_err() {
            self.left_out.fetch_add(1, Ordering::Relaxed);
        }
    }
}

/// How a log is written.
#[derive(Clone, Copy)]
pub(super) struct Style {
    pub(super) json: bool,
    pub(super) verbose: bool,
    pub(super) terminal: Terminal,
}

/// The thread that writes the log.
pub(super) struct Writer {
    /// A sign when lines were written; it ends when the thread does.
    written: Receiver<()>,
}

impl Writer {
    pub(super) fn start(style: Style) -> (Log, Self) {
        let (lines, waiting) = sync_channel(WAITING);
        let left_out = Arc::new(AtomicU64::new(0));
        let (told, written) = sync_channel(1);
        let clerk = Clerk { style, left_out: Arc::clone(&left_out) };
        std::thread::spawn(move || {
            for line in waiting {
                clerk.write(&line);
                // One that waits already says the same.
                let _ = told.try_send(());
            }
            clerk.tell_of_lost();
        });
        (Log { lines, left_out }, Self { written })
    }

    /// Lets the rest be written, as long as somebody reads it.
    pub(super) fn finish(self, log: Log) {
        drop(log);
        while self.written.recv_timeout(PATIENCE).is_ok() {}
    }
}

struct Clerk {
    style: Style,
    left_out: Arc<AtomicU64>,
}

impl Clerk {
    fn write(&self, line: &Line) {
        self.tell_of_lost();
        match line {
            Line::Note(text) => self.note(text),
            Line::Event(event) => self.event(event),
            Line::Failure(text) => say(&anyhow::anyhow!("{text}"), self.style.terminal),
            Line::Statistics(statistics) => self.statistics(statistics),
        }
    }

    fn tell_of_lost(&self) {
        let count = self.left_out.swap(0, Ordering::Relaxed);
        if count == 0 {
            return;
        }
        if self.style.json {
            return print_line(&json!({ "event": "lost", "lines": count }));
        }
        let lines = if count == 1 { "line was" } else { "lines were" };
        note(&format!("{count} {lines} left out: nobody read them in time"), self.style.terminal);
    }

    fn note(&self, text: &str) {
        if self.style.json {
            return print_line(&json!({ "event": "note", "text": text }));
        }
        note(text, self.style.terminal);
    }

    fn event(&self, event: &Event) {
        if self.style.json {
            return print_line(&event_object(event));
        }
        if self.style.verbose || matches!(event, Event::Trouble { .. }) {
            note(&event.to_string(), self.style.terminal);
        }
    }

    fn statistics(&self, statistics: &Statistics) {
        if self.style.json {
            return print_line(&statistics_object(statistics));
        }
        let late = |histogram: &Histogram| {
            let at = |share| milliseconds(histogram.quantile(share));
            let longest = milliseconds(histogram.longest());
            format!("50 % within {:.2} ms, 99 % within {:.2} ms, all within {longest:.2} ms", at(0.5), at(0.99))
        };
        let Statistics { clients, refused, packets, slip, lost, lateness, left_out } = statistics;
        note(&format!("clients: {clients} served, {refused} refused, {packets} packets"), self.style.terminal);
        if slip.count() > 0 {
            note(&format!("time was behind: {}", late(slip)), self.style.terminal);
        }
        if !lost.is_zero() {
            note(&format!("{:.3} s could not be caught up with", lost.as_secs_f64()), self.style.terminal);
        }
        if lateness.count() > 0 {
            let sent = lateness.count();
            note(
                &format!("fast status: {sent} sent, {left_out} left out, late: {}", late(lateness)),
                self.style.terminal,
            );
        }
    }
}

fn milliseconds(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e3
}

/// Prints a line. A log that cannot be written any more ends nothing.
fn print_line(object: &Value) {
    let _ = print(|out| writeln!(out, "{object}"));
}

fn event_object(event: &Event) -> Value {
    let mut object = match event {
        Event::Connected { stream, .. } => {
            json!({ "event": "connected", "stream": stream.map(|name| name.to_string()) })
        }
        Event::Disconnected { reason, .. } => json!({ "event": "disconnected", "reason": reason.to_string() }),
        Event::Refused { .. } => json!({ "event": "refused" }),
        Event::Unreadable { problem, .. } => json!({ "event": "unreadable", "problem": problem }),
        Event::Declined { problem, .. } => json!({ "event": "declined", "problem": problem }),
        Event::Halted { .. } => json!({ "event": "halted" }),
        Event::Downloaded { bytes } => json!({ "event": "downloaded", "bytes": bytes }),
        Event::Rebooting => json!({ "event": "rebooting" }),
        Event::Rebooted => json!({ "event": "rebooted" }),
        Event::Trouble { problem, .. } => json!({ "event": "trouble", "problem": problem }),
    };
    if let Some(service) = event.service() {
        let port = SERVICES.iter().find(|(known, _)| *known == service).map(|(_, port)| *port);
        object["port"] = json!(port);
    }
    if let Some(peer) = event.peer() {
        object["peer"] = json!(peer);
    }
    object
}

fn statistics_object(statistics: &Statistics) -> Value {
    let Statistics { clients, refused, packets, slip, lost, lateness, left_out } = statistics;
    let late = |histogram: &Histogram| {
        json!({
            "count": histogram.count(),
            "ms_50": milliseconds(histogram.quantile(0.5)),
            "ms_99": milliseconds(histogram.quantile(0.99)),
            "ms_999": milliseconds(histogram.quantile(0.999)),
            "ms_max": milliseconds(histogram.longest()),
        })
    };
    json!({
        "event": "statistics", "clients": clients, "refused": refused, "packets": packets,
        "slip": late(slip), "lost_ms": milliseconds(*lost), "fast_status": late(lateness), "left_out": left_out,
    })
}
