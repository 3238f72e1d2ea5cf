//! The tables as others rely on them.

use std::collections::BTreeSet;

use acrc_catalog::{
    CommandId, Confidence, FunctionId, Keyword, MessageId, ObjectKind, OperandClass, Operator, Shape, UnaryOperator,
    ValueType, all_commands, all_functions, all_operands, all_operators, command, default_model, function, message,
    model, models,
};

#[test]
fn operation_codes_fit_ten_bits_and_lead_back() {
    for row in all_commands() {
        assert!((1..=1023).contains(&row.id.0));
        assert_eq!(CommandId::from_opcode(row.id.0).map(CommandId::info), Some(row));
    }
    for unused in [0, 1024, u16::MAX] {
        assert_eq!(CommandId::from_opcode(unused), None);
    }
}

/// Images store these numbers: a changed number breaks every stored image.
#[test]
fn stored_numbers_are_stable() {
    assert_eq!((command::QUESTION.0, command::AXIS_MOVE.0, command::JOG_HOME.0, command::CMT_MAX.0), (1, 5, 329, 402));
    assert_eq!((function::SIN.0, function::RND.0, function::CHR_DOLLAR.0), (1, 25, 28));
    assert_eq!((Operator::Pow.id(), Operator::Eq.id(), Operator::Xnor.id(), UnaryOperator::Not.id()), (0, 8, 19, 2));
    assert_eq!((OperandClass::Parameter.id(), OperandClass::Bit.id(), OperandClass::StringA.id()), (0, 1, 9));
    assert_eq!((ObjectKind::Axis.id(), ObjectKind::Com.id(), Keyword::As.id(), Keyword::DacStep.id()), (0, 16, 0, 11));
    assert_eq!(message::IN_MOTION, MessageId(4));
}

#[test]
fn ids_lead_back() {
    for operator in all_operators() {
        assert_eq!(Operator::from_id(operator.id()), Some(operator));
        assert_eq!(Operator::from_symbol(operator.symbol()), Some(operator));
    }
    for row in all_functions() {
        assert_eq!(FunctionId::from_id(row.id.id()), Some(row.id));
        assert_eq!(row.argument_types.len(), usize::from(row.max_args));
    }
    assert_eq!((Operator::from_id(20), FunctionId::from_id(0), MessageId::from_id(0)), (None, None, None));
}

#[test]
fn ranks_of_operators() {
    let tighter = |left: Operator, right: Operator| left.precedence() < right.precedence();
    let ladder =
        [Operator::Pow, Operator::Mul, Operator::Add, Operator::Shl, Operator::Lt, Operator::And, Operator::Or];
    assert!(ladder.windows(2).all(|pair| tighter(pair[0], pair[1])));
    assert_eq!((Operator::Pow.precedence(), Operator::Or.precedence(), UnaryOperator::Not.precedence()), (2, 8, 1));
    assert_eq!((Operator::from_symbol("^"), Operator::from_symbol("mod")), (Some(Operator::Pow), Some(Operator::Mod)));
    assert_eq!((Operator::Add.confidence(), Operator::Shl.confidence()), (Confidence::High, Confidence::Low));
}

#[test]
fn operand_classes() {
    assert_eq!(OperandClass::Lv.value_type(), Some(ValueType::Long));
    assert_eq!(OperandClass::Parameter.value_type(), None);
    assert!(OperandClass::StringA.is_array() && !OperandClass::StringV.is_array());
    assert!(all_operands().len() > OperandClass::ALL.len());
}

#[test]
fn shapes_and_counts() {
    let counts = |id: CommandId| {
        let row = id.info();
        (row.shape, row.min_args, row.max_args, row.tuple_min, row.tuple_max, row.bare_axis)
    };
    assert_eq!(counts(command::DWL), (Shape::Value, 1, 1, 0, 0, false));
    assert_eq!(counts(command::ACC), (Shape::Value, 0, 1, 0, 0, false));
    assert_eq!(counts(command::MSEEK), (Shape::AxisValues, 1, 255, 2, 2, false));
    assert_eq!(counts(command::SLM), (Shape::AxisValues, 0, 255, 1, 2, true));
    assert_eq!(counts(command::SINE), (Shape::Move, 1, 255, 4, 4, false));
    assert_eq!(counts(command::JOG_HOME), (Shape::AxisValues, 1, 255, 1, 1, false));
    assert_eq!(counts(command::JOG), (Shape::Parent, 0, 0, 0, 0, false));
    assert_eq!(counts(command::END), (Shape::None, 0, 0, 0, 0, false));
    assert_eq!(counts(command::DIM_STRING_V), (Shape::Dim, 0, 2, 0, 0, false));
}

#[test]
fn families() {
    let words: Vec<&str> = command::GEAR.info().daughters.iter().map(|daughter| daughter.info().word).collect();
    assert!(words.contains(&"RATIO") && words.contains(&"ON"));
    assert_eq!(command::GEAR_ON_TRG.info().parent, Some(command::GEAR_ON));
    assert_eq!(command::ENDIF.info().belongs_to, Some(command::IF));
    assert!(command::IF.info().parts.contains(&command::ELSEIF));
}

#[test]
fn levels() {
    let vel = command::VEL.info().levels;
    assert!(!vel.sys() && vel.prog() && vel.plc());
    assert_eq!(command::ESAVE.info().levels.names().collect::<Vec<_>>(), ["sys"]);
    assert_eq!(command::APOSTROPHE.info().levels.bits(), 0);
}

/// A parent stands alone only where its daughters are optional, and what is unknown is never strict.
#[test]
fn rows_are_consistent() {
    for row in all_commands() {
        if row.shape == Shape::Parent {
            assert!(row.daughter_required && !row.daughters.is_empty(), "{}", row.name);
        }
        if row.bare_axis || matches!(row.shape, Shape::Axes | Shape::AxisValues | Shape::AxisSources | Shape::Move) {
            assert!(row.takes_axes, "{}", row.name);
        }
        assert!(
            !row.summary.ends_with('.') && row.summary.chars().next().is_some_and(char::is_uppercase),
            "{}",
            row.name
        );
    }
}

#[test]
fn names_of_arguments_appear_in_the_signature() {
    for row in all_commands().filter(|row| !row.name.starts_with("CONFIG")) {
        for argument in row.arguments.iter().filter(|argument| argument.name.len() > 1) {
            assert!(
                row.signature.contains(argument.name) || row.confidence == Confidence::Low,
                "{}: {}",
                row.name,
                argument.name
            );
        }
    }
}

#[test]
fn models_by_name() {
    assert_eq!(default_model().name, "ACR9000");
    assert_eq!(model("acr1505").map(|model| (model.masters, model.slaves)), Some((16, 16)));
    assert_eq!(model("ACR1500").and_then(|model| model.system_pointer), Some(0x00C0_8008));
    assert_eq!(default_model().system_pointer, None, "no document gives one");
    assert_eq!(model("ACR1"), None);
    assert_eq!(models().iter().map(|model| model.name).collect::<BTreeSet<_>>().len(), models().len());
    assert!(models().iter().all(|model| model.confidence == Confidence::High || model.note.contains("assumed")));
}

#[test]
fn known_texts_of_the_controller() {
    assert_eq!(message::REDIMENSIONED_BLOCK.text(), "Re-dimensioned block");
    assert_eq!(message::UNKNOWN_COMMAND.text(), "Unknown Command");
}
