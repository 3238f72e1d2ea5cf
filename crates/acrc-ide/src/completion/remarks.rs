//! Rules in a remark that allows findings: `' acrc: allow(ACR101)`.

use acrc_analysis::Db;
use acrc_diagnostics::Span;

use super::{Completion, CompletionKind};
use crate::FilePosition;

/// What stands before the names of rules.
const OPENERS: [&str; 2] = ["acrc: allow(", "acrc: allow-file("];

/// The rules, where one is being written.
pub(super) fn rules(db: &dyn Db, position: FilePosition) -> Vec<Completion> {
    let offset = position.offset as usize;
    let Some(before) = position.file.text(db).get(..offset) else { return Vec::new() };
    let line = before.rsplit(['\n', '\r']).next().unwrap_or_default();
    let open = OPENERS.iter().filter_map(|opener| line.rfind(opener).map(|at| at + opener.len())).max();
    let Some(typed) = open.and_then(|open| line.get(open..)).filter(|typed| !typed.contains(')')) else {
        return Vec::new();
    };
    let part = typed.rsplit([',', ' ']).next().unwrap_or_default();
    let span = Span::from(offset - part.len()..offset);
    acrc_lint::rules()
        .map(|rule| Completion {
            label: rule.code.id.to_owned(),
            kind: CompletionKind::Rule,
            detail: rule.code.name.to_owned(),
            insert: rule.code.id.to_owned(),
            snippet: false,
            span,
            filter: format!("{} {}", rule.code.id, rule.code.name),
            rank: 0,
            entity: None,
        })
        .collect()
}
