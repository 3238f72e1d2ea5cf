//! Frames of several lines.

use super::context::Context;
use super::items::{begins, item};
use super::{Completion, CompletionKind};

/// What is typed for a frame, what it is, and the frame; tabs stand for a step of indentation.
const FRAMES: [(&str, &str, &str); 8] = [
    ("IF", "block of IF", "IF (${1:condition})\n\t$0\nENDIF"),
    ("IF", "block of IF and ELSE", "IF (${1:condition})\n\t$2\nELSE\n\t$0\nENDIF"),
    ("FOR", "counted loop", "FOR ${1:LV0} = ${2:0} TO ${3:9}\n\t$0\nNEXT"),
    ("WHILE", "loop with a condition", "WHILE (${1:condition})\n\t$0\nWEND"),
    ("GOSUB", "subroutine", "_${1:name}\n\t$0\nRETURN"),
    ("PROGRAM", "text of a program", "PROGRAM\n\t$0\nENDP"),
    (
        "PROG",
        "whole program with an axis",
        "PROG${1:0}\nDETACH\nATTACH MASTER${1:0}\nATTACH SLAVE0 AXIS${2:0} \"${3:X}\"\nPROGRAM\n\t$0\nENDP",
    ),
    (
        "SYS",
        "memory of the system",
        "SYS\nHALT ALL\nNEW ALL\nCLEAR\nDIM PROG0(${1:8192})\nDIM P(${2:100})\nDIM DEF(${3:20})\n$0",
    ),
];

/// The frames that begin with what is typed.
pub(super) fn all(context: &Context<'_>) -> Vec<Completion> {
    let fitting = FRAMES.iter().filter(|(word, ..)| begins(word, context.part));
    fitting
        .map(|(word, what, frame)| Completion {
            detail: (*what).to_owned(),
            insert: (*frame).to_owned(),
            snippet: true,
            filter: (*word).to_owned(),
            ..item(context, &format!("{word} … ({what})"), CompletionKind::Snippet, 3)
        })
        .collect()
}

/// Text that stays as it is in a snippet.
pub(super) fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('$', "\\$").replace('}', "\\}")
}
