//! What a person reads when a statement is broken: one message, at the right place, that says what to do.

mod support;

use support::{checked, rendered};

macro_rules! message {
    ($name:ident, $source:expr) => {
        #[test]
        fn $name() {
            insta::assert_snapshot!(rendered($source));
        }
    };
}

message!(value_missing, "VEL 5 : ACC ) : DEC 5");
message!(text_behind_a_statement, "VEL 5 )\nX5, Y5\nENDIF 3");
message!(unknown_command, "PRNT \"x\"\nJGO ABS X5\nFOOBAR 5\nAB \"x\"");
message!(daughter_missing, "JOG X5\nJOG ABBS X5\nFLASH");
message!(operand_missing, "P0 =\nP0 = 5 +\nP0 = 5 + * 3\nP0 = 3 AND");
message!(parenthesis_missing, "P0 = (5 + LV0\nX(1, 2\nP0 = SIN(5");
message!(calculated_argument, "VEL P0 + 5\nX(P0)*2");
message!(command_with_equal_sign, "VEL = 5\nVEL = P0 * 2 : ACC=(P1)\nVEL =\nRES = 5");
message!(command_as_value, "P0 = VEL + 1");
message!(function_without_parenthesis, "P0 = SIN P1");
message!(variable_without_index, "P0 = LV\nBIT = 1");
message!(statement_without_assignment, "P0 5\nBIT 5");
message!(if_without_then, "IF (P0 = 1) GOTO Done");
message!(then_without_statement, "IF (P0 = 1) THEN\nENDIF");
message!(then_without_if, "THEN PRINT 5");
message!(broken_loop, "FOR LV0 = 0 9\nFOR LV0 TO 9\nWHILE");
message!(jump_with_underscore, "GOTO _Start");
message!(print_without_separator, "PRINT \"a\" \"b\"\nPRINT \"a\" P0\nPRINT #1 \"x\"");
message!(unterminated_string, "PRINT \"abc\nP0 = 5");
message!(device_without_number_sign, "OPEN \"COM1:\" AS 1\nCLOSE 1\nOPEN \"COM1:\"");
message!(unknown_memory, "DIM FOO(5)\nDIM LV(5");
message!(alias_without_operand, "#DEFINE Ready\n#DEFINE 5");
message!(label_without_name, "_ : REM nothing");
message!(detached_label, "_ Failed");
message!(object_without_command, "AXIS0\nAXIS0 5\nSTEPPER0 5");
message!(incremental_without_distance, "X/ Y5");
message!(flag_missing, "SET \"x\"\nCLR BIT\nINH -");
message!(remark_without_colon, "CLOSE #1 REM done");
message!(remark_on_label_line, "_Start : REM here");
message!(comment_behind_statement, "VEL 5 ' fast");
message!(size_without_parentheses, "DIM LV10\nDIM $V 2 80");
message!(typographic_characters, "PRINT \u{201C}a\u{201D} : INH \u{2013}516\n\u{2018} note\nX\u{A0}5");
message!(left_out_lines, "\u{2026}");
message!(unknown_character, "@home : VEL 5");
message!(unknown_function, "P0=FOO(1)\nP3=INT(2.7)\nX(Rate(2)) Y5");
message!(based_numbers, "P0=0x1F\nPRINT 0b101; 5\nSET 0x20\nP0=0xFFFFFFFFFF\nIF (P0 = 0XAB) THEN SET 32");
message!(ends_of_other_languages, "FOR LV0=1 TO 3\nNEXT LV0\nIF (BIT 24)\nEND IF");
message!(assignment_of_other_languages, "P0 := 1\nReady := 1 : SET 32");
message!(target_missing, "X\"a\"\nX\u{2026}\nPRNT\"a\"");
message!(too_deep, &format!("P0 = {}1", "(".repeat(300)));
message!(too_long, &format!("P0 = 1{}", " + 1".repeat(300)));

#[test]
fn an_axis_may_touch_the_zero_before_it() {
    for source in
        ["P0=0X1", "X0Y0x5", "Y0X100", "HLIM X0Y0", "P0=0B1", "P0=0BX5", "X/Dist Y5", "X/ Distance", "NEXT P0=1", "END"]
    {
        assert_eq!(checked(source).errors(), [], "{source}");
    }
}
