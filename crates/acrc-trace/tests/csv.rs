//! The CSV form, byte by byte.

use acrc_trace::csv::{self, CsvError, CsvWriter};
use acrc_trace::{Signal, Trace, TraceError};
use proptest::prelude::*;

fn signals() -> Vec<Signal> {
    vec![
        Signal::continuous("X.position", "mm", "position"),
        Signal::continuous("X.velocity", "mm/s", "velocity"),
        Signal::bit("BIT32", "bits"),
    ]
}

fn written(trace: &Trace) -> String {
    let mut out = Vec::new();
    csv::write(trace, &mut out).expect("writing to memory works");
    String::from_utf8(out).expect("CSV is text")
}

fn one_value(value: f64) -> String {
    let mut trace = Trace::new(vec![Signal::continuous("v", "", "v")]);
    trace.push(0.0, &[value]).expect("the row fits");
    let text = written(&trace);
    text.trim_end().rsplit(',').next().unwrap_or_default().to_owned()
}

#[test]
fn a_short_recording() {
    let mut trace = Trace::new(signals());
    let rows = [
        (0.0, [0.0, -0.0, 0.0]),
        (0.0005, [0.000_05, 0.2, 1.0]),
        (0.001, [1.0 / 3.0, -100.25, -0.0]),
        (3_600.123_456_7, [1e21, 1e-7, 2.0]),
        (1_000_000.0, [f64::NAN, f64::NEG_INFINITY, f64::NAN]),
    ];
    for (time, values) in rows {
        trace.push(time, &values).expect("the row fits");
    }
    insta::assert_snapshot!(written(&trace));
}

#[test]
fn values_are_as_short_as_they_can_be() {
    let expected = [
        (0.0, "0"),
        (-0.0, "0"),
        (1.0, "1"),
        (-12.5, "-12.5"),
        (0.1 + 0.2, "0.30000000000000004"),
        (123_456_789.0, "123456789"),
        (1e16, "1e16"),
        (f64::MAX, "1.7976931348623157e308"),
        (5e-324, "5e-324"),
    ];
    for (value, text) in expected {
        assert_eq!(one_value(value), text);
    }
}

#[test]
fn times_have_microseconds_and_no_negative_zero() {
    let mut trace = Trace::new(Vec::new());
    for time in [-1.0, -1e-9, 0.0, 4.9e-7, 5.1e-7, 0.002_5] {
        trace.push(time, &[]).expect("the row fits");
    }
    assert_eq!(written(&trace), "time_s\n-1.000000\n0.000000\n0.000000\n0.000000\n0.000001\n0.002500\n");
}

#[test]
fn names_are_quoted_where_they_must_be() {
    let names = ["plain name", "a,b", "5\" pipe", "two\nlines", "µ"];
    let trace = Trace::new(names.map(|name| Signal::bit(name, "bits")).to_vec());
    assert_eq!(written(&trace), "time_s,plain name,\"a,b\",\"5\"\" pipe\",\"two\nlines\",µ\n");
}

#[test]
fn row_by_row_gives_the_same_bytes() {
    let mut trace = Trace::new(signals());
    let mut writer = CsvWriter::new(Vec::new(), &signals()).expect("writing to memory works");
    for tick in 0..1_000 {
        let values = [f64::from(tick) / 7.0, f64::from(tick).sqrt(), f64::from(tick % 2)];
        trace.push(f64::from(tick) * 0.0005, &values).expect("the row fits");
        writer.row(f64::from(tick) * 0.0005, &values).expect("the row fits");
    }
    let streamed = writer.finish().expect("writing to memory works");
    assert_eq!(String::from_utf8(streamed).expect("CSV is text"), written(&trace));
}

#[test]
fn a_refused_row_writes_nothing() {
    let mut writer = CsvWriter::new(Vec::new(), &signals()).expect("writing to memory works");
    writer.row(1.0, &[0.0; 3]).expect("the row fits");
    assert!(matches!(writer.row(2.0, &[0.0; 2]), Err(CsvError::Row(TraceError::WrongLength { .. }))));
    assert!(matches!(writer.row(0.5, &[0.0; 3]), Err(CsvError::Row(TraceError::TimeGoesBack { .. }))));
    let out = writer.finish().expect("writing to memory works");
    assert_eq!(out, b"time_s,X.position,X.velocity,BIT32\n1.000000,0,0,0\n");
}

proptest! {
    #[test]
    fn values_read_back(value in any::<f64>().prop_filter("NaN is not equal to itself", |value| !value.is_nan())) {
        let read: f64 = one_value(value).parse().expect("a number was written");
        prop_assert_eq!(read, value);
    }
}
