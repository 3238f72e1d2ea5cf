//! `acrc serve`: a virtual controller on the network.
//!
//! The server has its own threads, which must not wait for anybody. What they have to tell (who connects, run-time errors, what is to be saved)
//! goes to this one, which writes it.

use std::io;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::Duration;

use acrc_controller::nonvolatile::Saved;
use acrc_controller::world::WorldEvent;
use acrc_controller::{Controller, FaultReport, Observer, Sent, StreamName, View};
use acrc_server::{Config, Event, Finished, Handle, Histogram, Server, Service, Statistics};
use acrc_wire::ethernet::{ASCII_PORT, COMMAND_STREAMS, FAST_STATUS_PORT, MANAGEMENT_PORT, MIXED_PORT};
use anyhow::{Context as _, bail};
use serde_json::{Value, json};

use super::nonvolatile::State;
use super::virtual_controller::{Wanted, describe_programs, power_up, unseen};
use crate::cli::{ColorChoice, ServeArguments, Speed};
use crate::exit::{Exit, note, say, warn};
use crate::output::{Terminal, print};

/// What may wait to be written.
const WAITING: usize = 4096;

/// The services with the ports of a real controller.
const SERVICES: [(Service, u16); 4] = [
    (Service::Ascii, ASCII_PORT),
    (Service::FastStatus, FAST_STATUS_PORT),
    (Service::Management, MANAGEMENT_PORT),
    (Service::Mixed, MIXED_PORT),
];

/// What other threads have to tell.
enum Message {
    /// A line for the log.
    Note(String),
    /// Something has happened on the network.
    Event(Event),
    /// A command has changed what outlasts a reset.
    Saved(Box<Saved>),
    /// Ctrl-C, or SIGTERM.
    Stop,
    /// The server has ended.
    Finished(Box<io::Result<Finished>>),
}

pub(super) fn run(arguments: &ServeArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let state = arguments.state.as_deref().map(State::open).transpose()?;
    let wanted = Wanted {
        project: arguments.project.as_deref(),
        model: arguments.model,
        world: arguments.world.as_deref(),
        battery: !arguments.no_battery,
        seed: arguments.seed,
        user_alarm: arguments.user_alarm,
        rapid_move_modes: arguments.rapid_move_modes,
    };
    let Some((name, controller)) = power_up(&wanted, state.as_ref(), color)? else { return Ok(Exit::Findings) };
    let (sender, messages) = sync_channel(WAITING);
    let stop = sender.clone();
    ctrlc::set_handler(move || {
        // When nobody takes messages any more, the end is near anyway.
        if stop.try_send(Message::Stop).is_err() {
            std::process::exit(Exit::Interrupted.status().into());
        }
    })
    .context("cannot watch for Ctrl-C")?;
    let server = start(arguments, controller, &sender)?;
    announce(arguments, &server, &name, Terminal::error(color))?;
    let handle = server.handle();
    std::thread::spawn(move || {
        let finished = Message::Finished(Box::new(server.wait()));
        drop(sender.send(finished));
    });
    Clerk { arguments, state, failure: None, terminal: Terminal::error(color) }.work(&messages, handle)
}

fn start(arguments: &ServeArguments, controller: Controller, sender: &SyncSender<Message>) -> anyhow::Result<Server> {
    let log = sender.clone();
    let config = Config {
        address: arguments.bind,
        ports: arguments.ports,
        speed: match arguments.speed {
            Speed::Factor(factor) => acrc_server::Speed::Factor(factor),
            Speed::Max => acrc_server::Speed::Max,
        },
        wire: arguments.wire,
        log: Box::new(move |event| drop(log.try_send(Message::Event(event.clone())))),
        ..Config::new(Teller(sender.clone()))
    };
    Ok(Server::bind(controller, config)?)
}

/// Says where the server listens, and to whom.
fn announce(arguments: &ServeArguments, server: &Server, project: &str, terminal: Terminal) -> anyhow::Result<()> {
    let (model, programs) = server.handle().look(|controller| (controller.model().name, describe_programs(controller)));
    let streams: Vec<String> = server.streams().iter().map(ToString::to_string).collect();
    let ports = SERVICES.map(|(service, port)| (port.to_string(), server.address(service).port()));
    print(|out| {
        if arguments.json {
            let ports: serde_json::Map<String, Value> =
                ports.iter().map(|(name, port)| (name.clone(), Value::from(*port))).collect();
            let line = json!({
                "event": "listening", "address": arguments.bind, "ports": ports, "model": model, "project": project,
                "streams": streams,
            });
            return writeln!(out, "{line}");
        }
        let ports = ports.map(|(name, port)| format!("{name}={port}")).join(" ");
        writeln!(out, "{model} (virtual), {project}: {programs}")?;
        writeln!(out, "listening at {}: {ports}", arguments.bind)?;
        writeln!(out, "{} for the clients of {ASCII_PORT} and {MIXED_PORT}; Ctrl-C ends", streams.join(", "))
    })?;
    if !arguments.bind.is_loopback() {
        warn(
            &format!(
                "whoever reaches {} can change programs and move this virtual machine: nobody is asked who he is. No real machine \
                 is behind it",
                if arguments.bind.is_unspecified() { "this computer".to_owned() } else { arguments.bind.to_string() }
            ),
            terminal,
        );
    }
    Ok(())
}

/// Writes what the threads of the server tell.
struct Clerk<'a> {
    arguments: &'a ServeArguments,
    state: Option<State>,
    /// Why something could not be saved.
    failure: Option<anyhow::Error>,
    terminal: Terminal,
}

impl Clerk<'_> {
    fn work(mut self, messages: &Receiver<Message>, handle: Handle) -> anyhow::Result<Exit> {
        let mut handle = Some(handle);
        loop {
            match messages.recv().context("the server has failed")? {
                Message::Note(text) => self.note(&text)?,
                Message::Event(event) => self.event(&event)?,
                Message::Saved(saved) => self.save(&saved),
                // The controller comes back from the server only when nobody else has it.
                Message::Stop => match handle.take() {
                    Some(handle) => handle.shutdown(),
                    None => return Ok(Exit::Interrupted),
                },
                Message::Finished(finished) => return self.finish(*finished),
            }
        }
    }

    fn note(&self, text: &str) -> anyhow::Result<()> {
        if self.arguments.json {
            return print_line(&json!({ "event": "note", "text": text }));
        }
        note(text, self.terminal);
        Ok(())
    }

    fn event(&self, event: &Event) -> anyhow::Result<()> {
        if self.arguments.json {
            return print_line(&event_object(event));
        }
        if self.arguments.verbose || matches!(event, Event::Trouble { .. }) {
            note(&event.to_string(), self.terminal);
        }
        Ok(())
    }

    fn save(&mut self, saved: &Saved) {
        let result = self.state.as_mut().map_or(Ok(()), |state| state.save(saved));
        if let Err(error) = result {
            say(&error, self.terminal);
            self.failure.get_or_insert(error);
        }
    }

    fn finish(mut self, finished: io::Result<Finished>) -> anyhow::Result<Exit> {
        let Finished { controller, statistics, .. } = finished.context("the server has failed")?;
        if self.state.is_some() {
            let Some(mut controller) = controller else { bail!("the state was not saved") };
            self.save(&controller.saved());
        }
        if self.arguments.stats {
            self.statistics(&statistics)?;
        }
        self.failure.map_or(Ok(Exit::Interrupted), Err)
    }

    fn statistics(&self, statistics: &Statistics) -> anyhow::Result<()> {
        if self.arguments.json {
            return print_line(&statistics_object(statistics));
        }
        let late = |histogram: &Histogram| {
            let at = |share| milliseconds(histogram.quantile(share));
            let longest = milliseconds(histogram.longest());
            format!("50 % within {:.2} ms, 99 % within {:.2} ms, all within {longest:.2} ms", at(0.5), at(0.99))
        };
        let Statistics { clients, refused, packets, slip, lost, lateness, left_out } = statistics;
        note(&format!("clients: {clients} served, {refused} refused, {packets} packets"), self.terminal);
        if slip.count() > 0 {
            note(&format!("time was behind: {}", late(slip)), self.terminal);
        }
        if !lost.is_zero() {
            note(&format!("{:.3} s could not be caught up with", lost.as_secs_f64()), self.terminal);
        }
        if lateness.count() > 0 {
            let sent = lateness.count();
            note(&format!("fast status: {sent} sent, {left_out} left out, late: {}", late(lateness)), self.terminal);
        }
        Ok(())
    }
}

fn milliseconds(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e3
}

fn print_line(object: &Value) -> anyhow::Result<()> {
    print(|out| writeln!(out, "{object}"))
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

/// Tells the clerk what the controller does. The log loses what the clerk cannot take; what is to be saved waits for it.
struct Teller(SyncSender<Message>);

impl Teller {
    fn note(&self, text: String) {
        drop(self.0.try_send(Message::Note(text)));
    }
}

impl Observer for Teller {
    fn output(&mut self, sent: &Sent) {
        let has_clients = |stream| matches!(stream, StreamName::Stream(number) if COMMAND_STREAMS.contains(&number));
        if let Some(text) = unseen(sent, has_clients) {
            self.note(text);
        }
    }

    fn fault(&mut self, fault: &FaultReport) {
        if !fault.heard {
            self.note(fault.to_string());
        }
    }

    fn saved(&mut self, saved: &Saved) {
        drop(self.0.send(Message::Saved(Box::new(saved.clone()))));
    }

    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}

    fn tick(&mut self, _: &View) {}

    fn watches_every_tick(&self) -> bool {
        false
    }
}
