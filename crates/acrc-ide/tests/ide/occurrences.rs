use acrc_ide::{Entity, at, everywhere, in_file};

use crate::fixture::Fixture;

const PROJECT: &str = "\
=== Setup.8K
SYS : DIM DEF(4)
#DEFINE Clamp BIT32
#DEFINE Speed P1
PROG0
ATTACH MASTER0 : ATTACH SLAVE0 AXIS0 \"X\"
=== Prog0.8K
PROGRAM
10 SET Clamp : VEL (Speed)
_Top
X10 : x/-5 : JOG VEL X(LV0+1)
IF (BIT(500+16) AND Clamp) THEN GOTO Top
GOSUB 10
LA0(1)=SQRT(P12288)
ENDP
";

#[test]
fn everything_with_a_name_or_a_number_occurs_once() {
    let fixture = Fixture::new(PROJECT);
    let mut shown = Vec::new();
    for file in &fixture.files {
        for occurrence in in_file(&fixture.db, fixture.project, *file) {
            let place = fixture.show(*file, occurrence.span);
            shown.push(format!("{place} = {:?} {:?}", occurrence.role, occurrence.entity));
        }
    }
    insta::assert_snapshot!(shown.join("\n"));
}

fn places(text: &str) -> Vec<String> {
    let fixture = Fixture::new(text);
    let occurrence = at(&fixture.db, fixture.cursor()).expect("something stands there");
    let found = everywhere(&fixture.db, fixture.project, &occurrence.entity);
    found.into_iter().map(|(file, occurrence)| fixture.show(file, occurrence.span)).collect()
}

#[test]
fn an_alias_is_found_in_all_files() {
    let found = places(&PROJECT.replace("SET Clamp", "SET Cl$0amp"));
    assert_eq!(found, ["Setup.8K:2:9 Clamp", "Prog0.8K:2:8 Clamp", "Prog0.8K:5:21 Clamp"]);
}

#[test]
fn an_axis_is_found_by_its_name_in_any_case() {
    let found = places(&PROJECT.replace("x/-5", "$0x/-5"));
    assert_eq!(found, ["Setup.8K:5:39 X", "Prog0.8K:4:1 X", "Prog0.8K:4:7 x", "Prog0.8K:4:22 X"]);
}

#[test]
fn the_end_of_a_name_belongs_to_it() {
    let fixture = Fixture::new("PROGRAM\nGOTO Top$0\n_Top\nENDP\n");
    let occurrence = at(&fixture.db, fixture.cursor()).expect("something stands there");
    assert!(matches!(occurrence.entity, Entity::Label(_, name) if &*name == "Top"));
}

#[test]
fn the_underscore_of_a_label_belongs_to_it() {
    let fixture = Fixture::new("PROGRAM\nGOTO Top\n$0_Top\nENDP\n");
    let occurrence = at(&fixture.db, fixture.cursor()).expect("something stands there");
    assert!(matches!(occurrence.entity, Entity::Label(_, name) if &*name == "Top"));
}

#[test]
fn of_two_that_touch_the_second_is_meant() {
    let fixture = Fixture::new("PROGRAM\nSET$034\nENDP\n");
    let occurrence = at(&fixture.db, fixture.cursor()).expect("something stands there");
    assert!(matches!(occurrence.entity, Entity::Operand { number: Some(34), .. }));
}

#[test]
fn nothing_stands_in_blanks_and_comments() {
    for text in
        ["PROGRAM\n  $0  SET 34\nENDP\n", "PROGRAM\nSET 34 ' com$0ment\nENDP\n", "$0", "PROGRAM\nREM so$0me\nENDP\n"]
    {
        let fixture = Fixture::new(text);
        assert_eq!(at(&fixture.db, fixture.cursor()), None, "{text}");
    }
}
