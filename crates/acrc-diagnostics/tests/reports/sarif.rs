//! The SARIF form: its picture, and that it obeys the schema of the standard.

use crate::sample::{LABEL, VALUE, with_sample, written};
use std::sync::LazyLock;

use acrc_diagnostics::sarif::{self, RuleInfo};
use acrc_diagnostics::{Code, Diagnostic, Edit, FileReport, Fix, Severity, SourceFile, Span, Unchecked};
use jsonschema::Validator;
use serde_json::Value;

fn rule(code: Code) -> Option<RuleInfo> {
    (code == LABEL).then(|| RuleInfo {
        severity: Severity::Error,
        summary: "A jump goes to a label that no line has.".into(),
        description: "A jump goes to a label that no line has. The controller stops the program there.".into(),
        help: "A jump goes to a label that no line has.\n\nDefine it.".into(),
        help_markdown: Some("A jump goes to a label that no line has.\n\nDefine **it**.".into()),
        tags: vec!["flow".into()],
    })
}

static VALIDATOR: LazyLock<Validator> = LazyLock::new(|| {
    // A pattern of the schema has a bracket too many, which a strict reader of regular expressions refuses.
    let schema = include_str!("data/sarif-schema-2.1.0.json").replace("[a-zA-Z]{2}]?$", "[a-zA-Z]{2}$");
    let schema = serde_json::from_str(&schema).expect("the schema is JSON");
    jsonschema::draft7::options().should_validate_formats(true).build(&schema).expect("the schema is one")
});

/// Renders, and insists on the schema.
pub(crate) fn rendered(reports: &[FileReport<'_>]) -> String {
    rendered_with(reports, &[])
}

fn rendered_with(reports: &[FileReport<'_>], unchecked: &[Unchecked]) -> String {
    let text = written(|out| sarif::render(reports, unchecked, &rule, out));
    assert!(text.ends_with("}\n") && text.matches('\n').count() == 1, "one line");
    let log: Value = serde_json::from_str(&text).expect("JSON reads back");
    let errors: Vec<String> =
        VALIDATOR.iter_errors(&log).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(errors.is_empty(), "{}", errors.join("\n"));
    text
}

fn read(reports: &[FileReport<'_>]) -> Value {
    serde_json::from_str(&rendered(reports)).expect("JSON reads back")
}

#[test]
fn the_validator_finds_mistakes() {
    let mut log = with_sample(read);
    log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"] = 0.into();
    assert!(!VALIDATOR.is_valid(&log));
    let mut log = with_sample(read);
    log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] = "a b".into();
    assert!(!VALIDATOR.is_valid(&log), "formats are looked at");
}

#[test]
fn sample() {
    let text = with_sample(rendered);
    let start = r#"{"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[{"tool":{"driver":{"name":"acrc","semanticVersion":""#;
    assert!(text.starts_with(start), "members keep their order");
    let log: Value = serde_json::from_str(&text).expect("JSON reads back");
    let results = serde_json::to_string_pretty(&log["runs"][0]["results"]).expect("it was JSON");
    insta::assert_snapshot!("results", results);
    let mut run = log["runs"][0].clone();
    run["results"] = Value::Null;
    run["tool"]["driver"]["semanticVersion"] = Value::Null;
    insta::assert_snapshot!("run", serde_json::to_string_pretty(&run).expect("it was JSON"));
}

#[test]
fn nothing_found() {
    let log = read(&[]);
    assert_eq!(log["runs"][0]["results"], Value::Array(vec![]));
    assert_eq!(log["runs"][0]["tool"]["driver"]["rules"], Value::Array(vec![]));
}

#[test]
fn indices_lead_to_the_rule() {
    let log = with_sample(read);
    let run = &log["runs"][0];
    for result in run["results"].as_array().expect("an array") {
        let index = result["ruleIndex"].as_u64().expect("a number") as usize;
        assert_eq!(run["tool"]["driver"]["rules"][index]["id"], result["ruleId"]);
    }
}

#[test]
fn names_become_uris() {
    let cases = [
        ("machine/Prog0.8K", "machine/Prog0.8K", true),
        ("./Prog0.8K", "Prog0.8K", true),
        (".\\machine\\Prog0.8K", "machine/Prog0.8K", true),
        ("../other/Prog0.8K", "../other/Prog0.8K", true),
        ("my machine/Achsé 100%#1?.8K", "my%20machine/Achs%C3%A9%20100%25%231%3F.8K", true),
        ("a:b/c", "a%3Ab/c", true),
        ("<stdin>", "%3Cstdin%3E", true),
        ("a[1]{2}|\"^`\n\u{2028}", "a%5B1%5D%7B2%7D%7C%22%5E%60%0A%E2%80%A8", true),
        ("it's_(~$&+,;=@!*).8K", "it's_(~$&+,;=@!*).8K", true),
        ("/home/me/a b.8K", "file:///home/me/a%20b.8K", false),
        ("C:\\Projects\\a b.8K", "file:///C:/Projects/a%20b.8K", false),
        ("\\\\?\\C:\\Projects\\a.8K", "file:///C:/Projects/a.8K", false),
        ("\\\\server\\share\\a.8K", "file://server/share/a.8K", false),
        ("\\\\?\\UNC\\server\\share\\a.8K", "file://server/share/a.8K", false),
    ];
    let findings = [Diagnostic::error(VALUE, Span::default(), "x")];
    for (name, uri, relative) in cases {
        let log = read(&[FileReport::new(SourceFile::new(name, "X1"), &findings)]);
        let location = &log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"];
        assert_eq!(location["uri"], uri);
        assert_eq!(location["uriBaseId"].as_str(), relative.then_some("%SRCROOT%"), "{name}");
    }
}

/// Carries out a fix as a viewer does: by the regions in the report.
fn apply_replacements(text: &str, replacements: &Value) -> String {
    let mut lines: Vec<usize> = vec![0];
    lines.extend(text.match_indices('\n').map(|(at, _)| at + 1));
    let offset = |line: &Value, column: &Value| {
        let start = lines[line.as_u64().expect("a line") as usize - 1];
        let column = column.as_u64().expect("a column") as usize - 1;
        start + text[start..].chars().take(column).map(char::len_utf8).sum::<usize>()
    };
    let mut out = text.to_owned();
    for replacement in replacements.as_array().expect("an array").iter().rev() {
        let region = &replacement["deletedRegion"];
        let start = offset(&region["startLine"], &region["startColumn"]);
        let end = offset(&region["endLine"], &region["endColumn"]);
        out.replace_range(start..end, replacement["insertedContent"]["text"].as_str().unwrap_or_default());
    }
    out
}

#[test]
fn fixes_can_be_carried_out() {
    let text = "µ “a”\r\nX1\r\nY2";
    let at = |part: &str| {
        let start = text.find(part).expect("it is there");
        Span::from(start..start + part.len())
    };
    let edits = vec![
        Edit::insert(0, "REM "),
        Edit::replace(at("“"), "\""),
        Edit::replace(at("”"), "\""),
        Edit::delete(at("X1\r\n")),
        Edit::insert(text.len() as u32, "\r\nEND\r\n"),
    ];
    let fix = Fix::safe("repair", edits);
    let findings = [Diagnostic::error(VALUE, Span::empty(0), "x").with_fix(fix.clone()).with_fix(fix.clone())];
    let log = read(&[FileReport::new(SourceFile::new("a.8K", text), &findings)]);
    let fixes = &log["runs"][0]["results"][0]["fixes"];
    assert_eq!(fixes.as_array().map(Vec::len), Some(1), "one that is given twice is listed once");
    let after = apply_replacements(text, &fixes[0]["artifactChanges"][0]["replacements"]);
    assert_eq!(after, acrc_diagnostics::apply(text, &[&fix]).expect("the edits fit"));
}

#[test]
fn what_could_not_be_checked_are_notifications() {
    let unchecked = [
        Unchecked { name: Some("a b/acrc.toml".to_owned()), reason: "no {valid} description".to_owned() },
        Unchecked { name: None, reason: "x".to_owned() },
    ];
    let log: Value = serde_json::from_str(&rendered_with(&[], &unchecked)).expect("JSON reads back");
    let place = serde_json::json!({ "uri": "a%20b/acrc.toml", "uriBaseId": "%SRCROOT%" });
    let expected = serde_json::json!([{
        "executionSuccessful": false,
        "toolExecutionNotifications": [
            {
                "level": "error",
                "message": { "text": "no {{valid}} description" },
                "locations": [{ "physicalLocation": { "artifactLocation": place } }],
            },
            { "level": "error", "message": { "text": "x" } },
        ],
    }]);
    assert_eq!(log["runs"][0]["invocations"], expected);
}
