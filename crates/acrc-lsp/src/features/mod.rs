//! The features of `acrc-ide` in the words of the protocol, one file each: what a request means, and how the answer is
//! written.

mod actions;
mod calls;
mod completion;
mod edits;
mod format;
mod hints;
mod hover;
mod links;
mod navigation;
mod rename;
mod structure;
mod symbols;
mod tokens;

pub(crate) use actions::{KINDS, actions};
pub(crate) use calls::{incoming, outgoing, prepare as prepare_calls};
pub(crate) use completion::{complete, resolve as resolve_completion};
pub(crate) use format::{format, format_range, format_typed};
pub(crate) use hints::{hints, lenses, values};
pub(crate) use hover::{hover, signature};
pub(crate) use links::links;
pub(crate) use navigation::{definition, highlights, references};
pub(crate) use rename::{prepare as prepare_rename, rename};
pub(crate) use structure::{folds, selections};
pub(crate) use symbols::{of_document, of_workspace};
pub(crate) use tokens::{Tokens, legend, range as tokens_in_range};

/// The answer to a question.
pub(crate) type Answer<T> = Option<T>;

/// Markdown without the marks that a client would show as they are.
fn plain(markdown: &str) -> String {
    let mut text = String::with_capacity(markdown.len());
    for line in markdown.lines().filter(|line| !line.starts_with("```")) {
        let line = line.trim_start_matches('#').trim_start_matches(' ');
        text.extend(line.chars().filter(|c| !matches!(c, '`' | '*' | '\\')));
        text.push('\n');
    }
    text
}

/// A text of `acrc-ide` for a client that shows Markdown, or one that does not.
fn markup(markdown: String, shows_markdown: bool) -> tower_lsp_server::ls_types::MarkupContent {
    use tower_lsp_server::ls_types::{MarkupContent, MarkupKind};
    if shows_markdown {
        MarkupContent { kind: MarkupKind::Markdown, value: markdown }
    } else {
        MarkupContent { kind: MarkupKind::PlainText, value: plain(&markdown) }
    }
}
