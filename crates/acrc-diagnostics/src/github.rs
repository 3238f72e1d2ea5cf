//! Workflow commands of GitHub Actions: one line a finding, which the runner shows beside the changed lines.
//!
//! ```text
//! ::error title=ACR101 undefined-label,file=Prog0.8K,line=3,col=6,endLine=3,endColumn=11::no line has the label ...
//! ```
//!
//! Advice becomes a notice. The runner takes columns only of a finding within one line, so a longer one is given with its
//! lines. It shows ten errors and ten warnings of a step and drops the rest: for a complete report see
//! [`sarif`](crate::sarif).

use std::fmt::{self, Write as _};
use std::io::{self, Write};

use crate::path::repository_path;
use crate::plain::visible;
use crate::remarks::message_with_remarks;
use crate::unchecked::NOT_CHECKED;
use crate::{Diagnostic, FileReport, Severity, SourceFile, Unchecked};

/// Writes every finding of every file as one command, in the order of `reports`, after what is `unchecked`, since the
/// runner does not show all.
pub fn render(reports: &[FileReport<'_>], unchecked: &[Unchecked], out: &mut dyn Write) -> io::Result<()> {
    for Unchecked { name, reason } in unchecked {
        write!(out, "::error title={NOT_CHECKED}")?;
        if let Some(name) = name {
            write!(out, ",file={}", Property(&repository_path(name)))?;
        }
        writeln!(out, "::{}", Data(reason))?;
    }
    for report in reports {
        let path = repository_path(report.file().name);
        for diagnostic in report.diagnostics() {
            let code = diagnostic.code;
            write!(out, "::{} title={} {}", command(diagnostic.severity), Property(code.id), Property(code.name))?;
            write!(out, ",file={}", Property(&path))?;
            place(report.file(), diagnostic, out)?;
            writeln!(out, "::{}", Data(&message_with_remarks(diagnostic)))?;
        }
    }
    Ok(())
}

const fn command(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Advice => "notice",
    }
}

fn place(file: &SourceFile<'_>, diagnostic: &Diagnostic, out: &mut dyn Write) -> io::Result<()> {
    let (start, end) = (file.position(diagnostic.span.start), file.position(diagnostic.span.end));
    if start.line == end.line {
        write!(out, ",line={},col={},endLine={},endColumn={}", start.line, start.column, end.line, end.column)
    } else {
        write!(out, ",line={},endLine={}", start.line, end.line)
    }
}

/// The text after the two colons.
struct Data<'a>(&'a str);

/// The value of a property before them.
struct Property<'a>(&'a str);

impl fmt::Display for Data<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        escape(self.0, &[], f)
    }
}

impl fmt::Display for Property<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        escape(self.0, &[':', ','], f)
    }
}

/// Escapes what would end a command or one of its parts; other control characters become visible.
fn escape(text: &str, separators: &[char], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    for c in text.chars() {
        if matches!(c, '%' | '\r' | '\n') || separators.contains(&c) {
            write!(f, "%{:02X}", c as u32)?;
        } else {
            f.write_char(visible(c))?;
        }
    }
    Ok(())
}
