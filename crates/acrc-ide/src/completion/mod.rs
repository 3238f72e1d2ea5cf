//! What can be written at a place.

mod context;
mod items;
mod named;
mod numbers;
mod remarks;
mod snippets;

use acrc_analysis::Db;
use acrc_diagnostics::Span;

use crate::{Entity, FilePosition};

use self::context::Context;

/// Something that can be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// What is shown.
    pub label: String,
    /// What it is.
    pub kind: CompletionKind,
    /// What it means, in a line.
    pub detail: String,
    /// What is written in place of [`Completion::span`]; with places to fill in when it is a snippet.
    pub insert: String,
    /// `insert` is a snippet as editors know them: `IF ($1)`.
    pub snippet: bool,
    /// What has been typed of it.
    pub span: Span,
    /// The text against which an editor compares what is typed further; the label where it is empty.
    pub filter: String,
    /// What fits better comes first: 0, then 1, ...
    pub rank: u8,
    /// What its page is about ([`crate::page`]).
    pub entity: Option<Entity>,
}

/// What a completion is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CompletionKind {
    /// A command or daughter.
    Command,
    /// A word that is only part of a statement.
    Keyword,
    /// The name of an axis.
    Axis,
    /// A label or line number.
    Label,
    /// An alias.
    Alias,
    /// A parameter.
    Parameter,
    /// A flag.
    Bit,
    /// A local variable or array.
    Variable,
    /// A function.
    Function,
    /// An object by number.
    Object,
    /// A frame of several lines.
    Snippet,
    /// A rule of the linter.
    Rule,
}

/// The completions of a place.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Completions {
    /// In the order in which they are shown.
    pub items: Vec<Completion>,
    /// There are more, which appear when more is typed.
    pub incomplete: bool,
}

/// What can be written at a place, the most fitting first.
pub fn completions(db: &dyn Db, position: FilePosition) -> Completions {
    let Some(context) = Context::new(db, position) else {
        return Completions { items: remarks::rules(db, position), incomplete: false };
    };
    let mut found = items::of(db, &context);
    if context.touches_number() {
        // Only a name in words goes on there.
        found.items.retain(|item| item.span.start < context.span.start);
    }
    found.items.sort_by(|a, b| (a.rank, &a.label).cmp(&(b.rank, &b.label)));
    found.items.dedup_by(|a, b| a.label == b.label && a.kind == b.kind);
    found
}
