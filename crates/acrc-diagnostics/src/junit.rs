//! A `JUnit` report: a test suite a file, a test case a finding, for services that show test results.
//!
//! Errors and warnings are failed tests. Advice is a skipped test: it is shown with its message and fails nothing. A file
//! without findings is one test that passed, and what could not be checked one that ended with an error. There are no times and no identifiers in the report: the same findings
//! always give the same bytes.

use std::collections::HashMap;
use std::io::{self, Write};

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};

use crate::plain::plain_line;
use crate::remarks::message_with_remarks;
use crate::unchecked::NOT_CHECKED;
use crate::xml::xml_name;
use crate::{Code, Diagnostic, FileReport, Position, Severity, SourceFile, Unchecked};

/// The test of a file in which nothing was found.
const CLEAN: &str = "no findings";
const INDENT: usize = 4;

/// The test of what could not be checked.
const COULD_NOT: &str = "could not be checked";

/// Writes every file with its findings, in the order of `reports`, then what is `unchecked`.
pub fn render(reports: &[FileReport<'_>], unchecked: &[Unchecked], out: &mut dyn Write) -> io::Result<()> {
    let mut xml = Writer::new_with_indent(out, b' ', INDENT);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let counts: Vec<Counts> = reports.iter().map(Counts::of).collect();
    let all = counts.iter().copied().chain(unchecked.iter().map(|_| Counts::UNCHECKED)).sum::<Counts>().attributes();
    let all = all.iter().map(|(name, count)| (*name, count.as_str()));
    let document = xml.create_element("testsuites").with_attribute(("name", "acrc")).with_attributes(all);
    document.write_inner_content(|xml| {
        reports.iter().zip(counts).try_for_each(|(report, counts)| suite(report, counts, xml))?;
        unchecked.iter().try_for_each(|unchecked| not_checked(unchecked, xml))
    })?;
    // What goes before the next thing ends the last line.
    xml.write_indent()
}

/// The tests of a suite or of all.
#[derive(Clone, Copy, Default)]
struct Counts {
    tests: usize,
    skipped: usize,
    failures: usize,
    errors: usize,
}

impl Counts {
    /// Of what could not be checked.
    const UNCHECKED: Self = Self { tests: 1, skipped: 0, failures: 0, errors: 1 };

    fn of(report: &FileReport<'_>) -> Self {
        let found = report.diagnostics();
        let skipped = found.iter().filter(|found| found.severity == Severity::Advice).count();
        Self { tests: found.len().max(1), skipped, failures: found.len() - skipped, errors: 0 }
    }

    fn attributes(self) -> [(&'static str, String); 4] {
        let Self { tests, skipped, failures, errors } = self;
        let counts = [("tests", tests), ("skipped", skipped), ("failures", failures), ("errors", errors)];
        counts.map(|(name, count)| (name, count.to_string()))
    }
}

impl std::iter::Sum for Counts {
    fn sum<I: Iterator<Item = Self>>(counts: I) -> Self {
        counts.fold(Self::default(), |all, one| Self {
            tests: all.tests + one.tests,
            skipped: all.skipped + one.skipped,
            failures: all.failures + one.failures,
            errors: all.errors + one.errors,
        })
    }
}

fn suite<W: Write>(report: &FileReport<'_>, counts: Counts, xml: &mut Writer<W>) -> io::Result<()> {
    let name = xml_name(report.file().name);
    let attributes = counts.attributes();
    let attributes = attributes.iter().map(|(name, count)| (*name, count.as_str()));
    let element = xml.create_element("testsuite").with_attribute(("name", name.as_str())).with_attributes(attributes);
    element.write_inner_content(|xml| {
        if report.diagnostics().is_empty() {
            let clean = [("name", CLEAN), ("classname", &name)];
            xml.create_element("testcase").with_attributes(clean).write_empty()?;
        }
        let mut names = Names::default();
        report.diagnostics().iter().try_for_each(|found| case(found, report.file(), &name, &mut names, xml))
    })?;
    Ok(())
}

fn not_checked<W: Write>(unchecked: &Unchecked, xml: &mut Writer<W>) -> io::Result<()> {
    let name = xml_name(unchecked.name_or_tool());
    let counts = Counts::UNCHECKED.attributes();
    let counts = counts.iter().map(|(name, count)| (*name, count.as_str()));
    let message = plain_line(&unchecked.reason);
    let suite = xml.create_element("testsuite").with_attribute(("name", name.as_str())).with_attributes(counts);
    suite.write_inner_content(|xml| {
        let attributes = [("name", COULD_NOT), ("classname", &name), ("file", &name)];
        xml.create_element("testcase").with_attributes(attributes).write_inner_content(|xml| {
            let attributes = [("message", &*message), ("type", NOT_CHECKED)];
            xml.create_element("error")
                .with_attributes(attributes)
                .write_text_content(BytesText::new(&message))
                .map(drop)
        })?;
        Ok(())
    })?;
    Ok(())
}

fn case<W: Write>(
    diagnostic: &Diagnostic,
    file: &SourceFile<'_>,
    file_name: &str,
    names: &mut Names,
    xml: &mut Writer<W>,
) -> io::Result<()> {
    let place = file.position(diagnostic.span.start);
    let (name, line) = (names.next(diagnostic, place), place.line.to_string());
    let attributes = [("name", name.as_str()), ("classname", file_name), ("file", file_name), ("line", &line)];
    xml.create_element("testcase").with_attributes(attributes).write_inner_content(|xml| {
        let outcome = match diagnostic.severity {
            Severity::Error | Severity::Warning => "failure",
            Severity::Advice => "skipped",
        };
        let message = plain_line(&diagnostic.message);
        let attributes = [("message", &*message), ("type", diagnostic.severity.as_str())];
        let Position { line, column } = place;
        let text = format!("line {line}, column {column}\n{}", message_with_remarks(diagnostic));
        xml.create_element(outcome).with_attributes(attributes).write_text_content(BytesText::new(&text)).map(drop)
    })?;
    Ok(())
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
