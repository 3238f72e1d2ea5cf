//! The arguments of commands: which operands are read and which are named.
//!
//! `VEL P0` reads P0; `PLS0 SRC P12288`, `IHPOS P12290 (100, 5)` and `INPUT LV0` name their operand. Where a command
//! takes a source, an operand in parentheses is read after all.

use acrc_catalog::{OperandClass, Shape, UnaryOperator};
use acrc_image::{Instruction, Item, Mark, Node};

use super::Loader;
use super::error::LoadErrorKind;
use super::place::Place;
use crate::op::Op;
use crate::plan::{Arguments, Index, Named, Operand, Part, PartValue, Plan};

/// Whether operands of a command are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Naming {
    /// They are read.
    Read,
    /// They are named unless they stand in parentheses.
    Sources,
    /// They are named.
    Always,
}

impl Naming {
    const fn of(shape: Shape) -> Self {
        match shape {
            Shape::Source | Shape::AxisSources | Shape::ParameterTuple => Self::Sources,
            Shape::Input => Self::Always,
            _ => Self::Read,
        }
    }

    fn names(self, node: &Node) -> bool {
        match self {
            Self::Read => false,
            Self::Sources => node.parens() == 0,
            Self::Always => true,
        }
    }
}

impl Loader<'_> {
    /// A command that the host executes.
    pub(super) fn command(&mut self, instruction: &Instruction) -> Result<(), LoadErrorKind> {
        let shape = instruction.command.info().shape;
        let (prefix, items) = match instruction.items.split_first() {
            Some((Item { node: Node::Object { kind, index, prefix: true, value: None, .. }, .. }, rest)) => {
                (Some((*kind, *index)), rest)
            }
            _ => (None, instruction.items.as_slice()),
        };
        let mut parts = Vec::with_capacity(items.len());
        for (place, item) in items.iter().enumerate() {
            let is_flag = shape == Shape::Bit || (shape == Shape::BitMove && place == 0);
            let part = if is_flag { self.flag_part(item)? } else { self.part(item, Naming::of(shape))? };
            parts.push(part);
        }
        let index = self.plans.len() as u32;
        self.plans.push(Plan { command: instruction.command, prefix, arguments: Arguments::new(parts) });
        self.emit(Op::Call { index });
        Ok(())
    }

    fn part(&mut self, item: &Item, naming: Naming) -> Result<Part, LoadErrorKind> {
        Ok(match &item.node {
            Node::Axis { name, slash, value } => {
                Part::Axis { name: *name, slash: *slash, value: self.part_value(value.as_deref(), naming)? }
            }
            Node::Object { kind, index, slash, value, .. } => {
                let value = self.part_value(value.as_deref(), naming)?;
                Part::Object { kind: *kind, index: *index, slash: *slash, value }
            }
            Node::Tuple(nodes) => Part::Tuple(self.operands_of(nodes)?),
            Node::Word { keyword, index } => Part::Word { keyword: *keyword, index: *index },
            Node::Interpolation(command) => Part::Interpolation(*command),
            Node::Device(number) => {
                let number = self.expression(number)?;
                Part::Device(self.index(&number)?)
            }
            node => match self.reference(node, naming)? {
                Some((named, negative)) => Part::Reference { named, negative, mark: item.mark },
                None => self.value_item(node, item.mark)?,
            },
        })
    }

    fn value_item(&mut self, node: &Node, mark: Mark) -> Result<Part, LoadErrorKind> {
        let place = self.expression(node)?;
        Ok(Self::value_part(place, mark))
    }

    /// The operand that a node names, and whether a minus stands in front of it.
    fn reference(&mut self, node: &Node, naming: Naming) -> Result<Option<(Named, bool)>, LoadErrorKind> {
        if let Node::Unary { op: UnaryOperator::Minus, operand, .. } = node
            && naming.names(node)
            && self.is_operand(operand)?
        {
            return Ok(self.named(operand)?.map(|named| (named, true)));
        }
        if self.is_whole_array(node)? || (naming.names(node) && self.is_operand(node)?) {
            return Ok(self.named(node)?.map(|named| (named, false)));
        }
        Ok(None)
    }

    fn is_operand(&self, node: &Node) -> Result<bool, LoadErrorKind> {
        Ok(matches!(self.resolve(node)?, Node::Scalar { .. } | Node::Array { .. }))
    }

    fn is_whole_array(&self, node: &Node) -> Result<bool, LoadErrorKind> {
        Ok(matches!(self.resolve(node)?, Node::Scalar { class, .. } if class.is_array()))
    }

    fn part_value(&mut self, value: Option<&Node>, naming: Naming) -> Result<PartValue, LoadErrorKind> {
        let Some(node) = value else { return Ok(PartValue::None) };
        Ok(match node {
            Node::Object { kind, index, .. } => PartValue::Object(*kind, *index),
            Node::Word { keyword, index } => PartValue::Word(*keyword, *index),
            Node::Tuple(nodes) => self.tuple_value(nodes)?,
            node => match self.reference(node, naming)? {
                Some((named, _)) => PartValue::Reference(named),
                None => PartValue::Value(Self::operand(self.expression(node)?)),
            },
        })
    }

    /// A tuple, with the array that may stand in it.
    fn tuple_value(&mut self, nodes: &[Node]) -> Result<PartValue, LoadErrorKind> {
        let mut values = Vec::with_capacity(nodes.len());
        let mut table = None;
        for node in nodes {
            if self.is_whole_array(node)? {
                table = self.named(node)?;
            } else {
                values.push(Self::operand(self.expression(node)?));
            }
        }
        let values = values.into_boxed_slice();
        Ok(match table {
            Some(table) => PartValue::Table { values, table },
            None => PartValue::Tuple(values),
        })
    }

    fn operands_of(&mut self, nodes: &[Node]) -> Result<Box<[Operand]>, LoadErrorKind> {
        nodes.iter().map(|node| self.expression(node).map(Self::operand)).collect()
    }

    /// An argument that is a flag: `34`, `-516`, `BIT 34`, `-Alias`, `(LV0)`.
    fn flag_part(&mut self, item: &Item) -> Result<Part, LoadErrorKind> {
        match &item.node {
            Node::Axis { .. }
            | Node::Object { .. }
            | Node::Tuple(_)
            | Node::Word { .. }
            | Node::Interpolation(_)
            | Node::Device(_) => self.part(item, Naming::Read),
            node => self.flag(node, false),
        }
    }

    fn flag(&mut self, node: &Node, negative: bool) -> Result<Part, LoadErrorKind> {
        match self.resolve(node)? {
            Node::Unary { op: UnaryOperator::Minus, operand, .. } => self.flag(operand, !negative),
            Node::Unary { op: UnaryOperator::Plus, operand, .. } => self.flag(operand, negative),
            Node::Scalar { class: OperandClass::Bit, index, .. } => {
                let place = self.expression(index)?;
                Ok(Part::Bit { index: self.index(&place)?, negative, signed: false })
            }
            node => {
                let place = self.expression(node)?;
                Ok(Part::Bit { index: self.index(&place)?, negative, signed: true })
            }
        }
    }

    /// `SET` and `CLR` of one flag with a constant number.
    pub(super) fn constant_set(&mut self, instruction: &Instruction, state: bool) -> Result<Option<Op>, LoadErrorKind> {
        let [Item { node, .. }] = instruction.items.as_slice() else { return Ok(None) };
        let number = match self.resolve(node)? {
            Node::Long(number @ 0..) => Some(*number),
            Node::Scalar { class: OperandClass::Bit, index, .. } => match self.resolve(index)? {
                Node::Long(number @ 0..) => Some(*number),
                _ => None,
            },
            _ => None,
        };
        Ok(number.map(|number| Op::SetBit { number, state }))
    }

    /// `SET` and `CLR` of one flag whose number is computed.
    pub(super) fn computed_set(&mut self, instruction: &Instruction, state: bool) -> Result<bool, LoadErrorKind> {
        let [item] = instruction.items.as_slice() else { return Ok(false) };
        let Part::Bit { index: Index::Slot(number), negative: false, .. } = self.flag_part(item)? else {
            return Ok(false);
        };
        let from = self.long(&Place::LongConst(i32::from(state)))?;
        self.emit(Op::StoreBitAt { number, from });
        Ok(true)
    }
}
