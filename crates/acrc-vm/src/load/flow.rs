//! Jumps, branches and loops (guide, "Program Flow").

use acrc_catalog::{CommandId, OperandClass, ValueType, command};
use acrc_image::{Instruction, Item, Node};

use super::error::LoadErrorKind;
use super::operand::Target;
use super::place::Place;
use super::{Jump, Loader};
use crate::fault::FaultKind;
use crate::op::Op;

impl Loader<'_> {
    /// `GOTO` and `GOSUB`
    pub(super) fn branch(&mut self, instruction: &Instruction) -> Result<(), LoadErrorKind> {
        let place = match instruction.items.first().map(|item| &item.node) {
            Some(Node::LabelRef(ordinal)) => self.labels.get(usize::from(*ordinal)).copied(),
            Some(Node::Long(line)) => self.line(*line),
            _ => return Err(LoadErrorKind::NoTarget(instruction.command)),
        };
        match (place, instruction.items.first().map(|item| &item.node)) {
            (Some(place), _) => self.emit_jump(branch_op(instruction.command), Jump::To(place)),
            (None, Some(Node::Long(line))) => self.raise(FaultKind::NoSuchLine { line: *line }),
            (None, _) => return Err(LoadErrorKind::NoTarget(instruction.command)),
        }
        Ok(())
    }

    /// The statement that a bare number goes to: the line of that number, or else the label of that name.
    fn line(&self, line: i32) -> Option<usize> {
        let numbered = |instruction: &Instruction| {
            instruction.command == command::LINE_NUMBER
                && matches!(instruction.items.first(), Some(Item { node: Node::Long(number), .. }) if *number == line)
        };
        let name = line.to_string();
        let named = |place: &&usize| {
            let label = self.instructions.get(**place).and_then(|instruction| instruction.items.first());
            matches!(label, Some(Item { node: Node::String { bytes, .. }, .. }) if *bytes == name.as_bytes())
        };
        self.instructions.iter().position(numbered).or_else(|| self.labels.iter().find(named).copied())
    }

    /// `IF`, `ELSEIF`, `WHILE`: goes to `otherwise` when the condition is false.
    pub(super) fn condition(&mut self, instruction: &Instruction, otherwise: Jump) -> Result<(), LoadErrorKind> {
        match instruction.items.first() {
            Some(item) => self.jump_unless(&item.node, otherwise),
            None => Err(LoadErrorKind::NotAValue),
        }
    }

    /// `FOR`: sets the counter, keeps end and step, and tests before the first pass.
    pub(super) fn begin_for(&mut self, instruction: &Instruction, index: u16, end: usize) -> Result<(), LoadErrorKind> {
        let mut nodes = instruction.items.iter().map(|item| &item.node);
        let (Some(counter), Some(start), Some(last)) = (nodes.next(), nodes.next(), nodes.next()) else {
            return Err(LoadErrorKind::NotAValue);
        };
        self.assign(counter, start)?;
        let last = self.expression(last)?;
        let last = self.double(&last)?;
        let step = match nodes.next() {
            Some(node) => self.expression(node)?,
            None => Place::LongConst(1),
        };
        let step = self.double(&step)?;
        let target = self.target(counter)?.ok_or(LoadErrorKind::NotAssignable)?;
        let whole = self.counter_class(counter)?.and_then(OperandClass::value_type) == Some(ValueType::Long);
        self.emit(Op::LoopBegin { index, end: last, step, whole });
        let behind = Jump::Behind(end);
        if let Target::Long(counter) = target {
            self.emit_jump(Op::LoopTestLong { index, counter, target: 0 }, behind);
        } else {
            let counter = self.load(target)?;
            let counter = self.double(&counter)?;
            self.emit_jump(Op::LoopTest { index, counter, target: 0 }, behind);
        }
        Ok(())
    }

    /// `NEXT`: adds the step, and goes back behind the `FOR` unless the counter is then beyond the end.
    pub(super) fn next_for(&mut self, start: usize, index: u16) -> Result<(), LoadErrorKind> {
        let counter = self.instructions.get(start).and_then(|instruction| instruction.items.first());
        let target = counter.map(|item| self.target(&item.node)).transpose()?.flatten();
        let body = Jump::Behind(start);
        match target.ok_or(LoadErrorKind::NotAssignable)? {
            Target::Long(counter) => self.emit_jump(Op::LoopNextLong { index, counter, target: 0 }, body),
            Target::Double(counter) => self.emit_jump(Op::LoopNext { index, counter, target: 0 }, body),
            target => {
                let place = self.load(target)?;
                let (from, to) = (self.double(&place)?, self.double_slot()?);
                self.emit(Op::LoopStep { index, to, from });
                self.store(target, &Place::Double(to))?;
                // The test ends behind this statement either way: out of the loop, or to the jump back.
                let here = self.steps.len() as u32;
                self.emit(Op::LoopTest { index, counter: to, target: here + 2 });
                self.emit_jump(Op::Jump { target: 0 }, body);
            }
        }
        Ok(())
    }

    fn counter_class(&self, counter: &Node) -> Result<Option<OperandClass>, LoadErrorKind> {
        Ok(match self.resolve(counter)? {
            Node::Scalar { class, .. } | Node::Array { class, .. } => Some(*class),
            _ => None,
        })
    }
}

const fn branch_op(command: CommandId) -> Op {
    match command {
        command::GOSUB => Op::Gosub { target: 0 },
        _ => Op::Jump { target: 0 },
    }
}
