//! What can be written at a place. The page of an item is made when the client shows it.

use acrc_ide::{Completion, CompletionKind};
use serde::{Deserialize, Serialize};
use tower_lsp_server::ls_types::{
    CompletionItem, CompletionItemKind, CompletionList, CompletionParams, CompletionResponse, CompletionTextEdit,
    Documentation, InsertTextFormat, TextDocumentPositionParams, TextEdit,
};

use super::{Answer, markup};
use crate::snapshot::Snapshot;

/// What an item carries so that its page can be made.
#[derive(Serialize, Deserialize)]
struct Origin {
    at: TextDocumentPositionParams,
}

pub(crate) fn complete(snapshot: &Snapshot, params: &CompletionParams) -> Answer<CompletionResponse> {
    let (position, lines) = snapshot.position(&params.text_document_position)?;
    let found = acrc_ide::completions(&snapshot.db, position);
    let origin = serde_json::to_value(Origin { at: params.text_document_position.clone() }).ok();
    let usable = found.items.into_iter().filter(|item| !item.snippet || snapshot.abilities.snippets);
    let items = usable.enumerate().map(|(place, item)| CompletionItem {
        text_edit: Some(CompletionTextEdit::Edit(TextEdit::new(lines.range(item.span), item.insert.clone()))),
        // Clients sort by text.
        sort_text: Some(format!("{place:05}")),
        data: item.entity.is_some().then(|| origin.clone()).flatten(),
        ..convert(item)
    });
    let items = items.collect();
    Some(CompletionResponse::List(CompletionList { is_incomplete: found.incomplete, items }))
}

fn convert(item: Completion) -> CompletionItem {
    CompletionItem {
        kind: Some(kind(item.kind)),
        detail: (!item.detail.is_empty()).then_some(item.detail),
        filter_text: (!item.filter.is_empty()).then_some(item.filter),
        insert_text_format: item.snippet.then_some(InsertTextFormat::SNIPPET),
        label: item.label,
        ..CompletionItem::default()
    }
}

/// Adds its page to an item.
pub(crate) fn resolve(snapshot: &Snapshot, mut item: CompletionItem) -> CompletionItem {
    let origin = item.data.as_ref().and_then(|data| Origin::deserialize(data).ok());
    let Some((position, _)) = origin.and_then(|origin| snapshot.position(&origin.at)) else { return item };
    let found = acrc_ide::completions(&snapshot.db, position).items;
    let same = found.into_iter().find(|other| other.label == item.label && Some(kind(other.kind)) == item.kind);
    if let Some(entity) = same.and_then(|same| same.entity) {
        let page = acrc_ide::page(&snapshot.db, position, &entity);
        item.documentation = Some(Documentation::MarkupContent(markup(page, snapshot.abilities.completion_markdown)));
    }
    item
}

fn kind(kind: CompletionKind) -> CompletionItemKind {
    match kind {
        CompletionKind::Command => CompletionItemKind::METHOD,
        CompletionKind::Keyword => CompletionItemKind::KEYWORD,
        CompletionKind::Axis => CompletionItemKind::FIELD,
        CompletionKind::Label => CompletionItemKind::REFERENCE,
        CompletionKind::Alias | CompletionKind::Rule => CompletionItemKind::CONSTANT,
        CompletionKind::Parameter => CompletionItemKind::PROPERTY,
        CompletionKind::Bit => CompletionItemKind::ENUM_MEMBER,
        CompletionKind::Variable => CompletionItemKind::VARIABLE,
        CompletionKind::Function => CompletionItemKind::FUNCTION,
        CompletionKind::Object => CompletionItemKind::CLASS,
        CompletionKind::Snippet => CompletionItemKind::SNIPPET,
    }
}
