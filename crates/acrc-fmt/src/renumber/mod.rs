//! New numbers for the lines of numbered programs, and for the jumps to them (guide, "Adding Lines of Code to
//! Programs").
//!
//! Lines that are entered with a number are stored in the order of the numbers, whatever the order of the text. So
//! the numbers must rise along the text before they may be changed; then the program is the same afterwards, but for
//! the numbers. Where that can't be promised, nothing is changed and the reasons are given with their places.
//!
//! A `GOTO` or `GOSUB` with a number leads to the line of that number, or, when there is none, to a label of that
//! name. New numbers pass over the names of such labels, so that no jump is caught by a line.

mod assign;
mod collect;

use std::num::NonZeroU32;

use acrc_diagnostics::{Edit, Span};
use acrc_syntax::Tree;
use acrc_syntax::units::Level;
use thiserror::Error;

/// The largest line number that a stored program holds.
pub const MAX_LINE_NUMBER: u32 = acrc_syntax::ast::LineNumber::MAX;

/// A file of a project.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// Its text.
    pub text: &'a str,
    /// The tree of the text.
    pub tree: &'a Tree,
    /// The prompt at which its first line is entered.
    pub start: Level,
    /// The whole text is the stored text of the program at `start`, without `PROGRAM` and `ENDP`.
    pub implicit_program: bool,
}

/// Why the lines can't be given new numbers, and where.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{kind}")]
pub struct RenumberError {
    /// Index of the file among those given to [`renumber`].
    pub file: usize,
    /// Where in its text.
    pub span: Span,
    /// What is wrong.
    pub kind: RenumberErrorKind,
}

/// What keeps lines from being given new numbers.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum RenumberErrorKind {
    /// A statement that can't be read. It may be a jump.
    #[error("this could not be read and may hold a line number")]
    Unreadable,
    /// Numbers that do not rise.
    #[error("line {number} stands behind line {before}: which is stored first depends on their numbers")]
    OutOfOrder {
        /// The number of the line.
        number: u32,
        /// The number of the line above it.
        before: u32,
    },
    /// The same number twice.
    #[error("line {number} is entered twice: the second one replaces the first")]
    Duplicate {
        /// The number.
        number: u32,
    },
    /// A number without a statement.
    #[error("line {number} holds nothing: a number alone removes the line from the program")]
    Empty {
        /// The number.
        number: u32,
    },
    /// A jump to a line that is not there.
    #[error("there is neither a line nor a label {target} in this program")]
    MissingTarget {
        /// The target as written.
        target: String,
    },
    /// A jump from the prompt to the lines of a program.
    #[error("this jump is entered at the prompt: it belongs to no program text")]
    OutsideProgram,
    /// Lines that are entered singly into a text that is also stored as a whole.
    #[error(
        "{level} is stored as a whole elsewhere: where this line takes its place depends on numbers that are not \
         written"
    )]
    StoredTwice {
        /// The program.
        level: Level,
    },
    /// Lines with numbers at the system prompt.
    #[error("there is no program to store this in: a `PROG` or `PLC` command must come first")]
    NoProgram,
    /// The numbers do not suffice.
    #[error("the line would get the number {number}; line numbers go up to {MAX_LINE_NUMBER}")]
    TooLarge {
        /// The number that it would get.
        number: u64,
    },
}

/// Gives the numbered lines of each program the numbers `start`, `start + step`, and so on, and changes the jumps to
/// them. The files are given in the order in which they are sent to the controller. The result holds for each file
/// what to change in it; lines without a number stay without.
///
/// Where lines with and without numbers are mixed, numbers are left out as far as needed to stay above those by which
/// the lines between are listed.
///
/// # Errors
/// Every reason, in the order of files and places. Nothing is to be changed then. Programs without numbers give none.
pub fn renumber(
    files: &[Source<'_>],
    start: NonZeroU32,
    step: NonZeroU32,
) -> Result<Vec<Vec<Edit>>, Vec<RenumberError>> {
    let mut errors = Vec::new();
    let texts = collect::texts(files, &mut errors);
    let mut edits = vec![Vec::new(); files.len()];
    for text in &texts {
        assign::text(files, text, (start, step), &mut edits, &mut errors);
    }
    if errors.is_empty() {
        for edits in &mut edits {
            edits.sort_by_key(|edit: &Edit| edit.span);
        }
        return Ok(edits);
    }
    errors.sort_by_key(|error| (error.file, error.span));
    errors.dedup();
    Err(errors)
}

/// The text of a span.
fn slice<'a>(files: &[Source<'a>], file: usize, span: Span) -> &'a str {
    files.get(file).and_then(|file| file.text.get(span.range())).unwrap_or_default()
}
