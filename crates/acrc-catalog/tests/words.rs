//! The words of the language: every row is found by its words, nothing else is found.

use acrc_catalog::{
    CommandId, Keyword, ObjectKind, OperandClass, Operator, UnaryOperator, all_commands, all_functions, command,
    daughter, function, word,
};
use proptest::prelude::*;

/// Forms of statements that no word introduces.
const WORDLESS: [CommandId; 6] = [
    command::QUESTION,
    command::APOSTROPHE,
    command::LABEL,
    command::LINE_NUMBER,
    command::AXIS_MOVE,
    command::ASSIGNMENT,
];

#[test]
fn every_command_is_found_by_its_words() {
    for row in all_commands() {
        let found = match row.parent {
            Some(parent) => daughter(parent, row.word),
            None => word(row.name).and_then(|word| word.command),
        };
        let expected = (!row.clause && !WORDLESS.contains(&row.id)).then_some(row.id);
        assert_eq!(found, expected, "{}", row.name);
        if row.parent.is_some() {
            assert!(word(row.word).is_some_and(|word| word.daughter), "{}", row.name);
        }
    }
}

#[test]
fn case_does_not_matter() {
    for row in all_commands().filter(|row| row.parent.is_none() && !row.clause && !WORDLESS.contains(&row.id)) {
        assert_eq!(word(&row.name.to_lowercase()).and_then(|word| word.command), Some(row.id));
    }
    assert_eq!(daughter(command::JOG, "Home"), Some(command::JOG_HOME));
}

#[test]
fn a_word_can_be_several_things() {
    let and = word("and").expect("a word");
    assert_eq!((and.command, and.operator, and.daughter), (Some(command::AND), Some(Operator::And), false));
    let not = word("NOT").expect("a word");
    assert_eq!((not.command, not.unary, not.daughter), (None, Some(UnaryOperator::Not), true));
    let prog = word("PROG").expect("a word");
    assert_eq!((prog.command, prog.object, prog.daughter), (Some(command::PROG), Some(ObjectKind::Prog), true));
    let step = word("Step").expect("a word");
    assert_eq!((step.command, step.keyword), (Some(command::STEP), Some(Keyword::Step)));
    let bit = word("BIT").expect("a word");
    assert_eq!((bit.command, bit.operand), (Some(command::BIT), Some(OperandClass::Bit)));
    let to = word("TO").expect("a word");
    assert_eq!((to.command, to.keyword, to.daughter), (None, Some(Keyword::To), true));
    let string = word("$v").expect("a word");
    assert_eq!((string.operand, string.daughter), (Some(OperandClass::StringV), true));
    assert_eq!(word("INKEY$").and_then(|word| word.function), Some(function::INKEY_DOLLAR));
    assert_eq!(word("#define").and_then(|word| word.command), Some(command::DEFINE));
}

#[test]
fn parts_of_statements_start_none() {
    for part in ["TO", "THEN", "USING", "AS", "ON", "OFF", "ALL", "NONE", "CLOCK", "DACSTEP"] {
        assert_eq!(word(part).map(|word| word.command), Some(None), "{part}");
    }
}

#[test]
fn daughters_belong_to_their_parent() {
    assert_eq!(daughter(command::LD, "NOT"), Some(command::LD_NOT));
    assert_eq!(daughter(command::AND, "LD"), Some(command::AND_LD));
    assert_eq!(daughter(command::CAM_ON, "TRG"), Some(command::CAM_ON_TRG));
    assert_eq!(daughter(command::ELSE, "IF"), Some(command::ELSE_IF));
    assert_eq!(daughter(command::DIM, "$A"), Some(command::DIM_STRING_A));
    assert_eq!(daughter(command::DIM, "COM1"), Some(command::DIM_COM1));
    assert_eq!(daughter(command::CMT, "MAX").and_then(|max| daughter(max, "RPM")), Some(command::CMT_MAX_RPM));
    assert_eq!(daughter(command::PRINT, "USING"), None);
    assert_eq!(daughter(command::VEL, "HOME"), None);
    assert_eq!(daughter(CommandId(0), "HOME"), None);
}

proptest! {
    #[test]
    fn any_text_is_found_exactly_if_some_row_has_it(text in "[A-Za-z$#?_]{0,9}") {
        let upper = text.to_uppercase();
        let known = all_commands().any(|row| row.parent.is_none() && !row.clause && !WORDLESS.contains(&row.id) && row.name == upper);
        prop_assert_eq!(word(&text).is_some_and(|word| word.command.is_some()), known);
        let known = all_functions().any(|row| row.name == upper);
        prop_assert_eq!(word(&text).is_some_and(|word| word.function.is_some()), known);
    }

    #[test]
    fn any_bytes_are_harmless(text in "\\PC{0,12}", parent in 0_u16..1100) {
        let _ = word(&text);
        let _ = daughter(CommandId(parent), &text);
    }
}
