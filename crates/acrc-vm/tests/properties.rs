//! What holds for every program.

mod support;

use acrc_catalog::{Keyword, OperandClass, Operator, UnaryOperator, command};
use acrc_image::{Alias, Instruction, Item, Mark, Node, Separator, UnitBuilder, UnitName};
use acrc_vm::{Budget, Code, Stop};
use proptest::prelude::*;
use support::{Machine, output, value};

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
        const OPERATORS: &[&str] = &["+", "-", "*", "/", "**", " MOD ", "<<", ">>", "=", "<>", "<", ">", "<=", ">=", " AND ", " OR ", " XOR "];
        const FUNCTIONS: &[&str] = &["SIN", "SQRT", "ABS", "ROUND", "LN", "RND", "STR$", "VAL", "LEN", "CHR$", "-", "NOT "];
        prop_oneof![
            4 => (inner.clone(), prop::sample::select(OPERATORS), inner.clone()).prop_map(|(a, op, b)| format!("({a}{op}{b})")),
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
        let text = format!("DIM LV(2)\nLV0 = {a} : LV1 = {b}\nPRINT LV0+LV1; \",\"; LV0-LV1; \",\"; LV0*LV1; \",\"; LV0 MOD LV1; \",\"; LV0 < LV1");
        let expected = format!(
            "{},{},{},{},{}\r\n",
            a.wrapping_add(b), a.wrapping_sub(b), a.wrapping_mul(b), a.wrapping_rem(b), -i32::from(a < b)
        );
        prop_assert_eq!(output(&text), expected);
    }

    #[test]
    fn doubles_agree_with_the_processor(a in -1e6..1e6f64, b in 1e-3..1e6f64) {
        let mut machine = Machine::new("DIM DV(6)\nDV0 = P0 : DV1 = P1\nDV2 = DV0+DV1 : DV3 = DV0-DV1 : DV4 = DV0*DV1 : DV5 = DV0/DV1");
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

/// Any statement, with flow and memory more often than a fair choice would give.
fn instruction() -> impl Strategy<Value = Instruction> {
    let every: Vec<_> = acrc_catalog::all_commands().map(|command| command.id).collect();
    let own = [
        command::ASSIGNMENT,
        command::ASSIGNMENT,
        command::IF,
        command::ENDIF,
        command::ELSE,
        command::WHILE,
        command::WEND,
        command::FOR,
        command::NEXT,
        command::BREAK,
        command::GOTO,
        command::GOSUB,
        command::RETURN,
        command::DIM_LV,
        command::DIM_DV,
        command::DIM_LA,
        command::DIM_STRING_A,
        command::PRINT,
        command::INPUT,
        command::SET,
        command::LABEL,
        command::LINE_NUMBER,
    ];
    let id = prop_oneof![3 => prop::sample::select(own.to_vec()), 1 => prop::sample::select(every)];
    let mark = prop::sample::select(&Mark::ALL[..]);
    let item = prop_oneof![6 => node(), 1 => (0..3u16).prop_map(Node::LabelRef)];
    let items = prop::collection::vec((item, mark).prop_map(|(node, mark)| Item { node, mark }), 0..4);
    let separator = prop::sample::select(&Separator::ALL[..]);
    (separator, id, items).prop_map(|(separator, command, items)| Instruction { address: 0, separator, command, items })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn no_verified_unit_panics(instructions in prop::collection::vec(instruction(), 1..40)) {
        let aliases = [Alias { name: "A".into(), target: Node::scalar(OperandClass::Lv, 1) }];
        let mut builder = UnitBuilder::new(UnitName::Program(0));
        for instruction in &instructions {
            // What cannot be encoded is left out.
            let _ = builder.push(instruction.separator, instruction.command, &instruction.items);
        }
        if let Ok(unit) = builder.finish()
            && let Ok(code) = Code::load(&unit, &aliases)
        {
            let mut machine = Machine::with(code);
            for _ in 0..20 {
                let run = machine.run(Budget::statements(50));
                prop_assert!(run.statements <= 50);
                // A fault ends a real program; here the next statements are tried as well.
                if run.stop == Stop::Ended {
                    break;
                }
            }
        }
    }

    #[test]
    fn no_altered_program_panics(place in any::<prop::sample::Index>(), word: u32, bit in 0..32u32) {
        let text = "DIM LV(3)\nDIM LA(1) : DIM LA0(4)\nFOR LV0 = 0 TO 3\nLA0(LV0) = LV0 * 2 + P0\nIF (LV0 > 1) THEN GOSUB Sub : PRINT LV0\nNEXT\n\
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
