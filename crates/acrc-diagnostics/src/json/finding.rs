//! A finding as a JSON object: the members that [`json`](super) and [`jsonl`](crate::jsonl) share.

use serde::Serialize;

use crate::unchecked::NOT_CHECKED;
use crate::{Diagnostic, Edit, Fix, Label, Severity, SourceFile, Span, Unchecked};

#[derive(Serialize)]
pub(crate) struct FindingJson<'a> {
    /// Null for what could not be checked, and so is the range.
    code: Option<&'static str>,
    name: &'static str,
    severity: &'static str,
    message: &'a str,
    file: Option<&'a str>,
    range: Option<RangeJson>,
    help: Option<&'a str>,
    related: Vec<RelatedJson<'a>>,
    fixes: Vec<FixJson<'a>>,
}

impl<'a> FindingJson<'a> {
    pub(crate) fn new(file: &SourceFile<'a>, diagnostic: &'a Diagnostic) -> Self {
        Self {
            code: Some(diagnostic.code.id),
            name: diagnostic.code.name,
            severity: diagnostic.severity.as_str(),
            message: &diagnostic.message,
            file: Some(file.name),
            range: Some(RangeJson::new(file, diagnostic.span)),
            help: diagnostic.help.as_deref(),
            related: diagnostic.labels.iter().map(|label| RelatedJson::new(file, label)).collect(),
            fixes: diagnostic.fixes.iter().map(|fix| FixJson::new(file, fix)).collect(),
        }
    }

    pub(crate) fn unchecked(Unchecked { name, reason }: &'a Unchecked) -> Self {
        Self {
            code: None,
            name: NOT_CHECKED,
            severity: Severity::Error.as_str(),
            message: reason,
            file: name.as_deref(),
            range: None,
            help: None,
            related: Vec::new(),
            fixes: Vec::new(),
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
        Self { start: PositionJson::new(file, span.start), end: PositionJson::new(file, span.end) }
    }
}

/// A place; also what a GitLab report calls one.
#[derive(Serialize)]
pub(crate) struct PositionJson {
    line: u32,
    column: u32,
}

impl PositionJson {
    /// The beginning of a file.
    pub(crate) const START: Self = Self { line: 1, column: 1 };

    pub(crate) fn new(file: &SourceFile<'_>, offset: u32) -> Self {
        let position = file.position(offset);
        Self { line: position.line, column: position.column }
    }
}
