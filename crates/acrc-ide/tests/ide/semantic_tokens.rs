use acrc_diagnostics::Span;
use acrc_ide::{SemanticToken, semantic_tokens};
use proptest::prelude::*;

use crate::fixture::Fixture;

const PROJECT: &str = "\
=== Setup.8K
SYS : DIM LV(4) : DIM $V(2,20)
#DEFINE Clamp BIT32
PROG0
ATTACH MASTER0 : ATTACH SLAVE0 AXIS0 \"X\"
AXIS0 PPU 1000 ' steps
=== Prog0.8K
PROGRAM
10 SET 34 : SET Clamp : CLR BIT 35 : VEL5
REM über alles
_Top2
X10 : x/-5 : JOG VEL X(LV0+1) : X1.5Y2
IF (BIT(500+16) AND Clamp) THEN GOTO Top2
GOSUB 10
FOR LV0 = 1 TO 10 STEP 2 : NEXT
LA0(1)=SQRT(P12288) : P(LV0)=1e-5
?\"a \"; P12290
WIBBLE 5
ENDP
";

fn shown(fixture: &Fixture) -> Vec<String> {
    let mut shown = Vec::new();
    for file in &fixture.files {
        for token in semantic_tokens(&fixture.db, fixture.project, *file, None) {
            let mut words = vec![format!("{:?}", token.class)];
            words.extend(token.declaration.then(|| "declaration".to_owned()));
            words.extend(token.modification.then(|| "modification".to_owned()));
            words.extend(token.builtin.then(|| "builtin".to_owned()));
            shown.push(format!("{} = {}", fixture.show(*file, token.span), words.join(" ")));
        }
    }
    shown
}

#[test]
fn every_word_has_its_class() {
    insta::assert_snapshot!(shown(&Fixture::new(PROJECT)).join("\n"));
}

#[test]
fn a_part_of_a_file_has_the_tokens_of_the_whole() {
    let fixture = Fixture::new(PROJECT);
    let file = fixture.files[1];
    let all = semantic_tokens(&fixture.db, fixture.project, file, None);
    let text = file.text(&fixture.db);
    let part = Span::from(text.find("_Top2").expect("it is there")..text.find("GOSUB").expect("it is there"));
    let within: Vec<SemanticToken> =
        all.into_iter().filter(|token| part.start <= token.span.start && token.span.start < part.end).collect();
    assert_eq!(semantic_tokens(&fixture.db, fixture.project, file, Some(part)), within);
}

proptest! {
    #[test]
    fn tokens_are_disjoint_and_in_order_for_any_text(text in "(?s)([A-Z0-9a-z$#?_:(),.+=*/ \"'\\n\u{e4}-]|SET|JOG VEL|BIT|P1|PROGRAM\n|IF \\(|THEN){0,60}") {
        let fixture = Fixture::new(&text.replace("$0", ""));
        let tokens = semantic_tokens(&fixture.db, fixture.project, fixture.files[0], None);
        let text = fixture.files[0].text(&fixture.db);
        for token in &tokens {
            let word = text.get(token.span.range()).expect("a token lies in the text");
            prop_assert!(!word.is_empty() && !word.contains(['\n', '\r']));
        }
        for pair in tokens.windows(2) {
            prop_assert!(pair[0].span.end <= pair[1].span.start);
        }
    }
}
