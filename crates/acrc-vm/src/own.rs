//! What the machine does without its host.

use acrc_catalog::{CommandId, command};

use crate::code::Code;
use crate::frame::Frame;

/// Commands that the machine executes by itself; every other one goes to the host.
const OWN: [CommandId; 33] = [
    command::ASSIGNMENT,
    command::BIT,
    command::BREAK,
    command::CLEAR,
    command::CLR,
    command::DIM_DA,
    command::DIM_DV,
    command::DIM_LA,
    command::DIM_LV,
    command::DIM_SA,
    command::DIM_STRING_A,
    command::DIM_STRING_V,
    command::DIM_SV,
    command::ELSE,
    command::ELSEIF,
    command::ELSE_IF,
    command::END,
    command::ENDIF,
    command::ENDP,
    command::FOR,
    command::GOSUB,
    command::GOTO,
    command::IF,
    command::LABEL,
    command::LINE_NUMBER,
    command::NEXT,
    command::PBOOT,
    command::PROGRAM,
    command::REM,
    command::RETURN,
    command::SET,
    command::WEND,
    command::WHILE,
];

/// Whether the machine executes a command without asking its host. Some go to the host as well, such as a bare `CLEAR`.
pub fn executes(command: CommandId) -> bool {
    OWN.contains(&command)
}

impl Frame {
    /// Goes on behind the present statement, as a prompt does after a statement that was refused.
    pub fn skip_statement(&mut self, code: &Code) {
        self.pc = code.next_statement(self.pc);
        self.held = false;
    }
}
