//! The codes of what this crate reports. Codes are stable and never used again for something else.

use acrc_diagnostics::Code;

/// A statement or expression that can't be read.
pub const SYNTAX_ERROR: Code = Code { id: "ACR001", name: "syntax-error" };
/// A curly quote, a long dash or a no-break space where the controller knows only ASCII.
pub const TYPOGRAPHIC_CHARACTER: Code = Code { id: "ACR002", name: "typographic-character" };
/// A remark behind a statement without the colon between them.
pub const REMARK_WITHOUT_COLON: Code = Code { id: "ACR003", name: "remark-without-colon" };
/// The file is not plain ASCII or UTF-8 text.
pub const ENCODING: Code = Code { id: "ACR004", name: "text-encoding" };
/// A string without its closing quote.
pub const UNTERMINATED_STRING: Code = Code { id: "ACR005", name: "unterminated-string" };
/// Blanks between the underscore of a label and its name.
pub const DETACHED_LABEL: Code = Code { id: "ACR006", name: "detached-label" };
/// The size of a `DIM` without its parentheses.
pub const DIM_WITHOUT_PARENTHESES: Code = Code { id: "ACR007", name: "dim-without-parentheses" };
/// A remark on the line of a label.
pub const REMARK_ON_LABEL_LINE: Code = Code { id: "ACR008", name: "remark-on-label-line" };
/// An apostrophe comment behind a statement, where the download does not drop it.
pub const COMMENT_AFTER_STATEMENT: Code = Code { id: "ACR009", name: "comment-after-statement" };
/// An equals sign between a command and its value.
pub const EQUALS_AFTER_COMMAND: Code = Code { id: "ACR010", name: "equals-after-command" };

/// All codes of this crate, in the order of their numbers.
pub const ALL: [Code; 10] = [
    SYNTAX_ERROR,
    TYPOGRAPHIC_CHARACTER,
    REMARK_WITHOUT_COLON,
    ENCODING,
    UNTERMINATED_STRING,
    DETACHED_LABEL,
    DIM_WITHOUT_PARENTHESES,
    REMARK_ON_LABEL_LINE,
    COMMENT_AFTER_STATEMENT,
    EQUALS_AFTER_COMMAND,
];
