use acrc_ide::hover;

use crate::fixture::Fixture;

const PROJECT: &str = "\
=== Setup.8K
SYS : DIM PROG0(4000) : DIM DEF(4) : DIM P(10)
#DEFINE Clamp BIT32
#DEFINE Speed P1
#DEFINE Where P12290
PROG0
DIM LV(4) : DIM LA(1) : DIM LA0(8)
ATTACH MASTER2 : ATTACH SLAVE1 AXIS3 \"X\"
=== Prog0.8K
PROGRAM
10 SET Clamp : VEL (Speed)
' Moves away
REM from the stop.
_Top
X10 : JOG VEL X(LV1+1)
IF (BIT516 AND Clamp) THEN GOTO Top
GOSUB Top : GOTO 10
LA0(1)=SQRT(Where) : LV0 = SV5
TRG -32 : WIBBLE ALL : AXIS3 PPU
ENDP
";

/// The hover at each place: the text up to it, and the text from there.
const PLACES: [(&str, &str); 16] = [
    ("SET ", "Clamp"),
    ("VEL (", "Speed"),
    ("SQRT(", "Where"),
    ("\n", "X10"),
    ("", "JOG VEL"),
    ("X(", "LV1"),
    ("IF (", "BIT516"),
    ("GOTO ", "Top"),
    ("GOTO ", "10"),
    ("\n", "LA0(1)"),
    ("=", "SQRT"),
    ("= ", "SV5"),
    ("TRG ", "-32"),
    (": ", "AXIS3 PPU"),
    ("AXIS3 ", "PPU"),
    ("\n", "ENDP"),
];

#[test]
fn everything_tells_what_it_is() {
    let mut shown = String::new();
    for (before, at) in PLACES {
        let needle = format!("{before}{at}");
        assert!(PROJECT.contains(&needle), "{needle}");
        let program = PROJECT.rfind(&needle).expect("it is there");
        let mut text = PROJECT.to_owned();
        text.insert_str(program + before.len(), "$0");
        let fixture = Fixture::new(&text);
        let file = fixture.cursor().file;
        let found = hover(&fixture.db, fixture.cursor()).expect("something is known");
        shown.push_str("==== ");
        shown.push_str(&fixture.show(file, found.span));
        shown.push('\n');
        shown.push_str(&found.markdown);
    }
    insta::assert_snapshot!(shown);
}

#[test]
fn nothing_is_told_of_what_means_nothing() {
    for text in ["PROGRAM\n  $0  SET 34\nENDP\n", "PROGRAM\nSET 34 ' com$0ment\nENDP\n", "$0"] {
        let fixture = Fixture::new(text);
        assert_eq!(hover(&fixture.db, fixture.cursor()), None, "{text}");
    }
}
