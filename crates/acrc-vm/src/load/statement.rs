//! Statements: everything that the machine executes by itself; the rest goes to the host.

use acrc_catalog::{CommandId, OperandClass, command};
use acrc_image::{Instruction, Mark, Node, Separator};

use super::blocks::Role;
use super::error::LoadErrorKind;
use super::expression::Hint;
use super::operand::Target;
use super::place::Place;
use super::{Jump, Loader};
use crate::fault::FaultKind;
use crate::locals::DimBlock;
use crate::op::Op;

impl Loader<'_> {
    /// The instructions of one statement.
    pub(super) fn statement(&mut self, place: usize, instruction: &Instruction) -> Result<(), LoadErrorKind> {
        let role = self.roles.get(place).copied().unwrap_or_default();
        // Who gets here from the branch above is done with the whole IF.
        if let Role::ElseIf { end, .. } | Role::Else { end } = role {
            self.emit_jump(Op::Jump { target: 0 }, Jump::To(end));
        }
        self.mark_start(place);
        match instruction.separator {
            Separator::Line => self.emit(Op::Line),
            _ if is_passive(instruction.command) => {}
            _ => self.emit(Op::Statement),
        }
        match role {
            Role::Plain => self.plain(instruction),
            Role::IfThen { next_line } => self.condition(instruction, Jump::Entry(next_line)),
            Role::If { otherwise } | Role::ElseIf { otherwise, .. } => self.condition(instruction, Jump::To(otherwise)),
            Role::Else { .. } => Ok(()),
            Role::While { end } => self.condition(instruction, Jump::Behind(end)),
            Role::Wend { start } => {
                self.emit_jump(Op::Jump { target: 0 }, Jump::To(start));
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
        if let Some(block) = dim_block(instruction) {
            return self.dim(block, instruction);
        }
        match instruction.command {
            command::ENDIF => {}
            id if is_passive(id) => {}
            command::ASSIGNMENT => match instruction.items.as_slice() {
                [target, value] => self.assign(&target.node, &value.node)?,
                _ => return Err(LoadErrorKind::NotAssignable),
            },
            command::GOTO | command::GOSUB => self.branch(instruction)?,
            command::RETURN => self.emit(Op::Return),
            // At a prompt these words end nothing; there the host says what they mean.
            command::END | command::ENDP if !self.boot => self.emit(Op::End),
            command::SET => self.set_flag(instruction, true)?,
            command::CLR => self.set_flag(instruction, false)?,
            command::CLEAR if instruction.items.is_empty() => {
                self.command(instruction)?;
                self.emit(Op::Clear);
            }
            _ => self.command(instruction)?,
        }
        Ok(())
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

    /// `DIM` of local variables and arrays.
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

/// Statements that do nothing when they are reached.
const fn is_passive(id: CommandId) -> bool {
    matches!(id, command::REM | command::APOSTROPHE | command::LABEL | command::LINE_NUMBER)
}

/// What a `DIM` of local variables allocates; `None` for any other statement, and for a `DIM` without a size, which reports.
fn dim_block(instruction: &Instruction) -> Option<DimBlock> {
    let class = match instruction.command {
        command::DIM_LV => OperandClass::Lv,
        command::DIM_SV => OperandClass::Sv,
        command::DIM_DV => OperandClass::Dv,
        command::DIM_STRING_V => OperandClass::StringV,
        command::DIM_LA => OperandClass::La,
        command::DIM_SA => OperandClass::Sa,
        command::DIM_DA => OperandClass::Da,
        command::DIM_STRING_A => OperandClass::StringA,
        _ => return None,
    };
    let first = instruction.items.first()?;
    if !class.is_array() {
        return Some(DimBlock::Variables(class));
    }
    // A semicolon behind the first item says that it is the number of an array.
    Some(if first.mark == Mark::Semicolon { DimBlock::Array(class) } else { DimBlock::References(class) })
}
