//! `acrc reset-kamr`: clears the flags that keep motion from starting (guide, "Kill All Motion Request vs. Kill All Moves").

use acrc_catalog::{ObjectKind, default_model, law};
use acrc_link::values::{Named, Register, Value, read};
use acrc_link::{Connection, Console as _, LinkError, Protocol, Tcp};
use anyhow::bail;
use serde_json::json;

use super::link::{Consent, confirm, connect, failed, watch_interrupt};
use crate::cli::{ColorChoice, ResetKamrArguments};
use crate::exit::Exit;
use crate::output::{Terminal, print};

/// Ctrl-Y: clears every Kill All Motion Request, and every Kill All Moves.
const CLEAR_KILL: u8 = 0x19;

pub(super) fn run(arguments: &ResetKamrArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let terminal = Terminal::error(color);
    watch_interrupt()?;
    let opened = connect(&arguments.to, Protocol::Text);
    let before = opened.and_then(|mut connection| set_flags(&mut connection).map(|set| (connection, set)));
    let (mut connection, before) = match before {
        Ok(both) => both,
        Err(error) => return Ok(failed(error, terminal)),
    };
    if arguments.show || before.is_empty() {
        return show(arguments.json, &before, &before);
    }
    if !arguments.yes {
        let question = format!("Set:\n  {}\nClear all of them at {}?", lines(&before), arguments.to.to);
        match confirm(&question, "clearing them lets motion start again")? {
            Consent::Given => {}
            Consent::Denied => bail!("nothing was cleared"),
            Consent::Interrupted => return Ok(Exit::Interrupted),
        }
    }
    let after = connection.send_key(CLEAR_KILL).and_then(|()| set_flags(&mut connection));
    match after {
        Ok(after) => show(arguments.json, &before, &after),
        Err(error) => Ok(failed(error, terminal)),
    }
}

/// The flags that are set.
fn set_flags(connection: &mut Connection<Tcp>) -> Result<Vec<Named>, LinkError> {
    let model = default_model();
    let of = |kind: ObjectKind, count: u8, law: acrc_catalog::Law, name: &'static str| {
        (0..u32::from(count)).filter_map(move |index| {
            Some(Named { name: format!("{kind}{index}.{name}"), register: Register::Bit(law.get(index)?) })
        })
    };
    let axes = of(ObjectKind::Axis, model.axes, law::KILL_ALL_MOTION_REQUEST, "kill_all_motion_request");
    let masters = of(ObjectKind::Master, model.masters, law::KILL_ALL_MOVES, "kill_all_moves");
    let all: Vec<Named> = axes.chain(masters).collect();
    let registers: Vec<Register> = all.iter().map(|named| named.register).collect();
    let values = read(connection, &registers)?;
    let set = all.into_iter().zip(values).filter(|(_, value)| *value == Value::Flag(true));
    Ok(set.map(|(named, _)| named).collect())
}

fn lines(flags: &[Named]) -> String {
    let line = |named: &Named| format!("{} ({})", named.name, named.register);
    flags.iter().map(line).collect::<Vec<_>>().join("\n  ")
}

fn show(json: bool, before: &[Named], after: &[Named]) -> anyhow::Result<Exit> {
    let names = |flags: &[Named]| flags.iter().map(|named| named.name.clone()).collect::<Vec<_>>();
    print(|out| match (json, before, after) {
        (true, ..) => writeln!(out, "{}", json!({ "before": names(before), "set": names(after) })),
        (_, [], _) => writeln!(out, "no axis has a kill request, and no master"),
        (_, _, []) => writeln!(out, "cleared:\n  {}", lines(before)),
        (..) => writeln!(out, "set:\n  {}", lines(after)),
    })?;
    Ok(if after.is_empty() { Exit::Clean } else { Exit::Findings })
}
