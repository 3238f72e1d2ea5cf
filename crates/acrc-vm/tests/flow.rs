//! Program flow (guide, "Program Flow" and its examples).

mod support;

use std::fmt::Write as _;

use acrc_vm::{Budget, LoadErrorKind, Stop};
use support::{Machine, output, try_load};

#[test]
fn a_block_if_takes_the_first_true_branch() {
    let program = "IF (P0 = 1)\nPRINT \"one\"\nELSEIF (P0 = 2)\nPRINT \"two\"\nELSE IF (P0 > 1)\n\
        PRINT \"more\"\nELSE\nPRINT \"none\"\nENDIF\nPRINT \"end\"";
    for (number, expected) in [(1, "one"), (2, "two"), (3, "more"), (0, "none")] {
        assert_eq!(output(&format!("P0 = {number}\n{program}")), format!("{expected}\r\nend\r\n"));
    }
}

#[test]
fn blocks_nest() {
    let program =
        "IF (P0)\nIF (P1)\nPRINT \"both\"\nELSE\nPRINT \"first\"\nENDIF\nELSE\nIF (P1)\nPRINT \"second\"\nENDIF\nENDIF";
    for (first, second, expected) in [(1, 1, "both\r\n"), (1, 0, "first\r\n"), (0, 1, "second\r\n"), (0, 0, "")] {
        assert_eq!(output(&format!("P0 = {first} : P1 = {second}\n{program}")), expected);
    }
}

#[test]
fn then_makes_the_rest_of_its_line_conditional() {
    let program = "IF (P0 > 4) THEN PRINT \"a\"; : P1 = 1 : IF (P0 > 8) THEN PRINT \"b\";\nPRINT P1";
    assert_eq!(output(&format!("P0 = 3\n{program}")), "0\r\n");
    assert_eq!(output(&format!("P0 = 5\n{program}")), "a1\r\n");
    assert_eq!(output(&format!("P0 = 9\n{program}")), "ab1\r\n");
}

#[test]
fn every_number_but_zero_is_true() {
    let program = "DIM DV(1)\nDV0 = 0.25\nIF (DV0) THEN PRINT \"double\"\nIF (2) THEN PRINT \"long\"\n\
        IF (0.5) THEN PRINT \"real\"\n\
                   IF (P5) THEN PRINT \"never\"\nIF (NOT BIT 40) THEN PRINT \"clear\"\nSET 40\n\
                       IF (BIT40) THEN PRINT \"set\"\nIF (BIT40 = -1) THEN PRINT \"minus one\"";
    assert_eq!(output(program), "double\r\nlong\r\nreal\r\nclear\r\nset\r\nminus one\r\n");
}

#[test]
fn a_while_tests_before_each_pass() {
    assert_eq!(output("WHILE (P0 < 3)\nPRINT P0;\nP0 = P0 + 1\nWEND\nPRINT \".\""), "012.\r\n");
    assert_eq!(output("WHILE (P0 > 3)\nPRINT P0\nWEND\nPRINT \".\""), ".\r\n");
}

#[test]
fn a_for_counts_up_past_its_end() {
    assert_eq!(output("DIM LV(1)\nFOR LV0 = 0 TO 4 STEP 2\nPRINT LV0;\nNEXT\nPRINT \" \"; LV0"), "024 6\r\n");
    assert_eq!(output("DIM LV(1)\nFOR LV0 = 0 TO 499\nNEXT\nPRINT LV0"), "500\r\n");
}

#[test]
fn a_for_may_make_no_pass() {
    assert_eq!(output("DIM LV(1)\nFOR LV0 = 5 TO 4\nPRINT \"pass\"\nNEXT\nPRINT LV0"), "5\r\n");
}

#[test]
fn a_for_counts_in_any_number() {
    assert_eq!(
        output("DIM DV(1)\nFOR DV0 = 0 TO 1 STEP 0.25\nPRINT DV0; \" \";\nNEXT\nPRINT DV0"),
        "0 0.25 0.5 0.75 1 1.25\r\n"
    );
    assert_eq!(output("DIM SV(1)\nFOR SV0 = 1 TO 2 STEP 0.5\nPRINT SV0; \" \";\nNEXT"), "1 1.5 2 ");
    assert_eq!(output("FOR P5 = 1 TO 3\nPRINT P5; \" \";\nNEXT"), "1 2 3 ");
    assert_eq!(output("DIM LA(1)\nDIM LA0(3)\nFOR LA0(1) = 1 TO 3\nPRINT LA0(1); \" \";\nNEXT"), "1 2 3 ");
    assert_eq!(output("DIM LV(2)\nLV0 = 1\nFOR LV(LV0) = -5 TO -2.5 : PRINT LV1; \" \"; : NEXT"), "-5 -4 -3 ");
}

#[test]
fn the_bounds_of_a_for_are_taken_once() {
    assert_eq!(output("DIM LV(2)\nLV1 = 3\nFOR LV0 = 1 TO LV1\nLV1 = 10\nNEXT\nPRINT LV0"), "4\r\n");
}

#[test]
fn a_for_up_to_the_largest_long_ends() {
    assert_eq!(output("DIM LV(1)\nFOR LV0 = 2147483646 TO 2147483647\nPRINT \"pass\"\nNEXT"), "pass\r\npass\r\n");
}

#[test]
fn break_leaves_the_innermost_loop() {
    let program =
        "DIM LV(2)\nFOR LV0 = 1 TO 2\nFOR LV1 = 1 TO 9\nIF (LV1 = 3)\nBREAK\nENDIF\nNEXT\nPRINT LV0; LV1\nNEXT";
    assert_eq!(output(program), "13\r\n23\r\n");
    assert_eq!(output("WHILE (1)\nP0 = P0 + 1\nIF (P0 > 4) THEN BREAK\nWEND\nPRINT P0"), "5\r\n");
}

#[test]
fn gosub_returns_behind_itself() {
    let program = "GOSUB Outer : PRINT \"back\"\nEND\n_Outer\nPRINT \"outer\"\nGOSUB Inner\n\
        PRINT \"outer again\"\nRETURN\n_Inner\nPRINT \"inner\"\nRETURN";
    assert_eq!(output(program), "outer\r\ninner\r\nouter again\r\nback\r\n");
}

#[test]
fn a_conditional_gosub_comes_back_into_its_line() {
    let program = "P0 = 5\nIF (P0 > 4) THEN GOSUB Less : P0 = P0 - 1\nPRINT P0\nEND\n_Less\nPRINT \"sub\"\nRETURN";
    assert_eq!(output(program), "sub\r\n4\r\n");
}

#[test]
fn goto_takes_labels_and_line_numbers() {
    assert_eq!(output("GOTO Skip\nPRINT \"no\"\n_Skip\nPRINT \"yes\""), "yes\r\n");
    assert_eq!(output("10 GOTO 30\n20 PRINT \"no\"\n30 PRINT \"yes\""), "yes\r\n");
    assert_eq!(output("GOTO 100\nPRINT \"no\"\n_100\nPRINT \"label\""), "label\r\n");
}

#[test]
fn goto_may_leave_blocks() {
    let program = "DIM LV(1)\n_Again\nP0 = P0 + 1\nWHILE (1)\nIF (P0 < 4)\nGOTO Again\nENDIF\nBREAK\nWEND\n\
                   FOR LV0 = 1 TO 5\nIF (LV0 = 2) THEN GOTO Out\nNEXT\n_Out\nPRINT P0; LV0";
    assert_eq!(output(program), "42\r\n");
}

#[test]
fn a_for_that_was_left_starts_anew() {
    let program = "DIM LV(1)\n_Again\nFOR LV0 = 1 TO 3\nP0 = P0 + 1\nIF (P0 = 2) THEN GOTO Again\nNEXT\nPRINT P0";
    assert_eq!(output(program), "5\r\n");
}

#[test]
fn falling_into_endp_ends() {
    assert_eq!(output("PROGRAM\nPRINT \"a\"\nENDP"), "a\r\n");
    assert_eq!(output("PRINT \"a\"\nEND\nPRINT \"b\""), "a\r\n");
    assert_eq!(output(""), "");
}

#[test]
fn flow_faults_name_their_place() {
    let cases = [
        ("P0 = 1\nRETURN", "RETURN without GOSUB [line 2, statement 1]"),
        ("P0 = 1 : BREAK", "BREAK outside of a loop [line 1, statement 2]"),
        ("GOTO 50", "there is no line 50 [line 1, statement 1]"),
        ("GOTO In\nFOR P0 = 1 TO 3\n_In\nNEXT", "NEXT without a running FOR [line 4, statement 1]"),
        ("DIM LV(1)\nGOTO In\nFOR LV0 = 1 TO 3\n_In\nNEXT", "NEXT without a running FOR [line 5, statement 1]"),
        ("FOR P0 = 1 TO 3 STEP 0\nNEXT", "STEP 0 does not count up; FOR counts upwards only [line 1, statement 1]"),
        ("FOR P0 = 3 TO 1 STEP -1\nNEXT", "STEP -1 does not count up; FOR counts upwards only [line 1, statement 1]"),
        (
            "DIM LV(1)\nFOR LV0 = 1 TO 3 STEP 0.5\nNEXT",
            "STEP 0.5 does not count up; FOR counts upwards only [line 2, statement 1]",
        ),
    ];
    for (program, expected) in cases {
        assert_eq!(output(program), expected, "{program}");
    }
}

#[test]
fn calls_end_with_the_memory() {
    let mut machine = Machine::new("DIM LV(4)\n_Deeper\nP0 = P0 + 1\nGOSUB Deeper");
    machine.locals.set_limit(16 + 4 * 5);
    let Stop::Fault(fault) = machine.finish() else { panic!("no fault") };
    assert_eq!(fault.to_string(), "GOSUB 6 levels deep needs 4 bytes a level, the program has no memory left");
    assert_eq!(machine.frame.depth(), 5);
}

#[test]
fn calls_and_variables_share_the_memory() {
    let mut machine = Machine::new("GOSUB Sub\n_Sub\nDIM LV(4)");
    machine.locals.set_limit(16);
    let Stop::Fault(fault) = machine.finish() else { panic!("no fault") };
    assert_eq!(fault.to_string(), "16 bytes do not fit into the 12 bytes that the program has left");
}

#[test]
fn blocks_that_do_not_match_are_refused() {
    let cases = [
        ("NEXT", "NEXT without FOR", 1),
        ("P0 = 1\nWEND", "WEND without WHILE", 2),
        ("ENDIF", "ENDIF without IF", 1),
        ("ELSE", "ELSE without IF", 1),
        ("IF (1)\nP0 = 1", "IF without ENDIF", 1),
        ("WHILE (1)", "WHILE without WEND", 1),
        ("FOR P0 = 1 TO 2", "FOR without NEXT", 1),
        ("FOR P0 = 1 TO 2\nWHILE (1)\nNEXT\nWEND", "NEXT closes a WHILE block that stands inside it", 3),
        ("IF (1)\nFOR P0 = 1 TO 2\nENDIF\nNEXT", "ENDIF closes a FOR block that stands inside it", 3),
        ("IF (1)\nELSE\nELSE\nENDIF", "ELSE behind ELSE", 3),
        ("IF (1)\nELSE\nELSEIF (1)\nENDIF", "ELSEIF behind ELSE", 3),
        (
            "FOR P0 = 1 TO 9\nIF (P0 = 2) THEN NEXT\nNEXT",
            "NEXT behind THEN belongs to a block that is not on the same line",
            2,
        ),
        (
            "IF (1) THEN WHILE (P0 < 3)\nP0 = P0 + 1\nWEND",
            "WHILE behind THEN belongs to a block that is not on the same line",
            1,
        ),
    ];
    for (program, message, line) in cases {
        let error = try_load(program).expect_err(program);
        assert_eq!(error.to_string(), format!("PROG0, line {line}: {message}"), "{program}");
    }
}

#[test]
fn a_block_behind_then_may_stand_on_its_line() {
    assert_eq!(output("IF (1) THEN WHILE (P0 < 3) : P0 = P0 + 1 : WEND : PRINT P0"), "3\r\n");
}

#[test]
fn a_statement_of_endless_length_is_refused() {
    let program = format!("P0 = 1\nPRINT {}", vec!["BIT 40"; 600].join(";"));
    let message = "the statement is too long to be executed at once: it needs more than 512 intermediate results";
    let error = try_load(&program).expect_err("too long");
    assert_eq!(error.to_string(), format!("PROG0, line 2: {message}"));
}

#[test]
fn words_that_are_no_program_are_refused() {
    let mut image = support::image("P0 = 1", true);
    image.programs[0].words.pop();
    let error = acrc_vm::Code::load(&image.programs[0], &image.aliases).expect_err("truncated");
    assert!(matches!(error.kind, LoadErrorKind::Image(_)), "{error}");
}

#[test]
fn a_budget_of_lines_counts_lines() {
    let mut machine = Machine::new("P0 = 1 : P1 = 1\nREM a line as well\nP0 = 2\nP0 = 3");
    let run = machine.run(Budget::lines(2));
    assert_eq!((run.stop, run.used, run.statements), (Stop::Budget, 2, 3));
    let run = machine.run(Budget::lines(9));
    assert_eq!((run.stop, run.used, run.statements), (Stop::Ended, 2, 2));
}

#[test]
fn a_budget_of_statements_stops_within_a_line() {
    let mut machine = Machine::new("PRINT 1; : PRINT 2; : PRINT 3;");
    for (stop, expected) in [(Stop::Budget, "1"), (Stop::Budget, "12"), (Stop::Ended, "123")] {
        assert_eq!(machine.run(Budget::statements(1)).stop, stop);
        assert_eq!(machine.bench.output, expected);
    }
}

#[test]
fn a_loop_within_one_line_uses_its_slice_up() {
    let mut machine = Machine::new("WHILE (1) : WEND");
    let run = machine.run(Budget::lines(4));
    assert_eq!(run.stop, Stop::Budget);
    assert_eq!(run.used, 4);
}

#[test]
fn no_budget_does_nothing() {
    let mut machine = Machine::new("PRINT 1");
    assert_eq!(machine.run(Budget::lines(0)).stop, Stop::Budget);
    assert_eq!(machine.bench.output, "");
}

#[test]
fn slices_do_not_change_what_a_program_does() {
    let program = "DIM LV(2)\nFOR LV0 = 1 TO 3\nLV1 = 0\n\
        WHILE (LV1 < LV0) : LV1 = LV1 + 1 : PRINT LV1; : WEND\nGOSUB Mark\nNEXT\nEND\n_Mark\nPRINT \"|\";\n\
        RETURN";
    let whole = output(program);
    assert_eq!(whole, "1|12|123|");
    for lines in 1..5 {
        let mut machine = Machine::new(program);
        while machine.run(Budget::lines(lines)).stop == Stop::Budget {}
        assert_eq!(machine.bench.output, whole, "{lines} lines a slice");
    }
    let mut machine = Machine::new(program);
    while machine.run(Budget::statements(1)).stop == Stop::Budget {}
    assert_eq!(machine.bench.output, whole);
}

#[test]
fn a_program_starts_over_after_a_reset() {
    let mut machine = Machine::new("PRINT \"run\"\nDIM LV(1)\nEND");
    assert_eq!(machine.finish(), Stop::Ended);
    assert_eq!(machine.finish(), Stop::Ended, "it stays at its end");
    machine.frame.reset();
    machine.locals.clear();
    assert_eq!(machine.finish(), Stop::Ended);
    assert_eq!(machine.bench.output, "run\r\nrun\r\n");
}

#[test]
fn every_statement_is_reported_before_it_runs() {
    let mut machine = Machine::new("P0 = 1 : P1 = 2\nIF (P0 = 2) THEN P1 = 3\nRETURN");
    machine.run_watched(Budget::lines(9));
    let places: Vec<_> =
        machine.bench.trace.iter().map(|pc| machine.code.location(*pc)).map(|at| (at.line, at.statement)).collect();
    assert_eq!(places, [(1, 1), (1, 2), (2, 1), (3, 1)]);
    assert_eq!(machine.code.locations().len(), 5);
}

#[test]
fn conditions_with_constants_hold_as_their_values_say() {
    let numbers = [i32::MIN, i32::MIN + 1, -1, 0, 1, 7, i32::MAX - 1, i32::MAX];
    for relation in ["=", "<>", "<", "<=", ">", ">="] {
        for constant in numbers {
            // The same relation as a value, as a condition, as that of a loop, and with the constant in front.
            let mut program = String::from("DIM LV(2)\n");
            for number in numbers {
                let _ = write!(
                    program,
                    "LV0 = {number}\nLV1 = LV0 {relation} {constant}\nIF (LV0 {relation} {constant})\nLV1 = LV1 + 1\nENDIF\n\
                     IF (LV0 - 1 + 1 {relation} {constant}) THEN LV1 = LV1 + 10\nIF (LV1 <> 0 AND LV1 <> 10) THEN PRINT LV0\n\
                     LV1 = (LV0 {relation} {constant}) * 2\nWHILE (LV0 {relation} {constant})\nLV1 = LV1 + 1\n\
                     IF (LV1 = 0) THEN BREAK\nWEND\nIF (LV1 <> 0) THEN PRINT LV0; LV1\n"
                );
            }
            assert_eq!(output(&program), "", "{relation} {constant}");
        }
    }
}

#[test]
fn a_remainder_may_decide() {
    let every = "DIM LV(1)\nFOR LV0 = -7 TO 7\nIF (LV0 MOD 3 = 0) THEN PRINT LV0; \" \";\nNEXT";
    assert_eq!(output(every), "-6 -3 0 3 6 ");
    let ranked = "DIM LV(1)\nFOR LV0 = -3 TO 3\nIF (1 > LV0 MOD 2)\nPRINT LV0; \" \";\nENDIF\nNEXT";
    assert_eq!(output(ranked), "-3 -2 -1 0 2 ");
    let loops = "DIM LV(1)\nWHILE (LV0 MOD 70000 < 9)\nLV0 = LV0 + 1\nWEND\nPRINT LV0";
    assert_eq!(output(loops), "9\r\n");
    assert_eq!(output("DIM LV(1)\nIF (LV0 MOD 0 = 1) THEN PRINT 1"), "division by zero [line 2, statement 1]");
    assert_eq!(
        output("IF (LV3 MOD 2 = 1) THEN PRINT 1"),
        "LV3 has no memory: no DIM LV was executed [line 1, statement 1]"
    );
}

#[test]
fn a_fault_of_a_loop_stands_at_its_condition() {
    // The condition fails when it is decided from its WEND.
    let program = "DIM LV(1)\nWHILE (LV0 < 3)\nLV0 = LV0 + 1 : CLEAR\nWEND";
    assert_eq!(output(program), "LV0 has no memory: no DIM LV was executed [line 2, statement 1]");
    let program = "DIM DV(1)\nGOSUB Sub\nEND\n_Sub\nFOR DV0 = 1 TO 3\nIF (DV0 = 2)\nDV0 = 3 : DV0 = 1 / (DV0 - 3)\nENDIF\nNEXT\nRETURN";
    assert_eq!(output(program), "division by zero [line 7, statement 2]");
}

#[test]
fn blocks_nest_as_deeply_as_they_are_written() {
    for (open, close) in [("IF (1)", "ENDIF"), ("WHILE (P1 = 0)", "WEND"), ("FOR P0 = 1 TO 1", "NEXT")] {
        let program = format!(
            "{}P1 = 1 : P2 = P2 + 1\n{}PRINT P2",
            format!("{open}\n").repeat(200),
            format!("{close}\n").repeat(200)
        );
        assert_eq!(output(&program), "1\r\n", "{open}");
    }
}

#[test]
fn text_behind_a_label_of_digits_and_a_line_of_that_number_is_told_apart() {
    assert_eq!(output("GOTO 20\n_20\nPRINT \"label\"\nEND\n20 PRINT \"line\""), "line\r\n");
    assert_eq!(output("GOSUB 30 : PRINT \"back\"\nEND\n30 PRINT \"line\" : RETURN"), "line\r\nback\r\n");
    assert_eq!(output("10 P0 = 1\n20 GOSUB 99"), "there is no line 99 [line 2, statement 1]");
}

#[test]
fn variables_are_dimensioned_while_a_program_runs() {
    let program = "DIM LV(2)\nLV1 = 3\nDIM DA(LV1 - 1)\nDIM DA(1)";
    assert_eq!(output(program), "Re-dimensioned block [line 4, statement 1]");
    let program = "DIM LV(2)\nLV1 = 3\nDIM DA(2)\nDIM DA0(LV1) : DIM DA1(DA0(2) + 1)\nDA1(0) = 1.5\nPRINT DA1(0)\nCLEAR\n\
                   DIM LV(9) : LV8 = 4 : PRINT LV8\nDA0(0) = 1";
    assert_eq!(output(program), "1.5\r\n4\r\nDA0 has no memory: no DIM DA was executed [line 9, statement 1]");
}
