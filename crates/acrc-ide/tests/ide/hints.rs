use acrc_diagnostics::Span;
use acrc_ide::{HintOptions, code_lenses, inlay_hints, inline_values, programs};
use acrc_syntax::units::Level;

use crate::fixture::Fixture;

const PROJECT: &str = "\
=== Setup.8K
SYS : CLEAR : DIM PROG0(1000) : DIM PLC1(200) : DIM P(9) : DIM DEF(1)
#DEFINE Clamp BIT32
PROG0
DIM LV(2)
PLC1
PROGRAM
LD 32
OUT 33
ENDP
=== Prog0.8K
PROGRAM
SET 8467 : CLR Clamp
P0 = P12290 + P(12288+256)
LV1 = LA0(1) : IF (BIT128) THEN END
P8 = P5000
ENDP
PROG1
PROGRAM
DWL 1
ENDP
";

/// The text with the hints in it.
fn hinted(options: HintOptions) -> String {
    let fixture = Fixture::new(PROJECT);
    let mut shown = String::new();
    for file in &fixture.files {
        let text = file.text(&fixture.db);
        let mut hinted = text.to_owned();
        let all = Span::new(0, text.len() as u32);
        for hint in inlay_hints(&fixture.db, fixture.project, *file, all, options).iter().rev() {
            hinted.insert_str(hint.offset as usize, &format!("«{}»", hint.label));
        }
        shown.push_str(&hinted);
    }
    shown
}

#[test]
fn numbers_and_programs_are_explained() {
    insta::assert_snapshot!(hinted(HintOptions::default()));
}

#[test]
fn bytes_are_summed_up_by_line() {
    insta::assert_snapshot!(hinted(HintOptions { numbers: false, bytes: true, running_bytes: true }));
}

#[test]
fn programs_can_be_run_and_show_what_they_take() {
    let fixture = Fixture::new(PROJECT);
    let outcome = |level| (level == Level::Program(0)).then(|| "ended after 2.5 s".to_owned());
    let mut shown = Vec::new();
    for file in &fixture.files {
        for lens in code_lenses(&fixture.db, fixture.project, *file, &outcome) {
            shown.push(format!("{}: {} {:?}", fixture.show(*file, lens.span), lens.title, lens.action));
        }
    }
    insta::assert_snapshot!(shown.join("\n"));
}

#[test]
fn a_program_that_the_setup_gives_nothing_has_no_space() {
    let fixture = Fixture::new(PROJECT);
    let space: Vec<_> =
        programs(&fixture.db, fixture.project, fixture.files[1]).iter().map(|program| program.space).collect();
    assert_eq!(space, [Some(1000), None]);
}

#[test]
fn operands_with_a_number_have_a_value_to_show() {
    let fixture = Fixture::new(PROJECT);
    let file = fixture.files[1];
    let all = Span::new(0, file.text(&fixture.db).len() as u32);
    let values = inline_values(&fixture.db, fixture.project, file, all);
    let shown: Vec<String> = values
        .iter()
        .map(|value| {
            let level = value.level.map_or_else(String::new, |level| format!(" of {level}"));
            format!("{} = {}{}{level}", fixture.show(file, value.span), value.class, value.number)
        })
        .collect();
    insta::assert_snapshot!(shown.join("\n"));
}
