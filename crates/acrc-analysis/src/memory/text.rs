//! The bytes of stored texts (guide, "How Much Memory?"): a bound that costs next to nothing, and the exact count of
//! each statement.

use std::ops::Range;

use acrc_catalog::command;
use acrc_compile::{Scope, encode_statement};
use acrc_image::{Node, TextCost};
use acrc_syntax::Tree;
use acrc_syntax::ast::Statement;
use acrc_syntax::lexer::TokenKind;
use acrc_syntax::units::SectionKind;

use super::calls::{self, Calls};
use crate::index::{FileIndex, SectionIndex};

/// A token stands for a command, an operator or a constant at most, and a constant for two words and one around it.
const NUMBER_BYTES: u64 = 12;
/// What any other token stands for at most: a command word that is not written, and its own word.
const TOKEN_BYTES: u64 = 8;

/// No stored text is longer than this bound, rounded up so that small changes of the text leave it as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextBound(pub u64);

/// The exact bytes of a stored text. A statement that cannot be stored counts nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SectionBytes {
    /// Of each statement, in their order.
    pub statements: Vec<u32>,
    /// How deep its subroutines call each other.
    pub calls: Calls,
}

impl SectionBytes {
    /// All of it.
    pub fn total(&self) -> u64 {
        self.statements.iter().map(|bytes| u64::from(*bytes)).sum()
    }

    /// The first statement, counted from 0, with which the text is longer than `space`.
    pub fn first_beyond(&self, space: u64) -> Option<u32> {
        let mut sum = 0;
        let beyond = |bytes: &u32| {
            sum += u64::from(*bytes);
            sum > space
        };
        self.statements.iter().position(beyond).map(|place| place as u32)
    }
}

/// Bounds of the stored texts of a file, by section; 0 for what is not stored.
pub(super) fn bounds(tree: &Tree, index: &FileIndex) -> Vec<TextBound> {
    index.sections.iter().map(|section| TextBound(round_up(bound(tree, section)))).collect()
}

/// A text whose bytes are counted as stored, whatever its names stand for: every name is one word.
struct AnyNames;

impl Scope for AnyNames {
    fn alias(&self, _name: &str) -> Option<u16> {
        Some(0)
    }

    fn label(&self, _name: &str) -> Option<u16> {
        Some(0)
    }
}

/// The exact bytes of the stored texts of a file, by section.
pub(super) fn bytes(text: &str, tree: &Tree, index: &FileIndex) -> Vec<SectionBytes> {
    index.sections.iter().map(|section| section_bytes(text, tree, section)).collect()
}

fn section_bytes(text: &str, tree: &Tree, section: &SectionIndex) -> SectionBytes {
    if section.section.kind != SectionKind::Stored {
        return SectionBytes::default();
    }
    let range = section.section.statements.clone();
    let numbers = numbered_starts(tree, &range);
    let mut numbers = numbers.iter().copied().peekable();
    let of = |(at, statement): (u32, &Statement)| {
        let mut cost = statement_cost(text, statement);
        if numbers.next_if_eq(&at).is_some() {
            cost += TextCost::of(command::LINE_NUMBER, &[Node::Long(0).into()]);
        }
        u32::try_from(cost.total()).unwrap_or(u32::MAX)
    };
    let statements = tree.statements().get(range.start as usize..range.end as usize).unwrap_or_default();
    SectionBytes {
        statements: (range.start..).zip(statements).map(of).collect(),
        calls: calls::of_section(tree, section),
    }
}

fn statement_cost(text: &str, statement: &Statement) -> TextCost {
    encode_statement(text, statement, &AnyNames)
        .map_or_else(|_| TextCost::default(), |(command, items)| TextCost::of(command, &items))
}

/// The statements of a range that begin a line with a number.
fn numbered_starts(tree: &Tree, range: &Range<u32>) -> Vec<u32> {
    let first = tree.line_of(range.start) as usize;
    let lines = tree.lines().get(first..).unwrap_or_default().iter();
    let inside = lines.take_while(|line| line.statements.start < range.end);
    let numbered = inside.filter(|line| line.number.is_some() && line.statements.start >= range.start);
    numbered.map(|line| line.statements.start).collect()
}

fn bound(tree: &Tree, section: &SectionIndex) -> u64 {
    let range = &section.section.statements;
    if section.section.kind != SectionKind::Stored || range.is_empty() {
        return 0;
    }
    let statements = tree.statements();
    let (Some(first), Some(last)) = (statements.get(range.start as usize), statements.get((range.end - 1) as usize))
    else {
        return 0;
    };
    let line = tree.lines().get(tree.line_of(range.start) as usize);
    // The number of the first line stands before its first statement.
    let start = line.filter(|line| line.number.is_some()).map_or(first.span.start, |line| line.span.start);
    let tokens = tree.tokens_in(acrc_diagnostics::Span::new(start, last.span.end));
    let of = |token: &acrc_syntax::lexer::Token| match token.kind {
        TokenKind::Integer | TokenKind::Real => NUMBER_BYTES,
        TokenKind::String | TokenKind::RemarkText => TOKEN_BYTES + u64::from(token.span.end - token.span.start),
        TokenKind::Newline | TokenKind::Comment | TokenKind::Colon | TokenKind::LeftParen | TokenKind::RightParen => 0,
        _ => TOKEN_BYTES,
    };
    let labels = section.labels.iter().map(|label| u64::from(label.name.end - label.name.start));
    tokens.iter().map(of).chain(labels).sum()
}

/// Bounds are multiples of this, in bytes.
const LEAST_STEP: u64 = 256;

/// The next number that is one of eight between two powers of two.
fn round_up(bytes: u64) -> u64 {
    let step = 1_u64 << bytes.checked_ilog2().unwrap_or(0).saturating_sub(3);
    bytes.next_multiple_of(step.max(LEAST_STEP))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_rounded_up_by_an_eighth_or_a_step() {
        for bytes in 0..50_000 {
            let rounded = round_up(bytes);
            assert!(rounded >= bytes && rounded < bytes + (bytes / 8).max(LEAST_STEP), "{bytes} {rounded}");
        }
    }
}
