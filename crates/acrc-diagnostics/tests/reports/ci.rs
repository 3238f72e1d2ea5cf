//! The forms that build services read: their pictures, and that hostile names and messages stay text.

use std::collections::HashSet;
use std::io::{self, Write};

use crate::sample::{HOSTILE_MESSAGE, HOSTILE_NAME, LABEL, VALUE, with_sample, written};
use acrc_diagnostics::{
    Diagnostic, FileReport, SourceFile, Span, Unchecked, checkstyle, github, gitlab, json, jsonl, junit,
};
use quick_xml::Reader;
use quick_xml::events::Event;
use serde_json::Value;

type Render = fn(&[FileReport<'_>], &[Unchecked], &mut dyn Write) -> io::Result<()>;

fn sample_as(render: Render) -> String {
    with_sample(|reports| written(|out| render(reports, &[], out)))
}

fn nothing_as(render: Render) -> String {
    written(|out| render(&[], &[], out))
}

#[test]
fn jsonl_is_one_object_a_line() {
    let lines = sample_as(jsonl::render);
    let whole: Value = serde_json::from_str(&sample_as(json::render)).expect("JSON reads back");
    let each: Vec<Value> = lines.lines().map(|line| serde_json::from_str(line).expect("JSON reads back")).collect();
    assert_eq!(whole["diagnostics"], Value::Array(each), "the members are those of the whole document");
    assert!(lines.ends_with("}\n"));
    assert!(!lines.contains(['\r', '\u{85}', '\u{2028}', '\u{2029}']), "nothing else that ends a line");
    assert_eq!(nothing_as(jsonl::render), "");
    insta::assert_snapshot!(lines);
}

#[test]
fn github_is_one_command_a_line() {
    let commands = sample_as(github::render);
    assert_eq!(commands.lines().count(), 9);
    for command in commands.lines() {
        let (properties, message) = command.trim_start_matches("::").split_once("::").expect("two parts");
        let (name, properties) = properties.split_once(' ').expect("a name and properties");
        assert!(["error", "warning", "notice"].contains(&name));
        assert!(properties.split(',').all(|property| property.matches('=').count() == 1), "{properties}");
        assert!(!message.is_empty());
    }
    assert!(!commands.contains(['\r', '\u{1b}', '\u{2028}']));
    assert_eq!(nothing_as(github::render), "");
    insta::assert_snapshot!(commands);
}

#[test]
fn gitlab_is_an_array_of_issues() {
    let issues: Value = serde_json::from_str(&sample_as(gitlab::render)).expect("JSON reads back");
    let issues = issues.as_array().expect("an array");
    let fingerprints: HashSet<_> = issues.iter().map(|issue| issue["fingerprint"].as_str()).collect();
    assert_eq!(fingerprints.len(), issues.len(), "each its own");
    assert_eq!(nothing_as(gitlab::render), "[]\n");
    insta::assert_snapshot!(sample_as(gitlab::render).replace("},{", "},\n{"));
}

#[test]
fn junit_has_a_suite_a_file() {
    let xml = sample_as(junit::render);
    assert_eq!(elements(&xml), 1 + 4 + 10 + 9, "suites, cases, and what was found");
    assert_eq!(elements(&nothing_as(junit::render)), 1);
    insta::assert_snapshot!(xml);
}

#[test]
fn checkstyle_has_an_element_a_file() {
    let xml = sample_as(checkstyle::render);
    assert_eq!(elements(&xml), 1 + 4 + 9, "files and findings");
    assert_eq!(elements(&nothing_as(checkstyle::render)), 1);
    insta::assert_snapshot!(xml);
}

/// How many elements there are in a document, after it has been read as strictly as XML asks for.
pub(crate) fn elements(xml: &str) -> usize {
    let allowed = |c| matches!(c, '\n' | '\u{20}'..='\u{D7FF}' | '\u{E000}'..='\u{FFFD}' | '\u{10000}'..);
    assert!(xml.chars().all(allowed), "only characters that XML allows, and LF");
    assert!(xml.ends_with(">\n"));
    let mut reader = Reader::from_str(xml);
    reader.config_mut().enable_all_checks(true);
    let mut count = 0;
    loop {
        match reader.read_event().expect("well-formed") {
            Event::Start(element) | Event::Empty(element) => {
                count += 1;
                for attribute in element.attributes() {
                    attribute.expect("well-formed");
                }
            }
            Event::Eof => return count,
            _ => {}
        }
    }
}

#[test]
fn what_is_said_arrives() {
    // What a reader of JSON gets is what was put in.
    let read: Value = serde_json::from_str(sample_as(jsonl::render).lines().nth(7).expect("a line")).expect("JSON");
    assert_eq!(read["file"], HOSTILE_NAME);
    assert_eq!(read["message"], HOSTILE_MESSAGE);
    assert_eq!(read["fixes"][0]["edits"][0]["text"], HOSTILE_MESSAGE);
    // GitHub decodes the three escapes of a message and the five of a property.
    let command = sample_as(github::render).lines().nth(7).expect("a line").to_owned();
    assert!(command.contains("file=sp ace/a\"b'<c>&d%2541%2Ce%3Af#é"), "{command}");
    assert!(command.contains("%250A::error:: {0}"), "{command}");
}

/// The fingerprints of findings at each `GOTO` of a text.
fn fingerprints(name: &str, text: &str) -> Vec<String> {
    let found = text.match_indices("GOTO").map(|(start, _)| {
        Diagnostic::error(LABEL, Span::from(start..start + 4), format!("a message that names byte {start}"))
    });
    let findings: Vec<_> = found.collect();
    let reports = [FileReport::new(SourceFile::new(name, text), &findings)];
    let issues: Value = serde_json::from_str(&written(|out| gitlab::render(&reports, &[], out))).expect("JSON");
    let issues = issues.as_array().expect("an array");
    issues.iter().map(|issue| issue["fingerprint"].as_str().expect("text").to_owned()).collect()
}

#[test]
fn fingerprints_outlive_changes_elsewhere() {
    let before = fingerprints("Prog0.8K", "GOTO A\nGOTO A : GOTO B\nX1\nGOTO A\n");
    // Pinned: another value would make every known finding a new one.
    assert_eq!(before, ["cb7f1d92f412072c:1", "8110216940d1374c:1", "8110216940d1374c:2", "cb7f1d92f412072c:2"]);
    let shifted = "REM new\r\n\r\n  GOTO A\r\n\tGOTO A : GOTO B \r\nGOTO A\r\n";
    assert_eq!(fingerprints(".\\Prog0.8K", shifted), before, "lines, indentation, line ends, way of writing the name");
    let other = fingerprints("Prog1.8K", "GOTO A");
    assert!(!before.contains(&other[0]), "another file");
}

#[test]
fn many_findings_on_one_long_line() {
    let text = "GOTO A : ".repeat(20_000);
    let all = fingerprints("Prog0.8K", &text);
    assert_eq!(all.iter().collect::<HashSet<_>>().len(), 20_000);
}

#[test]
fn the_same_name_twice_in_a_report() {
    let findings = [Diagnostic::error(VALUE, Span::default(), "x")];
    let report = || FileReport::new(SourceFile::new("Prog0.8K", "X1"), &findings);
    let issues: Value =
        serde_json::from_str(&written(|out| gitlab::render(&[report(), report()], &[], out))).expect("JSON reads back");
    assert_ne!(issues[0]["fingerprint"], issues[1]["fingerprint"]);
}

#[test]
fn what_could_not_be_checked_is_in_every_form() {
    let unchecked = [
        Unchecked { name: Some(HOSTILE_NAME.to_owned()), reason: HOSTILE_MESSAGE.to_owned() },
        Unchecked { name: None, reason: "a reason\nof two lines".to_owned() },
    ];
    let clean = [FileReport::new(SourceFile::new("Prog0.8K", ""), [])];
    let form = |render: Render| written(|out| render(&clean, &unchecked, out));
    let document: Value = serde_json::from_str(&form(json::render)).expect("JSON reads back");
    let errors = serde_json::json!([
        { "file": HOSTILE_NAME, "message": HOSTILE_MESSAGE },
        { "file": null, "message": "a reason\nof two lines" },
    ]);
    assert_eq!(document["errors"], errors);
    assert_eq!(form(jsonl::render).lines().count(), 2);
    let issues: Value = serde_json::from_str(&form(gitlab::render)).expect("JSON reads back");
    assert_eq!(issues.as_array().map(Vec::len), Some(2));
    assert_eq!(form(github::render).lines().count(), 2);
    assert_eq!(elements(&form(junit::render)), 1 + 3 + 3 + 2);
    assert_eq!(elements(&form(checkstyle::render)), 1 + 3 + 2);
    let forms = [jsonl::render, gitlab::render, github::render, junit::render, checkstyle::render]
        .map(|render: Render| form(render));
    insta::assert_snapshot!(forms.join("\n"));
}
