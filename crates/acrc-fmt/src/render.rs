//! Lines to rows: blanks and case of one line at a time.

use acrc_catalog::command;
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
use acrc_syntax::ast::{Line, Separator, Statement, StatementKind};
use acrc_syntax::lexer::{Token, TokenKind};

use crate::indent::Indents;
use crate::lines::{State, is_blank, slice, trim_end};
use crate::marks::{Mark, Marker};
use crate::options::Options;
use crate::rows::{Role, Rows, Table};
use crate::{case, spacing};

/// Writes every line of a text.
pub(crate) fn rows(text: &str, tree: &Tree, states: &[State], options: Options) -> Rows {
    let mut lines = tree.lines();
    // A text that ends with a line break has an empty last line, which is none.
    if let Some((last, before)) = lines.split_last()
        && last.span.is_empty()
    {
        lines = before;
    }
    let mut renderer = Renderer {
        text,
        tree,
        options,
        tokens: tree.tokens(),
        marks: Vec::new(),
        rows: Rows::with_capacity(text.len() + text.len() / 4, lines.len()),
    };
    let mut indents = Indents::new(tree, options);
    for (line, state) in lines.iter().zip(states) {
        let indent = indents.next(line.statements.clone());
        let tokens = renderer.take_tokens();
        let raw = slice(text, line.span);
        match state {
            State::Blank => renderer.rows.blank(),
            State::Unreadable => renderer.rows.copy(raw, Role::OTHER),
            State::Frozen => renderer.rows.copy(raw, Role::Frozen),
            State::Open => renderer.line(line, tokens, indent),
        }
    }
    renderer.rows
}

struct Renderer<'t> {
    text: &'t str,
    tree: &'t Tree,
    options: Options,
    /// The tokens from the next line on.
    tokens: &'t [Token],
    /// The marks of the tokens of a line; kept for its memory.
    marks: Vec<Mark>,
    rows: Rows,
}

/// A token and its mark.
type Marked = (Token, Mark);

impl<'t> Renderer<'t> {
    /// The tokens of the next line, without its line break.
    fn take_tokens(&mut self) -> &'t [Token] {
        let end = self.tokens.iter().position(|token| token.kind == TokenKind::Newline);
        let (line, rest) = self.tokens.split_at(end.unwrap_or(self.tokens.len()));
        self.tokens = rest.get(1..).unwrap_or_default();
        line
    }

    fn line(&mut self, line: &Line, tokens: &[Token], indent: usize) {
        let range = line.statements.start as usize..line.statements.end as usize;
        let statements = self.tree.statements().get(range).unwrap_or_default();
        let mut marker = Marker::new(tokens, &mut self.marks);
        for statement in statements {
            marker.statement(statement);
        }
        let table = table_stop(&mut marker, statements);
        let remark = remark_stop(&mut marker, tokens, line, statements);

        let mut row = self.rows.begin(indent, role(line, statements));
        let mut before: Option<Marked> = None;
        for (index, token) in tokens.iter().enumerate() {
            let marked = (*token, self.marks.get(index).copied().unwrap_or_default());
            let gap = Span::new(before.map_or(line.span.start, |(before, _)| before.span.end), token.span.start);
            // The indentation stands behind the number of a line.
            let indent = if index == usize::from(line.number.is_some()) { indent } else { 0 };
            if self.gap(gap, before, marked, indent) {
                row.table = row.table.or(table.filter(|stop| stop.1 == index).map(|stop| (stop.0, self.rows.stop())));
                row.remark = row.remark.or(remark.filter(|stop| *stop == index).map(|_| self.rows.stop()));
            }
            self.token(marked);
            before = Some(marked);
        }
        let rest = Span::new(before.map_or(line.span.start, |(last, _)| last.span.end), line.span.end);
        self.rows.out().push_str(trim_end(slice(self.text, rest)));
        self.rows.end(row);
    }

    /// Writes what stands before a token. False when it had to be left as it is.
    fn gap(&mut self, gap: Span, before: Option<Marked>, (token, mark): Marked, indent: usize) -> bool {
        let (text, out) = (slice(self.text, gap), self.rows.out());
        if !is_blank(text) {
            out.push_str(text);
            return false;
        }
        if let Some((before, before_mark)) = before {
            let apart = spacing::is_apart((before.kind, before_mark), (token.kind, mark));
            if apart || !text.is_empty() && spacing::would_merge(before.kind, token.kind) {
                out.push(' ');
            }
        }
        out.extend(std::iter::repeat_n(' ', indent));
        true
    }

    fn token(&mut self, (token, mark): Marked) {
        let text = slice(self.text, token.span);
        let out = self.rows.out();
        match token.kind {
            TokenKind::Word | TokenKind::Dollar if !mark.has(Mark::NAME) => {
                case::push(out, text, self.options.keyword_case);
            }
            TokenKind::RemarkText | TokenKind::Comment => out.push_str(trim_end(text)),
            _ => out.push_str(text),
        }
    }
}

/// The column of a table line: its table, and the index of the token that starts the column.
fn table_stop(marker: &mut Marker<'_>, statements: &[Statement]) -> Option<(Table, usize)> {
    let ([first] | [first, Statement { kind: StatementKind::Remark(_), .. }]) = statements else { return None };
    match &first.kind {
        StatementKind::Define(define) => Some((Table::Define, marker.find(define.operand.span.start))),
        StatementKind::Dim(dim) if dim.parenthesised => {
            let size = marker.find(dim.sizes.first()?.span.start);
            Some((Table::Dim, size.checked_sub(1)?))
        }
        _ => None,
    }
}

/// Index of the token that starts the remark behind other statements, with its colon.
fn remark_stop(marker: &mut Marker<'_>, tokens: &[Token], line: &Line, statements: &[Statement]) -> Option<usize> {
    if line.comment.is_some() {
        return if statements.is_empty() { None } else { tokens.len().checked_sub(1) };
    }
    let [_, .., last] = statements else { return None };
    let is_remark = matches!(last.kind, StatementKind::Remark(_)) && last.separator != Separator::Then;
    let word = is_remark.then(|| marker.find(last.span.start))?;
    let colon =
        word.checked_sub(1).filter(|&index| tokens.get(index).is_some_and(|token| token.kind == TokenKind::Colon));
    Some(colon.unwrap_or(word))
}

fn role(line: &Line, statements: &[Statement]) -> Role {
    let is_remark = |statement: &&Statement| matches!(statement.kind, StatementKind::Remark(_));
    let Some(first) = statements.iter().find(|statement| !is_remark(statement)) else {
        let is_comment = line.comment.is_some() || !statements.is_empty();
        return if is_comment { Role::Comment } else { Role::OTHER };
    };
    let is_conditional = statements.iter().any(|statement| statement.separator == Separator::Then);
    let last = statements.iter().rfind(|statement| !is_remark(statement)).unwrap_or(first);
    let leaves =
        matches!(&last.kind, StatementKind::Command(last) if [command::RETURN, command::END].contains(&last.id));
    Role::Code { label: matches!(first.kind, StatementKind::Label(_)), leaves: leaves && !is_conditional }
}
