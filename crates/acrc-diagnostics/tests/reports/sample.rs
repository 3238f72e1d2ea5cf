//! Findings of many kinds, which every form has to show.

use std::io::{self, Write};

use acrc_diagnostics::{Applicability, Code, Diagnostic, Edit, FileReport, Fix, SourceFile, Span};

pub(crate) const LABEL: Code = Code { id: "ACR101", name: "undefined-label" };
pub(crate) const QUOTES: Code = Code { id: "ACR001", name: "typographic-character" };
pub(crate) const VALUE: Code = Code { id: "ACR204", name: "missing-value" };
pub(crate) const BLOCK: Code = Code { id: "ACR110", name: "unclosed-block" };

/// A name and a message with everything that some format gives a meaning to.
pub(crate) const HOSTILE_NAME: &str = "sp ace/a\"b'<c>&d%41,e:f#é\u{2028}\n\u{1b}[31m\u{FFFE}.8K";
pub(crate) const HOSTILE_MESSAGE: &str =
    "a <b> & \"c\" 'd' ]]> %0A::error:: {0} [x](1)\r\nsecond\tline \u{0}\u{1b}[31m\u{85}\u{2028}\u{202e}\u{FFFE} end";

const MAIN: &str =
    "REM Achsé µm : GOTO RETRACT\r\n\tPRINT “a”\r\nIF (P1 > 0)\r\n  X10 Y\r\nP2 = 1\r\nREM Achsé µm : GOTO RETRACT";

fn at(text: &str, part: &str) -> Span {
    let start = text.find(part).expect("the part is in the text");
    Span::from(start..start + part.len())
}

fn main_findings() -> Vec<Diagnostic> {
    let open = at(MAIN, "“");
    let close = at(MAIN, "”");
    let block = Span::new(at(MAIN, "IF (").start, at(MAIN, "P2 = 1").end);
    let end = MAIN.len() as u32;
    let last_label = Span::from(MAIN.rfind("RETRACT").expect("it is there")..MAIN.len());
    let undefined = |span| Diagnostic::error(LABEL, span, "no line in program 0 has the label RETRACT");
    vec![
        undefined(at(MAIN, "RETRACT")).with_label("not defined").with_help("define the label, or go to one that is"),
        undefined(last_label).with_fix(Fix::new(Applicability::DisplayOnly, "define _RETRACT", vec![])),
        Diagnostic::advice(QUOTES, Span::cover(open, close), "typographic quotes around \"a\"")
            .with_fix(Fix::safe("write plain quotes", vec![Edit::replace(open, "\""), Edit::replace(close, "\"")])),
        Diagnostic::warning(BLOCK, block, "the block has no ENDIF")
            .with_related(at(MAIN, "IF ("), "the block begins here")
            .with_related(at(MAIN, "IF ("), "the block begins here")
            .with_note("blocks end with their program")
            .with_fix(Fix::unsafe_("end it here", vec![Edit::insert(end, "\r\nENDIF\r\n")]))
            .with_fix(Fix::unsafe_("delete it", vec![Edit::delete(block)])),
        Diagnostic::error(VALUE, at(MAIN, "Y\r\nP2"), "axis Y has no\ntarget").unconfirmed(),
        Diagnostic::warning(VALUE, Span::empty(end), "nothing follows"),
        Diagnostic::warning(VALUE, Span::new(end + 10, end + 20), "a place outside the text"),
    ]
}

/// Hands over reports on four files: many findings, a hostile name and message, an empty file with a finding, a file
/// without findings.
pub(crate) fn with_sample<T>(check: impl FnOnce(&[FileReport<'_>]) -> T) -> T {
    let findings = main_findings();
    let hostile = [Diagnostic::warning(VALUE, Span::new(0, 3), HOSTILE_MESSAGE)
        .with_label(HOSTILE_MESSAGE)
        .with_help(HOSTILE_MESSAGE)
        .with_related(Span::new(0, 1), HOSTILE_MESSAGE)
        .with_fix(Fix::safe(HOSTILE_MESSAGE, vec![Edit::replace(Span::new(0, 3), HOSTILE_MESSAGE)]))];
    let empty = [Diagnostic::advice(BLOCK, Span::default(), "the file is empty")];
    check(&[
        FileReport::new(SourceFile::new(".\\machine\\Prog0.8K", MAIN), &findings),
        FileReport::new(SourceFile::new(HOSTILE_NAME, "END"), &hostile),
        FileReport::new(SourceFile::new("machine/Empty.8K", ""), &empty),
        FileReport::new(SourceFile::new("machine/Clean.8K", "END"), []),
    ])
}

/// What `render` writes.
pub(crate) fn written(render: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> String {
    let mut out = Vec::new();
    render(&mut out).expect("writing to memory works");
    String::from_utf8(out).expect("every form is UTF-8")
}
