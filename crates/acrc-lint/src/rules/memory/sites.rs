//! From the findings of the memory map to places in the text, and numbers to words.

pub(super) use acrc_analysis::memory::grouped as number;
use acrc_analysis::memory::{IssueKind, Site};
use acrc_catalog::{Confidence, OperandClass, memory};
use acrc_diagnostics::{Edit, Fix, Span};
use acrc_syntax::ast::{Dim, StatementKind};

use crate::Context;

/// The findings of the memory map in this file. A piece of code without its surroundings has none.
pub(super) fn issues<'a>(context: &Context<'a>) -> impl Iterator<Item = (Site, IssueKind)> + use<'a> {
    let heard = !context.environment().fragment;
    let issues = context.memory().issues.iter().filter(move |_| heard);
    issues.map(|issue| (issue.site, issue.kind))
}

/// Where a finding stands: the `DIM`, the definition or the statement.
pub(super) fn span(context: &Context<'_>, site: Site) -> Span {
    match site {
        Site::Event(event) => event_statement(context, event).map_or(Span::default(), |at| context.statement_span(at)),
        Site::Define(define) => {
            context.index().defines.get(define as usize).map_or(Span::default(), |define| define.name)
        }
        Site::Text { section, statement } => {
            let section = context.index().sections.get(section as usize);
            section.map_or(Span::default(), |section| {
                context.statement_span(section.section.statements.start.saturating_add(statement))
            })
        }
    }
}

fn event_statement(context: &Context<'_>, event: u32) -> Option<u32> {
    context.memory_sites().statements.get(event as usize).copied()
}

/// The `DIM` that a finding stands at.
pub(super) fn dim<'a>(context: &Context<'a>, site: Site) -> Option<&'a Dim> {
    let Site::Event(event) = site else { return None };
    let statement = context.tree().statements().get(event_statement(context, event)? as usize)?;
    match &statement.kind {
        StatementKind::Dim(dim) => Some(dim),
        _ => None,
    }
}

/// A repair that writes another number into a `DIM`: the count, or the size in bytes.
pub(super) fn resize(dim: &Dim, size: u64) -> Option<Fix> {
    let number = dim.sizes.first()?;
    let edits = vec![Edit::replace(number.span, size.to_string())];
    Some(Fix::unsafe_(format!("dimension {size}"), edits))
}

/// How well the cost of variables of a class is attested.
pub(super) fn confidence(class: OperandClass) -> Confidence {
    if class == OperandClass::Parameter {
        Confidence::High
    } else {
        memory::LocalBlock::Variables(class).cost().confidence
    }
}

/// A count with its noun: `1 byte`, `8,420 bytes`.
pub(super) fn counted(value: u64, noun: &str) -> String {
    let end = if value == 1 { "" } else { "s" };
    format!("{} {noun}{end}", number(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_is_not_many() {
        assert_eq!((counted(1, "byte"), counted(2, "byte")), ("1 byte".to_owned(), "2 bytes".to_owned()));
    }
}
