//! Pictures. What they look like is for people to judge; here is what must hold for all of them.

use acrc_trace::plot::{Event, PlotOptions, svg};
use acrc_trace::{Signal, Trace};
use proptest::prelude::*;

fn event(time: f64, text: &str) -> Event {
    Event { time, text: text.to_owned() }
}

fn one_signal(samples: impl IntoIterator<Item = (f64, f64)>) -> Trace {
    let mut trace = Trace::new(vec![Signal::continuous("X.position", "mm", "position")]);
    for (time, value) in samples {
        trace.push(time, &[value]).expect("the row fits");
    }
    trace
}

fn one_bit(samples: impl IntoIterator<Item = (f64, bool)>) -> Trace {
    let mut trace = Trace::new(vec![Signal::bit("BIT32", "bits")]);
    for (time, on) in samples {
        trace.push(time, &[f64::from(u8::from(on))]).expect("the row fits");
    }
    trace
}

fn draw(trace: &Trace) -> String {
    svg(trace, &PlotOptions::default())
}

/// The points of the first curve of a picture.
fn first_curve(picture: &str) -> Vec<(f64, f64)> {
    let curves = picture.split_once("stroke-linejoin").map_or("", |(_, rest)| rest);
    let curves = curves.split_once("</g>").map_or("", |(curves, _)| curves);
    let data = curves.split_once("d=\"").and_then(|(_, rest)| rest.split_once('"')).map_or("", |(data, _)| data);
    let points = data.split(['M', 'L']).filter_map(|point| point.trim_end_matches("h0").split_once(' '));
    points.map(|(x, y)| (number(x), number(y))).collect()
}

/// Left edge and width of the bars of a picture of one bit.
fn bars(picture: &str) -> Vec<(f64, f64)> {
    let bars = picture.split_once("<g fill=\"#0072b2\">").map_or("", |(_, rest)| rest);
    let bars = bars.split_once("</g>").map_or("", |(bars, _)| bars);
    bars.lines().filter_map(|bar| Some((attribute(bar, "x")?, attribute(bar, "width")?))).collect()
}

fn attribute(element: &str, name: &str) -> Option<f64> {
    let (_, rest) = element.split_once(&format!(" {name}=\""))?;
    rest.split_once('"').map(|(value, _)| number(value))
}

fn number(text: &str) -> f64 {
    text.parse().expect("a number is written")
}

/// Checks that tags are balanced, attributes quoted and text escaped.
fn assert_well_formed(picture: &str) {
    let mut open = Vec::new();
    for tag in picture.split('<').skip(1) {
        let (tag, text) = tag.split_once('>').expect("every tag is closed");
        assert!(text.split('&').skip(1).all(|entity| entity.contains(';')), "bare ampersand in {text:?}");
        assert_eq!(tag.matches('"').count() % 2, 0, "odd quotes in {tag:?}");
        assert!(!text.contains(|c: char| c.is_control() && c != '\n'), "control character in {text:?}");
        let name = tag.split([' ', '/']).find(|name| !name.is_empty());
        if tag.starts_with('/') {
            assert_eq!(open.pop(), name, "tags are nested");
        } else if !tag.ends_with('/') {
            open.extend(name);
        }
    }
    assert!(open.is_empty(), "unclosed: {open:?}");
    assert!(picture.starts_with("<svg xmlns=") && picture.ends_with("</svg>\n"));
}

#[test]
fn a_small_picture() {
    let mut trace = Trace::new(vec![
        Signal::continuous("X.position", "mm", "position"),
        Signal::continuous("X.target", "mm", "position"),
        Signal::continuous("X.velocity", "mm/s", "velocity"),
        Signal::bit("IN3 <part>", "bits"),
        Signal::bit("OUT32 & lamp", "bits"),
    ]);
    let rows = [
        (0.0, [0.0, 10.0, 0.0, 0.0, 1.0]),
        (0.25, [1.25, 10.0, 10.0, 0.0, 1.0]),
        (0.5, [5.0, 10.0, 20.0, 1.0, 0.0]),
        (0.75, [8.75, 10.0, f64::NAN, 1.0, 0.0]),
        (1.0, [10.0, 10.0, 0.0, 0.0, 1.0]),
    ];
    for (time, values) in rows {
        trace.push(time, &values).expect("the row fits");
    }
    let options = PlotOptions {
        title: "One move <test>".to_owned(),
        width: 480,
        panel_height: 90,
        events: vec![event(0.5, "IN3 on"), event(0.0, "start"), event(2.0, "after the end")],
        ..PlotOptions::default()
    };
    let picture = svg(&trace, &options);
    assert_well_formed(&picture);
    assert_eq!(picture, svg(&trace, &options));
    insta::assert_snapshot!(picture);
}

#[test]
fn nothing_recorded() {
    let options = PlotOptions { title: "A & B".to_owned(), ..PlotOptions::default() };
    let without_rows = svg(&one_signal([]), &options);
    let mut without_signals = Trace::new(Vec::new());
    without_signals.push(0.0, &[]).expect("the row fits");
    assert_eq!(svg(&without_signals, &options), without_rows);
    assert_well_formed(&without_rows);
    insta::assert_snapshot!(without_rows);
}

#[test]
fn one_row_is_a_dot() {
    let picture = draw(&one_signal([(3.0, 5.0)]));
    assert_well_formed(&picture);
    assert_eq!(first_curve(&picture).len(), 1);
    assert!(picture.contains("h0\""), "a line without length");
}

#[test]
fn a_constant_signal_is_a_level_line() {
    for value in [0.0, 12.5, -3e7, 1e-300] {
        let picture = draw(&one_signal((0..1_000).map(|tick| (f64::from(tick), value))));
        let curve = first_curve(&picture);
        assert_eq!(curve.len(), 2, "two points are enough");
        assert_eq!(curve[0].1, curve[1].1);
    }
}

#[test]
fn peaks_survive_and_columns_have_two_points() {
    let spike = |tick: i32| if tick == 33_333 { 1_000.0 } else { f64::from(tick % 7) };
    let picture = draw(&one_signal((0..100_000).map(|tick| (f64::from(tick) * 0.0005, spike(tick)))));
    let curve = first_curve(&picture);
    let highest = curve.iter().map(|(_, y)| *y).fold(f64::INFINITY, f64::min);
    let coarse = draw(&one_signal([(0.0, 0.0), (16.666_5, 1_000.0), (49.999_5, 6.0)]));
    let expected = first_curve(&coarse)[1].1;
    assert_eq!(highest, expected, "the spike is as high as without its neighbours");

    let columns = curve.chunk_by(|a, b| a.0.floor() == b.0.floor());
    let crowded = columns.filter(|column| column.len() > 2).count();
    assert!(crowded <= 2, "only the first and the last column may hold an end point besides");
    assert!(curve.len() <= 2_000, "{} points", curve.len());
}

#[test]
fn what_is_no_number_breaks_the_line() {
    let values = [1.0, 2.0, f64::NAN, 3.0, f64::INFINITY, 4.0, 1e200, 2.0];
    let picture = draw(&one_signal((0_u8..).map(f64::from).zip(values)));
    assert_well_formed(&picture);
    assert!(!picture.contains("NaN") && !picture.contains("inf"));
    assert_eq!(first_curve(&picture).len(), 5);
    assert_eq!(picture.matches("h0").count(), 3, "single samples are dots");
}

#[test]
fn nothing_drawable_leaves_an_empty_panel() {
    let picture = draw(&one_signal([(0.0, f64::NAN), (1.0, f64::INFINITY)]));
    assert_well_formed(&picture);
    assert_eq!(first_curve(&picture), []);
}

#[test]
fn a_bit_holds_until_the_next_sample() {
    let picture = draw(&one_bit([(0.0, false), (1.0, true), (3.0, false), (4.0, true), (5.0, true)]));
    let bars = bars(&picture);
    assert_eq!(bars.len(), 2);
    assert!((bars[0].1 - 2.0 * bars[1].1).abs() < 0.02, "two seconds are twice as wide as one: {bars:?}");
}

#[test]
fn a_short_pulse_is_seen() {
    let picture = draw(&one_bit((0..100_000).map(|tick| (f64::from(tick), tick == 50_000))));
    let bars = bars(&picture);
    assert_eq!(bars.len(), 1);
    assert!(bars[0].1 >= 1.0);
}

#[test]
fn a_fast_bit_has_at_most_one_bar_a_pixel() {
    let picture = draw(&one_bit((0..100_000).map(|tick| (f64::from(tick), tick % 2 == 0))));
    assert!(bars(&picture).len() <= 1_000);
}

#[test]
fn the_same_axis_has_one_color_in_all_panels() {
    let mut trace = Trace::new(vec![
        Signal::continuous("X.position", "mm", "position"),
        Signal::continuous("Y.position", "mm", "position"),
        Signal::continuous("Y.velocity", "mm/s", "velocity"),
        Signal::continuous("Y.target", "mm/s", "velocity"),
    ]);
    trace.push(0.0, &[1.0, 2.0, 3.0, 4.0]).expect("the row fits");
    let picture = draw(&trace);
    // Each style is written for a curve and for its sample in the legend.
    assert_eq!(picture.matches("stroke=\"#0072b2\"").count(), 2);
    assert_eq!(picture.matches("stroke=\"#d55e00\"").count(), 6);
    assert_eq!(picture.matches("stroke=\"#d55e00\" stroke-dasharray").count(), 2, "the second of a color is dashed");
}

#[test]
fn labels_are_round_numbers() {
    let labels = |from: f64, to: f64| -> Vec<String> {
        let picture = draw(&one_signal([(0.0, from), (1.0, to)]));
        let labels = picture.lines().filter(|line| line.starts_with("<text x=") && line.contains("\"end\""));
        labels.filter_map(|line| Some(line.split_once('>')?.1.split_once('<')?.0.to_owned())).collect()
    };
    assert_eq!(labels(0.0, 1.0), ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
    assert_eq!(labels(-3.0, 0.0), ["−3", "−2", "−1", "0"]);
    assert_eq!(labels(0.0, 250_000.0), ["0", "50000", "100000", "150000", "200000", "250000"]);
    assert_eq!(labels(0.0, 5e9), ["0", "1e9", "2e9", "3e9", "4e9", "5e9"]);
    assert_eq!(labels(1e-6, 5e-6), ["1e-6", "2e-6", "3e-6", "4e-6", "5e-6"]);
    assert_eq!(labels(100.0, 100.000_04), ["100.00000", "100.00001", "100.00002", "100.00003", "100.00004"]);
}

#[test]
fn crowded_events_keep_their_lines() {
    let trace = one_signal([(0.0, 0.0), (1.0, 1.0)]);
    let events = (0..50).map(|tick| event(0.5 + f64::from(tick) * 1e-4, "IN & OUT")).collect();
    let picture = svg(&trace, &PlotOptions { events, ..PlotOptions::default() });
    assert_well_formed(&picture);
    assert_eq!(picture.matches("<title>IN &amp; OUT</title>").count(), 50);
    assert_eq!(picture.matches(">IN &amp; OUT</text>").count(), 4);
}

#[test]
fn long_names_are_cut_and_control_characters_replaced() {
    let long = "input of the light barrier at the far end of the left conveyor";
    let mut trace = Trace::new(vec![Signal::bit(long, "bits"), Signal::bit("bell\u{7}\u{0}\n", "bits")]);
    trace.push(0.0, &[0.0, 0.0]).expect("the row fits");
    let picture = draw(&trace);
    assert_well_formed(&picture);
    assert!(picture.contains(&format!("<title>{long}</title>")));
    assert!(picture.contains("bell\u{FFFD}\u{FFFD} <"));
}

proptest! {
    #[test]
    fn any_recording_can_be_drawn(
        rows in prop::collection::vec((any::<f64>(), any::<f64>(), -5.0..5.0), 0..40),
        options in (0_u32..3_000, 0_u32..500),
        at in any::<f64>(),
    ) {
        let mut trace = Trace::new(vec![
            Signal::continuous("a", "", "wild"),
            Signal::continuous("b", "", "tame"),
            Signal::bit("c", "bits"),
        ]);
        let mut rows: Vec<_> = rows.into_iter().filter(|(time, ..)| time.is_finite()).collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (time, wild, tame) in rows {
            trace.push(time, &[wild, tame, tame.floor()]).expect("the rows are sorted");
        }
        let (width, panel_height) = options;
        let events = vec![event(at, "event"), event(0.0, "zero")];
        let picture = svg(&trace, &PlotOptions { title: String::new(), width, panel_height, events, paths: Vec::new() });
        assert_well_formed(&picture);
        prop_assert!(!picture.contains("NaN") && !picture.contains("inf"));
        for (x, y) in first_curve(&picture) {
            prop_assert!((0.0..=f64::from(width.max(700))).contains(&x));
            prop_assert!((0.0..=800.0).contains(&y));
        }
    }

    #[test]
    fn axes_have_a_few_ticks(from in -1e12..1e12_f64, magnitude in -12..12_i32, panel_height in 60_u32..400) {
        let range = 10_f64.powi(magnitude);
        let options = PlotOptions { panel_height, ..PlotOptions::default() };
        let picture = svg(&one_signal([(0.0, from), (1.0, from + range)]), &options);
        let ticks = picture.matches("text-anchor=\"end\"").count();
        prop_assert!((1..=panel_height as usize / 28 + 2).contains(&ticks), "{} ticks", ticks);
    }
}
