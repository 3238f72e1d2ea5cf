//! Signals in bounded memory: what must hold however long a run is.

use acrc_trace::{Envelope, Signal, TraceError};
use proptest::prelude::*;

fn signals() -> Vec<Signal> {
    vec![Signal::continuous("X.position", "mm", "position"), Signal::bit("BIT32", "bits")]
}

fn envelope(samples: &[(f64, bool)], values: usize) -> Envelope {
    let mut envelope = Envelope::new(signals(), values);
    for (row, (value, bit)) in samples.iter().enumerate() {
        envelope.push(row as f64 * 0.5, &[*value, f64::from(u8::from(*bit))]).expect("the row fits");
    }
    envelope
}

#[test]
fn a_short_run_is_kept_as_it_is() {
    let envelope = envelope(&[(1.0, false), (f64::NAN, true), (3.0, false)], 12);
    assert_eq!((envelope.times(), envelope.per_point(), envelope.end()), (&[0.0, 0.5, 1.0][..], 1, Some(1.0)));
    let position = &envelope.bands()[0];
    assert_eq!(format!("{:?}", position.low), "[1.0, NaN, 3.0]");
    assert_eq!(envelope.bands()[1].high, [0.0, 1.0, 0.0]);
}

#[test]
fn a_full_envelope_makes_one_of_two_points() {
    let samples: Vec<(f64, bool)> = [5.0, 1.0, 2.0, 9.0, 4.0].map(|value| (value, value == 9.0)).to_vec();
    let envelope = envelope(&samples, 16);
    assert_eq!((envelope.times(), envelope.per_point()), (&[0.0, 1.0, 2.0][..], 2));
    assert_eq!(
        (&envelope.bands()[0].low[..], &envelope.bands()[0].high[..]),
        (&[1.0, 2.0, 4.0][..], &[5.0, 9.0, 4.0][..])
    );
    assert_eq!((&envelope.bands()[1].low[..], &envelope.bands()[1].high[..]), (&[0.0; 3][..], &[0.0, 1.0, 0.0][..]));
    assert_eq!(envelope.end(), Some(2.0));
}

#[test]
fn rows_that_do_not_fit_are_refused() {
    let mut envelope = Envelope::new(signals(), 100);
    assert_eq!(envelope.push(0.0, &[1.0]), Err(TraceError::WrongLength { expected: 2, found: 1 }));
    envelope.push(1.0, &[1.0, 0.0]).expect("a row");
    assert_eq!(envelope.push(0.5, &[1.0, 0.0]), Err(TraceError::TimeGoesBack { previous: 1.0, time: 0.5 }));
}

#[test]
fn signals_can_be_left_out() {
    let envelope = envelope(&[(0.0, true)], 12);
    assert!(envelope.bands()[0].is_zero() && !envelope.bands()[1].is_zero());
    let envelope = envelope.without(|index| index == 0);
    assert_eq!((envelope.signals()[0].name.as_str(), envelope.bands().len()), ("BIT32", 1));
}

proptest! {
    #[test]
    fn every_point_holds_its_samples_and_there_are_never_too_many(
        samples in prop::collection::vec((-1e6..1e6, any::<bool>()), 1..400),
        values in 8_usize..200,
    ) {
        let envelope = envelope(&samples, values);
        prop_assert!(envelope.times().len() <= (values / 4).max(2));
        let per_point = envelope.per_point() as usize;
        prop_assert_eq!(envelope.times().len(), samples.len().div_ceil(per_point));
        for (point, chunk) in samples.chunks(per_point).enumerate() {
            let least = chunk.iter().map(|sample| sample.0).fold(f64::INFINITY, f64::min);
            let greatest = chunk.iter().map(|sample| sample.0).fold(f64::NEG_INFINITY, f64::max);
            prop_assert_eq!(envelope.times()[point], (point * per_point) as f64 * 0.5);
            prop_assert_eq!(envelope.bands()[0].low[point], least);
            prop_assert_eq!(envelope.bands()[0].high[point], greatest);
            prop_assert_eq!(envelope.bands()[1].high[point] == 1.0, chunk.iter().any(|sample| sample.1));
            prop_assert_eq!(envelope.bands()[1].low[point] == 1.0, chunk.iter().all(|sample| sample.1));
        }
    }
}
