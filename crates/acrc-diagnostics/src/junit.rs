//! A `JUnit` report: a test suite a file, a test case a finding, for services that show test results.
//!
//! Errors and warnings are failed tests. Advice is a skipped test: it is shown with its message and fails nothing. A file
//! without findings is one test that passed. There are no times and no identifiers in the report: the same findings
//! always give the same bytes.

use std::collections::HashMap;
use std::io::{self, Write};

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite, XmlString};

use crate::plain::plain_line;
use crate::remarks::message_with_remarks;
use crate::xml::xml_name;
use crate::{Code, Diagnostic, FileReport, Position, Severity};

/// The test of a file in which nothing was found.
const CLEAN: &str = "no findings";

/// Writes every file with its findings, in the order of `reports`. The report is built in memory before it is written.
pub fn render(reports: &[FileReport<'_>], out: &mut dyn Write) -> io::Result<()> {
    let mut document = Report::new("acrc");
    document.add_test_suites(reports.iter().map(suite));
    // By way of a buffer, since the writer of the report would hide the kind of an error of `out`.
    let mut text = Vec::new();
    document.serialize(&mut text).map_err(io::Error::other)?;
    out.write_all(&text)
}

fn suite(report: &FileReport<'_>) -> TestSuite {
    let name = XmlString::new(xml_name(report.file().name));
    let mut suite = TestSuite::new(name.clone());
    if report.diagnostics().is_empty() {
        let mut clean = TestCase::new(CLEAN, TestCaseStatus::success());
        clean.set_classname(name.clone());
        suite.add_test_case(clean);
    }
    let mut names = Names::default();
    for diagnostic in report.diagnostics() {
        let place = report.file().position(diagnostic.span.start);
        let mut case = TestCase::new(names.next(diagnostic, place), status(diagnostic, place));
        case.set_classname(name.clone());
        case.extra.insert(XmlString::new("file"), name.clone());
        case.extra.insert(XmlString::new("line"), XmlString::new(place.line.to_string()));
        suite.add_test_case(case);
    }
    suite
}

fn status(diagnostic: &Diagnostic, place: Position) -> TestCaseStatus {
    let mut status = match diagnostic.severity {
        Severity::Error | Severity::Warning => TestCaseStatus::non_success(NonSuccessKind::Failure),
        Severity::Advice => TestCaseStatus::skipped(),
    };
    status.set_type(diagnostic.severity.as_str());
    status.set_message(&*plain_line(&diagnostic.message));
    let Position { line, column } = place;
    status.set_description(format!("line {line}, column {column}\n{}", message_with_remarks(diagnostic)));
    status
}

/// The names of the cases of a suite. No two are alike: services drop all but one of the cases that share a name.
#[derive(Default)]
struct Names {
    taken: HashMap<(Code, Position), u32>,
}

impl Names {
    fn next(&mut self, diagnostic: &Diagnostic, place: Position) -> String {
        let Code { id, name } = diagnostic.code;
        let count = self.taken.entry((diagnostic.code, place)).or_default();
        *count += 1;
        if *count == 1 { format!("{id} {name} {place}") } else { format!("{id} {name} {place} ({count})") }
    }
}
