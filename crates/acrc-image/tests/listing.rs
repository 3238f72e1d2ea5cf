//! The lister takes whatever the verifier lets through.

mod common;

use acrc_catalog::{OperandClass, Operator, UnaryOperator, command};
use acrc_image::dump::dump;
use acrc_image::list::{ListOptions, hidden_line_number, list, list_annotated};
use acrc_image::{
    Alias, Instruction, Item, Mark, Node, Separator, UnitName, encode, format_double, format_single, integer, negate,
    real,
};
use common::instructions;
use proptest::prelude::*;

fn aliases() -> Vec<Alias> {
    let alias = |name: &str| Alias { name: name.to_owned(), target: Node::scalar(OperandClass::Bit, 128) };
    ["Ready", "Busy", "Open", "Closed"].into_iter().map(alias).collect()
}

fn statement(separator: Separator, command: acrc_catalog::CommandId, items: Vec<Item>) -> Instruction {
    Instruction { address: 0, separator, command, items }
}

fn listed(instructions: &[Instruction]) -> String {
    let unit = encode(UnitName::Program(0), instructions).expect("valid");
    list(&unit, &aliases(), &ListOptions::default()).expect("valid")
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn everything_valid_can_be_listed_and_dumped(instructions in instructions(), line_numbers in any::<bool>()) {
        let unit = encode(UnitName::Program(0), &instructions).expect("generated statements are valid");
        let listed = list(&unit, &aliases(), &ListOptions { line_numbers });
        prop_assert!(listed.is_ok());
        let annotated = list_annotated(&unit, &aliases(), &ListOptions { line_numbers });
        prop_assert!(annotated.is_ok());
        let words = dump(&unit).expect("generated statements are valid");
        prop_assert_eq!(words.lines().filter(|line| !line.starts_with("pool")).count(), unit.words.len());
    }

    #[test]
    fn a_single_is_read_as_it_was_listed(text in "[0-9]{1,7}|[0-9]{1,3}\\.[0-9]{1,4}|[1-9](\\.[0-9]{1,6})?e-?[0-9]{1,2}") {
        let text = if text.contains(['.', 'e']) { text } else { format!("{text}.") };
        if let Some(Node::Single(value)) = real(&text) {
            prop_assert_eq!(real(&format_single(value)), Some(Node::Single(value)));
        }
    }

    #[test]
    fn a_double_is_read_as_it_was_listed(text in "[1-9][0-9]{0,20}\\.[0-9]{1,12}|[1-9]\\.[0-9]{7,17}e-?[0-9]{1,3}") {
        if let Some(Node::Double(value)) = real(&text) {
            let listed = format_double(value);
            let again = if listed.contains(['.', 'e']) { real(&listed) } else { listed.parse().ok().and_then(integer) };
            prop_assert_eq!(again, Some(Node::Double(value)));
        }
    }

    #[test]
    fn a_whole_number_is_exact_or_refused(value in any::<u64>()) {
        match integer(value) {
            Some(Node::Long(long)) => prop_assert_eq!(u64::try_from(long), Ok(value)),
            Some(Node::Double(double)) => prop_assert_eq!(format_double(double), value.to_string()),
            other => prop_assert!(other.is_none() && value > 1 << 53),
        }
    }
}

#[test]
fn numbers_are_singles_up_to_seven_digits() {
    let cases = [
        ("0.0000001234567", Node::Single(1.234_567e-7), "1.234567e-7"),
        ("1234567.", Node::Single(1_234_567.0), "1234567."),
        ("12345678.", Node::Double(12_345_678.0), "12345678.0"),
        ("5.0000000", Node::Double(5.0), "5.0000000"),
        ("1e10", Node::Single(1e10), "1e10"),
        ("1e39", Node::Double(1e39), "1e39"),
        ("1e-40", Node::Double(1e-40), "1e-40"),
        ("0.000", Node::Single(0.0), "0.0"),
        ("1.0000000e-400", Node::Single(0.0), "0.0"),
        ("1e-005", Node::Single(1e-5), "1e-5"),
    ];
    for (text, node, shown) in cases {
        assert_eq!(real(text), Some(node.clone()), "{text}");
        let out = listed(&[statement(Separator::Line, command::DWL, vec![node.into()])]);
        assert_eq!(out, format!("DWL {shown}\n"));
    }
    assert_eq!(real("1e400"), None);
}

#[test]
fn a_sign_belongs_to_its_number() {
    assert_eq!(negate(Node::Long(516)), Node::Long(-516));
    assert_eq!(negate(Node::Double(2_147_483_648.0)), Node::Long(i32::MIN));
    assert_eq!(negate(Node::Long(i32::MIN)), Node::Long(i32::MIN), "longs wrap");
    let zero = negate(Node::Long(0));
    assert!(matches!(zero, Node::Unary { op: UnaryOperator::Minus, .. }));
    assert_eq!(listed(&[statement(Separator::Line, command::INH, vec![zero.into()])]), "INH -0\n");
}

#[test]
fn a_tree_that_no_text_gives_is_listed_with_the_parentheses_it_needs() {
    let binary = |op, left, right| Node::Binary { op, left: Box::new(left), right: Box::new(right), parens: 0 };
    let sum = || binary(Operator::Add, Node::scalar(OperandClass::Lv, 0), Node::Long(1));
    let product = binary(Operator::Mul, sum(), sum());
    let difference = binary(Operator::Sub, sum(), sum());
    let complement = Node::Unary { op: UnaryOperator::Not, operand: Box::new(sum()), parens: 0 };
    let shown = |node: Node| listed(&[statement(Separator::Line, command::PRINT, vec![node.into()])]);
    assert_eq!(shown(product), "PRINT (LV0 + 1) * (LV0 + 1)\n");
    assert_eq!(shown(difference), "PRINT LV0 + 1 - (LV0 + 1)\n");
    assert_eq!(shown(complement), "PRINT NOT (LV0 + 1)\n");
}

#[test]
fn blocks_are_indented_with_the_line_that_closes_them() {
    let condition = || vec![Item { node: Node::Long(1), mark: Mark::None }];
    let line = |command, items| statement(Separator::Line, command, items);
    let out = listed(&[
        line(command::ENDIF, vec![]),
        line(command::WHILE, condition()),
        line(command::IF, condition()),
        line(command::BREAK, vec![]),
        line(command::ENDIF, vec![]),
        line(command::WEND, vec![]),
        line(command::IF, vec![Item { node: Node::Long(1), mark: Mark::Comma }]),
        statement(Separator::Then, command::END, vec![]),
        line(command::END, vec![]),
    ]);
    assert_eq!(out, "ENDIF\nWHILE (1)\n    IF (1)\n        BREAK\n        ENDIF\n    WEND\nIF (1) THEN END\nEND\n");
}

#[test]
fn lines_without_a_number_have_the_next_multiple_of_ten() {
    assert_eq!([0, 5, 10, 19, 20].map(hidden_line_number), [10, 10, 20, 20, 30]);
    assert_eq!(hidden_line_number(u32::MAX), u32::MAX);
}

#[test]
fn flags_and_parameters_are_named_above_their_line() {
    let alias = Node::Alias { index: 0, parens: 0 };
    let line = |command, items| statement(Separator::Line, command, items);
    let sum = Node::Binary {
        op: Operator::Add,
        left: Box::new(Node::scalar(OperandClass::Parameter, 12_288)),
        right: Box::new(Node::scalar(OperandClass::Parameter, 5)),
        parens: 0,
    };
    let instructions = [
        line(command::IF, vec![alias.into()]),
        line(command::INH, vec![Node::Long(-516).into()]),
        statement(Separator::Colon, command::CLR, vec![Node::Long(516).into()]),
        line(command::ENDIF, vec![]),
        line(command::PRINT, vec![sum.into()]),
        line(command::SET, vec![Node::Long(i32::MIN).into()]),
    ];
    let unit = encode(UnitName::Program(0), &instructions).expect("valid");
    let aliases = [Alias { name: "Killed".to_owned(), target: Node::scalar(OperandClass::Bit, 8467) }];
    let listed = list_annotated(&unit, &aliases, &ListOptions { line_numbers: true }).expect("valid");
    insta::assert_snapshot!(listed);
}
