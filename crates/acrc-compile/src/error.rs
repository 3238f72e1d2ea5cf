//! Why a text cannot be compiled.

use acrc_diagnostics::Span;
use acrc_image::EncodeError;
use thiserror::Error;

/// What may stand in front of a line.
pub const LINE_NUMBERS: &str = "line numbers go up to 2147483647";

/// One reason, and where.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{kind}")]
pub struct CompileError {
    /// Index of the file among those given to [`crate::compile`].
    pub file: usize,
    /// Where in its text.
    pub span: Span,
    /// What is wrong.
    pub kind: CompileErrorKind,
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum CompileErrorKind {
    /// The statement could not be read; the parser's own diagnostic says why.
    #[error("this could not be read, so the file cannot be compiled")]
    Syntax,
    /// `GOTO` or `GOSUB` to a label that the program does not define.
    #[error("the label `{0}` is not defined in this program")]
    UndefinedLabel(String),
    /// A label that the program defines twice.
    #[error("the label `{name}` is already defined in this program")]
    DuplicateLabel {
        /// Its name.
        name: String,
        /// The definition before, when it is in the same file.
        first: Option<Span>,
    },
    /// A name that no `#DEFINE` explains.
    #[error("the name `{0}` is not defined")]
    UndefinedAlias(String),
    /// An alias with two meanings.
    #[error("the alias `{name}` already stands for something else")]
    ConflictingAlias {
        /// Its name.
        name: String,
        /// The definition before, when it is in the same file.
        first: Option<Span>,
    },
    /// An alias for something that has no alias.
    #[error(
        "an alias stands for a constant, a parameter, a flag or a variable, and not for an expression or another alias"
    )]
    AliasOperand,
    /// A number that a constant cannot hold.
    #[error("the number {text} is too large: {limit}")]
    NumberTooLarge {
        /// As written.
        text: String,
        /// What the place allows.
        limit: &'static str,
    },
    /// Expressions within expressions beyond what the stored form allows.
    #[error(
        "the expression is nested too deeply: at most {} operands may lie within each other",
        acrc_image::MAX_DEPTH
    )]
    TooDeep,
    /// A character that a text cannot store.
    #[error("the character {0:?} cannot be stored: texts on the controller have one byte a character")]
    UnstorableCharacter(char),
    /// Something is longer or larger than the words have room for.
    #[error("{what} is {value}, the stored form holds at most {limit}")]
    Limit {
        /// What.
        what: &'static str,
        /// How large it is.
        value: u64,
        /// How large it may be.
        limit: u64,
    },
    /// A word where an axis must be named.
    #[error("`{0}` is no axis name: an axis name has one to four letters")]
    AxisName(String),
    /// Program text at the system prompt.
    #[error("there is no program to store this in: a `PROG` or `PLC` command must come first")]
    NoProgram,
    /// Operands that the stored form does not know.
    #[error("this cannot be stored: {0}")]
    Unstorable(EncodeError),
}
