//! Ranks of operators: a flat row of operands and operators becomes a tree (guide, "Parametric Evaluation").
//!
//! The row holds no parentheses: what stood between them is already one operand. So the grammar needs no recursion but
//! that of its ranks, and neither a long nor a deeply nested expression can exhaust the stack or be read twice.

use std::cell::OnceCell;
use std::vec;

use acrc_catalog::{Operator, UnaryOperator};
use acrc_diagnostics::Span;
use chumsky::error::{Error, LabelError};
use chumsky::input::{Stream, ValueInput};
use chumsky::inspector::SimpleState;
use chumsky::pratt::{Operator as _, infix, left, prefix};
use chumsky::prelude::*;
use chumsky::util::MaybeRef;

use crate::ast::{Expr, ExprKind};

/// One place in a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Item {
    /// An operand, by its place in the store.
    Operand(u32),
    /// An operator between two operands.
    Infix(Operator, Span),
    /// An operator before an operand.
    Prefix(UnaryOperator, Span),
}

/// The operands of the rows that are being read. Each is taken out once, when it becomes part of a larger one.
#[derive(Debug, Default)]
pub(super) struct Store(Vec<Option<Expr>>);

impl Store {
    pub(super) fn push(&mut self, operand: Expr) -> u32 {
        self.0.push(Some(operand));
        (self.0.len() - 1) as u32
    }

    pub(super) fn take(&mut self, index: u32) -> Option<Expr> {
        self.0.get_mut(index as usize).and_then(Option::take)
    }

    pub(super) fn get(&self, index: u32) -> Option<&Expr> {
        self.0.get(index as usize)?.as_ref()
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    pub(super) fn truncate(&mut self, length: usize) {
        self.0.truncate(length);
    }

    /// An operand for a node. Only a row that is refused anyway asks for one twice.
    fn node(&mut self, index: u32) -> Expr {
        self.take(index).unwrap_or(Expr { span: Span::default(), kind: ExprKind::Error })
    }

    fn unary(&mut self, operator: UnaryOperator, sign: Span, operand: u32) -> u32 {
        let operand = self.node(operand);
        self.push(Expr { span: Span::cover(sign, operand.span), kind: ExprKind::Unary(operator, Box::new(operand)) })
    }

    fn binary(&mut self, operator: Operator, place: Span, left: u32, right: u32) -> u32 {
        let (left, right) = (self.node(left), self.node(right));
        self.push(Expr {
            span: Span::cover(left.span, right.span),
            kind: ExprKind::Binary(operator, place, Box::new([left, right])),
        })
    }
}

/// What a row lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Missing(pub(super) &'static str);

impl Missing {
    pub(super) const VALUE: Self = Self(VALUE);
}

/// Builds the tree of a row; its place in the store is the result.
///
/// # Errors
/// The row does not alternate between operands and operators.
pub(super) fn arrange(row: &[Item], store: &mut Store) -> Result<u32, Missing> {
    // Nearly all rows are one value, or two with an operator.
    match *row {
        [Item::Operand(only)] => Ok(only),
        [Item::Operand(left), Item::Infix(operator, place), Item::Operand(right)] => {
            Ok(store.binary(operator, place, left, right))
        }
        [Item::Prefix(operator, sign), Item::Operand(operand)] => Ok(store.unary(operator, sign, operand)),
        _ => arrange_by_rank(row, store),
    }
}

type Row = Stream<vec::IntoIter<Item>>;
type Extra = extra::Full<Missing, SimpleState<Store>, ()>;
type Grammar = Boxed<'static, 'static, Row, u32, Extra>;

thread_local! {
    /// The grammar is built once per thread; building it takes longer than reading a file.
    static GRAMMAR: OnceCell<Grammar> = const { OnceCell::new() };
}

fn arrange_by_rank(row: &[Item], store: &mut Store) -> Result<u32, Missing> {
    let mut state = SimpleState(std::mem::take(store));
    let result = GRAMMAR.with(|grammar| {
        let grammar = grammar.get_or_init(grammar_of_ranks);
        grammar.parse_with_state(Stream::from_iter(row.to_vec()), &mut state).into_result()
    });
    *store = state.0;
    result.map_err(|missing| missing.first().copied().unwrap_or(Missing::VALUE))
}

const VALUE: &str = "a value";
const OPERATOR: &str = "an operator";

/// The loosest rank of the catalogue; a binding power is the distance from it.
const LOOSEST: u8 = 9;

fn power(rank: u8) -> u16 {
    u16::from(LOOSEST.saturating_sub(rank))
}

fn grammar_of_ranks() -> Grammar {
    let operand = select! { Item::Operand(index) => index }.labelled(VALUE).boxed();
    let mut ranks: Vec<u8> = Operator::ALL.iter().map(|operator| operator.precedence()).collect();
    ranks.sort_unstable();
    ranks.dedup();
    let infixes: Vec<_> = ranks
        .into_iter()
        .map(|rank| {
            let operator =
                select! { Item::Infix(operator, place) if operator.precedence() == rank => (operator, place) };
            infix(left(power(rank)), operator.labelled(OPERATOR).boxed(), |left, (operator, place), right, extra| {
                let state: &mut SimpleState<Store> = extra.state();
                state.binary(operator, place, left, right)
            })
            .boxed()
        })
        .collect();
    let prefixes: Vec<_> = UnaryOperator::ALL
        .iter()
        .map(|&wanted| {
            let operator = select! { Item::Prefix(operator, sign) if operator == wanted => (operator, sign) };
            prefix(power(wanted.precedence()), operator.labelled(VALUE).boxed(), |(operator, sign), operand, extra| {
                let state: &mut SimpleState<Store> = extra.state();
                state.unary(operator, sign, operand)
            })
            .boxed()
        })
        .collect();
    operand.pratt((infixes, prefixes)).then_ignore(end()).boxed()
}

impl<'src, I: ValueInput<'src>> Error<'src, I> for Missing {}

impl<'src, I: Input<'src>, L> LabelError<'src, I, L> for Missing
where
    L: Name,
{
    fn expected_found<E: IntoIterator<Item = L>>(
        expected: E,
        _found: Option<MaybeRef<'src, I::Token>>,
        _span: I::Span,
    ) -> Self {
        Self(expected.into_iter().next().map_or(VALUE, |label| label.name()))
    }

    fn label_with(&mut self, label: L) {
        self.0 = label.name();
    }
}

/// What chumsky calls an expected thing, in words.
trait Name {
    fn name(&self) -> &'static str;
}

impl Name for &'static str {
    fn name(&self) -> &'static str {
        self
    }
}

impl<T> Name for chumsky::DefaultExpected<'_, T> {
    fn name(&self) -> &'static str {
        OPERATOR
    }
}
