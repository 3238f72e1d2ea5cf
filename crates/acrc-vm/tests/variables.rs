//! Local variables, their memory and their faults (guide, "Variable Memory Allocation" and "How Much Memory?").

mod support;

use acrc_catalog::OperandClass;
use acrc_vm::{Reference, Value};
use support::{Machine, output};

#[test]
fn values_take_the_type_of_their_variable() {
    let program = "DIM LV(2)\nDIM SV(1)\nDIM DV(1)\nDIM $V(1,4)\nLV0 = 2.9\nLV1 = -2.9\nSV0 = 0.1\nDV0 = 1/3\n\
        $V0 = \"abcdef\"\n\
                   PRINT LV0; \" \"; LV1; \" \"; SV0; \" \"; DV0; \" \"; $V0";
    assert_eq!(output(program), "2 -2 0.1 0.333333333333333 abcd\r\n");
}

#[test]
fn a_long_keeps_the_bits_of_an_unsigned_number() {
    let program = "DIM LV(4)\nLV0 = 4294967295\nLV1 = 2147483648.0\nLV2 = 1e20\nLV3 = -1e20\n\
        PRINT LV0; \" \"; LV1; \" \"; LV2; \" \"; LV3";
    assert_eq!(output(program), "-1 -2147483648 2147483647 -2147483648\r\n");
}

#[test]
fn arrays_of_every_class() {
    let program = "DIM LA(2)\nDIM SA(1)\nDIM DA(1)\nDIM $A(1)\nDIM LA1(3)\nDIM SA0(2)\nDIM DA0(2)\n\
        DIM $A0(2,3)\nDIM LV(1)\nLV0 = 1\n\
                   LA1(2) = 7.5\nLA1(LV0) = LA1(2) + LV0\nSA0(LV0) = 0.1\nDA0(0) = SA0(1) * 2\n\
                       $A0(1) = \"word\"\n$A0(0) = $A0(1) + \"!\"\n\
                   PRINT LA1(1); LA(LV0)(2); \" \"; SA0(1); \" \"; DA0(0); \" \"; $A0(0); $A0(1)";
    assert_eq!(output(program), "87 0.1 0.200000002980232 worwor\r\n");
}

#[test]
fn variables_by_computed_number() {
    let program = "DIM LV(3)\nDIM DV(2)\nDIM SV(2)\nDIM $V(2,5)\nLV0 = 1\nLV(LV0 + 1) = 5\nDV(LV0) = 1.5\n\
        SV(LV0) = 0.1\n$V(LV0) = \"x\"\n\
                   PRINT LV2; LV(2); DV1; DV(LV0); SV(LV0); $V(LV0) + $V1";
    assert_eq!(output(program), "551.51.50.1xx\r\n");
}

#[test]
fn memory_is_that_of_the_guide() {
    let cases = [
        ("DIM LV(2)", 8),
        ("DIM SV(3)", 12),
        ("DIM DV(1)", 8),
        ("DIM $V(1,10)", 14),
        ("DIM $V(10,80)", 840),
        ("DIM LA(1)", 8),
        ("DIM LA(1)\nDIM LA0(500)", 8 + 2004),
        ("DIM SA(1)\nDIM SA0(500)", 8 + 2004),
        ("DIM DA(1)\nDIM DA0(3)", 8 + 28),
        ("DIM $A(2)\nDIM $A1(3,10)", 12 + 30),
        ("DIM LV(2)\nCLEAR\nDIM LV(1)", 4),
        ("DIM MBUF(3)", 3 * 136),
        ("DIM LV(2)\nDIM MBUF(3)\nCLEAR MBUF", 8),
        ("CLEAR MBUF\nDIM MBUF(3)\nCLEAR", 0),
    ];
    for (program, bytes) in cases {
        let mut machine = Machine::new(program);
        machine.finish();
        assert_eq!(machine.locals.used(), bytes, "{program}");
        let listed: u64 = machine.locals.dimensions().iter().map(|dimension| dimension.bytes).sum();
        assert_eq!(listed, bytes, "{program}");
    }
}

#[test]
fn clear_frees_the_variables_and_tells_the_host() {
    let mut machine = Machine::new("DIM LV(1)\nLV0 = 5\nCLEAR\nDIM LV(1)\nPRINT LV0");
    machine.finish();
    assert_eq!(machine.bench.output, "0\r\n");
    assert_eq!(machine.bench.log, "CLEAR: \n");
}

#[test]
fn faults_name_the_variable_and_its_limit() {
    let cases = [
        ("LV3 = 1", "LV3 has no memory: no DIM LV was executed"),
        ("DIM LV(2)\nLV3 = 1", "LV3 is outside DIM LV(2)"),
        ("DIM LV(2)\nPRINT LV2", "LV2 is outside DIM LV(2)"),
        ("DIM LV(2)\nLV0 = LV1 + LV2", "LV2 is outside DIM LV(2)"),
        ("DIM LV(1)\nLV0 = -1\nPRINT LV(LV0)", "LV-1 is outside DIM LV(1)"),
        ("DIM LV(2)\nLV(LV5) = 1", "LV5 is outside DIM LV(2)"),
        ("DIM DV(1)\nDV1 = 1", "DV1 is outside DIM DV(1)"),
        ("DIM SV(1)\nPRINT SV1", "SV1 is outside DIM SV(1)"),
        ("SV1 = 2", "SV1 has no memory: no DIM SV was executed"),
        ("DIM $V(1,5)\nPRINT $V1", "$V1 is outside DIM $V(1, length)"),
        ("DIM $V(1,5)\n$V1 = \"x\"", "$V1 is outside DIM $V(1, length)"),
        ("PRINT LV70000", "LV70000 has no memory: no DIM LV was executed"),
        ("PRINT LA0(1)", "LA0 has no memory: no DIM LA was executed"),
        ("DIM LA(1)\nLA0(1) = 2", "LA0 has no elements before DIM LA0(size)"),
        ("DIM LA(1)\nDIM LA0(4)\nLA0(4) = 2", "LA0(4) is outside DIM LA0(4)"),
        ("DIM DA(1)\nDIM DA0(4)\nPRINT DA0(-1)", "DA0(-1) is outside DIM DA0(4)"),
        ("DIM DA(1)\nDIM DA1(4)", "DA1 is outside DIM DA(1)"),
        ("DIM $A(1)\nDIM $A0(2,3)\n$A0(2) = \"\"", "$A0(2) is outside DIM $A0(2)"),
        ("DIM LA(1)\nPRINT LA0 + 1", "LA0 is a whole array, its elements are LA0(0) and so on"),
        ("DIM LV(1)\nDIM LV(2)", "Re-dimensioned block"),
        ("DIM $V(1,5)\nDIM $V(1,5)", "Re-dimensioned block"),
        ("DIM LA(1)\nDIM LA(1)", "Re-dimensioned block"),
        ("DIM LA(1)\nDIM LA0(1)\nDIM LA0(1)", "Re-dimensioned block"),
        ("DIM LV(-1)", "DIM cannot give -1 elements"),
        ("DIM DV(100000)", "800000 bytes do not fit into the 100000 bytes that the program has left"),
        ("DIM LV(1)\nLV0 = \"x\"", "a number is needed here, this is a string"),
        ("DIM $V(1,5)\n$V0 = 1", "a string is needed here, this is a number"),
        ("DIM $V(1,5)\n$V0 = P0", "a string is needed here, this is a number"),
        ("P0 = \"x\"", "a number is needed here, this is a string"),
        ("DIM SV(1)\nSV0 = 1e300", "1e+300 is beyond the range of 32-bit floating point numbers"),
        ("P12288 = 1", "P12288 can only be read"),
        ("PRINT P200000", "P200000 does not exist"),
        ("SET 5", "BIT5 can only be read"),
        ("PRINT BIT(-1)", "BIT-1 does not exist"),
        ("FLASH IMAGE", "FLASH IMAGE cannot be executed here"),
    ];
    for (program, expected) in cases {
        let line = program.lines().count();
        assert_eq!(output(program), format!("{expected} [line {line}, statement 1]"), "{program}");
    }
}

#[test]
fn a_dimension_of_nothing_is_legal() {
    assert_eq!(output("DIM LV(1)\nDIM DA(1)\nDIM DA0(LV0)\nPRINT \"ok\""), "ok\r\n");
}

#[test]
fn a_controller_reads_and_writes_by_reference() {
    let mut machine = Machine::new("DIM LV(2)\nDIM DA(1)\nDIM DA0(3)\nDA0(1) = 2.5");
    machine.finish();
    let element = Reference::Element { class: OperandClass::Da, array: 0, element: 1 };
    assert_eq!(machine.locals.read(element), Ok(Value::Double(2.5)));
    assert_eq!(machine.locals.array_size(OperandClass::Da, 0), Some(3));
    assert_eq!(machine.locals.array_size(OperandClass::Da, 1), None);
    let variable = Reference::Variable { class: OperandClass::Lv, index: 1 };
    machine.locals.write(variable, &Value::Double(7.9)).unwrap();
    assert_eq!(machine.locals.read(variable), Ok(Value::Long(7)));
    assert_eq!(machine.locals.count(OperandClass::Lv), 2);
    assert!(machine.locals.write(variable, &Value::Text("x".into())).is_err());
    assert!(machine.locals.read(Reference::Array { class: OperandClass::Da, array: 0 }).is_err());
}

#[test]
fn a_sum_in_place_is_a_sum() {
    let program = "DIM LV(2)\nDIM LA(1) : DIM LA0(3)\nDIM DA(1) : DIM DA0(2)\nLV1 = 7\n\
        LA0(1) = LA0(1) + LV1 : LA0(1) = LA0(1) + LA0(1) : LA0(LV0) = LA0(LV0) + 2147483647 : LA0(0) = LA0(0) + LV1\n\
        DA0(1) = 1.5 : DA0(1) = DA0(1) + DA0(1) : DA0(1) = DA0(1) + P0 : P0 = P0 + 0.25 : P0 = P0 - 1\n\
        PRINT LA0(0); \",\"; LA0(1); \",\"; DA0(1); \",\"; P0";
    assert_eq!(output(program), "-2147483642,14,3,-0.75\r\n");
    for (statement, fault) in [
        ("LA0(LV0) = LA0(LV0) + LV1", "LV0 has no memory: no DIM LV was executed"),
        ("LA0(2) = LA0(2) + LV1", "LA0 has no memory: no DIM LA was executed"),
        ("DIM LA(1) : DIM LA0(3) : LA0(2) = LA0(2) + LV1", "LV1 has no memory: no DIM LV was executed"),
        ("DIM DV(1) : DIM DA(1) : DIM DA0(2) : DA0(2) = DA0(2) + DV0", "DA0(2) is outside DIM DA0(2)"),
        (
            "DIM DV(1) : DIM DA(1) : DIM DA0(1) : DV0 = 1E308 : DA0(0) = DV0 : DA0(0) = DA0(0) + DV0",
            "the result of + is beyond the range of numbers",
        ),
        ("P0 = 1E308 : P0 = P0 + 1E308", "the result of + is beyond the range of numbers"),
    ] {
        let place = 1 + statement.matches(" : ").count();
        assert_eq!(output(statement), format!("{fault} [line 1, statement {place}]"));
    }
}

#[test]
fn conditions_with_real_constants_hold_either_way_round() {
    let program = "DIM DV(1)\nFOR DV0 = -1 TO 1 STEP 0.5\nIF (DV0 < 0.5) THEN PRINT \"a\";\nIF (0.5 > DV0) THEN PRINT \"b\";\n\
        IF (DV0 >= 0) THEN PRINT \"c\";\nIF (0 <= DV0) THEN PRINT \"d\";\nIF (DV0 = 0.5) THEN PRINT \"e\";\nPRINT \"|\";\nNEXT";
    assert_eq!(output(program), "ab|ab|abcd|cde|cd|");
}
