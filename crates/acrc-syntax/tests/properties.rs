//! What holds for every text and every file, however broken.

mod support;

use acrc_syntax::ast::{Expr, ExprKind};
use acrc_syntax::{DecodeError, SourceText, parse, parse_expression};
use proptest::prelude::*;

/// Pieces of programs: together they reach every part of the reader, in every wrong order.
const PIECES: [&str; 96] = [
    "X",
    "Y",
    "AXIS0",
    "AXIS",
    "ENC2",
    "PROG0",
    "MASTER1",
    "CMT0",
    "SLAVE0",
    "P0",
    "P",
    "LV1",
    "LA0",
    "$V0",
    "$V",
    "$",
    "BIT",
    "BIT24",
    "BIT 32",
    "SIN",
    "CHR$",
    "RND(",
    "INKEY$(1)",
    "VEL",
    "ACC10",
    "SET",
    "CLR 5",
    "INH -",
    "TRG",
    "INT",
    "MOV",
    "SINE",
    "CIRCW",
    "JOG",
    "JOG ABS",
    "GEAR SRC",
    "CAM ON",
    "DRIVE ON",
    "RES",
    "PPU",
    "SRC",
    "FLASH",
    "DIM",
    "DIM LV",
    "DIM PROG",
    "#DEFINE",
    "#",
    "Name",
    "Name1",
    "LongName",
    "_",
    "_Label",
    "GOTO",
    "GOSUB 100",
    "IF",
    "IF (P0)",
    "THEN",
    "THENP0",
    "ELSE",
    "ELSE IF",
    "ENDIF",
    "FOR",
    "TO",
    "STEP",
    "NEXT",
    "WHILE",
    "WEND",
    "PRINT",
    "?",
    "USING",
    "INPUT",
    "OPEN",
    "AS",
    "CLOSE",
    "REM",
    "'",
    "ATTACH",
    "CONFIG",
    "NONE",
    "ALL",
    "IHPOS",
    "MASK",
    "(",
    ")",
    ",",
    ";",
    ":",
    "\n",
    "\r\n",
    "=",
    "/",
    "-",
    "+ 1",
    "AND",
    "NOT",
    "\"a:b\"",
];

/// What stands between two pieces.
const GLUE: [&str; 5] = ["", " ", " ", "\t", "\u{A0}"];

/// Pieces that are no part of the language at all.
const ODD: [&str; 16] = [
    "\"open",
    "\u{201C}a\u{201D}",
    "\u{2013}5",
    "\u{2019}",
    "\u{2026}",
    "@",
    "1e",
    "1e-005",
    "..",
    "<>",
    "<<",
    "**",
    "99999999999999999999999",
    "\u{FEFF}",
    "äß",
    "\r",
];

fn soup() -> impl Strategy<Value = String> {
    let piece = prop_oneof![12 => prop::sample::select(PIECES.as_slice()), 1 => prop::sample::select(ODD.as_slice())];
    prop::collection::vec((piece, prop::sample::select(GLUE.as_slice())), 0..60)
        .prop_map(|pieces| pieces.into_iter().flat_map(|(piece, glue)| [piece, glue]).collect())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_order_of_words_is_read(text in soup()) {
        support::checked(&text);
    }

    #[test]
    fn any_text_is_read(text in "\\PC{0,200}") {
        support::checked(&text);
    }

    #[test]
    fn any_text_is_read_as_an_expression(text in soup()) {
        let (expression, errors) = parse_expression(&text);
        let is_broken = expression.kind == ExprKind::Error;
        let has_error = errors.iter().any(|error| error.severity == acrc_diagnostics::Severity::Error);
        prop_assert!(!is_broken || has_error);
    }

    #[test]
    fn the_result_depends_on_the_text_alone(text in soup()) {
        prop_assert_eq!(parse(&text), parse(&text));
    }

    #[test]
    fn any_file_is_written_back_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        if let Ok(source) = SourceText::decode(&bytes) {
            prop_assert_eq!(source.encode(), bytes);
            support::checked(&source.text);
        }
    }

    #[test]
    fn any_western_text_is_written_back(bytes in prop::collection::vec(prop_oneof![0x20_u8..0x7F, 0x80_u8..], 0..200)) {
        // By chance the bytes may be UTF-8 or UTF-16, and have control characters then.
        let wide = bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]);
        let controls = std::str::from_utf8(&bytes).is_ok_and(|text| text.contains(char::is_control));
        match SourceText::decode(&bytes) {
            Ok(source) => prop_assert_eq!(source.encode(), bytes),
            Err(error) => prop_assert!(wide || controls, "{}", error),
        }
    }

    #[test]
    fn any_wide_text_is_written_back(units in prop::collection::vec(any::<u16>(), 0..100), big in any::<bool>()) {
        let to_bytes = if big { u16::to_be_bytes } else { u16::to_le_bytes };
        let bytes: Vec<u8> = [0xFEFF].into_iter().chain(units).flat_map(to_bytes).collect();
        match SourceText::decode(&bytes) {
            Ok(source) => prop_assert_eq!(source.encode(), bytes),
            Err(DecodeError::Binary { offset }) => prop_assert!(offset < bytes.len()),
            Err(error) => return Err(TestCaseError::fail(error.to_string())),
        }
    }
}

/// A statement that is right, whatever its numbers are.
fn statement() -> impl Strategy<Value = String> {
    let value = || (0_u32..5000, -90_i32..90, expression());
    prop_oneof![
        value().prop_map(|(a, b, _)| format!("X{a} Y {b}")),
        value().prop_map(|(a, b, _)| format!("X/{b} SINE Y(0,90,{a},100)")),
        value().prop_map(|(a, _, e)| format!("P{a} = {e}")),
        value().prop_map(|(a, _, e)| format!("LA0({e})={a}")),
        value().prop_map(|(a, b, _)| format!("ACC{a} JOG VEL X {b}")),
        value().prop_map(|(a, _, e)| format!("SET {a} CLR ({e})")),
        value().prop_map(|(a, _, e)| format!("PRINT #1, \"x:\"; {e}; P{a}")),
        value().prop_map(|(a, _, e)| format!("IF ({e}) THEN SET {a}")),
        value().prop_map(|(a, _, e)| format!("FOR LV0 = {e} TO {a} STEP 1")),
        value().prop_map(|(a, _, e)| format!("AXIS1 SLM ({a}, {e})")),
        value().prop_map(|(a, _, e)| format!("IHPOS -P{a} ({e}, 5)")),
        value().prop_map(|(a, ..)| format!("GOTO Label{a}")),
        Just("DRIVE ON X Y AXIS2".to_owned()),
        Just("ENDIF".to_owned()),
    ]
}

fn expression() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        (0_u32..9000).prop_map(|number| number.to_string()),
        (0_u32..9000).prop_map(|number| format!("P{number}")),
        (0_u32..9000).prop_map(|number| format!("BIT {number}")),
        Just("LV3".to_owned()),
        Just("1.5e-3".to_owned()),
        Just("Height".to_owned()),
    ];
    leaf.prop_recursive(4, 24, 2, |inner| {
        let operator =
            prop::sample::select(vec!["+", " - ", "*", " / ", " MOD ", " AND ", " OR ", " = ", "<>", " << ", "**"]);
        prop_oneof![
            (inner.clone(), operator, inner.clone())
                .prop_map(|(left, operator, right)| format!("{left}{operator}{right}")),
            inner.clone().prop_map(|inner| format!("({inner})")),
            inner.clone().prop_map(|inner| format!("-{inner}")),
            inner.clone().prop_map(|inner| format!("NOT ({inner})")),
            inner.clone().prop_map(|inner| format!("SQRT({inner})")),
            inner.prop_map(|inner| format!("DA0({inner})")),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn right_programs_have_no_errors(statements in prop::collection::vec(statement(), 1..12), colons in any::<bool>()) {
        let text = statements.join(if colons { " : " } else { "\n" });
        let tree = support::checked(&text);
        prop_assert!(tree.errors().is_empty(), "{}\n{:#?}", text, tree.errors());
    }

    #[test]
    fn ranks_of_operators_are_kept(text in expression()) {
        let (expression, errors) = parse_expression(&text);
        prop_assert!(errors.is_empty(), "{}\n{:#?}", text, errors);
        prop_assert_eq!(expression.span.range(), 0..text.len());
        check_ranks(&expression);
    }
}

/// Operands and operators follow each other in the order of the text, what binds tighter lies deeper, and equal ranks
/// lean to the left. There is only one such tree.
fn check_ranks(expression: &Expr) {
    let rank = |operand: &Expr| match operand.kind {
        ExprKind::Binary(operator, ..) => operator.precedence(),
        _ => 0,
    };
    match &expression.kind {
        ExprKind::Binary(operator, place, operands) => {
            let [left, right] = &**operands;
            assert!(left.span.end <= place.start && place.end <= right.span.start);
            assert!(rank(left) <= operator.precedence() && rank(right) < operator.precedence());
            check_ranks(left);
            check_ranks(right);
        }
        ExprKind::Unary(operator, operand) => {
            assert!(expression.span.start < operand.span.start && rank(operand) < operator.precedence());
            check_ranks(operand);
        }
        ExprKind::Paren(inner) => check_ranks(inner),
        ExprKind::Call(_, arguments) => arguments.iter().for_each(check_ranks),
        ExprKind::Operand(operand) => {
            check_ranks(&operand.index);
            operand.element.iter().for_each(check_ranks);
        }
        _ => {}
    }
}
