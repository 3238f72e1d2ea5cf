//! `acrc move`: moves axes of a program, shows where they are, and stops them at Ctrl-C.

use std::io::{IsTerminal as _, Write as _};
use std::time::{Duration, Instant};

use acrc_link::motion::{Axis, Group, MoveError, Target};
use acrc_link::{Connection, LinkError, Protocol, Tcp};
use anyhow::bail;
use serde_json::json;

use super::link::{Consent, confirm, connect, failed, interrupted, watch_interrupt};
use crate::cli::{ColorChoice, MoveArguments};
use crate::exit::{Exit, note};
use crate::output::{Terminal, print};

/// From one look at the move to the next.
const BEAT: Duration = Duration::from_millis(50);
/// How long a stop may take before the rest is left to a person.
const STOPPING: Duration = Duration::from_secs(10);

/// How a move ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Arrived,
    /// The controller ended it.
    Killed,
    /// The user ended it.
    Stopped,
    /// The user ended it, and it still moves.
    Stopping,
}

pub(super) fn run(arguments: &MoveArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let terminal = Terminal::error(color);
    watch_interrupt()?;
    let mut connection = match connect(&arguments.to, Protocol::Text) {
        Ok(connection) => connection,
        Err(error) => return Ok(failed(error, terminal)),
    };
    match ordered(arguments, &mut connection, terminal) {
        Err(error) => match error.downcast::<MoveError>() {
            Ok(MoveError::Link(error)) => Ok(failed(error, terminal)),
            Ok(error) => Err(error.into()),
            Err(error) => Err(error),
        },
        result => result,
    }
}

fn ordered(arguments: &MoveArguments, connection: &mut Connection<Tcp>, terminal: Terminal) -> anyhow::Result<Exit> {
    let group = Group::find(connection, arguments.prog)?;
    let axes = group.moved(&arguments.targets)?;
    let obstacles = group.obstacles(connection).map_err(MoveError::Link)?;
    if !obstacles.is_empty() {
        let list: Vec<String> = obstacles.iter().map(ToString::to_string).collect();
        crate::exit::say(&anyhow::anyhow!("the axes cannot be moved:\n  {}", list.join("\n  ")), terminal);
        return Ok(Exit::Findings);
    }
    if !arguments.yes {
        let plan = plan(&group, connection, &axes, &arguments.targets).map_err(MoveError::Link)?;
        match confirm(&format!("{plan}\nMove at {}?", arguments.to.to), "a move has to be confirmed")? {
            Consent::Given => {}
            Consent::Denied => bail!("nothing was moved"),
            Consent::Interrupted => return Ok(Exit::Interrupted),
        }
    }
    if interrupted() {
        return Ok(Exit::Interrupted);
    }
    // From here on Ctrl-C shall stop the move, and not the question that is under way.
    connection.finish_undisturbed();
    let before = match arguments.velocity {
        Some(velocity) => Some(group.set_velocity(connection, velocity).map_err(MoveError::Link)?),
        None => None,
    };
    let started = group.start(connection, &arguments.targets);
    if let (Some(velocity), Ok(()) | Err(LinkError::Refused { .. })) = (before, &started) {
        // The move has taken its velocity along; the program shall find its own.
        group.set_velocity(connection, velocity).map_err(MoveError::Link)?;
    }
    started.map_err(MoveError::Link)?;
    let end = follow(&group, connection, &axes, arguments.json).inspect_err(|_| {
        note("the move goes on: nothing was sent to stop it", terminal);
    });
    let end = end.map_err(MoveError::Link)?;
    finish(arguments, &group, connection, &axes, end, terminal)
}

/// What the move does, in a line for each axis.
fn plan(
    group: &Group,
    connection: &mut Connection<Tcp>,
    axes: &[&Axis],
    targets: &[Target],
) -> Result<String, LinkError> {
    let mut lines = Vec::new();
    for (axis, target) in axes.iter().zip(targets) {
        let from = group.position(connection, axis)?;
        let to = if target.incremental { from + target.value } else { target.value };
        lines.push(format!("{} (AXIS{}) from {from} to {to}", axis.name, axis.number));
    }
    Ok(lines.join("\n"))
}

/// Shows the position until the master stands. Ctrl-C stops it.
fn follow(group: &Group, connection: &mut Connection<Tcp>, axes: &[&Axis], quiet: bool) -> Result<End, LinkError> {
    let shown = !quiet && std::io::stderr().is_terminal();
    let mut stopped: Option<Instant> = None;
    while group.is_moving(connection)? {
        if interrupted() && stopped.is_none() {
            group.stop(connection)?;
            stopped = Some(Instant::now());
        }
        if stopped.is_some_and(|since| since.elapsed() > STOPPING) {
            return Ok(End::Stopping);
        }
        if shown {
            show(&positions(group, connection, axes)?);
        }
        std::thread::sleep(BEAT);
    }
    if shown {
        show(&positions(group, connection, axes)?);
        show_line();
    }
    Ok(match (stopped, group.is_killed(connection)?) {
        (Some(_), _) => End::Stopped,
        (None, true) => End::Killed,
        (None, false) => End::Arrived,
    })
}

fn positions(group: &Group, connection: &mut Connection<Tcp>, axes: &[&Axis]) -> Result<Vec<(String, f64)>, LinkError> {
    axes.iter().map(|axis| Ok((axis.name.clone(), group.position(connection, axis)?))).collect()
}

fn line(positions: &[(String, f64)]) -> String {
    positions.iter().map(|(name, position)| format!("{name} {position}")).collect::<Vec<_>>().join("  ")
}

/// Overwrites the line of the terminal.
fn show(positions: &[(String, f64)]) {
    // Nothing depends on what is shown meanwhile.
    let _ = write!(std::io::stderr(), "\r{}\u{1b}[K", line(positions));
}

fn show_line() {
    let _ = writeln!(std::io::stderr());
}

fn finish(
    arguments: &MoveArguments,
    group: &Group,
    connection: &mut Connection<Tcp>,
    axes: &[&Axis],
    end: End,
    terminal: Terminal,
) -> anyhow::Result<Exit> {
    let positions = positions(group, connection, axes).map_err(MoveError::Link)?;
    let words = match end {
        End::Arrived => "arrived",
        End::Killed => "killed",
        End::Stopped => "stopped",
        End::Stopping => "stopping",
    };
    print(|out| {
        if arguments.json {
            let positions: serde_json::Map<_, _> =
                positions.iter().map(|(name, position)| (name.clone(), json!(position))).collect();
            return writeln!(out, "{}", json!({ "end": words, "positions": positions }));
        }
        writeln!(out, "{words} at {}", line(&positions))
    })?;
    let master = group.master;
    match end {
        End::Arrived => return Ok(Exit::Clean),
        End::Killed => note(
            &format!("Kill All Moves of MASTER{master} is set: a limit, a fault or somebody ended the move"),
            terminal,
        ),
        End::Stopped => note(&format!("Kill All Moves of MASTER{master} is set: acrc reset-kamr clears it"), terminal),
        End::Stopping => note(&format!("MASTER{master} still moves: Stop All Moves did not end the move"), terminal),
    }
    Ok(if end == End::Killed { Exit::Findings } else { Exit::Interrupted })
}
