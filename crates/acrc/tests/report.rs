//! `acrc sim --report`: the page of a run in a browser.

#[path = "common/browser.rs"]
mod browser;
mod common;

use std::path::{Path, PathBuf};

use acrc_trace::plot::Event;
use acrc_trace::report::{Report, html};
use acrc_trace::{Entry, Envelope, Place, Signal, StatementLog, Trace};
use browser::Browser;
use common::{Bench, gantry};

/// The page of the gantry.
fn gantry_page(bench: &Bench) -> PathBuf {
    bench.sim(&format!("{} --report run.html", gantry().display()));
    bench.path("run.html")
}

/// The value of an attribute of the element that `mark` stands in, ahead of it.
fn attribute<'d>(dom: &'d str, mark: &str, name: &str) -> &'d str {
    let (_, rest) = dom.split_once(mark).unwrap_or_else(|| panic!("no {mark}"));
    let (_, rest) = rest.split_once(&format!(" {name}=\"")).unwrap_or_else(|| panic!("no {name} behind {mark}"));
    rest.split_once('"').expect("the end of the attribute").0
}

/// The text of the first element behind `mark`.
fn text<'d>(dom: &'d str, mark: &str) -> &'d str {
    let (_, rest) = dom.split_once(mark).unwrap_or_else(|| panic!("no {mark}"));
    let (_, rest) = rest.split_once('>').expect("the end of the tag");
    rest.split_once('<').expect("the end of the text").0
}

/// What the legend says of a signal at the cursor.
fn value<'d>(dom: &'d str, signal: &str) -> &'d str {
    text(dom, &format!("class=\"value\" data-signal=\"{signal}\""))
}

/// Lets a script act on a page when it is ready, and gives back the document and the lines that the script wrote with `say`. Errors of any script are
/// lines, too.
fn act(browser: &Browser, page: &Path, address: &str, script: &str) -> (String, Vec<String>) {
    let text = std::fs::read_to_string(page).expect("the page");
    let say = "<script>function say(text) { document.body.append(Object.assign(document.createElement('pre'), { textContent: 'said ' + text })); }\n\
               window.addEventListener('error', (event) => say(event.message));</script>";
    let text = text.replacen("<body>", &format!("<body>{say}"), 1);
    let text = text.replacen("</body>", &format!("<script>{script}</script></body>"), 1);
    let copy = page.with_file_name("acted.html");
    std::fs::write(&copy, text).expect("the folder is writable");
    let dom = browser.dom(&copy, address);
    let said = dom.split("<pre>said ").skip(1).filter_map(|rest| rest.split_once("</pre>"));
    let said = said.map(|(line, _)| line.to_owned()).collect();
    (dom, said)
}

#[test]
fn the_page_is_written_beside_the_other_files() {
    let bench = Bench::new();
    let arguments = format!("{} --report run.html --trace t.csv --plot p.svg --until 1s", gantry().display());
    let run = bench.acrc(["sim"].into_iter().chain(arguments.split(' '))).expect(0);
    assert!(run.stdout.contains("report     run.html"), "{}", run.stdout);
    let clash = bench.acrc(["sim", &gantry().display().to_string(), "--report", "a", "--plot", "a"]).expect(2);
    assert!(clash.stderr.contains("a is named for two outputs"), "{}", clash.stderr);
    let page = String::from_utf8(bench.read("run.html")).expect("UTF-8");
    assert!(page.starts_with("<!DOCTYPE html>") && page.contains("X(60 * LV2) Y(45 * LV0)"), "the source is in it");
    bench.sim(&format!("{} --report again.html --until 1s", gantry().display()));
    assert_eq!(page.as_bytes(), bench.read("again.html"), "the same run gives the same page");
}

#[test]
fn the_page_shows_the_run_at_the_cursor() {
    let Some(browser) = Browser::find() else { return };
    let bench = Bench::new();
    let page = gantry_page(&bench);
    let (dom, said) = act(&browser, &page, "#from=2&to=3&at=2.7", "");
    assert_eq!(said, [""; 0]);
    assert_eq!(text(&dom, "<h1"), "gantry");
    assert_eq!(["data-from", "data-to", "data-cursor"].map(|name| attribute(&dom, "<main", name)), ["2", "3", "2.7"]);
    assert_eq!(text(&dom, "id=\"range\""), "2 s to 3 s (1 s)");
    let values = ["X.position", "Z.velocity", "BIT10 light_curtain", "BIT34 Camera"].map(|signal| value(&dom, signal));
    assert_eq!(values, ["180 units", "120 units/s", "on", "off"]);
    assert!(!dom.contains("data-group=\"following error\""), "always 0, and nobody asked");
    // Program 0 waits for the end of its move, program 1 for the curtain.
    assert_eq!(attribute(&dom, "data-program=\"PROG0\"", "data-line"), "19");
    assert_eq!(attribute(&dom, "data-program=\"PROG1\"", "data-line"), "11");
    let here: Vec<&str> = dom.split("aria-current=\"true\"").skip(1).map(|rest| text(rest, "</span")).collect();
    assert_eq!(here.iter().map(|line| line.trim()).collect::<Vec<_>>(), ["INH -516", "INH -LightCurtain"]);
    assert_eq!(text(&dom, "id=\"output-count\""), "2 lines, of 9 in the whole run");
    assert!(dom.contains("<td>PROG0</td><td>row 1 done</td>"));
    // Only the event in sight is marked.
    assert!(dom.contains(">curtain broken</text>") && !dom.contains(">curtain free</text>"));
}

#[test]
fn keys_buttons_and_mouse_move_the_view() {
    let Some(browser) = Browser::find() else { return };
    let bench = Bench::new();
    let page = gantry_page(&bench);
    let (dom, said) = act(&browser, &page, "", include_str!("report_acts.js"));
    let expected = [
        "End: 0.00 12.00 12.00",
        "Home: 0.00 12.00 0.00",
        "ArrowRight: 0.00 12.00 0.06",
        "Shift ArrowRight: 0.00 12.00 0.06",
        "field: 0.00 12.00 6.00",
        "+: 2.00 10.00 6.00",
        "Shift ArrowRight: 2.80 10.80 6.00",
        "-: 0.00 12.00 6.00",
        "0: 0.00 12.00 6.00",
        "zoom-in: 2.00 10.00 6.00",
        "zoom-in: 3.33 8.67 6.00",
        "forth: 4.67 10.00 6.00",
        "back: 3.33 8.67 6.00",
        "zoom-out: 2.00 10.00 6.00",
        "whole: 0.00 12.00 6.00",
        "click: 0.00 12.00 3.00",
        "selected: 50 25",
        "select: 6.00 9.00 3.00",
        "drag: 6.75 9.75 3.00",
        "wheel: 6.75 9.25 3.00",
        "heights: \u{2212}200 \u{2212}100 0 100 200",
        "fitted: \u{2212}150 \u{2212}100 \u{2212}50 0",
        "double click: 0.00 12.00 9.00",
        "output: 0.00 12.00 9.76",
    ];
    assert_eq!(said, expected);
    // What is drawn has followed.
    assert_eq!(text(&dom, "id=\"range\""), "0 s to 12 s (12 s)");
    assert_eq!(attribute(&dom, "data-program=\"PROG1\"", "data-line"), "8");
    assert_eq!(value(&dom, "X.position"), "0 units");
}

#[test]
fn a_long_run_is_shown_by_its_least_and_greatest_values() {
    let Some(browser) = Browser::find() else { return };
    let bench = Bench::new();
    let signals = vec![Signal::continuous("X.position", "mm", "position"), Signal::bit("BIT32", "bits")];
    let mut envelope = Envelope::new(signals, 40_000);
    let mut statements = StatementLog::new(1000);
    for row in 0_u32..100_000 {
        let time = f64::from(row) * 0.001;
        // A peak of one sample, and a pulse of one.
        let peak = if row == 54_321 { 99.0 } else { f64::from(row % 10) };
        envelope.push(time, &[peak, f64::from(u8::from(row == 12_345))]).expect("the row fits");
        let place = Place { file: None, line: 1 + row % 3, statement: 1 };
        statements.record(0, || "PROG0".to_owned(), Entry { time, place, state: "running" });
    }
    let page = html(&Report {
        title: "long",
        facts: Vec::new(),
        signals: &envelope,
        positions: &Trace::new(Vec::new()),
        paths: Vec::new(),
        events: &[],
        statements: &statements,
        files: Vec::new(),
        listings: Vec::new(),
        output: Vec::new(),
        faults: vec![Event { time: 50.0, text: "PROG0 line 3 statement 1: something is wrong".to_owned() }],
        notes: &["no document names P20000".to_owned()],
    });
    let path = bench.file("long.html", page);
    let (dom, said) = act(&browser, &path, "#at=54.321", "");
    assert_eq!(said, [""; 0]);
    assert_eq!(value(&dom, "X.position"), "0 \u{2026} 99 mm");
    assert!(text(&dom, "id=\"points\"").contains("a point is the least and the greatest of 16 samples"));
    assert!(text(&dom, "id=\"resolution\"").contains("right to within"), "{}", text(&dom, "id=\"resolution\""));
    assert!(
        dom.contains("something is wrong")
            && !dom.contains("id=\"faults-section\" aria-labelledby=\"faults-heading\" hidden")
    );
    assert!(dom.contains("no document names P20000"), "notes");
    assert!(dom.contains(">fault: PROG0 line 3 statement 1: something"), "it is marked in the plots");
    // Whatever the width of the picture, the curve has no more points than can be seen.
    let (_, curve) = dom.split_once("class=\"band\"").expect("a band");
    let curve = attribute(curve, "", "d");
    assert!(curve.matches('L').count() < 6000, "{}", curve.matches('L').count());
    let highest = curve.split(['M', 'L', 'Z']).filter_map(|point| point.split_once(' ')?.1.parse::<f64>().ok());
    let highest = highest.fold(f64::INFINITY, f64::min);
    assert!(highest < 34.0, "the peak reaches the top of the panel: {highest}");
    assert!(dom.contains("class=\"mixed\""), "a pulse shorter than a point");
}

#[test]
fn a_run_without_signals_is_a_page_too() {
    let Some(browser) = Browser::find() else { return };
    let bench = Bench::new();
    bench.file("hello.8K", "PROG0\nPROGRAM\nPRINT \"<b>hello</b> & more\"\nENDP\n");
    bench.sim("hello.8K --run PROG0 --report run.html");
    let (dom, said) = act(
        &browser,
        &bench.path("run.html"),
        "",
        "document.getElementById('plots').dispatchEvent(new WheelEvent('wheel', { ctrlKey: true }))",
    );
    assert_eq!(said, [""; 0]);
    assert!(dom.contains("No signal was recorded") && dom.contains("&lt;b&gt;hello&lt;/b&gt; &amp; more"));
}
