//! Texts that nobody would write.

use std::ops::Range;

use proptest::prelude::*;

/// Pieces of programs: together they reach every part of the reader, in every wrong order.
const PIECES: [&str; 128] = [
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
    "RETURN:REM a\n",
    "\n_Label : REM b\n",
    "DIM P(1)\n",
    "#DEFINE Name P1\n",
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

/// Pieces in any order.
pub(crate) fn soup() -> impl Strategy<Value = String> {
    pieces(0..60)
}

/// Short lines, of which most can be read.
pub(crate) fn short_lines() -> impl Strategy<Value = String> {
    let end = prop::sample::select(vec!["\n", "\n", "\r\n", "\r", "\n\n\n"]);
    prop::collection::vec((pieces(1..6), end), 0..30)
        .prop_map(|lines| lines.into_iter().map(|(line, end)| line + end).collect())
}

fn pieces(count: Range<usize>) -> impl Strategy<Value = String> {
    let piece = prop_oneof![6 => prop::sample::select(PIECES.as_slice()), 1 => prop::sample::select(ODD.as_slice())];
    prop::collection::vec((piece, prop::sample::select(GLUE.as_slice())), count)
        .prop_map(|pieces| pieces.into_iter().flat_map(|(piece, glue)| [piece, glue]).collect())
}

/// Statements that can be compiled, with a blank wherever one may stand or be left out.
const STATEMENTS: [&str; 44] = [
    "X 5 Y / - 3 Z ( P 0 + 1 )",
    "MOV X - 2.5 Y LV 0",
    "X 1 SINE Y ( 0 , 90 , 45 , 100 )",
    "P 0 = - P 1 - - 1 * ( LV 0 + 2 )",
    "LA 0 ( LV 1 + 1 ) = P ( LV 0 ) MOD 4",
    "Speed = SQRT ( P 3 ) / 2 ** 2 << 1",
    "$V 0 = CHR$ ( 65 ) + \"a : b\" + $V 1",
    "BIT 40 = NOT BIT ( LV 0 )",
    "IF ( P 0 >= 1 AND NOT Flag ) THEN SET Flag : GOTO Start",
    "IF ( P 0 <> 1 OR ( BIT 3 = 0 ) )",
    "ELSE IF ( P 1 )",
    "ELSE",
    "ENDIF",
    "FOR LV 0 = 0 TO 9 STEP 1",
    "NEXT",
    "WHILE ( BIT 24 )",
    "WEND",
    "BREAK",
    "GOSUB Loop1",
    "GOTO 20",
    "RETURN",
    "END",
    "PRINT # 1 , \"a\" ; P 0 , LV 1 ;",
    "? P 0",
    "PRINT USING \"##\" ; P 0",
    "INPUT ; # 1 , \"p\" ; $V 0 , P 1",
    "OPEN \"COM1:\" AS # 1",
    "DIM LV ( 2 )",
    "DIM LA 0 ( 5 )",
    "DIM $V ( 1 , 10 )",
    "#DEFINE Other P 7",
    "SET 34 CLR BIT 35",
    "INH - 516",
    "INH - Flag",
    "IHPOS - P 12290 ( 100 , 5 )",
    "ACC 10 DEC 10 STP 10 VEL ( P 0 )",
    "AXIS 0 PPU 4000",
    "RES X 0 Y 1",
    "ENC 0 RES",
    "JOG HOME X - 1 Y 1",
    "JOG VEL X Speed",
    "ATTACH SLAVE 0 AXIS 1 \"X\"",
    "GEAR SRC X ENC 2",
    "DWL 0.5 : REM wait  a bit ",
];

/// Programs of which most can be compiled, untidily written.
pub(crate) fn programs() -> impl Strategy<Value = String> {
    let blank = prop::sample::select(vec!["", " ", " ", " ", "  ", "\t"]);
    let statement = (prop::sample::select(STATEMENTS.as_slice()), prop::collection::vec(blank, 24), any::<bool>());
    let separator = prop::sample::select(vec![
        "\n",
        "\n",
        "\n",
        "\r\n",
        "\n\n\n",
        ":",
        " : ",
        " ",
        "\n10 ",
        "\n_Loop1\n",
        "\nRETURN : REM done\n_Loop1 : REM more\n",
    ]);
    prop::collection::vec((statement, separator), 0..12).prop_map(|statements| {
        let mut text = "#DEFINE Speed P5\n#DEFINE Flag BIT40\nPROG0\nPROGRAM\n_Start\n20 SET 32\n".to_owned();
        for ((statement, blanks, small), separator) in statements {
            for (word, blank) in statement.split(' ').zip(blanks.iter().cycle()) {
                let is_keyword = !word.contains(|letter: char| letter.is_ascii_lowercase());
                let word = if small && is_keyword { word.to_ascii_lowercase() } else { word.to_owned() };
                // Two words that touch are another word.
                let touch =
                    text.ends_with(|end: char| end.is_ascii_alphanumeric()) && word.starts_with(char::is_alphabetic);
                text.push_str(if touch && blank.is_empty() { " " } else { blank });
                text.push_str(&word);
            }
            text.push_str(separator);
        }
        text + "\nENDP\n"
    })
}

/// Lines on which the layout of their neighbours depends.
const LINES: [&str; 36] = [
    "",
    "",
    "   \t",
    "\u{A0}",
    "' comment",
    "REM remark",
    "  ' acrc: fmt off",
    "REM acrc: fmt on",
    "_A",
    "_LongLabel : REM remark",
    "RETURN",
    "RETURN : REM remark",
    "END",
    "IF (P0) THEN RETURN",
    "10 RETURN",
    "20 _Label",
    "30",
    "PROGRAM",
    "ENDP",
    "PROG1",
    "IF (P0)",
    "IF (P0) : REM remark",
    "ELSE",
    "ENDIF",
    "ENDIF : REM remark",
    "FOR LV0 = 0 TO 1 : NEXT",
    "WHILE (P0)",
    "WEND ' late",
    "SET 32 : NEXT",
    "X5 \u{A0}: REM remark",
    "X5 REM remark",
    "PRINT \"a text of many characters, so that it has no column\" : REM far",
    "#DEFINE A P0",
    "#DEFINE LongName P1 : REM remark",
    "DIM LV(1) : REM remark",
    "DIM PROG10(1)   : SET 32",
];

/// Lines in any order, which all can be read.
pub(crate) fn layouts() -> impl Strategy<Value = String> {
    let end = prop::sample::select(vec!["\n", "\n", "\n", "\r\n", "\r"]);
    prop::collection::vec((prop::sample::select(LINES.as_slice()), end), 0..40)
        .prop_map(|lines| lines.into_iter().flat_map(|(line, end)| [line, end]).collect())
}
