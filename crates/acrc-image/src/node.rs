//! One operand of an instruction as a tree.

use acrc_catalog::{CommandId, FunctionId, Keyword, ObjectKind, OperandClass, Operator, UnaryOperator};

use crate::name::AxisName;

/// A constant, an operand, an expression or an argument of a statement.
///
/// `parens` counts the parentheses written around a node, for the lister; constants lose theirs.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A whole number of 32 bits: one raw word.
    Long(i32),
    /// A number with at most seven significant digits: one raw word.
    Single(f32),
    /// Any other number: two raw words, the low one first.
    Double(f64),
    /// A text in Latin-1; its bytes lie in the pool of the unit.
    String {
        /// The characters.
        bytes: Vec<u8>,
        /// Parentheses around it.
        parens: u8,
    },
    /// `P0`, `LV(P0)`, `BIT 24`. With a class that is an array, the array as a whole (`PLS0 BASE LA0`).
    Scalar {
        /// Its class.
        class: OperandClass,
        /// Its number.
        index: Box<Node>,
        /// Parentheses around it.
        parens: u8,
    },
    /// `LA0(1)`
    Array {
        /// Its class, an array.
        class: OperandClass,
        /// Which array.
        array: Box<Node>,
        /// Which element.
        element: Box<Node>,
        /// Parentheses around it.
        parens: u8,
    },
    /// An entry of the alias table of the image.
    Alias {
        /// Its place in the table.
        index: u16,
        /// Parentheses around it.
        parens: u8,
    },
    /// The n-th label that the unit defines, from 0 in the order of the stream.
    LabelRef(u16),
    /// A sign or `NOT`. The sign of a number is part of the number, except for `-0`.
    Unary {
        /// Which.
        op: UnaryOperator,
        /// What it applies to.
        operand: Box<Node>,
        /// Parentheses around it.
        parens: u8,
    },
    /// Two operands with an operator between.
    Binary {
        /// Which.
        op: Operator,
        /// Left of it.
        left: Box<Node>,
        /// Right of it.
        right: Box<Node>,
        /// Parentheses around it.
        parens: u8,
    },
    /// A function.
    Call {
        /// Which.
        function: FunctionId,
        /// At most four arguments.
        arguments: Vec<Node>,
        /// Parentheses around it.
        parens: u8,
    },
    /// An axis by name with its value: `X`, `X5`, `X/25`, `Y(3,-1)`, `X ENC2`.
    Axis {
        /// Its name.
        name: AxisName,
        /// The slash of an incremental value.
        slash: bool,
        /// An expression, a [`Node::Tuple`], a [`Node::Object`] or a [`Node::Word`].
        value: Option<Box<Node>>,
    },
    /// An object by number: `ENC0`, `PROG1`, `AXIS3/5`.
    Object {
        /// What it is.
        kind: ObjectKind,
        /// Its number, at most 1022.
        index: Option<u16>,
        /// The slash of an incremental value.
        slash: bool,
        /// It stands before the command: `AXIS0 PPU 4000`.
        prefix: bool,
        /// As in [`Node::Axis`].
        value: Option<Box<Node>>,
    },
    /// Two to seven values in parentheses.
    Tuple(Vec<Node>),
    /// A word that is only part of a statement: `ALL`, `CLOCK`, `USING`.
    Word {
        /// Which.
        keyword: Keyword,
        /// The number glued to it, at most 1022.
        index: Option<u16>,
    },
    /// The kind of the moves behind it in one move statement: `X2 SINE Y(0,90,90,100)`.
    Interpolation(CommandId),
    /// `#1`
    Device(Box<Node>),
}

/// Where a node may stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// Operand of an operator, argument of a function, element of a tuple.
    Expression,
    /// Value of an axis or an object.
    Value,
    /// Item of an instruction.
    Item,
}

impl Role {
    /// Can `node` stand here?
    pub(crate) fn admits(self, node: &Node) -> bool {
        match node {
            Node::LabelRef(_) | Node::Axis { .. } | Node::Interpolation(_) | Node::Device(_) => self == Self::Item,
            Node::Object { .. } | Node::Tuple(_) | Node::Word { .. } => self != Self::Expression,
            _ => true,
        }
    }
}

impl Node {
    /// A text without parentheses.
    pub fn string(bytes: impl Into<Vec<u8>>) -> Self {
        Self::String { bytes: bytes.into(), parens: 0 }
    }

    /// A variable, parameter or flag with a constant number.
    pub fn scalar(class: OperandClass, index: i32) -> Self {
        Self::Scalar { class, index: Box::new(Self::Long(index)), parens: 0 }
    }

    /// Is it a raw constant?
    pub fn is_constant(&self) -> bool {
        matches!(self, Self::Long(_) | Self::Single(_) | Self::Double(_))
    }

    /// Does it have a value of its own (constants, operands, operators, functions)?
    pub fn is_expression(&self) -> bool {
        Role::Expression.admits(self)
    }

    /// The parentheses written around it.
    pub fn parens(&self) -> u8 {
        match self {
            Self::String { parens, .. }
            | Self::Scalar { parens, .. }
            | Self::Array { parens, .. }
            | Self::Alias { parens, .. }
            | Self::Unary { parens, .. }
            | Self::Binary { parens, .. }
            | Self::Call { parens, .. } => *parens,
            _ => 0,
        }
    }

    /// The count of parentheses, where the node has one.
    pub fn parens_mut(&mut self) -> Option<&mut u8> {
        match self {
            Self::String { parens, .. }
            | Self::Scalar { parens, .. }
            | Self::Array { parens, .. }
            | Self::Alias { parens, .. }
            | Self::Unary { parens, .. }
            | Self::Binary { parens, .. }
            | Self::Call { parens, .. } => Some(parens),
            _ => None,
        }
    }

    /// The nodes directly below it, in the order of the stream.
    pub fn children(&self) -> Vec<&Self> {
        match self {
            Self::Scalar { index: only, .. } | Self::Unary { operand: only, .. } | Self::Device(only) => vec![only],
            Self::Array { array: left, element: right, .. } | Self::Binary { left, right, .. } => vec![left, right],
            Self::Call { arguments: nodes, .. } | Self::Tuple(nodes) => nodes.iter().collect(),
            Self::Axis { value, .. } | Self::Object { value, .. } => value.iter().map(AsRef::as_ref).collect(),
            _ => Vec::new(),
        }
    }

    /// The nodes directly below it, to be changed.
    pub(crate) fn children_mut(&mut self) -> Vec<&mut Self> {
        match self {
            Self::Scalar { index: only, .. } | Self::Unary { operand: only, .. } | Self::Device(only) => vec![only],
            Self::Array { array: left, element: right, .. } | Self::Binary { left, right, .. } => vec![left, right],
            Self::Call { arguments: nodes, .. } | Self::Tuple(nodes) => nodes.iter_mut().collect(),
            Self::Axis { value, .. } | Self::Object { value, .. } => value.iter_mut().map(AsMut::as_mut).collect(),
            _ => Vec::new(),
        }
    }
}
