//! The summary of a run for a person.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Duration;

use acrc_analysis::project::LoadedProject;
use acrc_controller::{AxisReport, Controller, Port, Stopped};

use super::observer::Record;
use crate::cli::Register;
use crate::output::{Terminal, print as write_out};

/// A run that is over.
pub(super) struct Report<'a> {
    /// What a person calls the project.
    pub(super) title: &'a str,
    /// The project; `None` for programs that the controller has kept.
    pub(super) project: Option<&'a LoadedProject>,
    pub(super) controller: &'a Controller,
    pub(super) record: &'a Record,
    pub(super) stopped: Stopped,
    pub(super) read: &'a [Register],
    /// What the reader of the run has to know about its limits.
    pub(super) notes: &'a [String],
}

impl Report<'_> {
    /// The value of a register as a program would print it; why not, otherwise.
    pub(super) fn value(&self, register: Register) -> Result<acrc_vm::Value, String> {
        let value = match register {
            Register::Parameter(number) => self.controller.parameter(i64::from(number)),
            Register::Bit(number) => self.controller.bit(i64::from(number)).map(acrc_vm::Value::truth_value),
        };
        value.map_err(|error| error.to_string())
    }
}

/// Prints the summary.
pub(super) fn print(
    report: &Report,
    wall: Duration,
    until: f64,
    files: &[(&'static str, PathBuf)],
    terminal: Terminal,
) -> anyhow::Result<()> {
    let mut text = String::new();
    headline(&mut text, report, wall, until, terminal);
    programs(&mut text, report, terminal);
    axes(&mut text, report, terminal);
    masters(&mut text, report, terminal);
    values(&mut text, report, terminal);
    notes(&mut text, report, terminal);
    for (what, path) in files {
        section(&mut text, terminal, what, &[path.display().to_string()]);
    }
    write_out(|out| out.write_all(text.as_bytes()))
}

fn headline(text: &mut String, report: &Report, wall: Duration, until: f64, terminal: Terminal) {
    let seconds = report.controller.seconds();
    let what = match report.stopped {
        Stopped::Ended => "ended: no program runs and nothing moves".to_owned(),
        Stopped::Until => format!("stopped at --until {}s", trim(until, 6)),
        Stopped::Interrupted => "interrupted; no file was written".to_owned(),
    };
    let speed = if seconds > 0.0 && wall.as_millis() > 0 { speed(seconds / wall.as_secs_f64()) } else { String::new() };
    let line = format!("{what}\n{seconds:.3} s of virtual time in {:.3} s{speed}", wall.as_secs_f64());
    let _ = writeln!(text, "\n{}", terminal.heading(&line));
}

fn speed(ratio: f64) -> String {
    format!(", {} times real time", if ratio >= 10.0 { trim(ratio.round(), 0) } else { trim(ratio, 1) })
}

fn programs(text: &mut String, report: &Report, terminal: Terminal) {
    let rows = report.controller.programs();
    let rows: Vec<String> = rows
        .iter()
        .map(|program| {
            let line = program.line.map_or_else(String::new, |line| format!("line {line}"));
            let name = program.unit.to_string();
            format!("{name:<7} {:<8} {line:<9} {:>9} statements", program.state.name(), program.statements)
        })
        .collect();
    section(text, terminal, "programs", &rows);
}

fn axes(text: &mut String, report: &Report, terminal: Terminal) {
    let axes = report.controller.axes();
    if axes.is_empty() {
        return;
    }
    let header =
        format!("{:<12}{:>14}{:>14}{:>16}{:>20}", "", "position", "travel", "peak velocity", "peak acceleration");
    let rows = axes.iter().map(|axis| {
        format!(
            "{:<12}{:>14}{:>14}{:>16}{:>20}",
            axis_title(axis),
            trim(axis.position, 4),
            trim(axis.statistics.travel, 4),
            trim(axis.statistics.peak_velocity, 4),
            trim(axis.statistics.peak_acceleration, 4)
        )
    });
    let rows: Vec<String> = std::iter::once(header.trim_end().to_owned()).chain(rows).collect();
    section(text, terminal, "axes", &rows);
}

pub(super) fn axis_title(axis: &AxisReport) -> String {
    match &axis.name {
        Some(name) => format!("{name} (AXIS{})", axis.axis),
        None => format!("AXIS{}", axis.axis),
    }
}

fn masters(text: &mut String, report: &Report, terminal: Terminal) {
    let rows = report.controller.masters();
    let rows: Vec<String> = rows
        .iter()
        .map(|master| {
            let moves = master.statistics.moves;
            let name = format!("MASTER{}", master.master);
            format!("{name:<9} {moves:>6} moves in {:.3} s of motion", master.motion_seconds)
        })
        .collect();
    section(text, terminal, "moves", &rows);
}

fn values(text: &mut String, report: &Report, terminal: Terminal) {
    let rows = report.read.iter().map(|register| match report.value(*register) {
        Ok(value) => format!("{register} = {}", acrc_vm::format::number(&value)),
        Err(problem) => format!("{register}: {problem}"),
    });
    section(text, terminal, "values", &rows.collect::<Vec<_>>());
}

fn notes(text: &mut String, report: &Report, terminal: Terminal) {
    for note in report.notes {
        let _ = writeln!(text, "{} {note}", terminal.warning_word("note:"));
    }
    let faults = report.record.faults.len();
    if faults > 0 {
        let plural = if faults == 1 { "error" } else { "errors" };
        let _ = writeln!(text, "{} {faults} run-time {plural}, shown above", terminal.error_word("fault:"));
    }
}

/// What a run left out or relied on without proof.
pub(super) fn notes_of(controller: &Controller, record: &Record) -> Vec<String> {
    let mut notes: Vec<String> = controller.notes().map(str::to_owned).collect();
    for axis in controller.axes().iter().filter(|axis| axis.moved_disabled) {
        notes.push(format!("{} moved although its drive was never enabled (DRIVE ON)", axis_title(axis)));
    }
    for (unit, port) in controller.programs().iter().filter_map(|report| Some((report.unit, report.awaits?))) {
        let place = match port {
            Port::Stream(stream) => format!("at {stream}"),
            Port::Listener(_) => "from whoever listens to it".to_owned(),
        };
        notes.push(format!(
            "{unit} waits for input {place}: --input {port}=FILE types there, or an event with stream = \"{port}\" and a text"
        ));
    }
    if record.dropped > 0 {
        notes.push(format!("{} further lines of output are not in this report", record.dropped));
    }
    notes
}

/// Rows under a word at the left.
fn section(text: &mut String, terminal: Terminal, name: &str, rows: &[String]) {
    for (index, row) in rows.iter().enumerate() {
        let title = if index == 0 { name } else { "" };
        let _ = writeln!(text, "{}  {}", terminal.heading(&format!("{title:<9}")), row.trim_end());
    }
}

/// A number with at most so many decimals and no trailing zeros.
pub(super) fn trim(value: f64, decimals: usize) -> String {
    let fixed = format!("{value:.decimals$}");
    let trimmed = if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.') } else { &fixed };
    if trimmed == "-0" { "0".to_owned() } else { trimmed.to_owned() }
}
