//! The tree has no error where the compiler has none, and its highlights are what the compiler says about each token.

use std::fmt::Write as _;

use crate::classes::{self, Class};
use crate::programs::{Program, behind_objects, parse, programs, visit};
use acrc_diagnostics::{LineIndex, Severity};
use tree_sitter::{Query, QueryCursor, StreamingIterator as _};

#[test]
fn what_the_compiler_reads_has_no_error() {
    let mut wrong = String::new();
    for Program { name, text } in programs().into_iter().chain([behind_objects()]) {
        let lines = LineIndex::new(&text);
        let compiled = acrc_syntax::parse(&text);
        let errors = compiled.errors().iter().filter(|error| error.severity == Severity::Error);
        let refused: Vec<u32> = errors.map(|error| lines.position(error.span.start).line).collect();
        visit(parse(&text).root_node(), &mut |node| {
            let line = node.start_position().row as u32 + 1;
            if (node.is_error() || node.is_missing()) && !refused.contains(&line) {
                let _ = writeln!(wrong, "{name}:{line}: {:?}", text.get(node.byte_range()));
            }
        });
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// What a capture of the highlights stands for.
fn class(capture: &str) -> Class {
    match capture {
        "keyword" => Class::Keyword,
        "keyword.operator" => Class::OperatorWord,
        "operator" => Class::Operator,
        "number" => Class::Number,
        "string" => Class::String,
        "comment" => Class::Comment,
        "label" => Class::Label,
        "function.builtin" => Class::Function,
        "variable.parameter" => Class::Parameter,
        "constant.builtin" => Class::Bit,
        "variable.builtin" => Class::Variable,
        "variable" => Class::Name,
        "punctuation.delimiter" | "punctuation.bracket" | "punctuation.special" => Class::Punctuation,
        _ => panic!("the highlights have the capture {capture}, which stands for no class"),
    }
}

/// The class of each byte: of the smallest captured node, and of the last pattern that captures it.
fn highlights(query: &Query, text: &str) -> Vec<Option<Class>> {
    let tree = parse(text);
    let mut captures = Vec::new();
    let mut cursor = QueryCursor::new();
    let mut matches = cursor.matches(query, tree.root_node(), text.as_bytes());
    while let Some(found) = matches.next() {
        for capture in found.captures() {
            let name = query.capture_names()[capture.index as usize];
            captures.push((capture.node.byte_range(), found.pattern_index, class(name)));
        }
    }
    captures.sort_by_key(|(range, pattern, _)| (std::cmp::Reverse(range.len()), *pattern));
    let mut bytes = vec![None; text.len()];
    for (range, _, class) in captures {
        bytes[range].fill(Some(class));
    }
    bytes
}

#[test]
fn highlights_are_the_classes_of_the_compiler() {
    let language = tree_sitter_acrobasic::LANGUAGE.into();
    let query = Query::new(&language, tree_sitter_acrobasic::HIGHLIGHTS_QUERY).expect("the query fits the grammar");
    classes::compare(programs().into_iter().chain([behind_objects()]), |text| highlights(&query, text));
}

#[test]
fn every_query_fits_the_grammar() {
    let language = tree_sitter_acrobasic::LANGUAGE.into();
    for query in [
        tree_sitter_acrobasic::FOLDS_QUERY,
        tree_sitter_acrobasic::INDENTS_QUERY,
        tree_sitter_acrobasic::INJECTIONS_QUERY,
        tree_sitter_acrobasic::LOCALS_QUERY,
        tree_sitter_acrobasic::TAGS_QUERY,
    ] {
        if let Err(error) = Query::new(&language, query) {
            panic!("{error}");
        }
    }
}
