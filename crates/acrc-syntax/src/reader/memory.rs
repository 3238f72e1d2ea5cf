//! `DIM` (guide, "Memory Control").

use acrc_catalog::{CommandId, command};
use acrc_diagnostics::{Diagnostic, Edit, Fix, Span};

use super::{Read, Reader};
use crate::ast::{Dim, Expr, StatementKind};
use crate::codes;
use crate::lexer::{Token, TokenKind};

/// What has a number of its own before its size.
const NUMBERED: [CommandId; 3] = [command::DIM_PROG, command::DIM_PLC, command::DIM_STREAM];
/// Arrays: with a number the size of one array, without it the number of arrays.
const ARRAYS: [CommandId; 4] = [command::DIM_LA, command::DIM_SA, command::DIM_DA, command::DIM_STRING_A];

impl Reader<'_> {
    /// `DIM LV(10)`, `DIM PROG0(8192)`, `DIM $V(1, 10)`, `DIM LV10`, `DIM`; the word `DIM` is taken.
    pub(super) fn dim(&mut self, first: Token) -> Read<StatementKind> {
        let id = match self.dim_daughter() {
            Some((id, words)) => {
                self.skip(words);
                id
            }
            None if self.peek().kind.ends_statement() => command::DIM,
            None => {
                return Err(self.expected("a kind of memory").help("`LV`, `SV`, `DV`, `$V`, `LA`, `P`, `PROG`, ..."));
            }
        };
        let name = Span::new(first.span.start, self.consumed_to());
        let index = if self.has_index(id) { Some(self.value()?) } else { None };
        let parenthesised = self.peek().kind == TokenKind::LeftParen;
        let sizes = if parenthesised { self.list()? } else { self.bare_sizes()? };
        if sizes.is_empty() && id != command::DIM {
            self.wanted = ("a size in parentheses", None);
        }
        if let (false, [first, .., last] | [first @ last]) = (parenthesised, sizes.as_slice()) {
            self.report_bare_sizes(&sizes, first.span.start, last.span.end);
        }
        Ok(StatementKind::Dim(Box::new(Dim { id, name, index, sizes, parenthesised })))
    }

    fn dim_daughter(&self) -> Option<(CommandId, usize)> {
        let token = self.peek();
        if token.kind == TokenKind::Dollar {
            return acrc_catalog::daughter(command::DIM, self.slice(token.span)).map(|id| (id, 1));
        }
        self.daughter(command::DIM)
    }

    fn has_index(&self, id: CommandId) -> bool {
        let sized = matches!(self.peek_at(1).kind, TokenKind::LeftParen | TokenKind::Integer);
        self.peek().kind == TokenKind::Integer && (NUMBERED.contains(&id) || ARRAYS.contains(&id) && sized)
    }

    fn bare_sizes(&mut self) -> Read<Vec<Expr>> {
        let mut sizes = Vec::new();
        while matches!(self.peek().kind, TokenKind::Integer | TokenKind::Real) {
            sizes.push(self.value()?);
        }
        Ok(sizes)
    }

    fn report_bare_sizes(&mut self, sizes: &[Expr], start: u32, end: u32) {
        let gaps = sizes.windows(2).filter_map(|pair| match pair {
            [left, right] => Some(Edit::replace(Span::new(left.span.end, right.span.start), ", ")),
            _ => None,
        });
        let mut edits = vec![Edit::insert(start, "(")];
        edits.extend(gaps);
        edits.push(Edit::insert(end, ")"));
        self.report(
            Diagnostic::warning(
                codes::DIM_WITHOUT_PARENTHESES,
                Span::new(start, end),
                "the size of a `DIM` stands without parentheses",
            )
            .with_fix(Fix::safe("put it in parentheses", edits)),
        );
    }
}
