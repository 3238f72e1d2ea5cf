//! What holds for every program.

mod support;

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
