//! Makes the label that a jump looks for in vain.

use acrc_catalog::command;
use acrc_diagnostics::{Diagnostic, Edit};
use acrc_syntax::ast::{StatementKind, Target};

use super::{ActionKind, CodeAction, Request, touch};
use crate::edits::{indent_at, line_break};
use crate::place::{line_at, section_of};
use crate::routine::is_conditional;

pub(super) fn add(request: &Request<'_>, found: &[&Diagnostic], actions: &mut Vec<CodeAction>) {
    for finding in found.iter().filter(|finding| finding.code.name == "undefined-label") {
        if let Some((title, edit)) = at(request, finding) {
            actions.push(CodeAction {
                finding: Some((finding.code, finding.span)),
                ..request.here(ActionKind::QuickFix, title, vec![edit])
            });
        }
    }
}

/// The label stands at the end of the program, with a `RETURN` when it is called. What came last does not run into it.
fn at(request: &Request<'_>, finding: &Diagnostic) -> Option<(String, Edit)> {
    let Request { db, file, text, tree, .. } = *request;
    let statement = crate::statement_at(db, file, finding.span.start)?;
    let index = section_of(db, file, statement)?;
    let jump = index.jumps.iter().find(|jump| jump.to.is_none() && touch(jump.target.span(), finding.span))?;
    let Target::Label(name) = jump.target else { return None };
    let section = &index.section;
    // Lines with numbers are stored at those.
    if !index.lines.is_empty() || section.opener.is_some() && section.closer.is_none() {
        return None;
    }
    let name = request.slice(name);
    let end = line_break(text, tree, finding.span.start);
    let (place, before) = match section.closer {
        Some(closer) => {
            let closer = tree.statements().get(closer as usize)?;
            (tree.lines().get(line_at(tree, closer.span.start))?.span.start, "")
        }
        None => (text.len() as u32, if text.ends_with(['\n', '\r']) { "" } else { end }),
    };
    let last = section.statements.end.checked_sub(1)?;
    let falls = jump.call && !leaves(request, last);
    let indent = indent_at(text, tree, tree.statements().get(last as usize)?.span.start);
    let stop = if falls { format!("{indent}END{end}") } else { String::new() };
    let body = if jump.call { format!("{indent}RETURN{end}") } else { String::new() };
    let what = if jump.call { "subroutine" } else { "label" };
    Some((format!("Create the {what} `{name}`"), Edit::insert(place, format!("{before}{stop}_{name}{end}{body}"))))
}

/// Whether nothing runs on behind a statement.
fn leaves(request: &Request<'_>, statement: u32) -> bool {
    let last = request.tree.statements().get(statement as usize).map(|last| &last.kind);
    let jumps = matches!(last, Some(StatementKind::Command(last)) if [command::END, command::RETURN, command::GOTO].contains(&last.id));
    jumps && !is_conditional(request.tree, statement)
}
