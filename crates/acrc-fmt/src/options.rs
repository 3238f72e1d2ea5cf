//! What may be chosen.

/// How a text is laid out. The default is the controller's own `LIST` form, with tables and remarks in columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Options {
    /// The case of the words of the language.
    pub keyword_case: KeywordCase,
    /// Blanks by which a block is indented: 4 as in a listing of the controller; at most [`MAX_INDENT`] are used.
    pub indent: u8,
    /// Where the statement stands that closes or branches a block.
    pub block_ends: BlockEnds,
    /// Remarks behind the statements of neighbouring lines start in one column.
    pub align_remarks: bool,
    /// The operands of neighbouring `#DEFINE` lines start in one column, and the sizes of neighbouring `DIM` lines.
    pub align_tables: bool,
}

/// The most blanks by which a block is indented.
pub const MAX_INDENT: u8 = 16;

impl Default for Options {
    fn default() -> Self {
        Self {
            keyword_case: KeywordCase::Upper,
            indent: 4,
            block_ends: BlockEnds::Body,
            align_remarks: true,
            align_tables: true,
        }
    }
}

/// The case of commands, functions, operators and operands. Names (labels, aliases, axes) keep theirs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum KeywordCase {
    /// `SET 32`, as the controller lists it.
    #[default]
    Upper,
    /// `set 32`
    Lower,
    /// As written.
    Keep,
}

/// Where `ENDIF`, `NEXT`, `WEND`, `ELSE` and `ELSEIF` stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum BlockEnds {
    /// Indented with the body of their block, as the controller lists them (guide, "IF/ELSE").
    #[default]
    Body,
    /// Below the statement that opens the block.
    Opener,
}
