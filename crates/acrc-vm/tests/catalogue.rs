//! Every operator and every function of the catalogue computes a value and refuses something, at its own place.

mod support;

use std::collections::BTreeSet;

use acrc_catalog::{Operator, UnaryOperator, all_functions};
use acrc_vm::Stop;
use support::{Machine, value};

const NUMBER: &str = "a number is needed here, this is a string";
const STRING: &str = "a string is needed here, this is a number";

/// Operator, an expression, what it prints, an expression that faults, its fault.
const OPERATORS: &[(&str, &str, &str, &str, &str)] = &[
    ("**", "2 ** 3 ** 2", "64", "(-8) ** 0.5", "** has no result for -8"),
    ("^", "2 ^ 0.5 * 2 ^ 0.5", "2", "0 ^ -2", "division by zero"),
    ("*", "2147483647 * 2", "-2", "1e200 * 1e200", "the result of * is beyond the range of numbers"),
    ("/", "BIT 40 / 4 + 1 / 4", "0.25", "1 / (LV0 - 7)", "division by zero"),
    ("MOD", "-17 MOD 5 * 2", "-4", "LV0 MOD 0.9", "division by zero"),
    ("+", "2147483647 + LV0", "-2147483642", "LV0 + \"7\"", NUMBER),
    ("-", "-2147483648 - 1", "2147483647", "$V0 - \"A\"", NUMBER),
    ("<<", "1 + 1 << 3", "16", "1 << \"3\"", NUMBER),
    (">>", "-16 >> 2", "-4", "\"16\" >> 2", NUMBER),
    ("=", "LV0 = 7.0", "-1", "LV0 = \"7\"", NUMBER),
    ("<>", "SV1 <> 0.1", "0", "\"7\" <> LV0", NUMBER),
    ("<", "-1 < BIT 40", "-1", "P0 < \"1\"", NUMBER),
    (">", "DV0 > DV1", "-1", "\"b\" > SV0", NUMBER),
    ("<=", "0.25 <= DV0", "-1", "DV0 <= $V0", NUMBER),
    (">=", "\"b\" >= \"a\"", "-1", "$V0 >= 1", NUMBER),
    ("AND", "12 AND 10.9", "8", "1 AND $V0", NUMBER),
    ("NAND", "12 NAND 10", "-9", "$V0 NAND 1", NUMBER),
    ("OR", "12 OR 3", "15", "1 OR $V0", NUMBER),
    ("NOR", "12 NOR 3", "-16", "$V0 NOR 1", NUMBER),
    ("XOR", "12 XOR 10", "6", "1 XOR \"1\"", NUMBER),
    ("XNOR", "12 XNOR 10", "-7", "\"1\" XNOR 1", NUMBER),
    ("NOT", "NOT 0.9", "-1", "NOT $V0", NUMBER),
    ("unary -", "-(LV0 - 10)", "3", "-\"3\"", NUMBER),
    ("unary +", "+P38912", "5", "+$V0", NUMBER),
];

/// Function, an expression, what it prints, an expression that faults, its fault.
const FUNCTIONS: &[(&str, &str, &str, &str, &str)] = &[
    ("SIN", "sin(1.5707963267949)", "1", "SIN($V0)", NUMBER),
    ("COS", "COS(LV0 - 7)", "1", "COS(\"0\")", NUMBER),
    ("TAN", "TAN(0.5)", "0.54630248984379", "TAN($V0)", NUMBER),
    ("COT", "COT(0.5)", "1.83048772171245", "COT(0)", "COT has no result for 0"),
    ("ASIN", "ASIN(0.5) * 6", "3.14159265358979", "ASIN(1.5)", "ASIN has no result for 1.5"),
    ("ACOS", "ACOS(0.5) * 3", "3.14159265358979", "ACOS(-2)", "ACOS has no result for -2"),
    ("ATAN", "ATAN(-1) * 4", "-3.14159265358979", "ATAN($V0)", NUMBER),
    ("ACOT", "ACOT(0) * 2", "3.14159265358979", "ACOT($V0)", NUMBER),
    ("SINH", "SINH(1)", "1.1752011936438", "SINH(1000)", "SINH has no result for 1000"),
    ("COSH", "COSH(1)", "1.54308063481524", "COSH(1000)", "COSH has no result for 1000"),
    ("TANH", "TANH(1000)", "1", "TANH($V0)", NUMBER),
    ("COTH", "COTH(1000)", "1", "COTH(0)", "COTH has no result for 0"),
    ("ASINH", "ASINH(0)", "0", "ASINH($V0)", NUMBER),
    ("ACOSH", "ACOSH(1)", "0", "ACOSH(0.5)", "ACOSH has no result for 0.5"),
    ("ATANH", "ATANH(0)", "0", "ATANH(1)", "ATANH has no result for 1"),
    ("ACOTH", "ACOTH(2)", "0.549306144334055", "ACOTH(1)", "ACOTH has no result for 1"),
    ("ABS", "ABS(LV1)", "3", "ABS($V0)", NUMBER),
    ("ABSF", "ABSF(LV1)", "3", "ABSF($V0)", NUMBER),
    ("CEIL", "CEIL(-1.5)", "-1", "CEIL($V0)", NUMBER),
    ("FLOOR", "FLOOR(-1.5)", "-2", "FLOOR($V0)", NUMBER),
    ("ROUND", "ROUND(-1.5)", "-2", "ROUND($V0)", NUMBER),
    ("TRUNC", "TRUNC(-1.5)", "-1", "TRUNC($V0)", NUMBER),
    ("LN", "LN(1)", "0", "LN(-1)", "LN has no result for -1"),
    ("LOG", "LOG(0.01)", "-2", "LOG(0)", "LOG has no result for 0"),
    ("SQRT", "SQRT(DV0)", "0.5", "SQRT(LV1)", "SQRT has no result for -3"),
    ("RND", "RND(1)", "0", "RND(0)", "RND has no result for 0"),
    ("EXP", "EXP(0)", "1", "EXP(1000)", "EXP has no result for 1000"),
    ("ASC", "ASC($V0)", "65", "ASC(65)", STRING),
    ("CHR$", "CHR$(65.9)", "A", "CHR$(-1)", "CHR$ has no result for -1"),
    ("GETCH", "GETCH(1)", "107", "GETCH($V0)", NUMBER),
    ("INKEY$", "INKEY$(1)", "k", "INKEY$($V0)", NUMBER),
    ("INSTR", "INSTR($V0, \"is\")", "3", "INSTR($V0, \"x\", 0)", "INSTR has no result for 0"),
    ("KBHIT", "KBHIT(1)", "-1", "KBHIT($V0)", NUMBER),
    ("LCASE$", "LCASE$($V0)", "axis", "LCASE$(1)", STRING),
    ("LEFT$", "LEFT$($V0, 1)", "A", "LEFT$($V0, -1)", "LEFT$ has no result for -1"),
    ("LEN", "LEN($V1)", "0", "LEN(LV0)", STRING),
    ("MID$", "MID$($V0, 2, 1)", "x", "MID$($V0, 0)", "MID$ has no result for 0"),
    ("RIGHT$", "RIGHT$($V0, 1)", "s", "RIGHT$($V0, -1)", "RIGHT$ has no result for -1"),
    ("SPACE$", "SPACE$(1) + \".\"", " .", "SPACE$(70000)", "SPACE$ has no result for 70000"),
    ("STR$", "STR$(DV1)", "-1.5", "STR$($V0)", NUMBER),
    ("STRING$", "STRING$(2, 65)", "AA", "STRING$(-1, 65)", "STRING$ has no result for -1"),
    ("UCASE$", "UCASE$($V0)", "AXIS", "UCASE$(1)", STRING),
    ("VAL", "VAL(\"2.5\") + 1", "3.5", "VAL(2.5)", STRING),
];

/// Nothing is known about them but their names.
const UNKNOWN: &[&str] = &["DATE$", "TIME$"];

/// What an expression prints while keys wait at the devices.
fn value_with_keys(expression: &str) -> String {
    let mut machine = Machine::new(&format!("DIM $V(1,4)\nPRINT {expression}"));
    machine.bench.keys.extend(*b"key");
    assert_eq!(machine.finish(), Stop::Ended, "{expression}");
    machine.bench.output.trim_end_matches("\r\n").to_owned()
}

fn check(rows: &[(&str, &str, &str, &str, &str)]) {
    for (name, expression, expected, wrong, fault) in rows {
        let device = ["GETCH", "INKEY$", "KBHIT"].contains(name);
        let found = if device { value_with_keys(expression) } else { value(expression) };
        assert_eq!(found, *expected, "{expression}");
        assert_eq!(value(wrong), format!("{fault} [line 6, statement 1]"), "{wrong}");
    }
}

#[test]
fn every_operator_has_a_value_and_a_fault() {
    check(OPERATORS);
    let tested: BTreeSet<&str> = OPERATORS.iter().map(|row| row.0.trim_start_matches("unary ")).collect();
    for operator in Operator::ALL {
        assert!(tested.contains(operator.symbol()), "{} is not tested", operator.symbol());
    }
    for operator in UnaryOperator::ALL {
        assert!(tested.contains(operator.symbol()), "{} is not tested", operator.symbol());
    }
}

#[test]
fn every_function_has_a_value_and_a_fault() {
    check(FUNCTIONS);
    let tested: BTreeSet<&str> = FUNCTIONS.iter().map(|row| row.0).chain(UNKNOWN.iter().copied()).collect();
    for function in all_functions() {
        assert!(tested.contains(function.name), "{} is not tested", function.name);
    }
}

#[test]
fn functions_of_which_nothing_is_known_are_refused() {
    for name in UNKNOWN {
        let fault = format!("{name} cannot be evaluated: its behaviour is not documented [line 6, statement 1]");
        assert_eq!(value(&format!("{name}()")), fault);
    }
}
