//! What the machine does without its host: one table, which the loader and [`executes`] read.

use acrc_catalog::{CommandId, OperandClass, command};

use crate::code::Code;
use crate::frame::Frame;

/// How the machine executes a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Own {
    /// By the place it has in a block (`IF`, `WEND`, `BREAK`).
    Block,
    /// It does nothing when it is reached.
    Passive,
    /// It does nothing in a stored text. At a prompt it goes to the host.
    Marker,
    /// It ends a stored text. At a prompt it goes to the host.
    End,
    /// `target = value`
    Assign,
    /// A jump to a label or line.
    Branch,
    /// The end of a subroutine.
    Return,
    /// It sets or clears flags.
    Flag(bool),
    /// It allocates local variables.
    Dim(OperandClass),
    /// It allocates the move buffer, or frees it.
    Moves,
    /// It frees the local variables, after the host has done its part.
    Clear,
}

/// Commands that the machine executes by itself; every other one goes to the host.
const OWN: &[(CommandId, Own)] = &[
    (command::ASSIGNMENT, Own::Assign),
    (command::BIT, Own::Assign),
    (command::SET, Own::Flag(true)),
    (command::CLR, Own::Flag(false)),
    (command::IF, Own::Block),
    (command::ELSE, Own::Block),
    (command::ELSEIF, Own::Block),
    (command::ELSE_IF, Own::Block),
    (command::ENDIF, Own::Block),
    (command::WHILE, Own::Block),
    (command::WEND, Own::Block),
    (command::FOR, Own::Block),
    (command::NEXT, Own::Block),
    (command::BREAK, Own::Block),
    (command::GOTO, Own::Branch),
    (command::GOSUB, Own::Branch),
    (command::RETURN, Own::Return),
    (command::END, Own::End),
    (command::ENDP, Own::End),
    (command::PROGRAM, Own::Marker),
    (command::PBOOT, Own::Marker),
    (command::REM, Own::Passive),
    // The alias table of the image has what it says.
    (command::DEFINE, Own::Passive),
    (command::APOSTROPHE, Own::Passive),
    (command::LABEL, Own::Passive),
    (command::LINE_NUMBER, Own::Passive),
    (command::DIM_LV, Own::Dim(OperandClass::Lv)),
    (command::DIM_SV, Own::Dim(OperandClass::Sv)),
    (command::DIM_DV, Own::Dim(OperandClass::Dv)),
    (command::DIM_STRING_V, Own::Dim(OperandClass::StringV)),
    (command::DIM_LA, Own::Dim(OperandClass::La)),
    (command::DIM_SA, Own::Dim(OperandClass::Sa)),
    (command::DIM_DA, Own::Dim(OperandClass::Da)),
    (command::DIM_STRING_A, Own::Dim(OperandClass::StringA)),
    (command::DIM_MBUF, Own::Moves),
    (command::CLEAR_MBUF, Own::Moves),
    (command::CLEAR, Own::Clear),
];

/// How the machine executes a command; `None` when the host does.
pub(crate) fn own(command: CommandId) -> Option<Own> {
    OWN.iter().find(|(own, _)| *own == command).map(|(_, how)| *how)
}

/// Whether the machine executes a command of a stored text without asking its host. Some go to the host as well: a bare
/// `CLEAR`, a report of `DIM`, and `SET` and `CLR` in forms that are not plain.
pub fn executes(command: CommandId) -> bool {
    own(command).is_some()
}

impl Frame {
    /// Goes on behind the present statement, as a prompt does after a statement that was refused. With a condition or a loop goes all that
    /// depends on it.
    pub fn skip_statement(&mut self, code: &Code) {
        self.pc = code.next_statement(self.pc);
        self.held = false;
    }
}
