//! Splines and NURBS curves.

use std::f64::consts::{FRAC_PI_2, SQRT_2};

use acrc_motion::{ControlPoint, CurveBuilder, CurveError, Master, Move, MoveSettings, Span};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

fn ramps(velocity: f64, ramp: f64) -> MoveSettings {
    MoveSettings { velocity, acceleration: ramp, deceleration: ramp, stop: ramp, ..MoveSettings::default() }
}

fn point(x: f64, y: f64) -> ControlPoint {
    ControlPoint::new().at(0, x).at(1, y)
}

fn weighted(x: f64, y: f64, weight: f64) -> ControlPoint {
    ControlPoint { weight: Some(weight), ..point(x, y) }
}

/// All pieces of a curve: its points with the first knots, then the other knots.
fn pieces(mut curve: CurveBuilder, points: &[ControlPoint], knots: &[f64]) -> Vec<Span> {
    let mut pieces = Vec::new();
    for (index, knot) in knots.iter().enumerate() {
        pieces.extend(curve.push(Some(*knot), points.get(index)).unwrap());
    }
    while let Some(piece) = curve.finish() {
        pieces.push(piece);
    }
    pieces
}

/// A master at the first point with all pieces queued.
fn following(start: [f64; 2], pieces: &[Span], settings: MoveSettings) -> Master {
    let mut master = Master::new(64);
    for (slot, position) in start.into_iter().enumerate() {
        master.set_position(slot, position).unwrap();
    }
    for piece in pieces {
        master.push_span(&Move::new(settings), piece).unwrap();
    }
    master
}

fn place(master: &Master) -> [f64; 2] {
    [master.position(0), master.position(1)]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn speed(master: &Master) -> f64 {
    master.velocity(0).hypot(master.velocity(1))
}

#[test]
fn a_rational_curve_is_a_quarter_circle() {
    let points = [point(1.0, 0.0), weighted(1.0, 1.0, 1.0 / SQRT_2), point(0.0, 1.0)];
    let pieces = pieces(CurveBuilder::nurbs(3).unwrap(), &points, &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
    assert_eq!(pieces.len(), 1);
    let mut master = following([1.0, 0.0], &pieces, ramps(1.0, 4.0));
    let duration = FRAC_PI_2 + 0.25;
    assert!((master.next_event().unwrap() - duration).abs() < 1e-9);
    while master.in_motion() {
        assert!((distance(place(&master), [0.0, 0.0]) - 1.0).abs() < 1e-12);
        assert!((speed(&master) - master.vector_velocity()).abs() < 1e-7, "{}", speed(&master));
        // v²/r toward the centre, dv/dt along the path.
        let acceleration = master.acceleration(0).hypot(master.acceleration(1));
        let expected = (master.vector_velocity().powi(2)).hypot(master.vector_acceleration());
        assert!((acceleration - expected).abs() < 1e-6, "{acceleration} is not {expected}");
        master.advance(0.01);
    }
    assert!(distance(place(&master), [0.0, 1.0]) < 1e-15);
}

#[test]
fn knots_that_are_missing_count_as_equal_to_the_last() {
    let points = [point(0.0, 0.0), point(1.0, 2.0), point(3.0, 2.0), point(4.0, 0.0), point(6.0, 1.0)];
    let all = [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0, 2.0];
    let whole = pieces(CurveBuilder::nurbs(4).unwrap(), &points, &all);
    assert_eq!(whole.len(), 2);
    assert_eq!(pieces(CurveBuilder::nurbs(4).unwrap(), &points, &all[..6]), whole);
}

#[test]
fn a_spline_through_a_parabola_is_the_parabola() {
    let knots = [0.0, 1.0, 1.5, 3.0, 3.25, 5.0];
    let points: Vec<_> = knots.iter().map(|x| point(*x, x * x)).collect();
    let pieces = pieces(CurveBuilder::spline(), &points, &knots);
    assert_eq!(pieces.len(), 5);
    let mut master = following([0.0, 0.0], &pieces, MoveSettings { stop: 0.0, ..ramps(2.0, 100.0) });
    while master.in_motion() {
        let [x, y] = place(&master);
        assert!((y - x * x).abs() < 1e-12, "{x} {y}");
        assert!((speed(&master) - master.vector_velocity()).abs() < 1e-7, "{} at {x}", speed(&master));
        master.advance(0.001);
    }
    assert_eq!(place(&master), [5.0, 25.0]);
}

#[test]
fn a_spline_without_knots_goes_through_its_points() {
    let corners = [[0.0, 0.0], [3.0, 1.0], [4.0, 5.0], [-1.0, 2.0]];
    let mut curve = CurveBuilder::spline();
    let mut pieces = Vec::new();
    for [x, y] in corners {
        pieces.extend(curve.push(None, Some(&point(x, y))).unwrap());
    }
    pieces.extend(std::iter::from_fn(|| curve.finish()));
    let mut master = following([0.0, 0.0], &pieces, ramps(1.0, 0.0));
    let mut seen = Vec::new();
    while let Some(event) = master.next_event() {
        master.advance(event + 1e-9);
        seen.push(place(&master));
    }
    assert_eq!(seen.len(), 3);
    for (seen, corner) in seen.into_iter().zip(&corners[1..]) {
        assert!(distance(seen, *corner) < 1e-6);
    }
}

#[test]
fn two_points_make_a_line() {
    let pieces = pieces(CurveBuilder::spline(), &[point(0.0, 0.0), point(3.0, 4.0)], &[0.0, 1.0]);
    let mut master = following([0.0, 0.0], &pieces, ramps(1.0, 0.0));
    assert!((master.next_event().unwrap() - 5.0).abs() < 1e-12);
    master.advance(2.5);
    assert!(distance(place(&master), [1.5, 2.0]) < 1e-12);
    assert_eq!(CurveBuilder::spline().finish(), None);
}

#[test]
fn pieces_are_transformed() {
    let points = [point(1.0, 0.0), weighted(1.0, 1.0, 1.0 / SQRT_2), point(0.0, 1.0)];
    let pieces = pieces(CurveBuilder::nurbs(3).unwrap(), &points, &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
    let mut master = Master::new(1);
    master.set_scale(0, 2.0, 0.0).unwrap();
    master.set_scale(1, 2.0, 0.0).unwrap();
    master.set_rotation([0, 1], 90.0, [0.0, 0.0]).unwrap();
    master.set_offset(0, 10.0).unwrap();
    master.set_position(0, 10.0).unwrap();
    master.set_position(1, 2.0).unwrap();
    master.push_span(&Move::new(ramps(1.0, 0.0)), &pieces[0]).unwrap();
    assert!((master.next_event().unwrap() - 2.0 * FRAC_PI_2).abs() < 1e-9);
    for _ in 0..31 {
        master.advance(0.1);
        assert!((distance(place(&master), [10.0, 0.0]) - 2.0).abs() < 1e-12);
    }
    assert!(distance([master.target(0), master.target(1)], [8.0, 0.0]) < 1e-12);
}

#[test]
fn curves_that_cannot_be_are_refused() {
    assert_eq!(CurveBuilder::nurbs(6).unwrap_err().to_string(), "rank 6 of a curve is not 2 to 5");
    let mut curve = CurveBuilder::nurbs(3).unwrap();
    curve.push(Some(1.0), Some(&point(0.0, 0.0))).unwrap();
    let error = curve.push(Some(0.5), None).unwrap_err();
    assert_eq!(error.to_string(), "knot 0.5 does not lie above the knot before, 1");
    let error = curve.push(None, Some(&weighted(0.0, 0.0, 0.0))).unwrap_err();
    assert_eq!(error.to_string(), "weight of a control point is zero (0)");
    curve.push(None, None).unwrap();
    assert_eq!(curve.push(None, Some(&point(0.0, 0.0))), Err(CurveError::PointAfterEnd));
    let mut spline = CurveBuilder::spline();
    assert_eq!(spline.push(Some(0.0), None), Err(CurveError::NoPoint));
    spline.push(Some(0.0), Some(&point(0.0, 0.0))).unwrap();
    assert!(matches!(spline.push(Some(0.0), Some(&point(1.0, 0.0))), Err(CurveError::KnotOrder { .. })));
}

/// A point of a NURBS curve by the definition: the sum of its basis functions (Cox and de Boor).
fn by_definition(rank: usize, points: &[[f64; 3]], knots: &[f64], u: f64) -> [f64; 2] {
    fn basis(knots: &[f64], i: usize, k: usize, u: f64) -> f64 {
        if k == 1 {
            return f64::from(u8::from(knots[i] <= u && u < knots[i + 1]));
        }
        let part = |over: f64, width: f64| if width == 0.0 { 0.0 } else { over / width };
        part(u - knots[i], knots[i + k - 1] - knots[i]) * basis(knots, i, k - 1, u)
            + part(knots[i + k] - u, knots[i + k] - knots[i + 1]) * basis(knots, i + 1, k - 1, u)
    }
    let (mut x, mut y, mut w) = (0.0, 0.0, 0.0);
    for (i, point) in points.iter().enumerate() {
        let share = basis(knots, i, rank, u) * point[2];
        x += share * point[0];
        y += share * point[1];
        w += share;
    }
    [x / w, y / w]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 25, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn pieces_follow_the_definition(
        rank in 2_usize..=5, extra in prop::collection::vec(0.1..2.0_f64, 0..6),
        coordinates in prop::collection::vec([-9.0..9.0_f64, -9.0..9.0_f64, 0.2..5.0_f64], 11),
    ) {
        // As many points as knots between the clamped ends ask for.
        let mut points = coordinates[..rank + extra.len()].to_vec();
        for (index, point) in (0_u8..).zip(&mut points) {
            // Without a cusp, where the parameter of the curve itself comes to rest.
            point[0] = f64::from(index) * 4.0 + point[0] / 9.0;
        }
        let mut knots = vec![0.0; rank];
        for step in &extra {
            knots.push(knots[knots.len() - 1] + step);
        }
        let last = knots[knots.len() - 1] + 1.0;
        knots.extend(vec![last; rank]);
        let control: Vec<_> = points.iter().map(|[x, y, w]| weighted(*x, *y, *w)).collect();
        let pieces = pieces(CurveBuilder::nurbs(rank).unwrap(), &control, &knots);
        let mut master = following([points[0][0], points[0][1]], &pieces, MoveSettings { stop: 0.0, ..ramps(1.0, 0.0) });
        // Every place of the definition lies on the path, in the same order.
        let mut dense = Vec::new();
        while master.in_motion() {
            dense.push(place(&master));
            prop_assert!((speed(&master) - master.vector_velocity()).abs() < 1e-6, "{}", speed(&master));
            master.advance(0.01);
        }
        dense.push(place(&master));
        for step in 0..200 {
            let expected = by_definition(rank, &points, &knots, last * (f64::from(step) / 200.0));
            let nearest = dense.iter().map(|place| distance(*place, expected)).fold(f64::INFINITY, f64::min);
            prop_assert!(nearest <= 0.0051, "{expected:?} is {nearest} away");
        }
        let end = points[points.len() - 1];
        prop_assert!(distance(dense[dense.len() - 1], [end[0], end[1]]) < 1e-12);
    }
}
