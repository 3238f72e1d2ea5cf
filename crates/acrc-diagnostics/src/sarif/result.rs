//! Findings as SARIF results.

use std::collections::BTreeMap;

use serde::ser::SerializeSeq as _;
use serde::{Serialize, Serializer};

use super::rule::Rules;
use super::uri::FileUri;
use super::{SOURCE_ROOT, level};
use crate::fingerprint::Fingerprints;
use crate::plain::plain_line;
use crate::remarks::message_with_remarks;
use crate::{Applicability, Diagnostic, Edit, FileReport, Fix, SourceFile, Span};

/// Named with a version, as SARIF asks for: another way of counting would get another one.
const FINGERPRINT: &str = "acrcLineHash/v1";

/// The findings of all files, converted one at a time as they are written.
pub(super) struct Results<'a> {
    pub(super) reports: &'a [FileReport<'a>],
    pub(super) rules: &'a Rules,
}

impl Serialize for Results<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut results = serializer.serialize_seq(None)?;
        for report in self.reports {
            let file = File { source: report.file(), uri: FileUri::new(report.file().name) };
            // A file that is renamed keeps its findings, so its name is no part of their fingerprints.
            let mut fingerprints = Fingerprints::default();
            for diagnostic in report.diagnostics() {
                let fingerprint = fingerprints.next(report.file(), diagnostic);
                results.serialize_element(&file.result(self.rules, diagnostic, fingerprint))?;
            }
        }
        results.end()
    }
}

/// A file with the name that it has in the report.
struct File<'a> {
    source: &'a SourceFile<'a>,
    uri: FileUri,
}

impl File<'_> {
    fn result(&self, rules: &Rules, diagnostic: &Diagnostic, fingerprint: String) -> ResultJson<'_> {
        let label = diagnostic.label.as_deref();
        let related = (1..)
            .zip(&diagnostic.labels)
            .map(|(id, label)| Location { id: Some(id), ..self.location(label.span, Some(&label.message)) });
        ResultJson {
            rule_id: diagnostic.code.id,
            rule_index: rules.index(diagnostic.code),
            level: level(diagnostic.severity),
            message: Message::new(&message_with_remarks(diagnostic)),
            locations: [self.location(diagnostic.span, label)],
            related_locations: related.collect(),
            fixes: self.fixes(diagnostic),
            partial_fingerprints: BTreeMap::from([(FINGERPRINT, fingerprint)]),
            properties: diagnostic.unconfirmed.then_some(ResultProperties { unconfirmed: true }),
        }
    }

    fn location(&self, span: Span, message: Option<&str>) -> Location<'_> {
        let physical_location =
            PhysicalLocation { artifact_location: self.artifact(), region: Region::new(self.source, span) };
        Location { id: None, physical_location, message: message.map(|text| Message::new(&plain_line(text))) }
    }

    /// The fixes that a tool may apply. Two that are alike are one, since the format does not allow a second.
    fn fixes(&self, diagnostic: &Diagnostic) -> Vec<FixJson<'_>> {
        let mut fixes = Vec::new();
        for fix in diagnostic.fixes.iter().filter(|fix| is_applicable(fix)) {
            let fix = self.fix(fix);
            if !fixes.contains(&fix) {
                fixes.push(fix);
            }
        }
        fixes
    }

    fn fix(&self, fix: &Fix) -> FixJson<'_> {
        let replacements = fix.edits.iter().map(|edit| Replacement::new(self.source, edit)).collect();
        FixJson {
            description: Message::new(&plain_line(&fix.title)),
            artifact_changes: [ArtifactChange { artifact_location: self.artifact(), replacements }],
            properties: FixProperties { applicability: fix.applicability.as_str() },
        }
    }

    fn artifact(&self) -> ArtifactLocation<'_> {
        ArtifactLocation { uri: &self.uri.uri, uri_base_id: self.uri.relative.then_some(SOURCE_ROOT) }
    }
}

/// A fix in a report is one that a tool may apply, so a suggestion with parts to fill in is none; nor is one without edits.
fn is_applicable(fix: &Fix) -> bool {
    fix.applicability != Applicability::DisplayOnly && !fix.edits.is_empty()
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct ResultJson<'a> {
    rule_id: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    rule_index: Option<usize>,
    level: &'static str,
    message: Message,
    locations: [Location<'a>; 1],
    #[serde(skip_serializing_if = "Vec::is_empty")]
    related_locations: Vec<Location<'a>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    fixes: Vec<FixJson<'a>>,
    partial_fingerprints: BTreeMap<&'static str, String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    properties: Option<ResultProperties>,
}

#[derive(Serialize)]
struct ResultProperties {
    unconfirmed: bool,
}

#[derive(PartialEq, Serialize)]
pub(super) struct Message {
    text: String,
}

impl Message {
    /// Braces name arguments and are doubled to stand for themselves. `](` would make a link of what is in brackets; there
    /// is no way to write it but to part the two.
    pub(super) fn new(text: &str) -> Self {
        Self { text: text.replace('{', "{{").replace('}', "}}").replace("](", "] (") }
    }
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Location<'a> {
    /// Tells two related places apart that are alike in all else, which the format does not allow.
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<u32>,
    physical_location: PhysicalLocation<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    message: Option<Message>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct PhysicalLocation<'a> {
    artifact_location: ArtifactLocation<'a>,
    region: Region,
}

#[derive(PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
struct ArtifactLocation<'a> {
    uri: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    uri_base_id: Option<&'static str>,
}

/// Lines and columns from 1; the end is one past the last character, and equals the start where something is inserted.
#[derive(PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
struct Region {
    start_line: u32,
    start_column: u32,
    end_line: u32,
    end_column: u32,
}

impl Region {
    fn new(file: &SourceFile<'_>, span: Span) -> Self {
        let (start, end) = (file.position(span.start), file.position(span.end));
        Self { start_line: start.line, start_column: start.column, end_line: end.line, end_column: end.column }
    }
}

#[derive(PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
struct FixJson<'a> {
    description: Message,
    artifact_changes: [ArtifactChange<'a>; 1],
    properties: FixProperties,
}

#[derive(PartialEq, Serialize)]
struct FixProperties {
    applicability: &'static str,
}

#[derive(PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
struct ArtifactChange<'a> {
    artifact_location: ArtifactLocation<'a>,
    replacements: Vec<Replacement>,
}

#[derive(PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
struct Replacement {
    deleted_region: Region,
    /// Absent where something is only deleted.
    #[serde(skip_serializing_if = "Option::is_none")]
    inserted_content: Option<Content>,
}

impl Replacement {
    fn new(file: &SourceFile<'_>, edit: &Edit) -> Self {
        let inserted_content = (!edit.text.is_empty()).then(|| Content { text: edit.text.clone() });
        Self { deleted_region: Region::new(file, edit.span), inserted_content }
    }
}

#[derive(PartialEq, Serialize)]
struct Content {
    text: String,
}
