//! The reference grammar is well-formed, and its words are those of the catalogue.

use std::collections::BTreeSet;

use acrc_catalog::{Keyword, ObjectKind, OperandClass, Operator, Shape, UnaryOperator, all_commands};

const EBNF: &str = include_str!("../../../acrobasic.ebnf");

/// Shapes with a rule of their own; all others are written `<Value>`.
const WITH_A_RULE: [Shape; 14] = [
    Shape::Text,
    Shape::If,
    Shape::For,
    Shape::Condition,
    Shape::Print,
    Shape::Input,
    Shape::Open,
    Shape::Close,
    Shape::Dim,
    Shape::Define,
    Shape::Assignment,
    Shape::Label,
    Shape::LineNumber,
    Shape::Object,
];

#[derive(Debug, PartialEq)]
enum Symbol<'e> {
    /// Several words may be one name.
    Name(String),
    /// A text between quotes.
    Text(&'e str),
    /// What is said in words between question marks.
    Special(&'e str),
    Mark(char),
}

fn symbols(mut rest: &str) -> Vec<Symbol<'_>> {
    let mut symbols = Vec::new();
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("(*") {
            end_of(rest, "*)")
        } else if matches!(first, '"' | '\'' | '?') {
            let length = end_of(rest, &first.to_string());
            let inner = &rest[1..length - 1];
            symbols.push(if first == '?' { Symbol::Special(inner.trim()) } else { Symbol::Text(inner) });
            length
        } else if first.is_ascii_lowercase() {
            let length =
                rest.find(|next: char| !next.is_ascii_lowercase() && !next.is_whitespace()).unwrap_or(rest.len());
            symbols.push(Symbol::Name(rest[..length].split_whitespace().collect::<Vec<_>>().join(" ")));
            length
        } else {
            if !first.is_whitespace() {
                symbols.push(Symbol::Mark(first));
            }
            first.len_utf8()
        };
        rest = &rest[length..];
    }
    symbols
}

fn end_of(text: &str, end: &str) -> usize {
    let inner = text.get(end.len()..).and_then(|inner| inner.find(end));
    inner.unwrap_or_else(|| panic!("nothing closes {text:.40}")) + 2 * end.len()
}

/// The rules with what stands in them.
fn rules(symbols: &[Symbol<'static>]) -> Vec<(String, Vec<String>)> {
    let rules = symbols.split_inclusive(|symbol| *symbol == Symbol::Mark(';'));
    rules
        .map(|rule| {
            let [Symbol::Name(name), Symbol::Mark('='), body @ .., Symbol::Mark(';')] = rule else {
                panic!("no rule: {rule:?}")
            };
            check_body(name, body);
            let used = body.iter().filter_map(|symbol| match symbol {
                Symbol::Name(name) => Some(name.clone()),
                _ => None,
            });
            (name.clone(), used.collect())
        })
        .collect()
}

/// Brackets match, and operands are separated.
fn check_body(name: &str, body: &[Symbol]) {
    let mut open = Vec::new();
    let mut wants_operand = true;
    for symbol in body {
        match symbol {
            Symbol::Mark(mark @ ('(' | '[' | '{')) => {
                assert!(wants_operand, "{name}: no comma before {mark}");
                open.push(*mark);
            }
            Symbol::Mark(mark @ (')' | ']' | '}')) => {
                let opened = open.pop();
                let pairs = [('(', ')'), ('[', ']'), ('{', '}')];
                assert!(
                    !wants_operand && pairs.iter().any(|(left, right)| Some(*left) == opened && right == mark),
                    "{name}: {mark}"
                );
            }
            Symbol::Mark(',' | '|') => {
                assert!(!wants_operand, "{name}: an operand is missing");
                wants_operand = true;
            }
            Symbol::Mark(mark) => panic!("{name}: {mark} has no meaning"),
            Symbol::Name(_) | Symbol::Text(_) | Symbol::Special(_) => {
                assert!(wants_operand, "{name}: no comma before {symbol:?}");
                wants_operand = false;
            }
        }
    }
    assert!(open.is_empty() && !wants_operand, "{name}: it is not complete");
}

#[test]
fn every_rule_is_defined_once_and_used() {
    let rules = rules(&symbols(EBNF));
    let defined: BTreeSet<&str> = rules.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(defined.len(), rules.len(), "a rule is defined twice");
    let used: BTreeSet<&str> = rules.iter().flat_map(|(_, used)| used.iter().map(String::as_str)).collect();
    let unknown: Vec<_> = used.difference(&defined).collect();
    assert!(unknown.is_empty(), "not defined: {unknown:?}");
    let unused: Vec<_> = defined.difference(&used).filter(|name| **name != "text").collect();
    assert!(unused.is_empty(), "not used: {unused:?}");
}

#[test]
fn its_words_are_those_of_the_catalogue() {
    let symbols = symbols(EBNF);
    let is_word =
        |text: &&str| text.len() > 1 && text.contains(|letter: char| letter.is_ascii_uppercase()) || **text == *"P";
    let found: BTreeSet<&str> = symbols
        .iter()
        .filter_map(|symbol| match symbol {
            Symbol::Text(text) => Some(*text),
            _ => None,
        })
        .filter(is_word)
        .collect();
    let commands = all_commands().filter(|row| row.shape != Shape::Assignment && row.shape != Shape::Dim);
    let with_a_rule = commands.filter(|row| WITH_A_RULE.contains(&row.shape) && row.shape != Shape::Object);
    let names = with_a_rule.flat_map(|row| row.name.split(' ')).map(|name| name.trim_start_matches('#'));
    // `THEN` is said in words; ON, OFF and RES are daughters or commands.
    let parts = Keyword::ALL
        .iter()
        .filter(|keyword| !matches!(keyword, Keyword::Then | Keyword::On | Keyword::Off | Keyword::Res));
    let operators = Operator::ALL.iter().map(|operator| operator.name());
    let unary = UnaryOperator::ALL.iter().map(|operator| operator.name());
    let expected: BTreeSet<&str> = names
        .chain(parts.map(|keyword| keyword.name()))
        .chain(operators)
        .chain(unary)
        .chain(OperandClass::ALL.iter().map(|class| class.name()))
        .chain(["DIM", ObjectKind::Axis.name()])
        .filter(is_word)
        .collect();
    assert_eq!(found, expected);
}

#[test]
fn every_operator_and_shape_is_there() {
    let symbols = symbols(EBNF);
    for operator in Operator::ALL {
        let row = operator.info();
        for spelling in [row.symbol, row.alternative].into_iter().filter(|text| !text.is_empty()) {
            assert!(symbols.contains(&Symbol::Text(spelling)), "the operator {spelling}");
        }
    }
    let said: String = symbols
        .iter()
        .filter_map(|symbol| match symbol {
            Symbol::Special(text) => Some(*text),
            _ => None,
        })
        .collect();
    for shape in Shape::ALL {
        let is_said = said.contains(&format!("<{}>", shape.name()));
        // Jumps are written with their shape, as a rule of their own.
        assert!(is_said != WITH_A_RULE.contains(shape), "the shape {}", shape.name());
    }
}
