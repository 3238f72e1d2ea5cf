//! Statements: everything that the machine executes by itself; the rest goes to the host.

use acrc_catalog::{OperandClass, command};
use acrc_image::{Instruction, Mark, Node, Separator};

use super::blocks::Role;
use super::error::LoadErrorKind;
use super::expression::Hint;
use super::operand::Target;
use super::place::Place;
use super::{Jump, Loader};
use crate::account::Begins;
use crate::fault::FaultKind;
use crate::locals::DimBlock;
use crate::op::Op;
use crate::own::{Own, own};

impl Loader<'_> {
    /// The instructions of one statement.
    pub(super) fn statement(&mut self, place: usize, instruction: &Instruction) -> Result<(), LoadErrorKind> {
        let role = self.roles.get(place).copied().unwrap_or_default();
        // Who gets here from the branch above is done with the whole IF.
        if let Role::ElseIf { end, .. } | Role::Else { end } = role {
            self.emit_jump(Op::Jump { target: 0 }, Jump::To(end));
        }
        self.mark_start(place);
        self.begins = match instruction.separator {
            Separator::Line => Begins::Line,
            _ if own(instruction.command) == Some(Own::Passive) => Begins::Nothing,
            _ => Begins::Statement,
        };
        self.execution(role, instruction)?;
        if self.begins != Begins::Nothing {
            self.emit(Op::Nothing);
        }
        Ok(())
    }

    /// What a statement does once it is reached.
    fn execution(&mut self, role: Role, instruction: &Instruction) -> Result<(), LoadErrorKind> {
        match role {
            Role::Plain => self.plain(instruction),
            Role::IfThen { next_line } => self.condition(instruction, Jump::Entry(next_line)),
            Role::If { otherwise } | Role::ElseIf { otherwise, .. } => self.condition(instruction, Jump::To(otherwise)),
            Role::Else { .. } => Ok(()),
            Role::While { end } => self.condition(instruction, Jump::Behind(end)),
            Role::Wend { start } => {
                self.emit_jump(Op::Again { target: 0 }, Jump::To(start));
                Ok(())
            }
            Role::For { index, end } => self.begin_for(instruction, index, end),
            Role::Next { start, index } => self.next_for(start, index),
            Role::Break { end: Some(end) } => {
                self.emit_jump(Op::Jump { target: 0 }, Jump::Behind(end));
                Ok(())
            }
            Role::Break { end: None } => {
                self.raise(FaultKind::BreakOutsideLoop);
                Ok(())
            }
        }
    }

    /// A statement that is no part of a block.
    fn plain(&mut self, instruction: &Instruction) -> Result<(), LoadErrorKind> {
        let Some(own) = own(instruction.command) else { return self.command(instruction) };
        match own {
            Own::End | Own::Marker if self.boot => self.command(instruction),
            Own::Block | Own::Marker | Own::Passive => Ok(()),
            Own::End => {
                self.emit(Op::End);
                Ok(())
            }
            Own::Return => {
                self.emit(Op::Return);
                Ok(())
            }
            Own::Assign => match instruction.items.as_slice() {
                [target, value] => self.assign(&target.node, &value.node),
                _ => Err(LoadErrorKind::NotAssignable),
            },
            Own::Branch => self.branch(instruction),
            Own::Flag(state) => self.set_flag(instruction, state),
            // Without a size it reports.
            Own::Moves if instruction.command == command::CLEAR_MBUF => {
                self.emit(Op::ClearMoves);
                Ok(())
            }
            Own::Dim(_) | Own::Moves if instruction.items.is_empty() => self.command(instruction),
            Own::Moves => self.dim(DimBlock::Moves, instruction),
            Own::Dim(class) => self.dim(dim_block(class, instruction), instruction),
            Own::Clear => {
                self.command(instruction)?;
                if instruction.items.is_empty() {
                    self.emit(Op::Clear);
                }
                Ok(())
            }
        }
    }

    /// `target = value`
    pub(super) fn assign(&mut self, target: &Node, value: &Node) -> Result<(), LoadErrorKind> {
        let target = self.target(target)?.ok_or(LoadErrorKind::NotAssignable)?;
        let hint = match target {
            Target::Long(slot) => Hint::Long(slot),
            Target::Double(slot) => Hint::Double(slot),
            _ => Hint::None,
        };
        let place = self.expression_into(value, hint)?;
        self.store(target, &place)
    }

    /// `SET` and `CLR`
    fn set_flag(&mut self, instruction: &Instruction, state: bool) -> Result<(), LoadErrorKind> {
        if let Some(op) = self.constant_set(instruction, state)? {
            self.emit(op);
            return Ok(());
        }
        if self.computed_set(instruction, state)? {
            return Ok(());
        }
        self.command(instruction)
    }

    /// `DIM` of local variables, arrays and moves.
    fn dim(&mut self, block: DimBlock, instruction: &Instruction) -> Result<(), LoadErrorKind> {
        let mut slots = Vec::with_capacity(instruction.items.len());
        for item in &instruction.items {
            let place = self.expression(&item.node)?;
            slots.push(self.long(&place)?);
        }
        let zero = self.long(&Place::LongConst(0))?;
        let mut slots = slots.into_iter();
        let array = if matches!(block, DimBlock::Array(_)) { slots.next().unwrap_or(zero) } else { zero };
        let count = slots.next().unwrap_or(zero);
        let length = slots.next().unwrap_or(zero);
        self.emit(Op::Dim { block, array, count, length });
        Ok(())
    }
}

/// What a `DIM` of local variables allocates.
fn dim_block(class: OperandClass, instruction: &Instruction) -> DimBlock {
    // A semicolon behind the first item says that it is the number of an array.
    let numbered = instruction.items.first().is_some_and(|item| item.mark == Mark::Semicolon);
    match (class.is_array(), numbered) {
        (false, _) => DimBlock::Variables(class),
        (true, false) => DimBlock::References(class),
        (true, true) => DimBlock::Array(class),
    }
}
