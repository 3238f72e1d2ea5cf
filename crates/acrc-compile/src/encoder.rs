//! What is shared while the nodes of one text are encoded.

use acrc_diagnostics::Span;
use acrc_image::{MAX_DEPTH, Node};

use crate::error::CompileErrorKind;
use crate::scope::Scope;
use crate::text;

/// Encodes nodes of one text and collects what is wrong with them, so that several mistakes are found in one go. After a mistake a node is
/// replaced by a zero; nothing of a text with errors is used.
pub(crate) struct Encoder<'a> {
    source: &'a str,
    pub(crate) scope: &'a dyn Scope,
    pub(crate) errors: Vec<(Span, CompileErrorKind)>,
    depth: usize,
}

impl<'a> Encoder<'a> {
    /// For one text.
    pub(crate) fn new(source: &'a str, scope: &'a dyn Scope) -> Self {
        Self { source, scope, errors: Vec::new(), depth: 0 }
    }

    /// The text of a span.
    pub(crate) fn slice(&self, span: Span) -> &'a str {
        self.source.get(span.start as usize..span.end as usize).unwrap_or_default()
    }

    /// Notes a mistake and gives what stands in its place.
    pub(crate) fn mistake(&mut self, span: Span, kind: CompileErrorKind) -> Node {
        self.errors.push((span, kind));
        Node::Long(0)
    }

    /// Encodes something that may contain itself; `span` is blamed when it does so too often.
    pub(crate) fn nested(&mut self, span: Span, encode: impl FnOnce(&mut Self) -> Node) -> Node {
        if self.depth == MAX_DEPTH {
            return self.mistake(span, CompileErrorKind::TooDeep);
        }
        self.depth += 1;
        let node = encode(self);
        self.depth -= 1;
        node
    }

    /// A string constant.
    pub(crate) fn string(&mut self, span: Span) -> Node {
        match text::string(self.slice(span)) {
            Ok(bytes) => Node::string(bytes),
            Err((offset, character)) => {
                let start = span.start + offset as u32;
                let end = start + character.len_utf8() as u32;
                self.mistake(Span::new(start, end), CompileErrorKind::UnstorableCharacter(character))
            }
        }
    }

    /// The number of an object or a word, which has ten bits.
    pub(crate) fn number(&mut self, span: Span, number: Option<u32>) -> Option<u16> {
        const LIMIT: u16 = 1022;
        let fitting = |number| u16::try_from(number).ok().filter(|&number| number <= LIMIT);
        let value = number?;
        let stored = fitting(value);
        if stored.is_none() {
            self.mistake(
                span,
                CompileErrorKind::Limit { what: "the number of an object", value: value.into(), limit: LIMIT.into() },
            );
        }
        stored
    }
}
