//! Pages of what the compiler reports: `ACR020` and up. Where a rule of the linter finds the same mistake, the page
//! says which. The two codes that the linter shares with the compiler are rules of their own.

use acrc_analysis::compile_codes as codes;
use acrc_diagnostics::{Code, Severity};

use crate::rule::{Group, Rule, RuleDoc};

const STORED: &str = "System Configuration / Memory Allocations";

const fn page(code: Code, [what, why]: [&'static str; 2], [bad, good]: [&'static str; 2], guide: &'static str) -> Rule {
    let severity = Severity::Error;
    Rule {
        doc: RuleDoc { code, group: Group::Compile, severity, enabled: true, mark: None, what, why, bad, good, guide },
        checks: &[],
    }
}

pub(crate) static NOT_COMPILED: Rule = page(
    codes::NOT_COMPILED,
    [
        "A statement could not be read, so the file can't be compiled. The finding of the parser at the same place says \
         what is wrong.",
        "A program with a hole in it must not get to a machine.",
    ],
    ["PROG0\nPROGRAM\nP0 = (P1 + 2\nENDP", "PROG0\nPROGRAM\nP0 = (P1 + 2)\nENDP"],
    "Programming Basics / Command Syntax",
);

pub(crate) static UNDEFINED_LABEL: Rule = page(
    codes::UNDEFINED_LABEL,
    [
        "A jump goes to a label that its program does not define. The linter reports it as ACR101.",
        "The stored jump would have no goal.",
    ],
    ["PROG0\nPROGRAM\nGOTO Start\nENDP", "PROG0\nPROGRAM\n_Start\nGOTO Start\nENDP"],
    "Programming Basics / Program Labels",
);

pub(crate) static DUPLICATE_LABEL: Rule = page(
    codes::DUPLICATE_LABEL,
    ["A program defines a label twice. The linter reports it as ACR102.", "A stored jump goes to one place."],
    ["PROG0\nPROGRAM\n_A\nSET 32\n_A\nGOTO A\nENDP", "PROG0\nPROGRAM\n_A\nSET 32\nGOTO A\nENDP"],
    "Programming Basics / Program Labels",
);

pub(crate) static UNDEFINED_ALIAS: Rule = page(
    codes::UNDEFINED_ALIAS,
    ["A name stands for nothing. The linter reports it as ACR210.", "The stored form has numbers in place of names."],
    ["PROG0\nPROGRAM\nSET Clamp\nENDP", "#DEFINE Clamp BIT32\nPROG0\nPROGRAM\nSET Clamp\nENDP"],
    "Programming Basics / Aliases",
);

pub(crate) static NUMBER_TOO_LARGE: Rule = page(
    codes::NUMBER_TOO_LARGE,
    ["A number does not fit the place where it is stored.", "Stored otherwise it would be another number."],
    ["PROG0\nPROGRAM\nGOTO 99999999999\nENDP", "PROG0\nPROGRAM\n100 SET 32\nGOTO 100\nENDP"],
    STORED,
);

pub(crate) static TOO_DEEP: Rule = page(
    codes::TOO_DEEP,
    [
        "Operands lie within each other beyond what the stored form allows.",
        "Every level takes memory while the program runs.",
    ],
    ["P0 = ((((...))))", "P1 = P2 + P3\nP0 = P1 * 2"],
    STORED,
);

pub(crate) static LIMIT: Rule = page(
    codes::LIMIT,
    ["Something is longer or larger than the stored form has room for.", "It would be cut off without a word."],
    ["PRINT \"(a text of more than 65535 characters)\"", "PRINT \"a shorter text\""],
    STORED,
);

pub(crate) static CONFLICTING_ALIAS: Rule = page(
    codes::CONFLICTING_ALIAS,
    [
        "An alias has two meanings. The linter reports it as ACR211.",
        "Aliases are global: every program would see another one of the two.",
    ],
    ["#DEFINE Clamp BIT32\n#DEFINE Clamp BIT33", "#DEFINE Clamp BIT32\n#DEFINE Gripper BIT33"],
    "Programming Basics / Aliases",
);

pub(crate) static AXIS_NAME: Rule = page(
    codes::AXIS_NAME,
    [
        "A word stands for an axis and can't be the name of one. The linter reports its definition as ACR205.",
        "Axis names have one to four letters.",
    ],
    ["(a word of more than four letters where an axis is read)", "(the name that ATTACH SLAVE gives)"],
    "System Configuration / Attachments",
);
