//! Compile errors as diagnostics.

use acrc_diagnostics::{Code, Diagnostic, Span};

use crate::error::{CompileError, CompileErrorKind};

/// The codes of this crate, `ACR020` to `ACR031`.
pub mod codes {
    use acrc_diagnostics::Code;

    macro_rules! codes {
        ($($(#[$doc:meta])* $constant:ident = $id:literal $name:literal;)*) => {
            $($(#[$doc])* pub const $constant: Code = Code { id: $id, name: $name };)*

            /// All of them, in the order of their numbers.
            pub const ALL: &[Code] = &[$($constant),*];
        };
    }

    codes! {
        /// A statement that could not be read keeps the file from being compiled.
        NOT_COMPILED = "ACR020" "not-compiled";
        /// A jump to a label that the program does not define.
        UNDEFINED_LABEL = "ACR021" "undefined-label";
        /// A label that the program defines twice.
        DUPLICATE_LABEL = "ACR022" "duplicate-label";
        /// A name that nothing explains.
        UNDEFINED_ALIAS = "ACR023" "undefined-alias";
        /// A number that does not fit its place.
        NUMBER_TOO_LARGE = "ACR024" "number-too-large";
        /// An expression with too many levels.
        TOO_DEEP = "ACR025" "too-deep";
        /// A character that has no byte on the controller.
        UNSTORABLE_CHARACTER = "ACR026" "unstorable-character";
        /// Something exceeds a field of the stored form.
        LIMIT = "ACR027" "stored-form-limit";
        /// An alias with two meanings.
        CONFLICTING_ALIAS = "ACR028" "conflicting-alias";
        /// Program text without a program.
        NO_PROGRAM = "ACR029" "no-program";
        /// An alias for something that has no alias.
        ALIAS_OPERAND = "ACR030" "alias-operand";
        /// A word that cannot name an axis.
        AXIS_NAME = "ACR031" "axis-name";
    }
}

impl CompileErrorKind {
    /// Its code.
    pub fn code(&self) -> Code {
        match self {
            Self::Syntax => codes::NOT_COMPILED,
            Self::UndefinedLabel(_) => codes::UNDEFINED_LABEL,
            Self::DuplicateLabel { .. } => codes::DUPLICATE_LABEL,
            Self::UndefinedAlias(_) => codes::UNDEFINED_ALIAS,
            Self::NumberTooLarge { .. } => codes::NUMBER_TOO_LARGE,
            Self::TooDeep => codes::TOO_DEEP,
            Self::UnstorableCharacter(_) => codes::UNSTORABLE_CHARACTER,
            Self::Limit { .. } | Self::Unstorable(_) => codes::LIMIT,
            Self::ConflictingAlias { .. } => codes::CONFLICTING_ALIAS,
            Self::NoProgram => codes::NO_PROGRAM,
            Self::AliasOperand => codes::ALIAS_OPERAND,
            Self::AxisName(_) => codes::AXIS_NAME,
        }
    }

    /// What is wrong at its place, in few words.
    fn label(&self) -> &'static str {
        match self {
            Self::Syntax => "not read",
            Self::UndefinedLabel(_) => "no such label",
            Self::DuplicateLabel { .. } | Self::ConflictingAlias { .. } => "defined again",
            Self::UndefinedAlias(_) => "neither an alias nor a keyword",
            Self::NumberTooLarge { .. } | Self::Limit { .. } => "too large",
            Self::TooDeep => "too deep from here on",
            Self::UnstorableCharacter(_) => "has no byte",
            Self::AliasOperand => "no operand",
            Self::AxisName(_) => "not an axis",
            Self::NoProgram => "entered at the system prompt",
            Self::Unstorable(_) => "cannot be stored",
        }
    }

    /// What to do about it.
    fn help(&self) -> Option<&'static str> {
        Some(match self {
            Self::UndefinedLabel(_) => {
                "labels are case-sensitive and belong to one program; define it as `_name` on a line of its own"
            }
            Self::DuplicateLabel { .. } => "give one of the two another name: a jump can only go to one place",
            Self::UndefinedAlias(_) => "aliases are case-sensitive; define it with `#DEFINE name operand`",
            Self::TooDeep => "store a part of the expression in a variable first",
            Self::UnstorableCharacter(_) => "write it with plain characters, or join it with CHR$(code)",
            Self::ConflictingAlias { .. } => "an alias is known to all programs: use another name for one of the two",
            Self::NoProgram => {
                "write `PROG0` before it, or name the file after its program: `Prog0.8K` to `Prog15.8K`, `PLC0.8K` to `PLC7.8K`"
            }
            Self::AliasOperand => "define it for the operand alone and write the rest where it is used",
            _ => return None,
        })
    }

    /// An earlier place that belongs to it.
    fn related(&self) -> Option<(Span, &'static str)> {
        match self {
            Self::DuplicateLabel { first: Some(first), .. } => Some((*first, "first defined here")),
            Self::ConflictingAlias { first: Some(first), .. } => Some((*first, "defined here before")),
            _ => None,
        }
    }
}

impl From<&CompileError> for Diagnostic {
    fn from(error: &CompileError) -> Self {
        let mut diagnostic =
            Diagnostic::error(error.kind.code(), error.span, error.kind.to_string()).with_label(error.kind.label());
        if let Some(help) = error.kind.help() {
            diagnostic = diagnostic.with_help(help);
        }
        if let Some((span, message)) = error.kind.related() {
            diagnostic = diagnostic.with_related(span, message);
        }
        diagnostic
    }
}
