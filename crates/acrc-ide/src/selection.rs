//! What a growing selection takes in next: word, expression, argument, statement, line, block, subroutine, program, file.

use acrc_analysis::query::parse;
use acrc_analysis::{Db, SourceFile, walk};
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
use acrc_syntax::ast::{Argument, Axis, Object, Statement, StatementKind};
use acrc_syntax::lexer::{Token, TokenKind};

use crate::place::{lines_in, section_of};
use crate::routine::{span_of, subroutines};
use crate::statement_at;

/// The parts of a file that hold a place, from the smallest to the whole file. Each holds the one before it and more.
pub fn selection_ranges(db: &dyn Db, file: SourceFile, offset: u32) -> Vec<Span> {
    let tree = parse(db, file);
    let end = file.text(db).len() as u32;
    let offset = offset.min(end);
    let mut spans = vec![Span::new(0, end)];
    for line in tree.lines().get(lines_in(tree, Span::empty(offset))).unwrap_or_default() {
        spans.push(line.span);
        spans.extend(line.comment);
        spans.extend(line.number.map(|number| number.span));
        spans.extend(words(tree.tokens_in(line.span)));
    }
    if let Some(at) = statement_at(db, file, offset) {
        around(db, file, at, &mut spans);
        // Where two statements touch the first one may be meant, when nothing of the second is there.
        for statement in [at.checked_sub(1), Some(at)].into_iter().flatten() {
            spans.extend(tree.statements().get(statement as usize).into_iter().flat_map(inner));
        }
    }
    nested(spans, offset)
}

/// The tokens of a line; the number of `LV2` is no word of its own.
fn words(tokens: &[Token]) -> impl Iterator<Item = Span> {
    let before = std::iter::once(None).chain(tokens.iter().map(Some));
    let is_number_of = |token: &Token, before: Option<&Token>| {
        let touches = |word: &Token| word.kind == TokenKind::Word && word.span.end == token.span.start;
        token.kind == TokenKind::Integer && before.is_some_and(touches)
    };
    tokens.iter().zip(before).filter(move |(token, before)| !is_number_of(token, *before)).map(|(token, _)| token.span)
}

/// What holds the whole of a statement: blocks, subroutines, the program.
fn around(db: &dyn Db, file: SourceFile, statement: u32, spans: &mut Vec<Span>) {
    let (tree, Some(index)) = (parse(db, file), section_of(db, file, statement)) else { return };
    let own = index.blocks.block_of(statement).or_else(|| index.blocks.enclosing(statement));
    for block in std::iter::successors(own, |block| index.blocks.parent(block)) {
        let Some(closer) = block.closer else { continue };
        let marks: Vec<u32> =
            std::iter::once(block.opener).chain(block.branches.iter().copied()).chain([closer]).collect();
        spans.push(lines(tree, block.opener..closer + 1));
        let bodies = marks.windows(2).filter_map(|pair| Some(*pair.first()? + 1..*pair.last()?));
        spans.extend(bodies.filter(|body| !body.is_empty()).map(|body| lines(tree, body)));
    }
    spans.extend(subroutines(tree, index).into_iter().map(|routine| lines(tree, routine.statements)));
    let section = &index.section;
    spans.push(lines(tree, section.statements.clone()));
    let whole = section.opener.unwrap_or(section.statements.start);
    spans.push(lines(tree, whole..section.closer.map_or(section.statements.end, |closer| closer + 1)));
}

/// The lines of some statements, from the first character of the first line.
fn lines(tree: &Tree, statements: std::ops::Range<u32>) -> Span {
    let span = span_of(tree, statements);
    let lines = tree.lines().get(lines_in(tree, span)).unwrap_or_default();
    let line = |line: Option<&acrc_syntax::ast::Line>| line.map_or(span, |line| line.span);
    Span::cover(line(lines.first()), line(lines.last()))
}

/// The parts of a statement: itself, arguments, expressions.
fn inner(statement: &Statement) -> Vec<Span> {
    let mut spans = vec![statement.span];
    walk::expressions(statement, &mut |expr| spans.push(expr.span));
    if let StatementKind::Command(command) = &statement.kind {
        spans.push(command.name);
        spans.extend(command.prefix.iter().map(|prefix| prefix.span));
        command.arguments.iter().for_each(|argument| in_argument(argument, &mut spans));
    }
    spans
}

fn in_argument(argument: &Argument, spans: &mut Vec<Span>) {
    let (own, value) = match argument {
        Argument::Axis(Axis { span, name, value, .. }) | Argument::Object(Object { span, name, value, .. }) => {
            spans.push(*name);
            (*span, value)
        }
        Argument::Tuple(tuple) => (tuple.span, &None),
        Argument::Bit(bit) => (bit.span, &None),
        _ => return,
    };
    spans.push(own);
    if let Some(value) = value {
        in_argument(value, spans);
    }
}

/// Of the spans that hold a place those that hold each other.
fn nested(mut spans: Vec<Span>, offset: u32) -> Vec<Span> {
    spans.retain(|span| span.start <= offset && offset <= span.end);
    // Of two that touch at the place the one behind it is meant.
    spans.sort_by_key(|span| (span.is_empty(), span.len(), offset == span.end));
    let mut chain: Vec<Span> = Vec::new();
    for span in spans {
        let grows = |inner: &Span| span.start <= inner.start && inner.end <= span.end && span.len() > inner.len();
        if chain.last().is_none_or(grows) {
            chain.push(span);
        }
    }
    if chain.last().is_none() {
        chain.push(Span::empty(offset));
    }
    chain
}
