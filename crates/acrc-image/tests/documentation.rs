//! The page that specifies the format shows the layout that the code has.

use std::fmt::Write;
use std::path::Path;

use acrc_image::layout::{COMMAND_FIELDS, FIRST_FIELD, LAYOUTS};

#[test]
fn the_page_shows_the_layout_of_the_code() {
    let mut table = String::from("| Tag | Name | Fields: bits from 7 upwards |\n|---|---|---|\n");
    for layout in LAYOUTS {
        let fields: Vec<String> = layout.fields.iter().map(|field| format!("{} {}", field.name, field.width)).collect();
        let _ = writeln!(table, "| {} | {} | {} |", layout.tag, layout.name, fields.join(", "));
    }
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/image-format.md"))
        .expect("the page is part of the project");
    let shown = page.split_once("<!-- layout -->\n").and_then(|(_, rest)| rest.split_once("<!-- /layout -->"));
    assert_eq!(shown.map(|(shown, _)| shown), Some(table.as_str()), "docs/image-format.md shows another layout");
}

#[test]
fn no_two_tags_are_equal_and_every_word_is_full_at_most() {
    for (place, layout) in LAYOUTS.iter().enumerate() {
        assert!(LAYOUTS.iter().skip(place + 1).all(|other| other.tag != layout.tag), "tag {}", layout.tag);
        assert!(FIRST_FIELD + layout.fields.iter().map(|field| field.width).sum::<u32>() <= 32, "{}", layout.name);
    }
    assert_eq!(COMMAND_FIELDS.iter().map(|(_, width)| width).sum::<u32>(), 32);
}
