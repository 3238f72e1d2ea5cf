//! What is shown beside and above the code.

use acrc_ide::{HintOptions, LensAction};
use serde_json::json;
use tower_lsp_server::ls_types::{
    CodeLens, CodeLensParams, Command, InlayHint, InlayHintLabel, InlayHintParams, InlineValue, InlineValueParams,
    InlineValueText,
};

use super::Answer;
use crate::commands::{MEM, Outcomes, REPORT, SIM};
use crate::snapshot::{Place, Snapshot};

pub(crate) fn hints(snapshot: &Snapshot, params: &InlayHintParams) -> Answer<Vec<InlayHint>> {
    let Place { project, file } = snapshot.place(&params.text_document.uri)?;
    let lines = snapshot.lines(file);
    let part = lines.span(params.range)?;
    let settings = snapshot.settings.inlay_hints;
    let options =
        HintOptions { numbers: settings.operands, bytes: settings.program_bytes, running_bytes: settings.line_bytes };
    let found = acrc_ide::inlay_hints(&snapshot.db, project, file, part, options).into_iter();
    let hint = |hint: acrc_ide::InlayHint| InlayHint {
        position: lines.position(hint.offset),
        label: InlayHintLabel::String(hint.label),
        kind: None,
        text_edits: None,
        tooltip: None,
        padding_left: Some(true),
        padding_right: None,
        data: None,
    };
    Some(found.map(hint).collect())
}

pub(crate) fn lenses(snapshot: &Snapshot, params: &CodeLensParams, outcomes: &Outcomes) -> Answer<Vec<CodeLens>> {
    let uri = &params.text_document.uri;
    let Place { project, file } = snapshot.place(uri)?;
    let lines = snapshot.lines(file);
    let last = snapshot.files.keys.get(&project).and_then(|key| outcomes.of(key));
    let outcome = |level| last.as_ref().and_then(|run| run.outcome(level));
    let found = acrc_ide::code_lenses(&snapshot.db, project, file, &outcome).into_iter();
    let lens = |lens: acrc_ide::CodeLens| {
        let (command, argument) = match lens.action {
            LensAction::DryRun(level) => (SIM, json!({ "uri": uri, "program": level.to_string() })),
            LensAction::Memory => (MEM, json!({ "uri": uri })),
            LensAction::LastRun => (REPORT, json!({ "uri": uri })),
        };
        let command = Command { title: lens.title, command: command.to_owned(), arguments: Some(vec![argument]) };
        CodeLens { range: lines.range(lens.span), command: Some(command), data: None }
    };
    Some(found.map(lens).collect())
}

/// The values that the last dry run ended with.
pub(crate) fn values(snapshot: &Snapshot, params: &InlineValueParams, outcomes: &Outcomes) -> Answer<Vec<InlineValue>> {
    let Place { project, file } = snapshot.place(&params.text_document.uri)?;
    let last = snapshot.files.keys.get(&project).and_then(|key| outcomes.of(key));
    let (Some(run), lines) = (last, snapshot.lines(file)) else { return None };
    let part = lines.span(params.range)?;
    let found = acrc_ide::inline_values(&snapshot.db, project, file, part).into_iter();
    let text = |value: acrc_ide::InlineValue| {
        let name = crate::commands::operand(&value)?;
        let text = format!("{name} = {}", run.value(&name)?);
        Some(InlineValueText { range: lines.range(value.span), text }.into())
    };
    Some(found.filter_map(text).collect())
}
