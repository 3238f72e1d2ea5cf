use acrc_ide::{Completion, completions};
use proptest::prelude::*;

use crate::fixture::Fixture;

const SETUP: &str = "=== Setup.8K\nSYS : DIM DEF(4) : DIM P(9)\n#DEFINE clamp BIT32\n#DEFINE speed P1\nPROG0\nDIM LV(4)\n\
                     ATTACH MASTER0 : ATTACH SLAVE0 AXIS1 \"X\" : ATTACH SLAVE1 AXIS0 \"Y\"\nPLC1\nPROGRAM\nLD 0\nENDP\n";

fn at(line: &str) -> Vec<Completion> {
    let text = format!("{SETUP}=== Prog0.8K\nPROGRAM\n_top\n20 VEL 5\n{line}\nGOSUB top\nENDP\n");
    let fixture = Fixture::new(&text);
    completions(&fixture.db, fixture.cursor()).items
}

/// The first completions, with what they mean.
fn shown(line: &str, most: usize) -> String {
    let found = at(line);
    let more = if found.len() > most { format!("... {} in all\n", found.len()) } else { String::new() };
    let lines = found.iter().take(most).map(|item| format!("  {} {:?} {}\n", item.label, item.kind, item.detail));
    format!("{line}\n{}{more}", lines.collect::<String>())
}

#[test]
fn what_fits_depends_on_the_place() {
    let lines = [
        ("$0", 6),
        ("jo$0", 5),
        ("JOG $0", 4),
        ("JOG HO$0", 4),
        ("AXIS0 J$0", 4),
        ("AXIS0 $0", 4),
        ("ENC0 SR$0", 4),
        ("ENC0 SRC $0", 4),
        ("JOG VEL $0", 3),
        ("GOTO $0", 9),
        ("GOTO _$0", 9),
        ("GOTO _t$0", 9),
        ("_$0", 4),
        ("_Fo$0", 4),
        ("IF (BIT32) THEN GOS$0", 9),
        ("SET cl$0", 4),
        ("SET kamr x$0", 4),
        ("SET kill all motion axis 1$0", 4),
        ("P0 = encoder 0 pos$0", 4),
        ("SET BIT32 : CLR kamr axis 3$0", 4),
        ("P0 = actual position y$0", 6),
        ("P0 = SQ$0", 6),
        ("P0 = (L$0", 6),
        ("P0 = SQRT(sp$0", 6),
        ("RUN $0", 6),
        ("ATTACH MASTER0 : ATTACH S$0", 6),
        ("#DEF$0", 6),
        ("#DEFINE $0", 6),
        ("#DEFINE Stop kamr axis 1$0", 6),
        ("#DEFINE Stop $0", 6),
        ("FOR LV0 = 1 T$0", 6),
        ("' acrc: allow(ACR10$0", 3),
        ("' nothing$0", 3),
        ("PRINT \"nothing$0\"", 3),
        ("PRINT \"nothing$0", 3),
        ("X$0", 3),
        ("ACC10 DE$0", 3),
    ];
    let shown: Vec<String> = lines.iter().map(|(line, most)| shown(line, *most)).collect();
    insta::assert_snapshot!(shown.join("\n"));
}

#[test]
fn a_name_in_words_is_replaced_as_a_whole() {
    let found = at("SET kamr axis 1$0");
    let bit = found.iter().find(|item| item.label == "BIT8499").expect("KAMR of axis 1 is BIT8499");
    assert_eq!(bit.span.range().len(), "kamr axis 1".len());
    assert_eq!(bit.filter, "kamr axis 1");
}

#[test]
fn frames_leave_places_to_fill_in() {
    let found = at("whi$0");
    let frame = found.iter().find(|item| item.snippet).expect("WHILE has a frame");
    assert_eq!(frame.insert, "WHILE (${1:condition})\n\t$0\nWEND");
}

proptest! {
    #[test]
    fn any_place_in_any_text_has_completions(
        text in "(?s)([A-Z0-9a-z#?_:(),.+=*/ \"'\\n\u{e4}-]|SET |JOG VEL|BIT|P1|PROGRAM\n|IF \\(|THEN|\\$V){0,40}",
        place in 0.0..1.0,
    ) {
        let mut offset = (text.len() as f64 * place) as usize;
        while !text.is_char_boundary(offset) {
            offset -= 1;
        }
        let fixture = Fixture::new(&format!("{}$0{}", text.get(..offset).unwrap_or_default(), text.get(offset..).unwrap_or_default()));
        let cursor = fixture.cursor();
        for item in completions(&fixture.db, cursor).items {
            prop_assert!(cursor.file.text(&fixture.db).get(item.span.range()).is_some());
            prop_assert!(item.span.end == cursor.offset);
        }
    }
}
