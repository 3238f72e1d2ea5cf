//! The path of a tool in a picture: one signal over another.

use acrc_trace::plot::{PlotOptions, svg};
use acrc_trace::{Signal, Trace};

/// The path of two axes that go through these places, a second each.
fn picture(places: impl IntoIterator<Item = (f64, f64)>) -> String {
    let signal = |name: &str| Signal::continuous(name, "mm", "position");
    let mut trace = Trace::new(vec![signal("X.position"), signal("Y.position")]);
    for (second, (x, y)) in (0..).zip(places) {
        trace.push(f64::from(second), &[x, y]).expect("the row fits");
    }
    let paths = vec![["X.position", "Y.position"].map(str::to_owned)];
    svg(&trace, &PlotOptions { paths, ..PlotOptions::default() })
}

/// The points of the path, which is the last curve of a picture; `None` where the pen is lifted.
fn path(picture: &str) -> Vec<Option<(f64, f64)>> {
    let Some((_, rest)) = picture.rsplit_once("stroke-linecap=\"round\">") else { return Vec::new() };
    let data = rest.split_once("d=\"").and_then(|(_, rest)| rest.split_once('"')).map_or("", |(data, _)| data);
    let mut points = Vec::new();
    for stretch in data.split('M').skip(1) {
        points.push(None);
        let place = |point: &str| {
            let (x, y) = point.split_once(' ').expect("two numbers");
            Some((x.parse().expect("a number"), y.parse().expect("a number")))
        };
        points.extend(stretch.split('L').map(place));
    }
    points
}

#[test]
fn a_circle_is_a_circle() {
    let circle =
        (0..=360).map(|degree| f64::from(degree).to_radians()).map(|angle| (50.0 * angle.cos(), 50.0 * angle.sin()));
    let picture = picture(circle);
    let points: Vec<(f64, f64)> = path(&picture).into_iter().flatten().collect();
    let middle = |values: Vec<f64>| {
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        (f64::midpoint(least, greatest), (greatest - least) / 2.0)
    };
    let ((x, width), (y, height)) =
        (middle(points.iter().map(|point| point.0).collect()), middle(points.iter().map(|point| point.1).collect()));
    assert!((width - height).abs() < 0.1, "{width} {height}");
    for point in &points {
        assert!(((point.0 - x).hypot(point.1 - y) - width).abs() < 0.1, "{point:?}");
    }
    assert!(picture.contains(">X.position [mm]<") && picture.contains(">Y.position [mm]<"));
    assert!(picture.contains(">start<") && picture.contains(">end<"));
}

#[test]
fn a_way_is_drawn_once_however_often_it_is_gone() {
    let round = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
    let once = path(&picture(round.into_iter().chain([(0.0, 0.0)])));
    let often = path(&picture(round.into_iter().cycle().take(4001)));
    assert_eq!(once.len(), 6, "{once:?}");
    assert_eq!(once, often);
}

#[test]
fn a_gap_lifts_the_pen() {
    let points = path(&picture([(0.0, 0.0), (1.0, 0.0), (f64::NAN, 0.0), (1.0, 1.0), (0.0, 1.0)]));
    assert_eq!(points.iter().filter(|point| point.is_none()).count(), 2, "{points:?}");
}

#[test]
fn there_is_no_path_without_movement_or_without_its_signals() {
    assert!(!picture([(3.0, 4.0), (3.0, 4.0)]).contains(">start<"));
    assert!(!picture([]).contains(">start<"));
    let mut trace = Trace::new(vec![Signal::continuous("X.position", "mm", "position")]);
    trace.push(0.0, &[1.0]).expect("the row fits");
    let paths = vec![["X.position", "Y.position"].map(str::to_owned)];
    assert!(!svg(&trace, &PlotOptions { paths, ..PlotOptions::default() }).contains(">start<"));
}

#[test]
fn an_axis_alone_is_a_straight_line() {
    let points: Vec<(f64, f64)> = path(&picture([(0.0, 5.0), (10.0, 5.0)])).into_iter().flatten().collect();
    assert_eq!(points.len(), 2);
    assert_eq!(points[0].1, points[1].1);
}

#[test]
fn a_trace_can_leave_signals_out() {
    let signals = ["a", "b", "c"].map(|name| Signal::continuous(name, "", ""));
    let mut trace = Trace::new(signals.to_vec());
    trace.push(0.0, &[1.0, 2.0, 3.0]).expect("the row fits");
    let trace = trace.without(|index| index == 1);
    assert_eq!(trace.signals().iter().map(|signal| signal.name.as_str()).collect::<Vec<_>>(), ["a", "c"]);
    assert_eq!((trace.value(0, 0), trace.value(0, 1), trace.value(0, 2)), (Some(1.0), Some(3.0), None));
}
