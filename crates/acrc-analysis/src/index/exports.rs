//! What other files see of a file. Nothing here holds a place in the text.

use acrc_catalog::OperandClass;
use acrc_syntax::ast::{Expr, ExprKind};
use acrc_syntax::units::Level;

/// A name as it is written, or in capital letters where case does not matter.
pub type Name = Box<str>;

/// What other files see of a file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Exports {
    /// The aliases it defines, in the order of the text.
    pub aliases: Vec<(Name, AliasOperand)>,
    /// Attachments and detachments, in the order of the text.
    pub attachments: Vec<Attachment>,
    /// The names in places where an alias may stand, with the levels of those places, sorted, each once.
    pub uses: Vec<(Name, Level)>,
    /// Levels at which it has code, sorted, each once.
    pub levels: Vec<Level>,
    /// Levels for which it stores text that does something, sorted, each once.
    pub stored: Vec<Level>,
    /// It switches the prompt (`PROG0`, `PLC1`, `SYS`).
    pub switches_level: bool,
    /// It holds a `PROGRAM`.
    pub has_program: bool,
}

/// What an alias stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AliasOperand {
    /// The operand without blanks and in capital letters: two definitions agree when this is equal.
    pub text: Name,
    /// Its meaning.
    pub target: AliasTarget,
}

/// The meaning of an alias.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AliasTarget {
    /// A parameter, bit or variable, with its number when that is written as one.
    Operand(OperandClass, Option<u64>),
    /// A number.
    Number,
    /// A text.
    Text,
    /// Something else.
    Other,
}

impl AliasOperand {
    pub(super) fn new(text: &str, operand: &Expr) -> Self {
        let written = text.get(operand.span.range()).unwrap_or_default();
        Self { text: operand_text(written), target: AliasTarget::of(operand) }
    }
}

impl AliasTarget {
    fn of(operand: &Expr) -> Self {
        match &operand.kind {
            ExprKind::Paren(inner) => Self::of(inner),
            ExprKind::Operand(operand) => {
                // An element of an array is none that the number alone stands for.
                let number = if operand.element.is_none() { crate::walk::whole(&operand.index) } else { None };
                Self::Operand(operand.class, number)
            }
            ExprKind::String(_) => Self::Text,
            _ if crate::walk::literal(operand).is_some() => Self::Number,
            _ => Self::Other,
        }
    }
}

/// The order in which attachments happen: those typed at a prompt happen one after another through all files of the
/// project, those of a stored program whenever it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sequence {
    /// Typed at a prompt.
    Immediate,
    /// In the n-th section of the file, which is stored.
    Stored(u32),
}

/// A change of the attachments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attachment {
    /// The level at which it is made.
    pub level: Level,
    /// Where it stands in time.
    pub sequence: Sequence,
    /// It stands in a block or behind `THEN`, so it may not happen.
    pub conditional: bool,
    /// What happens.
    pub kind: AttachmentKind,
}

/// Kinds of changes of the attachments (guide, "Attachments").
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AttachmentKind {
    /// `ATTACH MASTERn`
    Master {
        /// The master.
        master: Option<u32>,
    },
    /// `ATTACH AXISn feedback signal`
    Axis {
        /// The axis.
        axis: Option<u32>,
        /// Its output is steps.
        stepper: bool,
    },
    /// `ATTACH SLAVEn AXISm "name"`
    Slave {
        /// The slot of the master.
        slot: Option<u32>,
        /// The axis.
        axis: Option<u32>,
        /// The name in capital letters. `None` when it is not written as a string.
        name: Option<Name>,
    },
    /// `DETACH`, `DETACH SLAVEn`, `DETACH AXISn` at the prompt of a program.
    Detach {
        /// Only this slot.
        slot: Option<u32>,
        /// Only this axis.
        axis: Option<u32>,
    },
    /// `DETACH ALL`
    DetachAll,
}

/// An operand as it is compared: without blanks and in capital letters.
pub fn operand_text(written: &str) -> Name {
    let text: String = written.chars().filter(|c| !c.is_whitespace()).map(|c| c.to_ascii_uppercase()).collect();
    text.into()
}
