//! The form for a person at a terminal: the message, the source with the finding marked, and what to do about it.
//!
//! ariadne lays out the marks. It is given only the lines that are shown, never the whole file, so the cost of a finding
//! does not depend on the size of the file or the length of a line. Because ariadne then knows neither the file's line
//! numbers nor its columns, the margin is drawn here.

mod excerpt;
mod gutter;
mod in_order;
mod marks;

use std::io::{self, Write};

use ariadne::{Color, Fmt};

use crate::plain::plain_line;
use crate::remarks::remarks;
use crate::{Diagnostic, FileReport, Severity, SourceFile};
use excerpt::Excerpt;
use gutter::{Gutter, Margin};
use in_order::in_order;

/// How findings are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Whether colours are used. Without them the output has no escape sequence at all, whatever the source contains.
    pub color: bool,
    /// Number of lines shown before and after the marked ones.
    pub context: u32,
}

/// Writes every finding of every file in the order of `reports`, each followed by an empty line. There is no summary:
/// that is for the caller to print, see [`Summary`](crate::Summary).
pub fn render(reports: &[FileReport<'_>], options: Options, out: &mut dyn Write) -> io::Result<()> {
    in_order(reports, out, |report, page| {
        report.diagnostics().iter().try_for_each(|diagnostic| render_one(report.file(), diagnostic, options, page))
    })
}

fn render_one(file: &SourceFile<'_>, diagnostic: &Diagnostic, options: Options, page: &mut Vec<u8>) -> io::Result<()> {
    let excerpt = Excerpt::new(file, diagnostic, options.context);
    let gutter = Gutter::new(excerpt.last_line_number(), options.color);

    let title = format!("{}[{}]", diagnostic.severity, diagnostic.code);
    let color = options.color.then_some(severity_color(diagnostic.severity));
    writeln!(page, "{}: {}", title.fg(color), plain_line(&diagnostic.message))?;

    gutter.open(page, file.name, file.position(diagnostic.span.start))?;
    gutter.row(page, Margin::Blank, "")?;
    marks::draw(&excerpt, diagnostic, options.color, &gutter, page)?;
    let remarks = remarks(diagnostic);
    if !remarks.is_empty() {
        gutter.row(page, Margin::Blank, "")?;
    }
    for (heading, text) in remarks {
        gutter.remark(page, heading, text)?;
    }
    gutter.close(page)?;
    writeln!(page)
}

const fn severity_color(severity: Severity) -> Color {
    match severity {
        Severity::Error => Color::Red,
        Severity::Warning => Color::Yellow,
        Severity::Advice => Color::Cyan,
    }
}
