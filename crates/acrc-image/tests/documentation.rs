//! The page that specifies the format shows the layout that the code has.

use std::fmt::Write;
use std::path::Path;

use acrc_catalog::{Keyword, ObjectKind, OperandClass, Operator, UnaryOperator};
use acrc_image::layout::{COMMAND_FIELDS, FIRST_FIELD, LAYOUTS};

#[test]
fn the_page_shows_the_layout_of_the_code() {
    let mut table = String::from("| Tag | Name | Fields: bits from 7 upwards |\n|---|---|---|\n");
    for layout in LAYOUTS {
        let fields: Vec<String> = layout.fields.iter().map(|field| format!("{} {}", field.name, field.width)).collect();
        let _ = writeln!(table, "| {} | {} | {} |", layout.tag, layout.name, fields.join(", "));
    }
    assert_shown("layout", &table);
}

#[test]
fn the_page_shows_the_codes_of_the_catalogue() {
    fn name<T>(from_id: fn(u8) -> Option<T>, name: fn(T) -> &'static str, code: u8) -> String {
        from_id(code).map_or("", name).replace('|', "\\|")
    }
    let mut table = String::from(
        "| Code | class | op of `Unary` | op of `Binary` | kind of `Object` | keyword |\n|---|---|---|---|---|---|\n",
    );
    for code in 0..=u8::MAX {
        let names = [
            name(OperandClass::from_id, OperandClass::name, code),
            name(UnaryOperator::from_id, UnaryOperator::name, code),
            name(Operator::from_id, Operator::name, code),
            name(ObjectKind::from_id, ObjectKind::name, code),
            name(Keyword::from_id, Keyword::name, code),
        ];
        if names.iter().all(String::is_empty) {
            break;
        }
        let _ = writeln!(table, "| {code} | {} |", names.join(" | "));
    }
    assert_shown("codes", &table);
}

/// The page shows exactly this between the marks of a table.
fn assert_shown(mark: &str, table: &str) {
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/image-format.md"))
        .expect("the page is part of the project");
    let shown = page
        .split_once(&format!("<!-- {mark} -->\n"))
        .and_then(|(_, rest)| rest.split_once(&format!("<!-- /{mark} -->")));
    assert_eq!(
        shown.map(|(shown, _)| shown),
        Some(table),
        "docs/image-format.md shows other {mark}; the code has\n{table}"
    );
}

#[test]
fn no_two_tags_are_equal_and_every_word_is_full_at_most() {
    for (place, layout) in LAYOUTS.iter().enumerate() {
        assert!(LAYOUTS.iter().skip(place + 1).all(|other| other.tag != layout.tag), "tag {}", layout.tag);
        assert!(FIRST_FIELD + layout.fields.iter().map(|field| field.width).sum::<u32>() <= 32, "{}", layout.name);
    }
    assert_eq!(COMMAND_FIELDS.iter().map(|(_, width)| width).sum::<u32>(), 32);
}
