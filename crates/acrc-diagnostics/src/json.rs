//! The machine-readable form: one compact JSON object and a line end.
//!
//! ```json
//! {"diagnostics":[{"code":"ACR101","name":"undefined-label","severity":"error","message":"...","file":"Prog0.8K",
//!   "range":{"start":{"line":3,"column":6},"end":{"line":3,"column":11}},"help":null,
//!   "related":[{"message":"...","range":{...}}],
//!   "fixes":[{"title":"...","applicability":"safe","edits":[{"range":{...},"text":"..."}]}]}],
//!  "summary":{"files":1,"errors":1,"warnings":0,"advice":0}}
//! ```
//!
//! Lines and columns count from 1, columns in Unicode scalar values; an end is one past the last character. Members are
//! added when there is need, never renamed or removed.

use std::io::{self, Write};

use serde::{Serialize, Serializer};

use crate::{Diagnostic, Edit, FileReport, Fix, Label, SourceFile, Span, Summary};

/// Writes every finding of every file, in the order of `reports`, and the summary.
pub fn render(reports: &[FileReport<'_>], out: &mut dyn Write) -> io::Result<()> {
    let document = Document { diagnostics: Diagnostics(reports), summary: SummaryJson::from(Summary::of(reports)) };
    serde_json::to_writer(&mut *out, &document)?;
    out.write_all(b"\n")
}

#[derive(Serialize)]
struct Document<'a> {
    diagnostics: Diagnostics<'a>,
    summary: SummaryJson,
}

/// The findings of all files as one array, converted one at a time as they are written.
struct Diagnostics<'a>(&'a [FileReport<'a>]);

impl Serialize for Diagnostics<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().flat_map(|report| {
            let file = report.file();
            report.diagnostics().iter().map(|diagnostic| DiagnosticJson::new(file, diagnostic))
        }))
    }
}

#[derive(Serialize)]
struct DiagnosticJson<'a> {
    code: &'static str,
    name: &'static str,
    severity: &'static str,
    message: &'a str,
    file: &'a str,
    range: RangeJson,
    help: Option<&'a str>,
    related: Vec<RelatedJson<'a>>,
    fixes: Vec<FixJson<'a>>,
}

impl<'a> DiagnosticJson<'a> {
    fn new(file: &SourceFile<'a>, diagnostic: &'a Diagnostic) -> Self {
        Self {
            code: diagnostic.code.id,
            name: diagnostic.code.name,
            severity: diagnostic.severity.as_str(),
            message: &diagnostic.message,
            file: file.name,
            range: RangeJson::new(file, diagnostic.span),
            help: diagnostic.help.as_deref(),
            related: diagnostic.labels.iter().map(|label| RelatedJson::new(file, label)).collect(),
            fixes: diagnostic.fixes.iter().map(|fix| FixJson::new(file, fix)).collect(),
        }
    }
}

#[derive(Serialize)]
struct RelatedJson<'a> {
    message: &'a str,
    range: RangeJson,
}

impl<'a> RelatedJson<'a> {
    fn new(file: &SourceFile<'_>, label: &'a Label) -> Self {
        Self { message: &label.message, range: RangeJson::new(file, label.span) }
    }
}

#[derive(Serialize)]
struct FixJson<'a> {
    title: &'a str,
    applicability: &'static str,
    edits: Vec<EditJson<'a>>,
}

impl<'a> FixJson<'a> {
    fn new(file: &SourceFile<'_>, fix: &'a Fix) -> Self {
        Self {
            title: &fix.title,
            applicability: fix.applicability.as_str(),
            edits: fix.edits.iter().map(|edit| EditJson::new(file, edit)).collect(),
        }
    }
}

#[derive(Serialize)]
struct EditJson<'a> {
    range: RangeJson,
    text: &'a str,
}

impl<'a> EditJson<'a> {
    fn new(file: &SourceFile<'_>, edit: &'a Edit) -> Self {
        Self { range: RangeJson::new(file, edit.span), text: &edit.text }
    }
}

#[derive(Serialize)]
struct RangeJson {
    start: PositionJson,
    end: PositionJson,
}

impl RangeJson {
    fn new(file: &SourceFile<'_>, span: Span) -> Self {
        let at = |offset| {
            let position = file.position(offset);
            PositionJson { line: position.line, column: position.column }
        };
        Self { start: at(span.start), end: at(span.end) }
    }
}

#[derive(Serialize)]
struct PositionJson {
    line: u32,
    column: u32,
}

#[derive(Serialize)]
struct SummaryJson {
    files: usize,
    errors: usize,
    warnings: usize,
    advice: usize,
}

impl From<Summary> for SummaryJson {
    fn from(Summary { files, errors, warnings, advice }: Summary) -> Self {
        Self { files, errors, warnings, advice }
    }
}
