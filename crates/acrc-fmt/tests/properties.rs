//! What holds for every text, however broken, and for every program at hand.

mod support;

use proptest::prelude::*;

/// Pieces of programs: together they reach every part of the reader, in every wrong order.
const PIECES: [&str; 124] = [
    "X",
    "Y",
    "x",
    "e",
    "AXIS0",
    "AXIS 1",
    "axis",
    "ENC2",
    "enc 0",
    "PROG0",
    "prog 1",
    "MASTER1",
    "CMT0",
    "SLAVE0",
    "P0",
    "p 0",
    "P",
    "LV1",
    "LA0",
    "la 0 (1)",
    "$V0",
    "$v",
    "$ V",
    "$",
    "BIT",
    "bit 24",
    "BIT24",
    "SIN",
    "CHR$",
    "chr $(",
    "RND (",
    "INKEY$(1)",
    "VEL",
    "acc10",
    "SET",
    "set34",
    "CLR 5",
    "INH -",
    "TRG",
    "INT",
    "MOV",
    "SINE",
    "JOG",
    "jog abs",
    "GEAR SRC",
    "CAM ON",
    "DRIVE ON",
    "RES",
    "PPU",
    "SRC",
    "FLASH",
    "DIM",
    "dim lv",
    "DIM PROG",
    "DIM COM 1",
    "CLEAR COM1",
    "CLEAR COM",
    "STREAM 2",
    "CONFIG ENC",
    "DACSTEP2",
    "DACSTEP 2",
    "STEPPER4",
    "#DEFINE",
    "# define",
    "#",
    "Name",
    "Name1",
    "LongName",
    "Name 1",
    "_",
    "_Label",
    "_ Label",
    "_9",
    "GOTO",
    "GOSUB 100",
    "GOTO Name1",
    "IF",
    "IF (P0)",
    "if(p0)then",
    "THEN",
    "THENP0",
    "THENREM",
    "ELSE",
    "ELSE IF",
    "ENDIF",
    "FOR",
    "TO",
    "STEP",
    "NEXT",
    "WHILE(1)",
    "WEND",
    "RETURN",
    "END",
    "PRINT",
    "?",
    "USING",
    "INPUT",
    "OPEN \"a\"",
    "AS",
    "CLOSE",
    "REM",
    "rem text ",
    "'",
    "' acrc: fmt off\n",
    "REM acrc: fmt on\n",
    "PROGRAM",
    "ENDP",
    "ATTACH",
    "NONE",
    "IHPOS",
    "(",
    ")",
    ",",
    ";",
    ":",
    "\n",
    "\r\n",
    "=",
    "/",
    "-",
    "+ 1",
    "AND",
    "NOT",
    "\"a:b\"",
];

/// What stands between two pieces.
const GLUE: [&str; 7] = ["", "", " ", " ", "   ", "\t", "\u{A0}"];

/// Pieces that are no part of the language, or seldom seen.
const ODD: [&str; 24] = [
    "\"open",
    "\u{201C}a\u{201D}",
    "\u{2013}5",
    "\u{2019}",
    "\u{2026}",
    "@",
    "1e",
    "1e-005",
    "1.5",
    ".5",
    "2.",
    "10",
    "..",
    "<>",
    "<<",
    "< <",
    "**",
    "* *",
    "0x10",
    "99999999999999999999999",
    "\u{FEFF}",
    "äß",
    "\r",
    "\x0C",
];

fn soup() -> impl Strategy<Value = String> {
    let piece = prop_oneof![6 => prop::sample::select(PIECES.as_slice()), 1 => prop::sample::select(ODD.as_slice())];
    prop::collection::vec((piece, prop::sample::select(GLUE.as_slice())), 0..60)
        .prop_map(|pieces| pieces.into_iter().flat_map(|(piece, glue)| [piece, glue]).collect())
}

/// Short lines, of which most can be read.
fn short_lines() -> impl Strategy<Value = String> {
    let piece = prop_oneof![6 => prop::sample::select(PIECES.as_slice()), 1 => prop::sample::select(ODD.as_slice())];
    let glue = prop::sample::select(GLUE.as_slice());
    let line = prop::collection::vec((piece, glue), 1..6)
        .prop_map(|pieces| pieces.into_iter().flat_map(|(piece, glue)| [piece, glue]).collect::<String>());
    let end = prop::sample::select(vec!["\n", "\n", "\r\n", "\r", "\n\n\n"]);
    prop::collection::vec((line, end), 0..30)
        .prop_map(|lines| lines.into_iter().map(|(line, end)| line + end).collect())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_order_of_words_keeps_its_tokens(text in soup()) {
        support::checked(&text);
    }

    #[test]
    fn any_lines_keep_their_tokens(text in short_lines()) {
        support::checked(&text);
    }

    #[test]
    fn any_text_keeps_its_tokens(text in "(\\PC|[\\x00-\\x1F]){0,200}") {
        support::checked(&text);
    }
}

#[test]
fn programs_of_the_guide_keep_their_tokens() {
    let Some(corpus) = support::corpus() else { return };
    let programs = support::programs(&corpus.join("guide"));
    assert!(programs.len() > 80, "the corpus is complete");
    for (_, text) in programs {
        support::checked(&text);
        support::checked(&text.replace('\n', "\r\n"));
    }
}

#[test]
fn examples_keep_their_tokens() {
    for (_, text) in support::examples() {
        support::checked(&text);
    }
}
