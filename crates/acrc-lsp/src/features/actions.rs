//! What can be done at a place.

use acrc_ide::{ActionKind, CodeAction as Action};
use tower_lsp_server::ls_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, CodeActionResponse, Diagnostic, NumberOrString,
};

use super::Answer;
use super::edits::workspace_edit;
use crate::snapshot::{Place, Snapshot};

/// The kinds that are offered.
pub(crate) const KINDS: [CodeActionKind; 4] = [
    CodeActionKind::QUICKFIX,
    CodeActionKind::REFACTOR_EXTRACT,
    CodeActionKind::REFACTOR_REWRITE,
    CodeActionKind::SOURCE_FIX_ALL,
];

pub(crate) fn actions(snapshot: &Snapshot, params: &CodeActionParams) -> Answer<CodeActionResponse> {
    let Place { project, file } = snapshot.place(&params.text_document.uri)?;
    let lines = snapshot.lines(file);
    let part = lines.span(params.range)?;
    // A client without literals can't take edits from here.
    if !snapshot.abilities.code_action_literals {
        return None;
    }
    let wants = |kind: &CodeActionKind| {
        params.context.only.as_ref().is_none_or(|only| only.iter().any(|only| includes(only, kind)))
    };
    let mut found = Vec::new();
    if KINDS.iter().any(|kind| *kind != CodeActionKind::SOURCE_FIX_ALL && wants(kind)) {
        found = acrc_ide::code_actions(&snapshot.db, project, file, part);
    }
    // All repairs are worked out only for those who ask for them.
    if params.context.only.is_some() && wants(&CodeActionKind::SOURCE_FIX_ALL) {
        found.extend(acrc_ide::fix_all(&snapshot.db, project, file));
    }
    let convert = |action: Action| {
        let about = action.finding.map(|(code, span)| (code.id, lines.range(span)));
        let is_about = |diagnostic: &&Diagnostic| {
            about.is_some_and(|(code, range)| {
                diagnostic.range == range && diagnostic.code == Some(NumberOrString::String(code.to_owned()))
            })
        };
        let diagnostics: Vec<_> = params.context.diagnostics.iter().filter(is_about).cloned().collect();
        CodeAction {
            title: action.title,
            kind: Some(kind(action.kind)),
            diagnostics: (!diagnostics.is_empty()).then_some(diagnostics),
            edit: Some(workspace_edit(snapshot, &action.edits)),
            is_preferred: action.preferred.then_some(true),
            ..CodeAction::default()
        }
    };
    let actions = found.into_iter().map(convert).filter(|action| action.kind.as_ref().is_some_and(wants));
    Some(actions.map(CodeActionOrCommand::CodeAction).collect())
}

/// Whether a kind is one or below it: `refactor` includes `refactor.extract`.
fn includes(wanted: &CodeActionKind, kind: &CodeActionKind) -> bool {
    let rest = kind.as_str().strip_prefix(wanted.as_str());
    rest.is_some_and(|rest| wanted.as_str().is_empty() || rest.is_empty() || rest.starts_with('.'))
}

fn kind(kind: ActionKind) -> CodeActionKind {
    match kind {
        ActionKind::QuickFix => CodeActionKind::QUICKFIX,
        ActionKind::Extract => CodeActionKind::REFACTOR_EXTRACT,
        ActionKind::Rewrite => CodeActionKind::REFACTOR_REWRITE,
        ActionKind::FixAll => CodeActionKind::SOURCE_FIX_ALL,
    }
}
