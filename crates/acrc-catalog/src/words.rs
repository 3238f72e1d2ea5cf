//! What a word of program text can be. The reader of program text asks for every word, so a look-up is one hash and one comparison.

use crate::generated::{DAUGHTER_HASH, DAUGHTERS, LONGEST_WORD, WORD_HASH, WORDS};
use crate::{CommandId, FunctionId, Keyword, ObjectKind, OperandClass, Operator, UnaryOperator};

/// Everything that a word can be; which of it applies depends on its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// The command that it starts, when no daughter follows.
    pub command: Option<CommandId>,
    /// The object that it names.
    pub object: Option<ObjectKind>,
    /// The function that it calls.
    pub function: Option<FunctionId>,
    /// The operator with two operands.
    pub operator: Option<Operator>,
    /// The operator with one operand.
    pub unary: Option<UnaryOperator>,
    /// The class of variable, parameter or flag.
    pub operand: Option<OperandClass>,
    /// The part of a statement.
    pub keyword: Option<Keyword>,
    /// Some command has it as a daughter.
    pub daughter: bool,
}

impl Word {
    pub(crate) const NOTHING: Self = Self {
        command: None,
        object: None,
        function: None,
        operator: None,
        unary: None,
        operand: None,
        keyword: None,
        daughter: false,
    };

    /// Whether a statement or an operand can begin with it, so that an axis of this name would never be reached.
    pub fn names_something(&self) -> bool {
        self.command.is_some()
            || self.object.is_some()
            || self.function.is_some()
            || self.operand.is_some()
            || self.operator.is_some()
    }

    /// Whether it is read as itself wherever it stands. What is only a daughter, such as HOME, is one behind its parent
    /// only.
    pub fn stands_alone(&self) -> bool {
        self.command.is_some()
            || self.object.is_some()
            || self.function.is_some()
            || self.operator.is_some()
            || self.unary.is_some()
            || self.operand.is_some()
            || self.keyword.is_some()
    }
}

/// What a word can be, in any case; `None` for a word that the language does not know.
///
/// `$` and `#` belong to a word (`CHR$`, `$V`, `#DEFINE`), digits do not, except in the daughters `COM1` and `COM2`.
pub fn word(text: &str) -> Option<Word> {
    if text.len() > LONGEST_WORD {
        return None;
    }
    let (spelling, word) = WORDS.get(WORD_HASH.find(0, text.as_bytes())?)?;
    spelling.eq_ignore_ascii_case(text).then_some(*word)
}

/// The daughter of a command with this word, in any case: `HOME` of `JOG`, `TRG` of `CAM ON`, `NOT` of `LD`.
pub fn daughter(parent: CommandId, word: &str) -> Option<CommandId> {
    let (owner, spelling, daughter) = DAUGHTERS.get(DAUGHTER_HASH.find(parent.0, word.as_bytes())?)?;
    (*owner == parent && spelling.eq_ignore_ascii_case(word)).then_some(*daughter)
}
