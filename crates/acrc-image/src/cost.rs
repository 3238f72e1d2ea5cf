//! What the bytes of a stored text go to, by the rows of the guide's table ("How Much Memory?").

use std::ops::{Add, AddAssign};

use acrc_catalog::{CommandId, command};

use crate::instruction::Item;
use crate::layout::{MANY, SLOTS};
use crate::node::Node;

/// Bytes of a word.
const WORD: u64 = 4;

/// Bytes of stored statements by what they go to. The sum over the statements of a unit is [`crate::Unit::memory`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TextCost {
    /// Commands: a word each.
    pub commands: u64,
    /// Operators, operands, axes, objects and words of statements: a word each.
    pub operators: u64,
    /// Numbers: a word, or two for a double.
    pub constants: u64,
    /// Texts of statements: a word and a byte a character.
    pub strings: u64,
    /// `REM` with its text.
    pub remarks: u64,
    /// Labels and line numbers.
    pub labels: u64,
}

impl TextCost {
    /// The cost of one statement.
    pub fn of(command: CommandId, items: &[Item]) -> Self {
        let mut cost = Self { commands: WORD, ..Self::default() };
        for (place, item) in items.iter().enumerate() {
            // Constants that have no slot in the command word are wrapped.
            if place >= SLOTS && item.node.is_constant() {
                cost.operators += WORD;
            }
            cost.add_node(&item.node);
        }
        if items.len() >= MANY as usize {
            cost.operators += WORD;
        }
        match command {
            command::REM => Self { remarks: cost.total(), ..Self::default() },
            command::LABEL | command::LINE_NUMBER => Self { labels: cost.total(), ..Self::default() },
            _ => cost,
        }
    }

    /// All of it, in bytes.
    pub fn total(&self) -> u64 {
        self.kinds().into_iter().map(|(_, bytes)| bytes).sum()
    }

    /// Each kind by its name, in the order of reports.
    pub fn kinds(&self) -> [(&'static str, u64); 6] {
        let Self { commands, operators, constants, strings, remarks, labels } = *self;
        [
            ("commands", commands),
            ("operators", operators),
            ("constants", constants),
            ("strings", strings),
            ("remarks", remarks),
            ("labels", labels),
        ]
    }

    fn add_node(&mut self, node: &Node) {
        match node {
            Node::Long(_) | Node::Single(_) => self.constants += WORD,
            Node::Double(_) => self.constants += 2 * WORD,
            Node::String { bytes, .. } => self.strings += WORD + bytes.len() as u64,
            _ => self.operators += WORD,
        }
        match node {
            Node::Scalar { index: only, .. } | Node::Unary { operand: only, .. } | Node::Device(only) => {
                self.add_node(only);
            }
            Node::Array { array: left, element: right, .. } | Node::Binary { left, right, .. } => {
                self.add_node(left);
                self.add_node(right);
            }
            Node::Call { arguments: nodes, .. } | Node::Tuple(nodes) => {
                for node in nodes {
                    self.add_node(node);
                }
            }
            Node::Axis { value, .. } | Node::Object { value, .. } => {
                if let Some(value) = value {
                    self.add_node(value);
                }
            }
            Node::Long(_)
            | Node::Single(_)
            | Node::Double(_)
            | Node::String { .. }
            | Node::Alias { .. }
            | Node::LabelRef(_)
            | Node::Word { .. }
            | Node::Interpolation(_) => {}
        }
    }
}

impl Add for TextCost {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            commands: self.commands + other.commands,
            operators: self.operators + other.operators,
            constants: self.constants + other.constants,
            strings: self.strings + other.strings,
            remarks: self.remarks + other.remarks,
            labels: self.labels + other.labels,
        }
    }
}

impl AddAssign for TextCost {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl std::iter::Sum for TextCost {
    fn sum<I: Iterator<Item = Self>>(costs: I) -> Self {
        costs.fold(Self::default(), Add::add)
    }
}
