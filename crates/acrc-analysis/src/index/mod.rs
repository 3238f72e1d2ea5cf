//! What the text of one file decides by itself: sections, labels, jumps, blocks, aliases, attachments.
//!
//! Two views of it exist. [`FileIndex`] holds places and changes with every edit. [`Exports`] holds only what other
//! files can see, without places, so that an edit that moves text about leaves it equal and costs the others nothing.

mod build;
mod effects;
mod exports;
mod section;

use acrc_catalog::{OperandClass, command};
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
use acrc_syntax::ast::StatementKind;

pub use effects::{Effects, Use, UserWrite, WriteKind};
pub use exports::{AliasOperand, AliasTarget, Attachment, AttachmentKind, Exports, Name, Sequence, operand_text};
pub use section::{Jump, LabelSite, LineSite, SectionIndex, Swallowed};

use crate::FileRole;

/// Everything about one file that its own text decides, with places.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FileIndex {
    /// The file is a program without `PROGRAM`: its whole text is stored.
    pub implicit_program: bool,
    /// The sections in the order of the text.
    pub sections: Vec<SectionIndex>,
    /// Definitions of aliases, in the order of [`Exports::aliases`].
    pub defines: Vec<DefineSite>,
    /// Places of the attachments, in the order of [`Exports::attachments`].
    pub attachments: Vec<AttachmentSite>,
    /// The operands that are written by their numbers, sorted, each once.
    pub numbers: Vec<(OperandClass, u64)>,
}

/// Where an alias is defined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DefineSite {
    /// The name.
    pub name: Span,
    /// What it stands for.
    pub operand: Span,
}

/// Where a slave is attached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AttachmentSite {
    /// The statement.
    pub statement: Span,
    /// The axis name with its quotes, when one is written.
    pub name: Option<Span>,
}

/// The index of one text, what others see of it, and what it does to the machine.
pub(crate) fn build(text: &str, tree: &Tree, role: FileRole) -> (FileIndex, Exports, Effects) {
    build::build(text, tree, role)
}

/// Whether a file of this role is a stored program as a whole: the vendor's editor supplies `PROGRAM` and `ENDP`
/// when it downloads a program file that has none.
pub(crate) fn is_implicit_program(role: FileRole, tree: &Tree) -> bool {
    let opens = |kind: &StatementKind| matches!(kind, StatementKind::Command(c) if c.id == command::PROGRAM);
    matches!(role, FileRole::Program(_) | FileRole::Plc(_))
        && !tree.statements().iter().any(|statement| opens(&statement.kind))
}
