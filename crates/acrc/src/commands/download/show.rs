//! Plans, objections, failures and results in words.

use std::io::{self, Write};

use acrc_link::LinkError;
use acrc_link::download::{Cause, Erased, Failure, Fate, Objection, Plan, State};
use serde_json::{Value, json};

use super::progress::at;
use super::{Order, is_interrupted, show_problems};
use crate::commands::project::title;
use crate::output::{print, tell};

/// What a plan comes to.
pub(super) fn summary(plan: &Plan, order: &Order) {
    tell(|err| write_summary(plan, order, err));
}

fn write_summary(plan: &Plan, order: &Order, out: &mut dyn Write) -> io::Result<()> {
    let (to, model) = (&order.arguments.to.to, order.project.model.name);
    writeln!(out, "{} to {to} ({model})", title(order.project))?;
    write_erased(plan, out)?;
    for unit in plan.state.with(Fate::Old).filter(|unit| !plan.erased.iter().any(|erased| erased.unit == *unit)) {
        writeln!(out, "  stays    {unit}, which the project does not have")?;
    }
    for unit in &plan.kept {
        writeln!(out, "  kept     {unit}, the same is there already")?;
    }
    writeln!(out, "  sent     {} lines", plan.steps.len() + plan.protect.len())?;
    for (place, note) in &plan.notes {
        let file = place.and_then(|place| Some((order.script.files.get(place.file)?, place.line)));
        match file {
            Some((file, line)) => writeln!(out, "  note     {}:{line}: {note}", file.name)?,
            None => writeln!(out, "  note     {note}")?,
        }
    }
    if order.settings.unverified {
        writeln!(out, "  then     nothing is verified")?;
    } else {
        writeln!(out, "  then     every program is listed and compared")?;
    }
    for save in &order.settings.save {
        writeln!(out, "  then     {}", save.command())?;
    }
    for unit in &order.settings.run {
        writeln!(out, "  then     RUN {unit}")?;
    }
    Ok(())
}

fn write_erased(plan: &Plan, out: &mut dyn Write) -> io::Result<()> {
    if plan.whole {
        writeln!(out, "  erased   all programs, memory, aliases and variables of the controller")?;
    }
    for Erased { unit, lines, bytes } in &plan.erased {
        let size = bytes.map_or_else(String::new, |bytes| format!(", {bytes} bytes"));
        match lines {
            Some(1) => writeln!(out, "  erased   {unit}, 1 line{size}")?,
            Some(lines) => writeln!(out, "  erased   {unit}, {lines} lines{size}")?,
            None => writeln!(out, "  erased   {unit}, if there is one: the controller does not show it")?,
        }
    }
    if !plan.freed.is_empty() {
        let blocks: Vec<String> = plan.freed.iter().map(|(block, size)| format!("{block}({size})")).collect();
        writeln!(out, "  erased   DIM {}", blocks.join(" "))?;
    }
    match plan.forgotten {
        0 => Ok(()),
        1 => writeln!(out, "  erased   1 alias"),
        count => writeln!(out, "  erased   {count} aliases"),
    }
}

/// The whole plan, on standard output.
pub(super) fn plan(plan: &Plan, order: &Order) -> anyhow::Result<()> {
    if order.arguments.json {
        return print(|out| writeln!(out, "{}", plan_json(plan, order)));
    }
    print(|out| {
        write_summary(plan, order, out)?;
        writeln!(out)?;
        let places: Vec<String> = plan.steps.iter().map(|step| at(step, &order.script).unwrap_or_default()).collect();
        let width = places.iter().map(String::len).max().unwrap_or(0);
        for (step, place) in plan.steps.iter().zip(&places) {
            writeln!(out, "{place:<width$}  {}", step.line)?;
        }
        plan.protect.iter().try_for_each(|step| writeln!(out, "{:<width$}  {} (behind the comparison)", "", step.line))
    })
}

pub(super) fn plan_json(plan: &Plan, order: &Order) -> Value {
    let erased = plan.erased.iter();
    let erased: Vec<Value> =
        erased.map(|one| json!({ "program": one.unit.to_string(), "lines": one.lines, "bytes": one.bytes })).collect();
    let freed: Vec<String> = plan.freed.iter().map(|(block, size)| format!("{block}({size})")).collect();
    let kept: Vec<String> = plan.kept.iter().map(ToString::to_string).collect();
    let steps = plan.steps.iter().chain(&plan.protect);
    let steps: Vec<Value> = steps.map(|step| json!({ "line": step.line, "at": at(step, &order.script) })).collect();
    let notes: Vec<Value> =
        plan.notes.iter().map(|(place, note)| json!({ "text": note, "line": place.map(|place| place.line) })).collect();
    json!({
        "event": "plan", "whole": plan.whole, "erased": erased, "freed": freed, "kept": kept, "steps": steps, "notes": notes,
    })
}

/// For a program: nothing was sent, as the controller could not be asked.
pub(super) fn unreached(error: &LinkError, order: &Order) {
    refused(&[json!({ "text": error.to_string(), "help": null })], order);
}

fn refused(objections: &[Value], order: &Order) {
    if order.arguments.json {
        // A reader that has gone changes nothing.
        let _ = print(|out| writeln!(out, "{}", json!({ "event": "refused", "objections": objections })));
    }
}

/// Why nothing was sent, or nothing more since the connection broke.
pub(super) fn objections(objections: &[Objection], order: &Order, before: Option<&Failure>) {
    let list: Vec<Value> =
        objections.iter().map(|one| json!({ "text": one.to_string(), "help": one.help() })).collect();
    refused(&list, order);
    let word = order.terminal.error_word("error:");
    tell(|err| {
        for objection in objections {
            writeln!(err, "{word} {objection}\n  help: {}", objection.help())?;
        }
        match before {
            None => writeln!(err, "{} is not sent: nothing was changed on the controller", title(order.project)),
            Some(failure) => writeln!(err, "state of the controller: {}", failure.state),
        }
    });
}

/// What went wrong, in which state the controller is, and how to go on.
pub(super) fn failure(failure: &Failure, order: &Order) -> anyhow::Result<()> {
    if order.arguments.json {
        let event = json!({
            "event": "failed",
            "cause": failure.cause.to_string(),
            "line": failure.step.as_ref().map(|step| step.line.clone()),
            "at": failure.step.as_ref().and_then(|step| at(step, &order.script)),
            "tidied": failure.tidied,
            "state": state_json(&failure.state),
        });
        print(|out| writeln!(out, "{event}"))?;
    }
    if let Some(problem) = failure.problem() {
        show_problems(order.project, vec![problem], "did not arrive as a whole", order.terminal);
    }
    let word = order.terminal.error_word("error:");
    tell(|err| {
        match &failure.step {
            Some(step) => {
                let place = at(step, &order.script).map_or_else(String::new, |at| format!(" ({at})"));
                writeln!(err, "{word} {}, at `{}`{place}", failure.cause, step.line)?;
            }
            None => writeln!(err, "{word} {}", failure.cause)?,
        }
        if let Cause::Different(_, difference) = &failure.cause {
            let shown = |line: &Option<String>| line.clone().unwrap_or_else(|| "(nothing)".to_owned());
            writeln!(err, "  expected: {}\n  found:    {}", shown(&difference.expected), shown(&difference.found))?;
        }
        if let Some(tidied) = &failure.tidied {
            writeln!(err, "{tidied}")?;
        }
        writeln!(err, "state of the controller: {}", failure.state)?;
        let again = match &failure.cause {
            _ if is_interrupted(failure) => "the same command goes on from here",
            Cause::Link(_) => "when it can be reached again, the same command goes on from here",
            _ => "when the cause is removed, the same command goes on from here",
        };
        writeln!(err, "{again}")
    });
    Ok(())
}

/// What was done.
pub(super) fn done(state: &State, plan: &Plan, order: &Order) -> anyhow::Result<()> {
    if order.arguments.json {
        return print(|out| writeln!(out, "{}", json!({ "event": "done", "state": state_json(state) })));
    }
    let verified = state.with(Fate::Verified).count();
    let programs = |count: usize| if count == 1 { "1 program".to_owned() } else { format!("{count} programs") };
    print(|out| {
        let lines = plan.steps.len() + plan.protect.len();
        write!(out, "{} to {}: {lines} lines sent", title(order.project), order.arguments.to.to)?;
        if !plan.kept.is_empty() {
            write!(out, ", {} kept", programs(plan.kept.len()))?;
        }
        if order.settings.unverified {
            writeln!(out, ", not verified")
        } else {
            writeln!(out, ", {} verified", programs(verified))
        }
    })
}

fn state_json(state: &State) -> Value {
    let fate = |fate: Fate| match fate {
        Fate::Missing => "missing",
        Fate::Old => "old",
        Fate::Kept => "kept",
        Fate::Erased => "erased",
        Fate::Partial => "partial",
        Fate::Sent => "sent",
        Fate::Verified => "verified",
    };
    let programs: serde_json::Map<String, Value> =
        state.programs.iter().map(|(unit, one)| (unit.to_string(), fate(*one).into())).collect();
    json!({ "done": state.done, "lines": state.lines, "cleared": state.cleared, "programs": programs })
}
