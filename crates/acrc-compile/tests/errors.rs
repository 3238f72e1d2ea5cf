//! What cannot be compiled, as a person reads it.

mod common;

use acrc_compile::{CompileErrorKind, NoNames, Tables, codes, encode_statements};
use acrc_diagnostics::{Diagnostic, FileReport, SourceFile, text};
use acrc_image::Node;
use acrc_syntax::units::Level;
use common::compile_file;

/// The mistakes of a program text, rendered.
fn mistakes(source: &str, start: Level, implicit_program: bool) -> String {
    let errors = compile_file(source, start, implicit_program).expect_err("the text has mistakes");
    let diagnostics: Vec<Diagnostic> = errors.iter().map(Diagnostic::from).collect();
    let report = FileReport::new(SourceFile::new("Prog0.8K", source), &diagnostics);
    let mut out = Vec::new();
    text::render(&[report], text::Options::default(), &mut out).expect("writing to memory works");
    String::from_utf8(out).expect("renderers write UTF-8")
}

fn in_program(source: &str) -> String {
    mistakes(source, Level::Program(0), true)
}

#[test]
fn labels() {
    insta::assert_snapshot!(in_program("_Loop\nGOTO loop\n_Loop\nGOSUB Missing"));
}

#[test]
fn names() {
    insta::assert_snapshot!(in_program(
        "#DEFINE Speed P1\n#DEFINE Speed P2\n#DEFINE Fast Speed\n#DEFINE Sum P0 + 1\nVEL (speed)\nSET Ready"
    ));
}

#[test]
fn numbers_and_characters() {
    insta::assert_snapshot!(in_program(
        "P0 = 99999999999999999999\nP1 = 1e999\nGOTO 4294967295\nPRINT \"\u{3a9}\"\nPRINT \"a \u{201c}b\u{201d}\""
    ));
}

#[test]
fn limits_of_the_stored_form() {
    let deep = format!("LV0 = {}1{}", "1+(".repeat(210), ")".repeat(210));
    insta::assert_snapshot!(in_program(&format!("{deep}\nP0 = ((((((((P1))))))))\nAXIS2000 RES\nPPU Spindle 4")));
}

#[test]
fn program_text_at_the_system_prompt() {
    insta::assert_snapshot!(mistakes("PROGRAM\nX5\nENDP\n10 X6", Level::System, false));
}

#[test]
fn every_statement_that_cannot_be_read_is_named() {
    let errors = compile_file("VEL )\nACC 5\nX5 : DWL (\nEND", Level::Program(0), true)
        .expect_err("two statements cannot be read");
    assert_eq!(
        errors.iter().map(|error| error.kind.clone()).collect::<Vec<_>>(),
        [CompileErrorKind::Syntax, CompileErrorKind::Syntax]
    );
}

#[test]
fn codes_are_in_order_and_unique() {
    let ids: Vec<&str> = codes::ALL.iter().map(|code| code.id).collect();
    assert!(ids.is_sorted() && ids.windows(2).all(|pair| pair[0] != pair[1]), "{ids:?}");
}

#[test]
fn a_terminal_encodes_statements_with_names_of_its_own() {
    let source = "SET Ready : GOTO Start";
    let tree = acrc_syntax::parse(source);
    let mut names = Tables::default();
    names.aliases.insert("Ready".to_owned(), 7);
    names.labels.insert("Start".to_owned(), 0);
    let instructions = encode_statements(&tree, source, 0..1, &names).expect("the alias is known");
    assert_eq!(
        instructions.iter().map(|instruction| &instruction.items[0].node).collect::<Vec<_>>(),
        [&Node::Alias { index: 7, parens: 0 }]
    );
    let errors = encode_statements(&tree, source, 0..2, &NoNames).expect_err("nothing is known");
    assert_eq!(errors.len(), 2);
}

#[test]
fn numbers_of_lines() {
    insta::assert_snapshot!(mistakes("4294967296 PRINT 1\n  4294967297 PRINT 2\n", Level::Program(0), false));
}
