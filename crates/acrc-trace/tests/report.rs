//! The page of a run: that it is one file, that nothing in a run gets out of its place, and that its script can be read. What it does in a browser is
//! tested with the command line.

use std::path::{Path, PathBuf};
use std::process::Command;

use acrc_trace::plot::Event;
use acrc_trace::report::{OutputLine, Report, SourceText, html};
use acrc_trace::{Entry, Envelope, Place, Signal, StatementLog, Trace};
use serde_json::{Value, json};

const EVIL: &str = "</script><script>alert(1)</script><!-- {{data}} {{script}}";

fn page() -> String {
    let signals = vec![
        Signal::continuous("X.position", "mm", "position").with_source("P12288 / P12375"),
        Signal::continuous("P0", "", "P0"),
        Signal::bit(EVIL, "bits"),
    ];
    let mut envelope = Envelope::new(signals.clone(), 1000);
    let mut positions = Trace::new(signals[..2].to_vec());
    for row in 0..5 {
        let value = f64::from(row);
        envelope.push(value, &[value * 0.25, f64::NAN, f64::from(row % 2)]).expect("the row fits");
        positions.push(value, &[value, 7.0]).expect("the row fits");
    }
    let mut statements = StatementLog::new(10);
    let place = Place { file: Some(0), line: 2, statement: 1 };
    statements.record(0, || "PROG0".to_owned(), Entry { time: 0.25, place, state: "waiting" });
    let place = Place { file: None, ..place };
    statements.record(1, || "PROG1".to_owned(), Entry { time: 0.5, place, state: "running" });
    html(&Report {
        title: EVIL,
        facts: vec![("end".to_owned(), EVIL.to_owned())],
        signals: &envelope,
        positions: &positions,
        paths: vec![["X.position", "P0"].map(str::to_owned), ["X.position", "gone"].map(str::to_owned)],
        events: &[Event { time: 1.0, text: EVIL.to_owned() }],
        statements: &statements,
        files: vec![SourceText { name: "Prog0.8K".to_owned(), text: format!("PROGRAM\r\n{EVIL}\r\nENDP\r\n") }],
        listings: vec![SourceText { name: "PROG1".to_owned(), text: "PBOOT\nEND\n".to_owned() }],
        output: vec![OutputLine { time: 0.5, source: "PROG0".to_owned(), text: EVIL }],
        faults: Vec::new(),
        notes: &[EVIL.to_owned()],
    })
}

/// The data of a page.
fn data(page: &str) -> Value {
    let (_, rest) = page.split_once("id=\"data\">").expect("the data");
    serde_json::from_str(rest.split_once("</script>").expect("its end").0).expect("JSON")
}

#[test]
fn a_page_is_one_file() {
    let page = page();
    for outside in [" src=", " href=", "@import", "url(http", "fetch(", "XMLHttpRequest", "import("] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert!(page.contains("default-src 'none'"));
}

#[test]
fn text_of_a_run_stays_text() {
    let page = page();
    assert_eq!(page.matches("</script>").count(), 2, "the data and the script");
    assert_eq!(page.matches("alert(1)").count(), page.matches(r"\u003cscript>alert(1)").count() + 1, "and the title");
    assert!(page.contains("<title>&lt;/script&gt;"));
    let data = data(&page);
    assert_eq!(data["notes"], json!([EVIL]));
    assert_eq!(data["files"][0]["lines"], json!(["PROGRAM", EVIL, "ENDP"]));
}

#[test]
fn the_data_has_what_the_script_reads() {
    let data = data(&page());
    assert_eq!((&data["end"], &data["per_point"], &data["resolution"]), (&json!(4.0), &json!(1), &json!(0.0)));
    let [position, parameter, bit] = [0, 1, 2].map(|index| data["signals"][index].clone());
    assert_eq!((&position["source"], &position["real"]["high"]), (&json!("P12288 / P12375"), &Value::Null));
    assert_eq!(position["real"]["low"]["count"], 5);
    assert_eq!(parameter["real"]["low"], Value::Null, "no number at all");
    assert_eq!(bit["bit"], json!([0, 0, 1, 3, 2, 0, 3, 3, 4, 0]));
    assert_eq!(data["times"], json!([1, 0, 4, 1_000_000]));
    assert_eq!(data["paths"].as_array().map(Vec::len), Some(1));
    assert_eq!(data["paths"][0]["y"], json!(7.0));
    assert_eq!(
        data["programs"][0],
        json!({ "name": "PROG0", "places": [[0, 2, 1, "waiting"]], "steps": [250_000], "entries": [0] })
    );
    assert_eq!(data["programs"][1]["places"], json!([[1, 2, 1, "running"]]), "the listing stands behind the files");
}

#[test]
fn numbers_keep_nine_digits_of_their_range() {
    let mut envelope = Envelope::new(vec![Signal::continuous("a", "", "")], 1000);
    let values = [-1e9, 3.25, 0.0, 1e9];
    for (row, value) in (0..).zip(values) {
        envelope.push(f64::from(row), &[value]).expect("the row fits");
    }
    let statements = StatementLog::new(1);
    let positions = Trace::new(Vec::new());
    let page = html(&Report {
        title: "",
        facts: Vec::new(),
        signals: &envelope,
        positions: &positions,
        paths: Vec::new(),
        events: &[],
        statements: &statements,
        files: Vec::new(),
        listings: Vec::new(),
        output: Vec::new(),
        faults: Vec::new(),
        notes: &[],
    });
    let low = data(&page)["signals"][0]["real"]["low"].clone();
    let [offset, step] = ["offset", "step"].map(|key| low[key].as_f64().expect("a number"));
    let bytes =
        base64::Engine::decode(&base64::engine::general_purpose::STANDARD, low["wholes"].as_str().expect("text"));
    let wholes = bytes
        .expect("base64")
        .chunks(4)
        .map(|bytes| i32::from_le_bytes(bytes.try_into().expect("four")))
        .collect::<Vec<_>>();
    for (value, whole) in values.iter().zip(wholes) {
        assert!((offset + step * f64::from(whole) - value).abs() <= 1.0, "{value} {whole}");
    }
}

fn scripts() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/report/page");
    let entries =
        std::fs::read_dir(folder).expect("the parts of the page").map(|entry| entry.expect("an entry").path());
    let mut scripts: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|end| end == "js")).collect();
    scripts.sort();
    scripts
}

#[test]
fn every_part_of_the_script_is_in_the_page() {
    let page = page();
    for script in scripts() {
        let text = std::fs::read_to_string(&script).expect("a script");
        assert!(page.contains(&text), "{} is in no page", script.display());
    }
}

#[test]
fn every_part_of_the_script_can_be_read() {
    if Command::new("node").arg("--version").output().is_err() {
        eprintln!("node is not installed: the syntax of the script is not checked here");
        return;
    }
    for script in scripts() {
        let check = Command::new("node").arg("--check").arg(&script).output().expect("node starts");
        assert!(check.status.success(), "{}", String::from_utf8_lossy(&check.stderr));
    }
}
