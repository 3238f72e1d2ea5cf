//! How the arguments of a command are put together when it is executed.
//!
//! Everything that is known at load lies here; what is computed has a slot. A command whose arguments are all constant
//! has them ready.

use acrc_catalog::{CommandId, Keyword, ObjectKind, OperandClass};
use acrc_image::{AxisName, Mark};

use crate::fault::FaultKind;
use crate::host::{Arg, ArgValue, Reference, Source};
use crate::op::Slot;
use crate::value::Value;

/// A command and its arguments.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) command: CommandId,
    pub(crate) prefix: Option<(ObjectKind, Option<u16>)>,
    pub(crate) arguments: Arguments,
}

/// The arguments of a command.
#[derive(Clone, Debug)]
pub(crate) enum Arguments {
    /// Nothing in them changes.
    Constant(Box<[Arg]>),
    /// They are put together at each execution.
    Computed(Box<[Part]>),
}

/// A value of an argument.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Operand {
    Const(Value),
    Long(Slot),
    Double(Slot),
    Single(Slot),
    Value(Slot),
}

/// The number of a variable, parameter or flag.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Index {
    Const(i32),
    Slot(Slot),
}

/// An operand that is named instead of read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Named {
    pub(crate) class: OperandClass,
    pub(crate) index: Index,
    pub(crate) element: Option<Index>,
}

/// One argument.
#[derive(Clone, Debug)]
pub(crate) enum Part {
    Value(Operand, Mark),
    Axis {
        name: AxisName,
        slash: bool,
        value: PartValue,
    },
    Object {
        kind: ObjectKind,
        index: Option<u16>,
        slash: bool,
        value: PartValue,
    },
    Tuple(Box<[Operand]>),
    Word {
        keyword: Keyword,
        index: Option<u16>,
    },
    Interpolation(CommandId),
    Device(Index),
    Reference {
        named: Named,
        negative: bool,
        mark: Mark,
    },
    /// `signed`: the sign of the number counts, because it is written as a number and not as a flag.
    Bit {
        index: Index,
        negative: bool,
        signed: bool,
    },
}

/// What stands behind an axis or an object.
#[derive(Clone, Debug)]
pub(crate) enum PartValue {
    None,
    Value(Operand),
    Tuple(Box<[Operand]>),
    Table { values: Box<[Operand]>, table: Named },
    Object(ObjectKind, Option<u16>),
    Reference(Named),
    Word(Keyword, Option<u16>),
}

/// Where the slots of a plan are read.
pub(crate) trait Slots {
    /// The value of an operand.
    fn operand(&self, operand: &Operand) -> Result<Value, FaultKind>;

    /// The number of a variable, parameter or flag.
    fn index(&self, index: Index) -> Result<i64, FaultKind>;
}

/// There are no slots yet: at load.
pub(crate) struct NoSlots;

impl Slots for NoSlots {
    fn operand(&self, operand: &Operand) -> Result<Value, FaultKind> {
        match operand {
            Operand::Const(value) => Ok(value.clone()),
            _ => Err(not_constant()),
        }
    }

    fn index(&self, index: Index) -> Result<i64, FaultKind> {
        match index {
            Index::Const(number) => Ok(i64::from(number)),
            Index::Slot(_) => Err(not_constant()),
        }
    }
}

/// Only says that a plan is not constant; no program ever sees it.
fn not_constant() -> FaultKind {
    FaultKind::Argument("not constant".into())
}

impl Arguments {
    /// Makes them ready if they are constant.
    pub(crate) fn new(parts: Vec<Part>) -> Self {
        let constant: Result<Box<[Arg]>, FaultKind> = parts.iter().map(|part| part.build(&NoSlots)).collect();
        constant.map_or_else(|_| Self::Computed(parts.into()), Self::Constant)
    }
}

impl Part {
    /// The argument.
    pub(crate) fn build(&self, slots: &impl Slots) -> Result<Arg, FaultKind> {
        Ok(match self {
            Self::Value(operand, mark) => Arg::Value(slots.operand(operand)?, *mark),
            Self::Axis { name, slash, value } => Arg::Axis { name: *name, slash: *slash, value: value.build(slots)? },
            Self::Object { kind, index, slash, value } => {
                Arg::Object { kind: *kind, index: *index, slash: *slash, value: value.build(slots)? }
            }
            Self::Tuple(operands) => Arg::Tuple(values(operands, slots)?),
            Self::Word { keyword, index } => Arg::Word { keyword: *keyword, index: *index },
            Self::Interpolation(command) => Arg::Interpolation(*command),
            Self::Device(index) => Arg::Device(slots.index(*index)? as i32),
            Self::Reference { named, negative, mark } => {
                Arg::Reference { target: named.build(slots)?, negative: *negative, mark: *mark }
            }
            Self::Bit { index, negative, signed } => {
                let index = slots.index(*index)?;
                let minus = *signed && index < 0;
                Arg::Bit { index: if minus { -index } else { index }, negative: *negative != minus }
            }
        })
    }
}

impl PartValue {
    fn build(&self, slots: &impl Slots) -> Result<ArgValue, FaultKind> {
        Ok(match self {
            Self::None => ArgValue::None,
            Self::Value(operand) => ArgValue::Value(slots.operand(operand)?),
            Self::Tuple(operands) => ArgValue::Tuple(values(operands, slots)?),
            Self::Table { values: operands, table } => {
                ArgValue::Table { values: values(operands, slots)?, table: table.build(slots)? }
            }
            Self::Object(kind, index) => ArgValue::Source(Source::Object(*kind, *index)),
            Self::Reference(named) => ArgValue::Source(Source::Reference(named.build(slots)?)),
            Self::Word(keyword, index) => ArgValue::Source(Source::Word(*keyword, *index)),
        })
    }
}

impl Named {
    /// The place it names.
    pub(crate) fn build(&self, slots: &impl Slots) -> Result<Reference, FaultKind> {
        let (class, index) = (self.class, slots.index(self.index)?);
        Ok(match (class, self.element) {
            (OperandClass::Parameter, _) => Reference::Parameter(index),
            (OperandClass::Bit, _) => Reference::Bit(index),
            (_, Some(element)) => Reference::Element { class, array: index, element: slots.index(element)? },
            (_, None) if class.is_array() => Reference::Array { class, array: index },
            (_, None) => Reference::Variable { class, index },
        })
    }
}

fn values(operands: &[Operand], slots: &impl Slots) -> Result<Vec<Value>, FaultKind> {
    operands.iter().map(|operand| slots.operand(operand)).collect()
}
