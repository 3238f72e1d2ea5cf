//! The tree of one text: lines, statements and what is wrong with them.

use acrc_diagnostics::{Diagnostic, Span};

use crate::ast::{Line, Statement};
use crate::lexer::Token;

/// The result of [`crate::parse`]. It holds spans into the text, not the text itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tree {
    pub(crate) tokens: Vec<Token>,
    pub(crate) lines: Vec<Line>,
    pub(crate) statements: Vec<Statement>,
    pub(crate) errors: Vec<Diagnostic>,
}

impl Tree {
    /// The physical lines. A text that ends with a line break has an empty last line, an empty text one line.
    #[must_use]
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// The statements of all lines, in order and disjoint.
    #[must_use]
    pub fn statements(&self) -> &[Statement] {
        &self.statements
    }

    /// What could not be read, and what was read leniently, in the order of the text.
    #[must_use]
    pub fn errors(&self) -> &[Diagnostic] {
        &self.errors
    }

    /// The tokens, line breaks and comments included; between two of them stand only blanks. The text of a remark is
    /// one token.
    #[must_use]
    pub fn tokens(&self) -> &[Token] {
        &self.tokens
    }

    /// The tokens that start in `span`.
    #[must_use]
    pub fn tokens_in(&self, span: Span) -> &[Token] {
        let first = self.tokens.partition_point(|token| token.span.start < span.start);
        let tail = self.tokens.get(first..).unwrap_or_default();
        let count = tail.partition_point(|token| token.span.start < span.end);
        tail.get(..count).unwrap_or_default()
    }

    /// Index of the line on which a statement stands. An index beyond the last statement gives the last line.
    #[must_use]
    pub fn line_of(&self, statement: u32) -> u32 {
        let after = self.lines.partition_point(|line| line.statements.end <= statement);
        after.min(self.lines.len().saturating_sub(1)) as u32
    }

    /// Writes the tree back: line numbers, statements and comments from their nodes, and what lies between them. Equal
    /// to `text`, when that is the text from which the tree was made.
    #[must_use]
    pub fn print(&self, text: &str) -> String {
        let mut printer = Printer { text, out: String::with_capacity(text.len()), position: 0 };
        for line in &self.lines {
            printer.gap(line.span.start);
            if let Some(number) = line.number {
                printer.node(number.span);
            }
            let range = line.statements.start as usize..line.statements.end as usize;
            for statement in self.statements.get(range).unwrap_or_default() {
                printer.node(statement.span);
            }
            if let Some(comment) = line.comment {
                printer.node(comment);
            }
            printer.gap(line.span.end);
        }
        printer.gap(text.len() as u32);
        printer.out
    }
}

/// Copies nodes and the gaps between them.
struct Printer<'t> {
    text: &'t str,
    out: String,
    position: u32,
}

impl Printer<'_> {
    /// Text that belongs to no node: blanks, separators, line breaks.
    fn gap(&mut self, end: u32) {
        let gap = Span::new(self.position, end);
        self.out.push_str(self.text.get(gap.range()).unwrap_or_default());
        self.position = gap.end;
    }

    fn node(&mut self, span: Span) {
        self.gap(span.start);
        self.out.push_str(self.text.get(span.range()).unwrap_or_default());
        self.position = span.end;
    }
}
