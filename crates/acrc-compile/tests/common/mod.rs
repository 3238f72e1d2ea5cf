//! Helpers shared by the tests.

#![allow(dead_code, reason = "each test program uses its own part")]

use acrc_compile::{CompileError, SourceUnit, compile};
use acrc_image::list::{ListOptions, list};
use acrc_image::{Image, Unit};
use acrc_syntax::units::Level;

/// The level at which the examples are entered.
pub(crate) const PROGRAM: Level = Level::Program(0);

/// Compiles one file.
pub(crate) fn compile_file(text: &str, start: Level, implicit_program: bool) -> Result<Image, Vec<CompileError>> {
    let tree = acrc_syntax::parse(text);
    compile(&[SourceUnit { name: "test.8K", text, tree: &tree, start, implicit_program }], "ACR9000")
}

/// Compiles the text of program 0.
pub(crate) fn program(text: &str) -> (Unit, Image) {
    let image = compile_file(text, PROGRAM, true).unwrap_or_else(|errors| panic!("{text}\n{errors:#?}"));
    image.verify().unwrap_or_else(|error| panic!("{text}\n{error}"));
    (image.programs.last().expect("a stored text").clone(), image)
}

/// Lists a unit without added line numbers.
pub(crate) fn listing(unit: &Unit, image: &Image) -> String {
    list(unit, &image.aliases, &ListOptions::default()).expect("compiled units can be listed")
}

/// Definitions of the aliases of an image, as text to put before a listing of it.
pub(crate) fn definitions(image: &Image) -> String {
    let define = |place| acrc_image::Instruction {
        address: 0,
        separator: acrc_image::Separator::Line,
        command: acrc_catalog::command::DEFINE,
        items: vec![acrc_image::Node::Alias { index: place, parens: 0 }.into()],
    };
    let instructions: Vec<_> = (0_u16..).zip(&image.aliases).map(|(place, _)| define(place)).collect();
    acrc_image::list::list_instructions(&instructions, &image.aliases, &ListOptions::default())
        .expect("the table holds them")
}
