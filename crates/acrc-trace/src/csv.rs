//! Plain CSV that spreadsheets and data tools read without settings.
//!
//! The first line is `time_s` and the names of the signals; every further line is one row. Fields are separated by
//! commas, lines end with LF, and a name with a comma, quote or line end is quoted as RFC 4180 says. Times have six
//! decimals, which is a microsecond, bits are `0` and `1`, and other values have the fewest digits that read back as
//! the same number.

use std::fmt::Write as _;
use std::io::{self, Write};
use std::ops::Range;

use thiserror::Error;

use crate::signal::is_on;
use crate::trace::check_row;
use crate::{Kind, Signal, Trace, TraceError};

/// Why a row could not be written.
#[derive(Debug, Error)]
pub enum CsvError {
    /// The row does not fit the header or the rows before it; nothing was written.
    #[error(transparent)]
    Row(#[from] TraceError),
    /// The output failed.
    #[error("the recording could not be written")]
    Io(#[from] io::Error),
}

/// Writes a whole trace.
pub fn write(trace: &Trace, out: &mut impl Write) -> io::Result<()> {
    let mut lines = Lines::new(trace.signals());
    let mut header = String::new();
    push_header(&mut header, trace.signals());
    out.write_all(header.as_bytes())?;
    for (row, time) in trace.times().iter().enumerate() {
        let values = (0..trace.signals().len()).filter_map(|signal| trace.value(row, signal));
        out.write_all(lines.next(*time, values).as_bytes())?;
    }
    Ok(())
}

/// Writes rows as they come, so that the length of a run does not matter. It does not buffer: give it a
/// [`BufWriter`](io::BufWriter) when the output is a file.
#[derive(Debug)]
pub struct CsvWriter<W> {
    out: W,
    last_time: Option<f64>,
    lines: Lines,
}

impl<W: Write> CsvWriter<W> {
    /// Writes the header.
    pub fn new(mut out: W, signals: &[Signal]) -> io::Result<Self> {
        let mut header = String::new();
        push_header(&mut header, signals);
        out.write_all(header.as_bytes())?;
        Ok(Self { out, last_time: None, lines: Lines::new(signals) })
    }

    /// Writes one row: `time` in seconds, `values` in the order of the signals.
    pub fn row(&mut self, time: f64, values: &[f64]) -> Result<(), CsvError> {
        check_row(self.lines.fields.len(), self.last_time, time, values)?;
        let line = self.lines.next(time, values.iter().copied());
        self.out.write_all(line.as_bytes())?;
        self.last_time = Some(time);
        Ok(())
    }

    /// Flushes the output and hands it back.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }
}

/// Makes the lines. Most values of most rows are those of the row before, and their text is taken from there.
#[derive(Debug)]
struct Lines {
    line: String,
    before: String,
    fields: Vec<Field>,
}

/// One column.
#[derive(Debug)]
struct Field {
    kind: Kind,
    /// The value of the row before, and where its text stands in that line.
    value: u64,
    place: Range<usize>,
}

impl Lines {
    fn new(signals: &[Signal]) -> Self {
        let fields = signals.iter().map(|signal| Field { kind: signal.kind, value: 0, place: 0..0 });
        Self { line: String::new(), before: String::new(), fields: fields.collect() }
    }

    fn next(&mut self, time: f64, values: impl Iterator<Item = f64>) -> &str {
        std::mem::swap(&mut self.line, &mut self.before);
        let line = &mut self.line;
        line.clear();
        push_time(line, time);
        for (field, value) in self.fields.iter_mut().zip(values) {
            line.push(',');
            let start = line.len();
            let known = self.before.get(field.place.clone()).filter(|text| !text.is_empty());
            match (field.kind, known) {
                (Kind::Bit, _) => line.push(if is_on(value) { '1' } else { '0' }),
                (Kind::Continuous, Some(text)) if field.value == value.to_bits() => line.push_str(text),
                (Kind::Continuous, _) => push_value(line, value),
            }
            (field.value, field.place) = (value.to_bits(), start..line.len());
        }
        line.push('\n');
        line
    }
}

fn push_header(line: &mut String, signals: &[Signal]) {
    line.push_str("time_s");
    for signal in signals {
        line.push(',');
        push_quoted(line, &signal.name);
    }
    line.push('\n');
}

fn push_quoted(line: &mut String, name: &str) {
    if name.contains([',', '"', '\r', '\n']) {
        line.push('"');
        line.push_str(&name.replace('"', "\"\""));
        line.push('"');
    } else {
        line.push_str(name);
    }
}

fn push_time(line: &mut String, seconds: f64) {
    // A negative time that rounds to zero must not keep its sign.
    let microsecond = 1e-6;
    let seconds = if seconds.abs() < microsecond / 2.0 { 0.0 } else { seconds };
    push_formatted(line, format_args!("{seconds:.6}"));
}

/// The debug form of a float is its shortest one that reads back, with an exponent where that is shorter, but whole
/// numbers end in `.0`.
fn push_value(line: &mut String, value: f64) {
    let start = line.len();
    // Adding zero turns -0 into 0 and changes nothing else.
    push_formatted(line, format_args!("{:?}", value + 0.0));
    if line.get(start..).is_some_and(|text| text.ends_with(".0")) {
        line.truncate(line.len() - ".0".len());
    }
}

fn push_formatted(line: &mut String, text: std::fmt::Arguments<'_>) {
    line.write_fmt(text).expect("a string takes any text");
}
