//! Formatter of `AcroBASIC` programs.
//!
//! [`format()`] lays a text out as the controller's `LIST` does (guide, "IF/ELSE" for the indentation, "Remarks" and
//! "Command Syntax" for the blanks), and puts tables and remarks into columns, which a listing has not.
//! [`renumber()`] gives the lines of numbered programs new numbers, and the jumps to them too.
//!
//! ```
//! let text = "if (bit 24)\nset34:X10 Y/-5:rem out\nendif";
//! let formatted = acrc_fmt::format(text, &acrc_fmt::Options::default());
//! assert_eq!(formatted.text, "IF (BIT24)\n    SET 34 : X10 Y/-5 : REM out\n    ENDIF\n");
//! ```
//!
//! **Invariants.** For any text whatever: nothing panics; formatting twice gives what formatting once gives; the
//! tokens of the text stay the same but for the case of keywords and blanks at the ends of lines; no statement
//! changes its line, because a line is what the scheduler counts and what a `THEN` governs. The compiled image of a
//! program is the same before and after. A line that can't be read is left as it is, byte for byte.

mod align;
mod blank;
mod case;
mod directive;
mod indent;
mod line_end;
mod lines;
mod marks;
mod options;
mod render;
pub mod renumber;
mod rows;
mod spacing;

use acrc_syntax::Tree;
pub use options::{BlockEnds, KeywordCase, MAX_INDENT, Options};
pub use renumber::renumber;

/// A formatted text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Formatted {
    /// The text.
    pub text: String,
    /// The lines of the original, counted from 1, that were left as they are because they can't be read.
    pub unreadable: Vec<u32>,
}

/// Formats a text.
#[must_use]
pub fn format(text: &str, options: &Options) -> Formatted {
    format_tree(text, &acrc_syntax::parse(text), options)
}

/// Formats the text from which `tree` was made.
#[must_use]
pub fn format_tree(text: &str, tree: &Tree, options: &Options) -> Formatted {
    let states = lines::states(text, tree);
    let mut rows = render::rows(text, tree, &states, *options);
    blank::separate(&mut rows);
    if options.align_tables {
        align::tables(&mut rows);
    }
    if options.align_remarks {
        align::remarks(&mut rows);
    }
    let unreadable = (1..).zip(&states).filter(|(_, state)| **state == lines::State::Unreadable);
    Formatted {
        text: rows.join(line_end::dominant(tree, text)),
        unreadable: unreadable.map(|(number, _)| number).collect(),
    }
}
