//! Comments that allow what a rule finds, on its line or in its file.

use acrc_diagnostics::{Applicability, Diagnostic, Edit, Severity, Span};
use acrc_lint::{Group, RuleDoc};
use acrc_syntax::ast::Line;

use super::{ActionKind, CodeAction, Request};
use crate::edits::{indent_at, line_break};
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

/// In the comment that allows something already, or else on a line of its own above: the controller takes no apostrophe
/// behind a statement.
fn on_line(request: &Request<'_>, line: &Line, name: &str) -> Edit {
    let above = line.span.start.checked_sub(1).and_then(|end| request.tree.lines().get(line_at(request.tree, end)));
    let above = above.filter(|above| above.statements.is_empty());
    let mut comments = [Some(line), above].into_iter().flatten().filter_map(|line| line.comment);
    if let Some(list) = comments.find_map(|comment| allowed_list(request, comment)) {
        return Edit::insert(list, format!(", {name}"));
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
