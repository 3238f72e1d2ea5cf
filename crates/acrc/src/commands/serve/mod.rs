//! `acrc serve`: a virtual controller on the network.
//!
//! The server has its own threads, which must not wait for anybody. What they have to tell (who connects, run-time errors)
//! goes to a thread that writes the log, what is to be saved to another one, and this one waits for the end.

mod log;
mod saver;

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, channel};

use acrc_controller::nonvolatile::Saved;
use acrc_controller::world::WorldEvent;
use acrc_controller::{Controller, FaultReport, Observer, Sent, StreamName, View};
use acrc_server::{Config, Finished, Handle, Server, Service};
use acrc_wire::ethernet::{ASCII_PORT, COMMAND_STREAMS, FAST_STATUS_PORT, MANAGEMENT_PORT, MIXED_PORT};
use anyhow::Context as _;
use serde_json::{Value, json};

use self::log::{Log, Style, Writer};
use self::saver::{Saver, ToSave};
use super::nonvolatile::State;
use super::virtual_controller::{Wanted, describe_programs, power_up, unseen};
use crate::cli::{ColorChoice, ServeArguments, Speed};
use crate::exit::{Exit, warn};
use crate::output::{Terminal, print};

/// The services with the ports of a real controller.
const SERVICES: [(Service, u16); 4] = [
    (Service::Ascii, ASCII_PORT),
    (Service::FastStatus, FAST_STATUS_PORT),
    (Service::Management, MANAGEMENT_PORT),
    (Service::Mixed, MIXED_PORT),
];

/// What this thread waits for.
enum Message {
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
    let (sender, messages) = channel();
    let stop = sender.clone();
    let stopped = AtomicBool::new(false);
    ctrlc::set_handler(move || {
        // A second one ends it at once, also when this thread waits for whoever reads what it says.
        if stopped.swap(true, Ordering::Relaxed) || stop.send(Message::Stop).is_err() {
            std::process::exit(Exit::Interrupted.status().into());
        }
    })
    .context("cannot watch for Ctrl-C")?;
    let terminal = Terminal::error(color);
    let (log, writer) = Writer::start(Style { json: arguments.json, verbose: arguments.verbose, terminal });
    let to_save = ToSave::default();
    let keeps = state.is_some();
    let server = start(arguments, controller, &log, keeps.then(|| to_save.clone()))?;
    announce(arguments, &server, &name, terminal)?;
    let saver = state.map(|state| Saver::start(state, to_save, log.clone()));
    let handle = server.handle();
    std::thread::spawn(move || sender.send(Message::Finished(Box::new(server.wait()))));
    let (last, statistics) = match finished(&messages, handle) {
        Ok(Finished { controller, statistics, .. }) => (controller.map(|mut last| last.saved()), Ok(statistics)),
        Err(error) => (None, Err(error)),
    };
    // What waits to be saved is saved also when the server has failed.
    let saved = saver.map_or(Ok(()), |saver| saver.finish(last.as_ref()));
    let statistics = statistics?;
    if arguments.stats {
        log.statistics(statistics);
    }
    writer.finish(log);
    saved.map(|()| Exit::Interrupted)
}

/// Ends the server when that is wanted, and waits until it has ended.
fn finished(messages: &Receiver<Message>, handle: Handle) -> anyhow::Result<Finished> {
    let mut handle = Some(handle);
    loop {
        match messages.recv().context("the server has failed")? {
            Message::Stop => _ = handle.take().map(Handle::end),
            Message::Finished(finished) => return finished.context("the server has failed"),
        }
    }
}

fn start(
    arguments: &ServeArguments,
    controller: Controller,
    log: &Log,
    to_save: Option<ToSave>,
) -> anyhow::Result<Server> {
    let events = log.clone();
    let config = Config {
        address: arguments.bind,
        ports: arguments.ports,
        speed: match arguments.speed {
            Speed::Factor(factor) => acrc_server::Speed::Factor(factor),
            Speed::Max => acrc_server::Speed::Max,
        },
        wire: arguments.wire,
        log: Box::new(move |event| events.event(event)),
        ..Config::new(Teller { log: log.clone(), to_save })
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

/// Tells others what the controller does. It is called while everybody waits for the controller, so it waits for nobody.
struct Teller {
    log: Log,
    /// `None` without `--state`.
    to_save: Option<ToSave>,
}

impl Observer for Teller {
    fn output(&mut self, sent: &Sent) {
        let has_clients = |stream| matches!(stream, StreamName::Stream(number) if COMMAND_STREAMS.contains(&number));
        if let Some(text) = unseen(sent, has_clients) {
            self.log.note(text);
        }
    }

    fn fault(&mut self, fault: &FaultReport) {
        if !fault.heard {
            self.log.note(fault.to_string());
        }
    }

    fn saved(&mut self, saved: &Saved) {
        if let Some(to_save) = &self.to_save {
            to_save.put(saved);
        }
    }

    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}

    fn tick(&mut self, _: &View) {}

    fn watches_every_tick(&self) -> bool {
        false
    }
}
