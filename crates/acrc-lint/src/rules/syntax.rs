//! Pages of what the parser reports: `ACR001` to `ACR009`.

use acrc_diagnostics::{Code, Severity};
use acrc_syntax::codes;

use crate::rule::{Group, Mark, Rule, RuleDoc};

const fn page(
    code: Code,
    severity: Severity,
    [what, why]: [&'static str; 2],
    [bad, good]: [&'static str; 2],
    guide: &'static str,
) -> Rule {
    Rule {
        doc: RuleDoc { code, group: Group::Syntax, severity, enabled: true, mark: None, what, why, bad, good, guide },
        checks: &[],
    }
}

/// The page of a spelling that is read, though the guide has another one for it.
const fn deprecated(rule: &Rule) -> Rule {
    Rule { doc: RuleDoc { mark: Some(Mark::Deprecated), ..rule.doc }, checks: rule.checks }
}

pub(crate) static SYNTAX_ERROR: Rule = page(
    codes::SYNTAX_ERROR,
    Severity::Error,
    [
        "A statement can't be read: an unknown word, a missing value or parenthesis, something left over at its end.",
        "The controller answers such a line with an error while it is sent, and stores the program without it. The \
         machine then runs a program with a hole.",
    ],
    ["PROG0\nPROGRAM\nP0 = (P1 + 2\nENDP", "PROG0\nPROGRAM\nP0 = (P1 + 2)\nENDP"],
    "Programming Basics / Command Syntax",
);

pub(crate) static TYPOGRAPHIC_CHARACTER: Rule = page(
    codes::TYPOGRAPHIC_CHARACTER,
    Severity::Warning,
    [
        "A curly quote, a long dash, a no-break space or the like stands where the language has an ASCII character. \
         Such characters come with text that was copied from a document.",
        "The controller knows ASCII only: it refuses the line, or takes the character for something else.",
    ],
    ["PRINT \u{201c}ready\u{201d}", "PRINT \"ready\""],
    "Programming Basics / Command Syntax",
);

pub(crate) static REMARK_WITHOUT_COLON: Rule = page(
    codes::REMARK_WITHOUT_COLON,
    Severity::Warning,
    [
        "A REM follows a statement with no colon between them.",
        "The guide asks for blank, colon, blank before a remark. Without the colon the remark may be taken for an \
         argument of the statement before it.",
    ],
    ["SET 32 REM open the gripper", "SET 32 : REM open the gripper"],
    "Programming Basics / Remarks",
);

pub(crate) static ENCODING: Rule = page(
    codes::ENCODING,
    Severity::Advice,
    [
        "The file starts with a byte order mark, or its bytes are not UTF-8 (it is then read in the Windows code page \
         or as UTF-16).",
        "What other tools send to the controller for these bytes differs from tool to tool.",
    ],
    ["(a file saved as \"Unicode\" or \"ANSI\")", "(the same file saved as UTF-8 without a byte order mark)"],
    "says nothing of text encodings",
);

pub(crate) static UNTERMINATED_STRING: Rule = page(
    codes::UNTERMINATED_STRING,
    Severity::Error,
    [
        "A text begins with a quote and does not end with one on its line.",
        "Everything up to the end of the line becomes part of the text, statements behind it included.",
    ],
    ["PRINT \"ready : SET 32", "PRINT \"ready\" : SET 32"],
    "Programming Basics / Command Syntax",
);

pub(crate) static DETACHED_LABEL: Rule = page(
    codes::DETACHED_LABEL,
    Severity::Warning,
    [
        "Blanks stand between the underscore of a label and its name.",
        "A label is an underscore followed by letters and digits. Whether a controller forgives the blank is not \
         documented; if it does not, every jump to the label fails.",
    ],
    ["_ Start\nSET 32\nGOTO Start", "_Start\nSET 32\nGOTO Start"],
    "Programming Basics / Program Labels",
);

pub(crate) static DIM_WITHOUT_PARENTHESES: Rule = deprecated(&page(
    codes::DIM_WITHOUT_PARENTHESES,
    Severity::Warning,
    [
        "The size in a DIM stands without parentheses.",
        "Every form in the guide has them. `DIM LV10` looks like the variable LV10 and is read here as ten variables.",
    ],
    ["DIM LV10", "DIM LV(10)"],
    "System Configuration / Memory Allocations",
));

pub(crate) static REMARK_ON_LABEL_LINE: Rule = page(
    codes::REMARK_ON_LABEL_LINE,
    Severity::Advice,
    [
        "A REM stands on the line of a label.",
        "The guide forbids it, without saying what happens. Programs that do it are known to run; a line of its own is \
         the safe place.",
    ],
    ["_Start : REM begin of the cycle\nSET 32\nGOTO Start", "REM begin of the cycle\n_Start\nSET 32\nGOTO Start"],
    "Programming Basics / Program Labels",
);

pub(crate) static COMMENT_AFTER_STATEMENT: Rule = page(
    codes::COMMENT_AFTER_STATEMENT,
    Severity::Warning,
    [
        "An apostrophe comment follows a statement on the same line.",
        "The download drops lines that begin with an apostrophe. Behind a statement the comment is sent to the \
         controller, which does not know it.",
    ],
    ["SET 32 ' open the gripper", "' open the gripper\nSET 32"],
    "Programming Basics / Remarks",
);

pub(crate) static EQUALS_AFTER_COMMAND: Rule = deprecated(&page(
    codes::EQUALS_AFTER_COMMAND,
    Severity::Warning,
    [
        "An equals sign stands between a command and its value.",
        "No document shows this form. It is read here as if the sign were not there; a controller may as well refuse \
         the line, and the machine then moves with the value before.",
    ],
    ["VEL = 5", "VEL 5"],
    "Programming Basics / Command Syntax",
));
