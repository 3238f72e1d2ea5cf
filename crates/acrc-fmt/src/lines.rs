//! What may be done to each line.

use acrc_diagnostics::{Severity, Span};
use acrc_syntax::Tree;
use acrc_syntax::ast::StatementKind;

use crate::directive::{self, Directive};

/// What may be done to a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum State {
    /// It is formatted.
    Open,
    /// It holds nothing but blanks.
    Blank,
    /// It can't be read and stays as it is.
    Unreadable,
    /// It was asked to stay as it is.
    Frozen,
}

/// Characters that may be changed where they stand between tokens. A no-break space is not one of them: what becomes
/// of it is for the linter to propose.
pub(crate) fn is_blank(text: &str) -> bool {
    text.bytes().all(|byte| matches!(byte, b' ' | b'\t' | b'\x0C'))
}

/// A text without the blanks at its end.
pub(crate) fn trim_end(text: &str) -> &str {
    text.trim_end_matches([' ', '\t', '\x0C'])
}

/// The states of the lines of a tree.
pub(crate) fn states(text: &str, tree: &Tree) -> Vec<State> {
    let mut states = Vec::with_capacity(tree.lines().len());
    let mut errors = tree.errors().iter().filter(|error| error.severity == Severity::Error).peekable();
    let mut frozen = false;
    for line in tree.lines() {
        let mut broken = false;
        while errors.next_if(|error| error.span.start <= line.span.end).is_some() {
            broken = true;
        }
        let directive = directive::of(text, tree, line);
        frozen &= directive != Some(Directive::On);
        // The number of diagnostics is limited, that of broken statements is not.
        let range = line.statements.start as usize..line.statements.end as usize;
        let statements = tree.statements().get(range).unwrap_or_default();
        states.push(if frozen {
            State::Frozen
        } else if broken || statements.iter().any(|statement| statement.kind == StatementKind::Error) {
            State::Unreadable
        } else if is_blank(slice(text, line.span)) {
            State::Blank
        } else {
            State::Open
        });
        frozen |= directive == Some(Directive::Off);
    }
    states
}

/// The text of a span.
pub(crate) fn slice(text: &str, span: Span) -> &str {
    text.get(span.range()).unwrap_or_default()
}
