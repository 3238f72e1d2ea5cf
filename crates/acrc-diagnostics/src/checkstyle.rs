//! A Checkstyle report: the XML form that most tools which collect findings can read.
//!
//! Every file is listed, also one without findings. Advice has the severity `info`. The source of a finding is its code
//! after `acrc.`.

use std::io::{self, Write};

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

use crate::plain::plain_line;
use crate::unchecked::NOT_CHECKED;
use crate::xml::xml_name;
use crate::{Diagnostic, FileReport, Severity, SourceFile, Unchecked};

/// The version of Checkstyle whose format this is, as readers expect it.
const FORMAT_VERSION: &str = "4.3";
const INDENT: usize = 2;

/// Writes every file with its findings, in the order of `reports`, then what is `unchecked`, as errors in line 1.
pub fn render(reports: &[FileReport<'_>], unchecked: &[Unchecked], out: &mut dyn Write) -> io::Result<()> {
    let mut xml = Writer::new_with_indent(out, b' ', INDENT);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let document = xml.create_element("checkstyle").with_attribute(("version", FORMAT_VERSION));
    document.write_inner_content(|xml| {
        reports.iter().try_for_each(|report| file(report, xml))?;
        unchecked.iter().try_for_each(|unchecked| not_checked(unchecked, xml))
    })?;
    // What goes before the next thing ends the last line.
    xml.write_indent()
}

fn file<W: Write>(report: &FileReport<'_>, xml: &mut Writer<W>) -> io::Result<()> {
    let name = xml_name(report.file().name);
    let element = xml.create_element("file").with_attribute(("name", name.as_str()));
    if report.diagnostics().is_empty() {
        element.write_empty()?;
    } else {
        element.write_inner_content(|xml| {
            report.diagnostics().iter().try_for_each(|diagnostic| error(report.file(), diagnostic, xml))
        })?;
    }
    Ok(())
}

fn not_checked<W: Write>(unchecked: &Unchecked, xml: &mut Writer<W>) -> io::Result<()> {
    let (name, source) = (xml_name(unchecked.name_or_tool()), format!("acrc.{NOT_CHECKED}"));
    let message = plain_line(&unchecked.reason);
    let attributes = [("line", "1"), ("severity", "error"), ("message", &message), ("source", source.as_str())];
    let element = xml.create_element("file").with_attribute(("name", name.as_str()));
    element
        .write_inner_content(|xml| xml.create_element("error").with_attributes(attributes).write_empty().map(drop))?;
    Ok(())
}

fn error<W: Write>(file: &SourceFile<'_>, diagnostic: &Diagnostic, xml: &mut Writer<W>) -> io::Result<()> {
    let place = file.position(diagnostic.span.start);
    let attributes = [
        ("line", place.line.to_string()),
        ("column", place.column.to_string()),
        ("severity", severity(diagnostic.severity).to_owned()),
        ("message", plain_line(&diagnostic.message).into_owned()),
        ("source", format!("acrc.{}", diagnostic.code)),
    ];
    let attributes = attributes.iter().map(|(name, value)| (*name, value.as_str()));
    xml.create_element("error").with_attributes(attributes).write_empty().map(drop)
}

const fn severity(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Advice => "info",
    }
}
