//! The formatter and the lister of stored programs agree: a listing is formatted already.

mod support;

use std::fmt::Write;

use acrc_compile::{SourceUnit, compile};
use acrc_fmt::{Options, format};
use acrc_image::Image;
use acrc_image::list::{ListOptions, list};
use acrc_syntax::units::Level;

/// Compiles a text after definitions of what it only refers to. `None` when it has mistakes of another kind.
fn compile_fragment(text: &str) -> Option<Image> {
    use acrc_compile::CompileErrorKind::{UndefinedAlias, UndefinedLabel};
    let mut names = String::new();
    let implicit_program = !text.contains("PROGRAM");
    loop {
        let whole = format!("{names}{text}");
        let tree = acrc_syntax::parse(&whole);
        let start = Level::Program(0);
        let source = SourceUnit { name: "fragment.8K", text: &whole, tree: &tree, start, implicit_program };
        let errors = match compile(&[source], "ACR9000") {
            Ok(image) => return Some(image),
            Err(errors) => errors,
        };
        let before = names.len();
        for error in &errors {
            match &error.kind {
                UndefinedAlias(name) if !names.contains(&format!(" {name} ")) => {
                    let _ = writeln!(names, "#DEFINE {name} P{before}");
                }
                UndefinedLabel(name) if !names.contains(&format!("_{name}\n")) => {
                    let _ = writeln!(names, "_{name}");
                }
                _ => {}
            }
        }
        if names.len() == before {
            return None;
        }
    }
}

#[test]
fn a_listing_is_formatted() {
    let options = Options { align_remarks: false, align_tables: false, ..Options::default() };
    let corpus = support::corpus().map(|corpus| support::programs(&corpus.join("guide"))).unwrap_or_default();
    for (name, text) in corpus.into_iter().chain(support::examples()) {
        let Some(image) = compile_fragment(&text) else { continue };
        for unit in &image.programs {
            let listing = list(unit, &image.aliases, &ListOptions::default()).expect("a compiled unit");
            let formatted = format(&listing, &options).text;
            // The prompt is switched as the guide writes it, and a listing has no blank lines.
            let expected = listing.replace("PROG 0\n", "PROG0\n").replace("PROG 1\n", "PROG1\n");
            assert_eq!(formatted.replace("\n\n", "\n"), expected, "{name}");
        }
    }
}
