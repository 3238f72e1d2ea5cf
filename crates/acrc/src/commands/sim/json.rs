//! The report of a run as one JSON object. It holds nothing that differs between two runs of the same project.

use std::collections::BTreeMap;

use acrc_controller::{State, Stopped};
use acrc_image::UnitName;
use acrc_vm::Value;
use serde::Serialize;

use super::summary::Report;
use crate::output;

#[derive(Serialize)]
struct Document {
    virtual_seconds: f64,
    /// `ended`, `until`, `interrupted`, or `fault` when everything has ended and a program did so by a run-time error.
    stopped: &'static str,
    programs: Vec<Program>,
    axes: Vec<Axis>,
    moves: Vec<Moves>,
    output: Vec<Output>,
    faults: Vec<Fault>,
    notes: Vec<String>,
    values: BTreeMap<String, serde_json::Value>,
}

#[derive(Serialize)]
struct Program {
    program: String,
    state: &'static str,
    line: Option<u32>,
    /// The stream, or the terminal that listens to a program, where it waits for characters.
    awaits: Option<String>,
    statements: u64,
}

#[derive(Serialize)]
struct Axis {
    axis: u8,
    name: Option<String>,
    position: f64,
    travel: f64,
    peak_velocity: f64,
    peak_acceleration: f64,
}

#[derive(Serialize)]
struct Moves {
    master: u8,
    moves: u64,
    motion_seconds: f64,
}

#[derive(Serialize)]
struct Output {
    time: f64,
    program: Option<String>,
    device: i32,
    stream: Option<String>,
    text: String,
}

#[derive(Serialize)]
struct Fault {
    time: f64,
    program: Option<String>,
    file: Option<String>,
    line: Option<u32>,
    statement: u32,
    message: String,
}

/// Prints the report.
pub(super) fn print(report: &Report) -> anyhow::Result<()> {
    let document = document(report);
    output::print(|out| {
        serde_json::to_writer_pretty(&mut *out, &document)?;
        out.write_all(b"\n")
    })
}

fn document(report: &Report) -> Document {
    let controller = report.controller;
    let name = |unit: UnitName| (unit != UnitName::Boot).then(|| unit.to_string());
    Document {
        virtual_seconds: controller.seconds(),
        stopped: match report.stopped {
            Stopped::Ended if controller.programs().iter().any(|program| program.state == State::Fault) => "fault",
            Stopped::Ended => "ended",
            Stopped::Until => "until",
            Stopped::Interrupted => "interrupted",
        },
        programs: controller
            .programs()
            .into_iter()
            .map(|program| Program {
                program: program.unit.to_string(),
                state: program.state.name(),
                line: program.line,
                awaits: program.awaits.map(|port| port.to_string()),
                statements: program.statements,
            })
            .collect(),
        axes: controller
            .axes()
            .into_iter()
            .map(|axis| Axis {
                axis: axis.axis,
                name: axis.name,
                position: axis.position,
                travel: axis.statistics.travel,
                peak_velocity: axis.statistics.peak_velocity,
                peak_acceleration: axis.statistics.peak_acceleration,
            })
            .collect(),
        moves: controller
            .masters()
            .into_iter()
            .map(|master| Moves {
                master: master.master,
                moves: master.statistics.moves,
                motion_seconds: master.motion_seconds,
            })
            .collect(),
        output: report
            .record
            .output
            .iter()
            .map(|line| Output {
                time: line.seconds,
                program: name(line.unit),
                device: line.device,
                stream: line.stream.map(|stream| stream.to_string()),
                text: line.text.clone(),
            })
            .collect(),
        faults: report
            .record
            .faults
            .iter()
            .map(|fault| Fault {
                time: fault.seconds,
                program: name(fault.unit),
                file: fault.file.clone(),
                line: fault.line,
                statement: fault.statement,
                message: fault.message.clone(),
            })
            .collect(),
        notes: report.notes.to_vec(),
        values: report.read.iter().map(|register| (register.to_string(), json(&report.value(*register)))).collect(),
    }
}

/// Whole numbers without a point, what could not be read as null.
fn json(value: &Result<Value, String>) -> serde_json::Value {
    match value {
        Ok(Value::Long(number)) => (*number).into(),
        Ok(Value::Single(number)) => real(f64::from(*number)),
        Ok(Value::Double(number)) => real(*number),
        Ok(Value::Text(_)) | Err(_) => serde_json::Value::Null,
    }
}

fn real(number: f64) -> serde_json::Value {
    const EXACT: f64 = 9_007_199_254_740_992.0;
    if number.fract() == 0.0 && number.abs() <= EXACT { (number as i64).into() } else { number.into() }
}
