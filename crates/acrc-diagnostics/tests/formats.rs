//! The line form, the JSON form and the summary.

use acrc_diagnostics::{Code, Diagnostic, Edit, FileReport, Fix, SourceFile, Span, Summary, concise, json};

const MISSING: Code = Code { id: "ACR204", name: "missing-value" };
const QUOTES: Code = Code { id: "ACR001", name: "typographic-character" };

const FIRST: &str = "X10 Y\r\nPRINT “a”\r\n";

fn findings() -> Vec<Diagnostic> {
    let quotes = Fix::safe(
        "write plain quotes",
        vec![Edit::replace(Span::new(13, 16), "\""), Edit::replace(Span::new(17, 20), "\"")],
    );
    vec![
        Diagnostic::error(MISSING, Span::new(4, 5), "axis Y has no\ntarget")
            .with_related(Span::new(0, 3), "axis X has one")
            .with_help("write the target after the axis"),
        Diagnostic::advice(QUOTES, Span::new(13, 20), "typographic quotes around \"a\"").with_fix(quotes),
    ]
}

fn with_reports<T>(check: impl FnOnce(&[FileReport<'_>]) -> T) -> T {
    let findings = findings();
    let other = [Diagnostic::warning(MISSING, Span::empty(3), "nothing follows").unconfirmed()];
    check(&[
        FileReport::new(SourceFile::new("machine/Prog0.8K", FIRST), &findings),
        FileReport::new(SourceFile::new("machine/PLC0.8K", "END"), &other),
        FileReport::new(SourceFile::new("machine/Setup.8K", ""), []),
    ])
}

#[test]
fn concise_is_one_line_a_finding() {
    let mut out = Vec::new();
    with_reports(|reports| concise::render(reports, &mut out)).expect("writing to memory works");
    insta::assert_snapshot!(String::from_utf8_lossy(&out));
}

#[test]
fn json_has_every_member() {
    let mut out = Vec::new();
    with_reports(|reports| json::render(reports, &[], &mut out)).expect("writing to memory works");
    let out = String::from_utf8(out).expect("JSON is text");
    assert_eq!(out.matches('\n').count(), 1, "one line");
    assert!(out.ends_with("}\n"));
    let members = r#"{"diagnostics":[{"code":"ACR204","name":"missing-value","severity":"error","message":"#;
    assert!(out.starts_with(members), "members keep their order");
    let value: serde_json::Value = serde_json::from_str(&out).expect("JSON reads back");
    insta::assert_snapshot!(serde_json::to_string_pretty(&value).expect("it was JSON"));
}

#[test]
fn json_of_nothing() {
    let mut out = Vec::new();
    json::render(&[], &[], &mut out).expect("writing to memory works");
    let empty = r#"{"diagnostics":[],"errors":[],"summary":{"files":0,"errors":0,"warnings":0,"advice":0}}"#;
    assert_eq!(String::from_utf8_lossy(&out), format!("{empty}\n"));
}

#[test]
fn summaries_count_in_words() {
    assert_eq!(with_reports(Summary::of).to_string(), "1 error, 1 warning, 1 piece of advice in 3 files");
    let shown = |files, errors, warnings, advice| Summary { files, errors, warnings, advice }.to_string();
    assert_eq!(shown(3, 0, 0, 0), "no problems in 3 files");
    assert_eq!(shown(1, 0, 0, 0), "no problems in 1 file");
    assert_eq!(shown(3, 2, 1, 0), "2 errors, 1 warning in 3 files");
    assert_eq!(shown(0, 0, 0, 2), "2 pieces of advice in 0 files");
}

#[test]
fn an_unconfirmed_finding_is_at_most_a_warning() {
    let error = Diagnostic::error(MISSING, Span::default(), "x").unconfirmed();
    let advice = Diagnostic::advice(MISSING, Span::default(), "x").unconfirmed();
    assert_eq!(error.severity.to_string(), "warning");
    assert_eq!(advice.severity.to_string(), "advice");
}
