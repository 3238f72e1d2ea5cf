//! Rows in, columns out.

use acrc_trace::{Kind, Signal, Trace, TraceError};

fn two_signals() -> Trace {
    Trace::new(vec![Signal::continuous("X.position", "mm", "position"), Signal::bit("BIT32", "bits")])
}

#[test]
fn rows_are_kept_by_column() {
    let mut trace = two_signals();
    trace.push(0.0, &[1.5, 0.0]).expect("the first row fits");
    trace.push(0.0, &[2.5, 0.0]).expect("rows may share a time");
    trace.push(0.5, &[3.5, 1.0]).expect("later rows fit");
    assert_eq!((trace.rows(), trace.times()), (3, [0.0, 0.0, 0.5].as_slice()));
    assert_eq!(trace.column(0), [1.5, 2.5, 3.5]);
    assert_eq!((trace.time(2), trace.value(2, 0), trace.value(2, 1)), (Some(0.5), Some(3.5), Some(1.0)));
    assert_eq!(trace.signal_index("BIT32"), Some(1));
    assert_eq!(trace.signals()[1].kind, Kind::Bit);
}

#[test]
fn what_is_not_there_is_none() {
    let trace = two_signals();
    assert_eq!((trace.time(0), trace.value(0, 0), trace.value(0, 9)), (None, None, None));
    assert!(trace.column(9).is_empty());
    assert_eq!(trace.signal_index("x.position"), None);
}

#[test]
fn rows_that_do_not_fit_are_refused_and_change_nothing() {
    let mut trace = two_signals();
    trace.push(1.0, &[0.0, 0.0]).expect("the row fits");
    let before = trace.clone();
    assert_eq!(trace.push(2.0, &[0.0]), Err(TraceError::WrongLength { expected: 2, found: 1 }));
    assert_eq!(trace.push(0.5, &[0.0, 0.0]), Err(TraceError::TimeGoesBack { previous: 1.0, time: 0.5 }));
    assert!(matches!(trace.push(f64::NAN, &[0.0, 0.0]), Err(TraceError::NotATime { .. })));
    assert!(trace.push(f64::INFINITY, &[0.0, 0.0]).is_err());
    assert_eq!(trace, before);
}

#[test]
fn errors_name_the_values() {
    let texts = [
        TraceError::WrongLength { expected: 2, found: 3 }.to_string(),
        TraceError::NotATime { time: f64::NAN }.to_string(),
        TraceError::TimeGoesBack { previous: 1.0, time: 0.5 }.to_string(),
    ];
    assert_eq!(texts[0], "a row has 3 values, but 2 signals are recorded");
    assert_eq!(texts[1], "the time of a row is NaN, which is not a point in time");
    assert_eq!(texts[2], "a row at 0.5 s follows one at 1 s");
}
