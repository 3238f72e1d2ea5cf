//! Encoder and decoder are inverses, and the decoder survives anything.

mod common;

use acrc_catalog::command;
use acrc_image::{
    EncodeError, ImageError, Instruction, Item, MAX_DEPTH, Mark, Node, Problem, Separator, TextCost, Unit, UnitBuilder,
    UnitName, encode,
};
use common::instructions;
use proptest::prelude::*;

fn without_addresses(mut instructions: Vec<Instruction>) -> Vec<Instruction> {
    for instruction in &mut instructions {
        instruction.address = 0;
    }
    instructions
}

fn unit(words: Vec<u32>, strings: Vec<u8>) -> Unit {
    Unit { name: UnitName::Program(0), words, strings, debug: None }
}

fn problem(words: &[u32], strings: &[u8]) -> Problem {
    match unit(words.to_vec(), strings.to_vec()).decode() {
        Err(ImageError::Word { problem, .. }) => problem,
        other => panic!("expected a problem with a word, got {other:?}"),
    }
}

fn one(command: acrc_catalog::CommandId, items: Vec<Item>) -> Result<Unit, EncodeError> {
    encode(UnitName::Program(0), &[Instruction { address: 0, separator: Separator::Line, command, items }])
}

/// `NOT NOT ... 1` with `levels` operators.
fn nested(levels: usize) -> Node {
    (0..levels).fold(Node::Long(1), |operand, _| Node::Unary {
        op: acrc_catalog::UnaryOperator::Not,
        operand: Box::new(operand),
        parens: 0,
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn decode_gives_back_what_was_encoded(instructions in instructions()) {
        let unit = encode(UnitName::Program(3), &instructions).expect("generated statements are valid");
        prop_assert_eq!(&without_addresses(unit.decode().expect("encoded units are valid")), &instructions);
        prop_assert_eq!(unit.memory() as usize, 4 * unit.words.len() + unit.strings.len());
        let cost: TextCost = instructions.iter().map(|statement| TextCost::of(statement.command, &statement.items)).sum();
        prop_assert_eq!(cost.total(), u64::from(unit.memory()));
    }

    #[test]
    fn what_decodes_has_one_encoding(words in proptest::collection::vec(any::<u32>(), 0..40), strings in proptest::collection::vec(any::<u8>(), 0..20)) {
        let unit = unit(words, strings);
        if let Ok(instructions) = unit.decode() {
            prop_assert_eq!(encode(unit.name, &instructions).expect("decoded statements are valid"), unit);
        }
    }

    #[test]
    fn a_changed_word_is_refused_or_still_has_one_encoding(instructions in instructions(), place in any::<prop::sample::Index>(), bit in 0..32_u32) {
        let mut unit = encode(UnitName::Program(0), &instructions).expect("generated statements are valid");
        let place = place.index(unit.words.len());
        unit.words[place] ^= 1_u32 << bit;
        if let Ok(instructions) = unit.decode() {
            prop_assert_eq!(encode(unit.name, &instructions).expect("decoded statements are valid"), unit);
        }
    }

    #[test]
    fn a_unit_that_is_cut_off_is_refused_or_ends_between_statements(instructions in instructions(), place in any::<prop::sample::Index>()) {
        let mut unit = encode(UnitName::Program(0), &instructions).expect("generated statements are valid");
        unit.words.truncate(place.index(unit.words.len()));
        if let Ok(decoded) = unit.decode() {
            prop_assert_eq!(without_addresses(decoded.clone()), instructions[..decoded.len()].to_vec());
        }
    }
}

#[test]
fn memory_is_the_table_of_the_guide() {
    let long = one(command::ACC, vec![Node::Long(10_000).into()]).expect("valid");
    assert_eq!(long.memory(), 4 + 4);
    let double = one(command::ACC, vec![Node::Double(0.123_456_789).into()]).expect("valid");
    assert_eq!(double.memory(), 4 + 8);
    let text = one(command::PRINT, vec![Node::string("ok").into()]).expect("valid");
    assert_eq!(text.memory(), 4 + 4 + 2);
    let operand =
        one(command::PRINT, vec![Node::scalar(acrc_catalog::OperandClass::Parameter, 0).into()]).expect("valid");
    assert_eq!(operand.memory(), 4 + 4 + 4);
}

#[test]
fn a_constant_without_a_slot_costs_a_word_more() {
    let items = |count: i32| (0..count).map(|value| Node::Long(value).into()).collect::<Vec<Item>>();
    assert_eq!(one(command::LIST, items(4)).expect("valid").words.len(), 1 + 4);
    assert_eq!(one(command::LIST, items(6)).expect("valid").words.len(), 1 + 4 + 2 * 2);
    assert_eq!(one(command::LIST, items(14)).expect("valid").words.len(), 1 + 4 + 10 * 2);
    assert_eq!(one(command::LIST, items(15)).expect("valid").words.len(), 1 + 4 + 11 * 2 + 1);
}

#[test]
fn nesting_has_a_limit_on_both_sides() {
    let deepest = one(command::PRINT, vec![nested(MAX_DEPTH).into()]).expect("as deep as allowed");
    assert_eq!(deepest.decode().expect("as deep as allowed").len(), 1);
    assert_eq!(one(command::PRINT, vec![nested(MAX_DEPTH + 1).into()]), Err(EncodeError::Invalid(Problem::TooDeep)));
    let mut words = deepest.words;
    let inner = words[1];
    let kind_of_operand = 3 << 12;
    words.insert(1, inner & !kind_of_operand);
    assert_eq!(problem(&words, &[]), Problem::TooDeep);
}

#[test]
fn fields_that_are_too_narrow_are_errors() {
    let too_large = |node: Node| matches!(one(command::PRINT, vec![node.into()]), Err(EncodeError::TooLarge { .. }));
    assert!(too_large(Node::String { bytes: Vec::new(), parens: 8 }));
    assert!(too_large(Node::string(vec![b'x'; 65_536])));
    assert!(!too_large(Node::string(vec![b'x'; 65_535])));
    assert!(too_large(Node::Tuple(vec![Node::Long(0); 8])));
    assert!(too_large(Node::Call {
        function: acrc_catalog::function::SIN,
        arguments: vec![Node::Long(0); 5],
        parens: 0
    }));
}

#[test]
fn what_the_verifier_would_refuse_is_not_encoded() {
    let invalid = |command, items: Vec<Item>| matches!(one(command, items), Err(EncodeError::Invalid(_)));
    assert!(invalid(command::ACC, vec![Node::Double(f64::NAN).into()]));
    assert!(invalid(command::ACC, vec![Node::Single(f32::INFINITY).into()]));
    assert!(invalid(acrc_catalog::CommandId(1023), Vec::new()));
    assert!(invalid(command::LABEL, vec![Node::Long(1).into()]));
    assert!(invalid(command::GOTO, vec![Node::LabelRef(0).into()]));
    assert!(invalid(command::PRINT, vec![Node::Device(Box::new(Node::Device(Box::new(Node::Long(1))))).into()]));
    assert!(invalid(command::PRINT, vec![Node::Tuple(vec![Node::Long(1)]).into()]));
}

#[test]
fn a_refused_statement_leaves_no_trace() {
    let mut builder = UnitBuilder::new(UnitName::Program(0));
    let broken = [Node::string("text").into(), Node::Double(f64::NAN).into()];
    assert!(builder.push(Separator::Line, command::PRINT, &broken).is_err());
    assert_eq!(builder.push(Separator::Line, command::END, &[]), Ok(0));
    let unit = builder.finish().expect("valid");
    assert_eq!((unit.words.len(), unit.strings.len()), (1, 0));
}

#[test]
fn then_needs_an_if() {
    let condition = Item { node: Node::Long(1), mark: Mark::Comma };
    let mut builder = UnitBuilder::new(UnitName::Program(0));
    assert!(builder.push(Separator::Then, command::END, &[]).is_err());
    builder.push(Separator::Line, command::IF, &[condition]).expect("valid");
    builder.push(Separator::Then, command::END, &[]).expect("valid behind IF with THEN");
    assert!(builder.push(Separator::Then, command::END, &[]).is_err());
}

#[test]
fn every_problem_is_found() {
    let end = u32::from(command::END.0) << 2;
    let acc = u32::from(command::ACC.0) << 2;
    assert_eq!(problem(&[1000 << 2], &[]), Problem::Unknown { what: "opcode", code: 1000 });
    assert_eq!(problem(&[acc | 1 << 12 | 1 << 16], &[]), Problem::EndOfWords);
    assert_eq!(problem(&[end | 1 << 16], &[]), Problem::NotCanonical(end | 1 << 16));
    assert_eq!(problem(&[acc | 1 << 12, 31], &[]), Problem::Unknown { what: "node tag", code: 31 });
    assert_eq!(problem(&[acc | 1 << 12 | 3 << 18, 4], &[]), Problem::Unknown { what: "mark", code: 3 });
    assert_eq!(problem(&[acc | 1 << 12, 1 | 3 << 10], &[]), Problem::EndOfText { needed: 3, left: 0 });
    assert_eq!(problem(&[acc | 1 << 12, 4 | 1 << 5], &[]), Problem::NotCanonical(4 | 1 << 5));
    assert_eq!(problem(&[acc | 1 << 12, 4 | 1 << 31], &[]), Problem::NotCanonical(4 | 1 << 31));
    assert_eq!(problem(&[end], b"x"), Problem::UnusedText(1));
    assert_eq!(problem(&[acc | 1 << 12 | 2 << 16, f32::NAN.to_bits()], &[]), Problem::NotFinite);
    assert_eq!(problem(&[acc | 1 << 12, 5 | 7 << 7], &[]), Problem::NoSuchLabel { ordinal: 7, labels: 0 });
    assert_eq!(problem(&[end | 3], &[]), Problem::Operands("a statement follows THEN without an IF before it"));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn aliases_are_renumbered_there_and_back(instructions in instructions()) {
        let unit = encode(UnitName::Program(0), &instructions).expect("valid");
        let there: Vec<u16> = (0..=u16::MAX).map(|place| place.wrapping_add(7)).collect();
        let back: Vec<u16> = (0..=u16::MAX).map(|place| place.wrapping_sub(7)).collect();
        let moved = unit.renumber_aliases(&there).expect("every alias has a place");
        prop_assert_eq!(moved.words.len(), unit.words.len());
        prop_assert_eq!(moved.renumber_aliases(&back).expect("every alias has a place"), unit);
    }
}

#[test]
fn an_alias_without_a_place_is_refused() {
    let unit = one(command::PRINT, vec![Node::Alias { index: 2, parens: 0 }.into()]).expect("valid");
    let refused = unit.renumber_aliases(&[5, 4]).map_err(|error| error.to_string());
    assert_eq!(refused, Err("PROG0, word 0: alias 2 is referred to, the image defines 2".to_owned()));
    let moved = unit.renumber_aliases(&[5, 4, 9]).and_then(|unit| unit.decode()).expect("renumbered");
    assert_eq!(moved[0].items[0].node, Node::Alias { index: 9, parens: 0 });
}
