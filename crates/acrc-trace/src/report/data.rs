//! What a run was, for the script of the page: one JSON object.
//!
//! Columns of numbers are small: one that never changes is a number, else it is the base64 of 32-bit whole numbers with an offset and a step, which
//! keeps nine digits of its range. Times are whole microseconds: how many follow each other at which distance. Bits are runs: the point at which a state begins, and the state.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

use super::Report;
use crate::{Band, Entry, Kind, Place, ProgramLog, Signal, Trace};

/// What stands for no number among the whole numbers of a column.
const NO_NUMBER: i32 = i32::MIN;

#[derive(Serialize)]
struct Document<'a> {
    facts: &'a [(String, String)],
    times: Vec<u64>,
    end: f64,
    per_point: u64,
    signals: Vec<SignalData<'a>>,
    paths: Vec<PathData<'a>>,
    events: Vec<(f64, &'a str)>,
    files: Vec<FileData<'a>>,
    programs: Vec<ProgramData<'a>>,
    resolution: f64,
    output: Vec<(f64, &'a str, &'a str)>,
    faults: Vec<(f64, &'a str)>,
    notes: &'a [String],
}

/// Numbers, one a point.
#[derive(Serialize)]
#[serde(untagged)]
enum Column {
    /// All the same; `null` for no number.
    Same(Option<f64>),
    /// `offset + step * whole`, the whole numbers as little-endian 32 bits in base64.
    Packed { offset: f64, step: f64, wholes: String, count: usize },
}

#[derive(Serialize)]
struct SignalData<'a> {
    name: &'a str,
    unit: &'a str,
    group: &'a str,
    source: &'a str,
    #[serde(flatten)]
    values: Values,
}

#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Values {
    /// Least and greatest values; only the least where they are the same.
    Real { low: Column, high: Option<Column> },
    /// Point and state in turns; 0 is off, 3 is on, 2 is both within the point.
    Bit(Vec<usize>),
}

#[derive(Serialize)]
struct PathData<'a> {
    names: [&'a str; 2],
    units: [&'a str; 2],
    times: Vec<u64>,
    x: Column,
    y: Column,
}

#[derive(Serialize)]
struct FileData<'a> {
    name: &'a str,
    lines: Vec<&'a str>,
}

#[derive(Serialize)]
struct ProgramData<'a> {
    name: &'a str,
    /// File (an index, or -1 for none), line, statement and state of each kind of entry.
    places: Vec<(i64, u32, u32, &'static str)>,
    /// Microseconds since the entry before.
    steps: Vec<u64>,
    /// Which of the places.
    entries: Vec<usize>,
}

/// The object as text that is safe inside a script element.
pub(super) fn json(report: &Report) -> String {
    let text = serde_json::to_string(&document(report)).expect("plain data has a JSON form");
    // The only way out of a script element begins with this character, which JSON has inside of texts only.
    text.replace('<', "\\u003c")
}

fn document<'a>(report: &'a Report<'a>) -> Document<'a> {
    let signals = report.signals;
    let files = report.files.iter().chain(&report.listings);
    let moments =
        |events: &'a [crate::plot::Event]| events.iter().map(|event| (event.time, event.text.as_str())).collect();
    Document {
        facts: &report.facts,
        times: steps(signals.times()),
        end: signals.end().unwrap_or(0.0),
        per_point: signals.per_point(),
        signals: signals
            .signals()
            .iter()
            .zip(signals.bands())
            .map(|(signal, band)| signal_data(signal, band))
            .collect(),
        paths: report.paths.iter().filter_map(|names| path_data(report.positions, names)).collect(),
        events: moments(report.events),
        files: files.map(|file| FileData { name: &file.name, lines: file.text.lines().collect() }).collect(),
        programs: report.statements.programs().map(|program| program_data(program, report)).collect(),
        resolution: report.statements.resolution(),
        output: report.output.iter().map(|line| (line.time, line.source.as_str(), line.text)).collect(),
        faults: moments(&report.faults),
        notes: report.notes,
    }
}

fn signal_data<'a>(signal: &'a Signal, band: &Band) -> SignalData<'a> {
    let values = match signal.kind {
        Kind::Bit => Values::Bit(runs(band)),
        Kind::Continuous => {
            let is_line = band.low.iter().zip(&band.high).all(|(low, high)| low == high || low.is_nan());
            Values::Real { low: column(&band.low), high: (!is_line).then(|| column(&band.high)) }
        }
    };
    SignalData { name: &signal.name, unit: &signal.unit, group: &signal.group, source: &signal.source, values }
}

fn column(values: &[f64]) -> Column {
    let first = values.first().copied().filter(|value| value.is_finite());
    if values.iter().all(|value| Some(*value) == first || first.is_none() && !value.is_finite()) {
        return Column::Same(first);
    }
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let (least, greatest) =
        finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, g), value| (l.min(value), g.max(value)));
    // Half of the range each way, so that a difference of the greatest numbers is none.
    let (middle, reach) = (least / 2.0 + greatest / 2.0, greatest / 2.0 - least / 2.0);
    // A range at zero is counted from there, so that zero stays zero.
    let far = least.abs().max(greatest.abs());
    let (offset, reach) = if far / 4.0 <= reach { (0.0, far) } else { (middle, reach) };
    let step = (reach / f64::from(i32::MAX)).max(f64::MIN_POSITIVE);
    let mut bytes = Vec::with_capacity(4 * values.len());
    for value in values {
        let whole = if value.is_finite() { ((value - offset) / step).round() as i32 } else { NO_NUMBER };
        bytes.extend(whole.to_le_bytes());
    }
    Column::Packed { offset, step, wholes: STANDARD.encode(bytes), count: values.len() }
}

/// Times as a count and a distance in microseconds in turns; the first distance is that from 0.
fn steps(times: &[f64]) -> Vec<u64> {
    let mut steps: Vec<u64> = Vec::new();
    let mut before = 0;
    for time in times {
        let now = (time * 1e6).round() as u64;
        let step = now.saturating_sub(before);
        before = now;
        match steps.as_mut_slice() {
            [.., count, last] if *last == step => *count += 1,
            _ => steps.extend([1, step]),
        }
    }
    steps
}

fn runs(band: &Band) -> Vec<usize> {
    let mut runs = Vec::new();
    let mut last = None;
    for (point, (low, high)) in band.low.iter().zip(&band.high).enumerate() {
        let state = usize::from(*low > 0.0) + 2 * usize::from(*high > 0.0);
        if last != Some(state) {
            runs.extend([point, state]);
            last = Some(state);
        }
    }
    runs
}

fn path_data<'a>(trace: &'a Trace, names: &[String; 2]) -> Option<PathData<'a>> {
    let [x, y] = [trace.signal_index(&names[0])?, trace.signal_index(&names[1])?];
    let signals = [trace.signals().get(x)?, trace.signals().get(y)?];
    Some(PathData {
        names: signals.map(|signal| signal.name.as_str()),
        units: signals.map(|signal| signal.unit.as_str()),
        times: steps(trace.times()),
        x: column(trace.column(x)),
        y: column(trace.column(y)),
    })
}

fn program_data<'a>(program: &'a ProgramLog, report: &Report) -> ProgramData<'a> {
    let listing = report.listings.iter().position(|text| text.name == program.name);
    let listing = listing.map_or(-1, |index| (report.files.len() + index) as i64);
    let mut kinds: Vec<(Place, &'static str)> =
        program.entries.iter().map(|entry| (entry.place, entry.state)).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let index = |entry: &Entry| kinds.binary_search(&(entry.place, entry.state)).unwrap_or(0);
    let mut before = 0;
    let steps = program.entries.iter().map(|entry| {
        let now = (entry.time * 1e6).round() as u64;
        now.saturating_sub(std::mem::replace(&mut before, now))
    });
    ProgramData {
        name: &program.name,
        steps: steps.collect(),
        entries: program.entries.iter().map(index).collect(),
        places: kinds
            .iter()
            .map(|(place, state)| (place.file.map_or(listing, i64::from), place.line, place.statement, *state))
            .collect(),
    }
}
