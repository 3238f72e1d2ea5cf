//! `acrc diff`: compares a project with what a controller has.

use std::io::{self, Write};

use acrc_diagnostics::unified_diff;
use acrc_link::Protocol;
use acrc_link::download::{Comparison, Entry, Script, Standing, compare, survey};
use serde_json::{Value, json};

use super::link::{connect, failed, watch_interrupt};
use super::project::{compile, load};
use crate::cli::{ColorChoice, DiffArguments};
use crate::exit::Exit;
use crate::output::{Terminal, print};

pub(super) fn run(arguments: &DiffArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let terminal = Terminal::error(color);
    let project = load(&arguments.project)?;
    let Some(image) = compile(&project, "is not compared", terminal) else { return Ok(Exit::Failure) };
    let script = Script::any(&project, image);
    watch_interrupt()?;
    let survey = connect(&arguments.to, Protocol::Text).and_then(|mut connection| {
        let survey = survey(&mut connection, project.model)?;
        connection.close();
        Ok(survey)
    });
    let survey = match survey {
        Ok(survey) => survey,
        Err(error) => return Ok(failed(error, terminal)),
    };
    let comparison = compare(&script, &survey);
    for note in &comparison.notes {
        crate::exit::warn(note, terminal);
    }
    let protected = survey.protected.is_some();
    print(|out| {
        if arguments.json {
            writeln!(out, "{}", as_json(&comparison))
        } else {
            write_text(&comparison, Terminal::output(color), out)
        }
    })?;
    Ok(match (comparison.is_equal(), protected) {
        (_, true) => Exit::Failure,
        (true, false) => Exit::Clean,
        (false, false) => Exit::Findings,
    })
}

fn write_text(comparison: &Comparison, terminal: Terminal, out: &mut dyn Write) -> io::Result<()> {
    let joined = |lines: &[String]| lines.iter().flat_map(|line| [line.as_str(), "\n"]).collect::<String>();
    for pair in &comparison.programs {
        writeln!(out, "{}: {}", pair.unit, pair.standing.as_str())?;
    }
    for entry in comparison.entries.iter().filter(|entry| entry.standing != Standing::Equal) {
        writeln!(out, "{}: {}", entry.name, entry_text(entry))?;
    }
    for pair in comparison.programs.iter().filter(|pair| pair.standing == Standing::Different) {
        writeln!(out)?;
        let (old, new) = (joined(&pair.project), joined(&pair.controller));
        unified_diff(&pair.unit.to_string(), &old, &new, terminal.color, out)?;
    }
    Ok(())
}

fn entry_text(entry: &Entry) -> String {
    match (&entry.project, &entry.controller) {
        (Some(project), Some(controller)) => format!("{project} in the project, {controller} on the controller"),
        _ => entry.standing.as_str().to_owned(),
    }
}

fn as_json(comparison: &Comparison) -> Value {
    let standing = |standing: Standing| match standing {
        Standing::Equal => "equal",
        Standing::Different => "different",
        Standing::OnlyProject => "missing",
        Standing::OnlyController => "extra",
    };
    let programs: Vec<Value> = comparison
        .programs
        .iter()
        .map(|pair| {
            let (project, controller) = (&pair.project, &pair.controller);
            json!({
                "program": pair.unit.to_string(), "standing": standing(pair.standing),
                "project": project, "controller": controller,
            })
        })
        .collect();
    let entries: Vec<Value> = comparison
        .entries
        .iter()
        .map(|entry| {
            json!({
                "name": entry.name, "standing": standing(entry.standing),
                "project": entry.project, "controller": entry.controller,
            })
        })
        .collect();
    json!({ "equal": comparison.is_equal(), "programs": programs, "entries": entries, "notes": comparison.notes })
}
