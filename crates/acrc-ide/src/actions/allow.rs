//! Comments that allow what a rule finds, on its line or in its file.

use acrc_diagnostics::{Applicability, Diagnostic, Edit, Severity, Span};
use acrc_lint::{Group, RuleDoc};
use acrc_syntax::ast::{Line, StatementKind};

use super::{ActionKind, CodeAction, Request};
use crate::edits::{indent_at, line_break};
use crate::folding::statements_of;
use crate::place::line_at;

pub(super) fn add(request: &Request<'_>, found: &[&Diagnostic], actions: &mut Vec<CodeAction>) {
    let mut told = Vec::new();
    for finding in found {
        let Some(doc) = acrc_lint::explain(finding.code.id).filter(|doc| may_be_allowed(doc, finding)) else {
            continue;
        };
        let line = line_at(request.tree, finding.span.start);
        if told.contains(&(doc.code, line)) {
            continue;
        }
        told.push((doc.code, line));
        let Some(line) = request.tree.lines().get(line) else { continue };
        let name = doc.code.name;
        let edits = [
            (format!("Allow {name} on this line"), on_line(request, line, name)),
            (format!("Allow {name} in this file"), in_file(request, name)),
        ];
        actions.extend(edits.map(|(title, edit)| CodeAction {
            applicability: Applicability::Safe,
            finding: Some((finding.code, finding.span)),
            ..request.here(ActionKind::QuickFix, title, vec![edit])
        }));
    }
}

/// What the parser refuses the controller refuses too; and a comment that allows nothing is no cure for another one.
fn may_be_allowed(doc: &RuleDoc, finding: &Diagnostic) -> bool {
    let is_refused = doc.group == Group::Syntax && finding.severity == Severity::Error;
    !is_refused && !matches!(doc.group, Group::Suppressions | Group::Compile)
}

/// Behind the statements of the line, or on a line of its own above, where a remark or a comment ends the line.
fn on_line(request: &Request<'_>, line: &Line, name: &str) -> Edit {
    let statements = statements_of(request.tree, line);
    let ends_with_remark =
        statements.last().is_some_and(|last| matches!(last.kind, StatementKind::Remark(_) | StatementKind::Error));
    if let Some(list) = line.comment.and_then(|comment| allowed_list(request, comment)) {
        return Edit::insert(list, format!(", {name}"));
    }
    if line.comment.is_none() && !ends_with_remark && !statements.is_empty() {
        let code = request.slice(line.span).trim_end_matches([' ', '\t']);
        let end = Span::new(line.span.start + code.len() as u32, line.span.end);
        return Edit::replace(end, format!(" ' acrc: allow({name})"));
    }
    let (indent, end) =
        (indent_at(request.text, request.tree, line.span.start), line_break(request.text, request.tree, 0));
    Edit::insert(line.span.start, format!("{indent}' acrc: allow({name}){end}"))
}

/// The end of the list of a comment that allows rules already.
fn allowed_list(request: &Request<'_>, comment: Span) -> Option<u32> {
    let text = request.slice(comment);
    let start = text.find("acrc: allow(")?;
    let end = start + text.get(start..)?.find(')')?;
    Some(comment.start + end as u32)
}

fn in_file(request: &Request<'_>, name: &str) -> Edit {
    Edit::insert(0, format!("' acrc: allow-file({name}){}", line_break(request.text, request.tree, 0)))
}
