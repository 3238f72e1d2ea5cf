//! What holds for every program.

mod support;

use acrc_catalog::{CommandId, Keyword, OperandClass, Operator, UnaryOperator, command};
use acrc_image::{Alias, Instruction, Item, Mark, Node, Separator, UnitName};
use acrc_vm::{Budget, Code, Stop};
use proptest::prelude::*;
use support::{Machine, output, value};

/// Operators as they are written.
const OPERATORS: &[&str] =
    &["+", "-", "*", "/", "**", " MOD ", "<<", ">>", "=", "<>", "<", ">", "<=", ">=", " AND ", " OR ", " XOR "];

/// Functions and signs in front of one argument.
const FUNCTIONS: &[&str] = &["SIN", "SQRT", "ABS", "ROUND", "LN", "RND", "STR$", "VAL", "LEN", "CHR$", "-", "NOT "];

/// Random expressions over constants, variables of every type, parameters and flags.
fn expression() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        any::<i32>().prop_map(|value| format!("({value})")),
        (-1000.0..1000.0f64).prop_map(|value| format!("({value:.3})")),
        (0..6i32).prop_map(|index| format!("LV{index}")),
        (0..4i32).prop_map(|index| format!("SV{index}")),
        (0..4i32).prop_map(|index| format!("DV{index}")),
        (0..4i32).prop_map(|index| format!("$V{index}")),
        prop_oneof![Just(0), Just(5), Just(38912), Just(39168)].prop_map(|number| format!("P{number}")),
        Just("BIT 32".to_owned()),
        Just("\"text\"".to_owned()),
    ];
    leaf.prop_recursive(5, 64, 3, |inner| {
        prop_oneof![
            4 => (inner.clone(), prop::sample::select(OPERATORS), inner.clone())
                .prop_map(|(left, operator, right)| format!("({left}{operator}{right})")),
            2 => (prop::sample::select(FUNCTIONS), inner.clone()).prop_map(|(f, a)| format!("{f}({a})")),
            1 => inner.clone().prop_map(|a| format!("LV({a})")),
            1 => inner.prop_map(|a| format!("P({a})")),
        ]
    })
}

proptest! {
    #[test]
    fn no_expression_panics(expression in expression()) {
        let _ = value(&expression);
    }

    #[test]
    fn longs_agree_with_wrapping_arithmetic(a: i32, b in any::<i32>().prop_filter("not zero", |b| *b != 0)) {
        let text = format!("DIM LV(2)\nLV0 = {a} : LV1 = {b}\n\
            PRINT LV0+LV1; \",\"; LV0-LV1; \",\"; LV0*LV1; \",\"; LV0 MOD LV1; \",\"; LV0 < LV1");
        let expected = format!(
            "{},{},{},{},{}\r\n",
            a.wrapping_add(b), a.wrapping_sub(b), a.wrapping_mul(b), a.wrapping_rem(b), -i32::from(a < b)
        );
        prop_assert_eq!(output(&text), expected);
    }

    #[test]
    fn doubles_agree_with_the_processor(a in -1e6..1e6f64, b in 1e-3..1e6f64) {
        let mut machine = Machine::new("DIM DV(6)\nDV0 = P0 : DV1 = P1\n\
            DV2 = DV0+DV1 : DV3 = DV0-DV1 : DV4 = DV0*DV1 : DV5 = DV0/DV1");
        machine.bench.parameters.insert(0, acrc_vm::Value::Double(a));
        machine.bench.parameters.insert(1, acrc_vm::Value::Double(b));
        machine.finish();
        let read = |index| {
            let variable = acrc_vm::Reference::Variable { class: acrc_catalog::OperandClass::Dv, index };
            machine.locals.read(variable).unwrap().to_f64().unwrap()
        };
        prop_assert_eq!([read(2), read(3), read(4), read(5)], [a + b, a - b, a * b, a / b]);
    }
}

/// Any node, sensible or not.
fn node() -> impl Strategy<Value = Node> {
    let class = prop::sample::select(OperandClass::ALL);
    let scalar = (class, -1..5i32).prop_map(|(class, index)| Node::scalar(class, index));
    let leaf = prop_oneof![
        any::<i32>().prop_map(Node::Long),
        (-2..9i32).prop_map(Node::Long),
        (-1e6..1e6f32).prop_map(Node::Single),
        (-1e6..1e6f64).prop_map(Node::Double),
        Just(Node::string(*b"text")),
        scalar,
        Just(Node::Word { keyword: Keyword::All, index: None }),
        Just(Node::Alias { index: 0, parens: 0 }),
    ];
    leaf.prop_recursive(4, 24, 3, |inner| {
        let class = prop::sample::select(OperandClass::ALL);
        let operator = prop::sample::select(Operator::ALL);
        let functions: Vec<_> = acrc_catalog::all_functions().map(|function| function.id).collect();
        let boxed = inner.clone().prop_map(Box::new);
        prop_oneof![
            (class.clone(), boxed.clone()).prop_map(|(class, index)| Node::Scalar { class, index, parens: 1 }),
            (class, boxed.clone(), boxed.clone()).prop_map(|(class, array, element)| Node::Array {
                class,
                array,
                element,
                parens: 0
            }),
            (operator, boxed.clone(), boxed.clone()).prop_map(|(op, left, right)| Node::Binary {
                op,
                left,
                right,
                parens: 0
            }),
            (prop::sample::select(UnaryOperator::ALL), boxed.clone()).prop_map(|(op, operand)| Node::Unary {
                op,
                operand,
                parens: 0
            }),
            (prop::sample::select(functions), prop::collection::vec(inner.clone(), 0..4))
                .prop_map(|(function, arguments)| Node::Call { function, arguments, parens: 0 }),
            prop::collection::vec(inner, 2..5).prop_map(Node::Tuple),
            (any::<bool>(), boxed.clone()).prop_map(|(slash, value)| Node::Axis {
                name: "X".parse().unwrap(),
                slash,
                value: Some(value)
            }),
            boxed.prop_map(Node::Device),
        ]
    })
}

/// A statement of any command, if the loader takes it by itself.
fn statement() -> impl Strategy<Value = Vec<Instruction>> {
    const OWN: &[CommandId] = &[
        command::ASSIGNMENT,
        command::DIM_LV,
        command::DIM_DV,
        command::DIM_LA,
        command::DIM_STRING_A,
        command::PRINT,
        command::INPUT,
        command::SET,
        command::RETURN,
        command::BREAK,
    ];
    let every: Vec<_> = acrc_catalog::all_commands().map(|command| command.id).collect();
    let id = prop_oneof![4 => prop::sample::select(OWN), 1 => prop::sample::select(every)];
    let item = (node(), prop::sample::select(&Mark::ALL[..])).prop_map(|(node, mark)| Item { node, mark });
    let items = prop::collection::vec(item, 0..4);
    let made = (prop::bool::ANY, id, items).prop_map(|(line, command, items)| {
        let separator = if line { Separator::Line } else { Separator::Colon };
        Instruction { address: 0, separator, command, items }
    });
    made.prop_map(|instruction| {
        let alone = [instruction];
        if load(&alone).is_some() { alone.to_vec() } else { Vec::new() }
    })
}

/// A line with a command of program flow.
fn flow(command: CommandId, items: Vec<Node>) -> Instruction {
    let items = items.into_iter().map(Item::from).collect();
    Instruction { address: 0, separator: Separator::Line, command, items }
}

/// An expression that can be a condition or a bound.
fn condition() -> impl Strategy<Value = Node> {
    node().prop_filter("an expression", |node| {
        load(&[flow(command::ASSIGNMENT, vec![Node::scalar(OperandClass::Parameter, 0), node.clone()])]).is_some()
    })
}

/// Statements in blocks of any nesting.
fn program() -> impl Strategy<Value = Vec<Instruction>> {
    let plain = prop::collection::vec(statement(), 1..6).prop_map(|statements| statements.concat());
    plain.prop_recursive(4, 48, 4, |inner| {
        let body = prop::collection::vec(inner, 1..4).prop_map(|parts| parts.concat());
        let counter =
            (prop::sample::select(OperandClass::ALL), 0..3i32).prop_map(|(class, index)| Node::scalar(class, index));
        let counter =
            counter.prop_filter("one value", |node| !matches!(node, Node::Scalar { class, .. } if class.is_array()));
        let wrap = |open: Instruction, body: Vec<Instruction>, close: CommandId| {
            [vec![open], body, vec![flow(close, vec![])]].concat()
        };
        prop_oneof![
            (condition(), body.clone()).prop_map(move |(c, body)| wrap(
                flow(command::WHILE, vec![c]),
                body,
                command::WEND
            )),
            (condition(), body.clone()).prop_map(move |(c, body)| wrap(
                flow(command::IF, vec![c]),
                body,
                command::ENDIF
            )),
            (condition(), body.clone(), body.clone()).prop_map(move |(c, first, second)| {
                let branches = [first, vec![flow(command::ELSE, vec![])], second].concat();
                wrap(flow(command::IF, vec![c]), branches, command::ENDIF)
            }),
            (counter, condition(), condition(), body).prop_map(move |(counter, start, end, body)| {
                wrap(flow(command::FOR, vec![counter, start, end]), body, command::NEXT)
            }),
        ]
    })
}

/// Encodes and loads a program; `None` when it is refused.
fn load(instructions: &[Instruction]) -> Option<Code> {
    let aliases = [Alias { name: "A".into(), target: Node::scalar(OperandClass::Lv, 1) }];
    let unit = acrc_image::encode(UnitName::Program(0), instructions).ok()?;
    Code::load(&unit, &aliases).ok()
}

/// `DIM` of some variables of every class.
fn dimensions() -> Vec<Instruction> {
    let sizes = [
        (command::DIM_LV, vec![3]),
        (command::DIM_SV, vec![3]),
        (command::DIM_DV, vec![3]),
        (command::DIM_STRING_V, vec![3, 8]),
        (command::DIM_LA, vec![3]),
        (command::DIM_STRING_A, vec![3]),
    ];
    sizes.into_iter().map(|(command, sizes)| flow(command, sizes.into_iter().map(Node::Long).collect())).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn no_verified_program_panics(program in program(), dimensioned: bool) {
        let instructions = if dimensioned { [dimensions(), program].concat() } else { program };
        let code = load(&instructions);
        prop_assert!(code.is_some(), "a program of statements that load does not load");
        let mut machine = Machine::with(code.unwrap());
        for _ in 0..40 {
            let run = machine.run(Budget::statements(50));
            prop_assert!(run.statements <= 50);
            match run.stop {
                Stop::Ended => break,
                // Such a program mostly consists of faults; the statements behind them count as well.
                Stop::Fault(_) => machine.frame.skip_statement(&machine.code),
                Stop::Blocked | Stop::Budget => {}
            }
        }
    }

    #[test]
    fn no_altered_program_panics(place in any::<prop::sample::Index>(), word: u32, bit in 0..32u32) {
        let text = "DIM LV(3)\nDIM LA(1) : DIM LA0(4)\nFOR LV0 = 0 TO 3\nLA0(LV0) = LV0 * 2 + P0\n\
            IF (LV0 > 1) THEN GOSUB Sub : PRINT LV0\nNEXT\n\
                    WHILE (LV1 < 9)\nLV1 = LV1 + 1\nWEND\nX(LV1) Y/2\nEND\n_Sub\nP1 = SQRT(P0 + 2)\nRETURN";
        let mut unit = support::image(text, true).programs.remove(0);
        let index = place.index(unit.words.len());
        for change in [word, unit.words[index] ^ (1 << bit)] {
            unit.words[index] = change;
            if let Ok(code) = Code::load(&unit, &[]) {
                Machine::with(code).run(Budget::statements(300));
            }
        }
    }
}
