//! What commands ask of the controller around the machine: of the scheduler, and of the programs' texts and variables.

use acrc_catalog::CommandId;
use acrc_syntax::units::Level;

use crate::nonvolatile::Operation;
use crate::task::Task;
use crate::terminal::ChannelId;

/// What a program asks of the scheduler; carried out when its statement is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Request {
    Run(Task),
    Halt(Task),
    Pause(u8),
    Resume(u8),
    /// Erase the text of a program.
    New(Task),
    /// Start everything that begins with `PBOOT`.
    Boot,
    /// Turn block mode of a program on or off.
    Block(u8, bool),
    /// Execute the next line of a program in block mode.
    Step(u8),
    /// Turn the trace of a program's lines on or off.
    Trace(u8, bool),
    /// Give the memory of all variables back (`CLEAR` at the system prompt).
    ClearAllLocals,
    /// Install stored text: index into the image's programs.
    Install(usize),
    /// Save, load or forget what outlasts a reset, or restart.
    Memories(Operation),
    /// Forget what aliases mean (`CLEAR` typed at the system prompt).
    ForgetAliases,
    /// Answer a question that concerns the programs.
    Report(Query, Origin),
}

/// A question that the programs' texts and variables answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Query {
    /// `LIST`: the lines between two numbers of the program at the prompt.
    List { first: u32, last: u32 },
    /// `DIM` without a size: everything at the level, or only what one of its daughters allocates.
    Dimensions(CommandId),
    /// `MEM`
    FreeMemory,
    /// `DEF`
    Aliases,
}

/// Who gave a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Origin {
    /// The prompt level of an immediate command; for a program its own.
    pub(crate) level: Level,
    /// The channel at which it was typed.
    pub(crate) channel: Option<ChannelId>,
    /// It was typed, or is setup code.
    pub(crate) immediate: bool,
}
