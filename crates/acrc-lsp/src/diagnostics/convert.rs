//! Findings in the words of the protocol.

use acrc_diagnostics::{Applicability, Diagnostic as Finding, Severity};
use serde_json::json;
use tower_lsp_server::ls_types::{
    CodeDescription, Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, Location, NumberOrString, Position,
    Range, Uri,
};

use super::tags;
use crate::lines::Lines;
use crate::snapshot::Snapshot;
use crate::workspace::Trouble;

/// Who says it.
const SOURCE: &str = "acrc";

/// A finding for the client.
pub(super) fn diagnostic(snapshot: &Snapshot, finding: &Finding, lines: &Lines, uri: Option<&Uri>) -> Diagnostic {
    let abilities = snapshot.abilities;
    let page = || snapshot.scratch.rule_page(finding.code.id).map(|href| CodeDescription { href });
    let related = abilities.related_information.then(|| related(finding, lines, uri)).flatten();
    Diagnostic {
        range: lines.range(finding.span),
        severity: Some(severity(finding.severity)),
        code: Some(NumberOrString::String(finding.code.id.to_owned())),
        code_description: abilities.code_description.then(page).flatten(),
        source: Some(SOURCE.to_owned()),
        message: message(finding),
        related_information: related,
        tags: abilities.diagnostic_tags.then(|| tags::of(finding.code.id).map(|tag| vec![tag])).flatten(),
        data: abilities.diagnostic_data.then(|| data(finding)).flatten(),
    }
}

/// What is wrong with the description of a project, for the client.
pub(crate) fn of_trouble(trouble: &Trouble) -> Diagnostic {
    let (line, column) = trouble.place.unwrap_or((1, 1));
    let start = Position::new(line.saturating_sub(1), column.saturating_sub(1));
    let severity = if trouble.fatal { Severity::Error } else { Severity::Warning };
    Diagnostic {
        range: Range::new(start, start),
        severity: Some(self::severity(severity)),
        source: Some(SOURCE.to_owned()),
        message: trouble.message.clone(),
        ..Diagnostic::default()
    }
}

fn severity(severity: Severity) -> DiagnosticSeverity {
    match severity {
        Severity::Error => DiagnosticSeverity::ERROR,
        Severity::Warning => DiagnosticSeverity::WARNING,
        Severity::Advice => DiagnosticSeverity::INFORMATION,
    }
}

/// The message with what to do and what else is good to know: editors have no other place for these.
fn message(finding: &Finding) -> String {
    let mut message = finding.message.clone();
    for (title, text) in [("help", &finding.help), ("note", &finding.note)] {
        if let Some(text) = text {
            message.push('\n');
            message.push_str(title);
            message.push_str(": ");
            message.push_str(text);
        }
    }
    message
}

fn related(finding: &Finding, lines: &Lines, uri: Option<&Uri>) -> Option<Vec<DiagnosticRelatedInformation>> {
    let uri = uri?;
    let labels = finding.labels.iter().map(|label| DiagnosticRelatedInformation {
        location: Location::new(uri.clone(), lines.range(label.span)),
        message: label.message.clone(),
    });
    let labels: Vec<_> = labels.collect();
    (!labels.is_empty()).then_some(labels)
}

/// What an editor may show before it asks for actions: the rule, and how bold its fix is.
fn data(finding: &Finding) -> Option<serde_json::Value> {
    let fix = finding.fixes.first()?;
    let applicable = fix.applicability != Applicability::DisplayOnly;
    applicable
        .then(|| json!({ "rule": finding.code.name, "fix": fix.title, "applicability": fix.applicability.as_str() }))
}
