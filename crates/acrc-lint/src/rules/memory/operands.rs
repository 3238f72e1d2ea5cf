//! The numbers that programs name variables by, beside the room that `DIM` makes for them.

use acrc_analysis::index::AliasTarget;
use acrc_analysis::memory::{Extent, LocalBlock};
use acrc_analysis::{AliasFact, walk};
use acrc_catalog::OperandClass;
use acrc_catalog::memory::USER_PARAMETERS;
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Expr, ExprKind, StatementKind};
use acrc_syntax::units::Level;

use crate::Context;

/// A number that must lie within a `DIM`.
#[derive(Clone, Copy)]
pub(super) struct Place<'e> {
    /// What is named, as a whole.
    pub(super) span: Span,
    /// What the number counts.
    pub(super) room: Room,
    /// The number.
    pub(super) index: Index<'e>,
}

/// What a number counts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Room {
    /// User parameters.
    Parameters,
    /// Variables of a class.
    Variables(OperandClass),
    /// Arrays of a class.
    Arrays(OperandClass),
    /// Elements of an array.
    Elements(OperandClass, u32),
}

/// A number as it is written.
#[derive(Clone, Copy)]
pub(super) enum Index<'e> {
    /// A constant.
    Number(i64),
    /// Something that is computed.
    Computed(&'e Expr),
}

impl Room {
    /// The class of the operand.
    pub(super) fn class(self) -> OperandClass {
        match self {
            Self::Parameters => OperandClass::Parameter,
            Self::Variables(class) | Self::Arrays(class) | Self::Elements(class, _) => class,
        }
    }

    /// The words of its `DIM`, without the size.
    pub(super) fn dim(self) -> String {
        match self {
            Self::Elements(class, array) => format!("DIM {class}{array}"),
            _ => format!("DIM {}", self.class()),
        }
    }

    /// What there is when `count` are dimensioned.
    pub(super) fn contents(self, count: u64) -> String {
        let last = count.saturating_sub(1);
        match (self, count) {
            (_, 0) => "nothing".to_owned(),
            (Self::Elements(..), 1) => "element 0".to_owned(),
            (Self::Elements(..), _) => format!("elements 0 to {last}"),
            (_, 1) => format!("{}0", self.class()),
            _ => format!("{class}0 to {class}{last}", class = self.class()),
        }
    }

    /// How large it is at most: `None` when nothing dimensions it.
    pub(super) fn extent(self, context: &Context<'_>) -> Option<Extent> {
        let locals = || context.memory().locals(context.level());
        match self {
            Self::Parameters => context.memory().parameters,
            Self::Variables(class) => locals()?.extent(LocalBlock::Variables(class), 0),
            Self::Arrays(class) => locals()?.extent(LocalBlock::References(class), 0),
            Self::Elements(class, array) => locals()?.extent(LocalBlock::Array(class), array),
        }
    }
}

/// The numbers of an operand or of an alias for one that lie in dimensioned memory.
pub(super) fn places<'e>(context: &Context<'_>, expr: &'e Expr) -> impl Iterator<Item = Place<'e>> + use<'e> {
    let found = if judged(context) { find(context, expr) } else { [None, None] };
    let local = matches!(context.level(), Level::Program(_));
    // At other prompts there are no local variables to name.
    found.into_iter().flatten().filter(move |place| local || place.room == Room::Parameters)
}

/// A piece of code without its surroundings names what is dimensioned elsewhere, and a definition only names.
fn judged(context: &Context<'_>) -> bool {
    let statement = context.tree().statements().get(context.statement() as usize);
    let defines = statement.is_some_and(|statement| matches!(statement.kind, StatementKind::Define(_)));
    !defines && !context.environment().fragment
}

fn find<'e>(context: &Context<'_>, expr: &'e Expr) -> [Option<Place<'e>>; 2] {
    let span = expr.span;
    let place = |room, index| Some(Place { span, room, index });
    match &expr.kind {
        ExprKind::Operand(operand) => {
            let (class, number) = (operand.class, index(&operand.index));
            let first = room(class, number).and_then(|room| place(room, number));
            let second = match (&operand.element, number) {
                (Some(element), Index::Number(array)) => {
                    let array = u32::try_from(array).ok();
                    array.and_then(|array| place(Room::Elements(class, array), index(element)))
                }
                _ => None,
            };
            [first, second]
        }
        ExprKind::Alias => {
            let target = context.alias(span).and_then(|fact| match fact {
                AliasFact::Defined { operand, .. } => Some(operand.target),
                AliasFact::Undefined { .. } => None,
            });
            match target {
                Some(AliasTarget::Operand(class, Some(number))) => {
                    let number = Index::Number(i64::try_from(number).unwrap_or(i64::MAX));
                    [room(class, number).and_then(|room| place(room, number)), None]
                }
                _ => [None, None],
            }
        }
        _ => [None, None],
    }
}

/// What the number of an operand counts. `None` for what is not dimensioned: flags, parameters of the system.
fn room(class: OperandClass, number: Index<'_>) -> Option<Room> {
    match class {
        OperandClass::Bit => None,
        OperandClass::Parameter => match number {
            Index::Number(number) => (0..i64::from(USER_PARAMETERS)).contains(&number).then_some(Room::Parameters),
            Index::Computed(_) => Some(Room::Parameters),
        },
        _ if class.is_array() => Some(Room::Arrays(class)),
        _ => Some(Room::Variables(class)),
    }
}

fn index(expr: &Expr) -> Index<'_> {
    match walk::literal(expr) {
        Some(value) if value.fract() == 0.0 && value.abs() < 1e15 => Index::Number(value as i64),
        _ => Index::Computed(expr),
    }
}
