//! Typed statements run as those of programs do.

use crate::support::{Desk, TWO_AXES};

#[test]
fn they_use_the_variables_of_their_program() {
    let mut desk = Desk::with(&format!("{TWO_AXES}PROGRAM\nDIM LV(2)\nLV0 = 7\nENDP\n"));
    desk.send("PROG0\rRUN\r");
    desk.wait(0.1);
    assert_eq!(desk.ask("LV0 = LV0 + 1 : ?LV0"), "8\r\n");
    assert_eq!(desk.send("PROG1\r"), "PROG1\r\nP01>");
    assert_eq!(desk.ask("?LV0"), "LV0 has no memory: no DIM LV was executed\r\n");
}

#[test]
fn a_statement_that_waits_holds_its_channel_only() {
    let mut desk = Desk::with(TWO_AXES);
    let other = desk.controller.open_channel("STREAM2".parse().expect("a name")).expect("a stream");
    desk.controller.receive(desk.channel, b"PROG0\rDWL 2 : ?1\r?2\r");
    desk.controller.receive(other, b"?3\r");
    desk.controller.step(200, &mut desk.log);
    assert_eq!(desk.read(), "PROG0\r\nP00>DWL 2 : ?1\r\n");
    assert_eq!(desk.controller.take_output(other), b"?3\r\n3\r\nSYS>");
    assert_eq!(desk.wait(1.8), "");
    assert_eq!(desk.wait(0.2), "1\r\nP00>?2\r\n2\r\nP00>");
}

#[test]
fn a_third_move_waits_for_the_first() {
    let mut desk = Desk::machine();
    desk.controller.receive(desk.channel, b"X10\rX20\rX30\r");
    desk.controller.step(100, &mut desk.log);
    assert_eq!(desk.read(), "X10\r\nP00>X20\r\nP00>X30\r\n");
    assert_eq!(desk.wait(1.2), "P00>");
}

#[test]
fn esc_gives_a_wait_up() {
    let mut desk = Desk::machine();
    assert_eq!(desk.send("INH 32 : ?1\r"), "INH 32 : ?1\r\n");
    assert_eq!(desk.send("typed meanwhile\x1b"), "P00>");
    assert_eq!(desk.ask("?2"), "2\r\n");
}

#[test]
fn commands_of_another_level_are_unknown() {
    let mut desk = Desk::with(TWO_AXES);
    for line in [
        "VEL 5",
        "X10",
        "ACC",
        "ATTACH MASTER0",
        "LIST",
        "DIM LV(2)",
        "DIM LV(0)",
        "DIM LA(1)",
        "DIM MBUF(2)",
        "GARBLE",
        "15 VEL 5",
        "= 5",
        ")",
        "PROGRAM",
    ] {
        assert_eq!(desk.ask(line), "Unknown Command\r\n", "{line}");
    }
    // What follows a PROGRAM that is refused is read and not executed, up to its end.
    assert_eq!(desk.ask("SET 32"), "");
    assert_eq!(desk.ask("ENDP : ?BIT 32"), "0\r\n");
    desk.send("PROG0\r");
    for line in ["DIM PROG1(100)", "GARBLE 1", "FOO 5", "FOO", "FOO = 5"] {
        assert_eq!(desk.ask(line), "Unknown Command\r\n", "{line}");
    }
    // Z is no axis of program 0, X none of program 1.
    for line in ["Z5", "RES Z", "PPU Z", "JOG VEL Z5", "DRIVE ON Z", "PROG1 : RES X", "X5", "VECDEF X1"] {
        assert_eq!(desk.ask(line), "Unknown Command\r\n", "{line}");
    }
}

#[test]
fn errors_are_one_line_in_the_words_of_the_controller_where_they_are_known() {
    let mut desk = Desk::machine();
    desk.ask("DIM LV(4)");
    assert_eq!(desk.ask("DIM LV(4)"), "Re-dimensioned block\r\n");
    assert_eq!(desk.send("SYS\rDIM PROG0(100)\r"), "SYS\r\nSYS>DIM PROG0(100)\r\nRe-dimensioned block\r\nSYS>");
    desk.send("PROG0\r");
    desk.ask("X10");
    assert_eq!(desk.ask("DRIVE ON X"), "Not valid while in motion\r\n");
    desk.wait(2.0);
    desk.ask("SET 8467");
    assert_eq!(desk.ask("Y10"), "Associated Slave Kill Motion Request Active\r\n");
    assert_eq!(desk.ask("VEL ="), "Syntax error: expected a value after `VEL`, found `=`\r\n");
    assert_eq!(desk.ask("?1/0"), "division by zero\r\n");
}

#[test]
fn a_loop_on_one_line_runs_and_can_be_left() {
    let mut desk = Desk::with("SYS\nDIM P(10)\nPROG0\n");
    desk.send("PROG0\r");
    assert_eq!(desk.ask("FOR P0 = 1 TO 3 : ?P0; : NEXT : ?\"\""), "123\r\n");
    desk.send("WHILE (1) : WEND\r");
    assert_eq!(desk.wait(1.0), "");
    assert_eq!(desk.send("\x1b"), "P00>");
}

#[test]
fn the_line_can_be_corrected() {
    let mut desk = Desk::new();
    assert_eq!(desk.send("\x08?12\x083\x7f4\r"), "?12\x08 \x083\x08 \x084\r\n14\r\nSYS>");
}

#[test]
fn a_line_that_is_too_long_is_refused_as_a_whole() {
    let mut desk = Desk::with("SYS\nDIM P(10)\n");
    let line = format!("P0 = 1{}", " ".repeat(1100));
    assert_eq!(desk.ask(&line), "Line too long\r\n");
    assert_eq!(desk.ask("?P0"), "0\r\n");
}

#[test]
fn latin_1_passes_and_other_control_characters_do_not() {
    let mut desk = Desk::new();
    desk.controller.receive(desk.channel, b"\0?\"\xb5m\x07\x11\"\0\0\r");
    desk.controller.step(40, &mut desk.log);
    assert_eq!(desk.controller.take_output(desk.channel), b"?\"\xb5m\"\r\n\xb5m\r\nSYS>");
}

#[test]
fn aliases_need_room_and_are_forgotten_by_clear() {
    let mut desk = Desk::with("SYS\nDIM P(10)\nDIM DEF(1)\n");
    assert_eq!(desk.ask("#DEFINE speed P1"), "");
    assert_eq!(desk.ask("#DEFINE other P2"), "there is no room for the alias other: DIM DEF(1) gives 1\r\n");
    assert_eq!(desk.ask("#DEFINE speed P3"), "");
    assert_eq!(desk.ask("speed = 4 : ?P1,P3"), "0\t4\r\n");
    assert_eq!(desk.ask("CLEAR"), "");
    assert_eq!(desk.ask("? speed"), "the name `speed` is not defined\r\n");
}

#[test]
fn a_prompt_needs_its_number() {
    let mut desk = Desk::new();
    assert_eq!(desk.ask("PROG"), "PROG expects a number\r\n");
    assert_eq!(desk.ask("PLC"), "PLC expects a number\r\n");
}

#[test]
fn what_is_typed_at_a_prompt_are_commands() {
    let mut desk = Desk::new();
    desk.send("PROG0\rDIM LV(1)\r");
    for line in ["INPUT LV0", "?KBHIT(0)", "?INKEY$(0)"] {
        let told = desk.ask(line);
        assert!(told.starts_with("#0 is this terminal, which takes commands"), "{line}: {told}");
    }
}

#[test]
fn what_depends_on_a_condition_that_cannot_be_read_is_not_executed() {
    let mut desk = Desk::new();
    let refused = "P99 is outside DIM P(0)\r\n";
    assert_eq!(desk.ask("IF (P99 = 0) THEN ?1 : ?2"), refused);
    assert_eq!(desk.ask("WHILE (P99 = 0) : ?1 : WEND : ?2"), format!("{refused}2\r\n"));
}

#[test]
fn aliases_have_the_names_that_a_build_takes() {
    let mut desk = Desk::with("SYS\nDIM P(10)\nDIM DEF(9)\n");
    let long = "a".repeat(25);
    for (name, problem) in [
        ("VEL", "is a word of the language"),
        ("b1", "has a `1`; only letters may be in it"),
        (long.as_str(), "has 25 letters; at most 24 are possible"),
    ] {
        assert_eq!(desk.ask(&format!("#DEFINE {name} P1")), format!("the alias {name} {problem}\r\n"));
    }
    assert_eq!(desk.ask("DEF"), "");
    desk.send("PROG0\rPROGRAM\r#DEFINE b1 P1\rENDP\r");
    assert_eq!(
        desk.send("LRUN\r") + &desk.wait(0.1),
        "LRUN\r\nthe alias b1 has a `1`; only letters may be in it\r\nP00>"
    );
    let mut later = Desk::of_model("SYS\nDIM P(10)\nDIM DEF(9)\n", "ACR7000");
    assert_eq!(later.ask("#DEFINE b1 P1"), "");
}

#[test]
fn a_definition_finds_the_memory_that_the_line_gives_out_before_it() {
    let mut desk = Desk::new();
    assert_eq!(
        desk.ask("SYS : DIM P(9) : DIM DEF(4) : #DEFINE a P1 : a = 5 : #DEFINE b P2 : b = a + 1 : ?a : ?b"),
        "5\r\n6\r\n"
    );
    assert_eq!(desk.ask("DEF"), "#DEFINE a P1\r\n#DEFINE b P2\r\n");
    assert_eq!(desk.ask("IF (0) THEN CLEAR : #DEFINE c P3"), "");
    let full = "there is no room for the alias e: DIM DEF(4) gives 4\r\n";
    assert_eq!(desk.ask("?1 : #DEFINE d P4 : #DEFINE e P5 : ?2"), format!("1\r\n{full}2\r\n"));
    assert_eq!(desk.ask("CLEAR : DIM PROG1(400) : DIM DEF(1) : #DEFINE a P38912 : PROG1 : PROGRAM"), "");
    assert_eq!(desk.ask("VEL 1 : ENDP : LIST : ?a"), "VEL 1\r\n0\r\n");
}

#[test]
fn jumps_belong_to_programs() {
    let mut desk = Desk::with("SYS\nDIM PLC0(400)\n");
    for prompt in ["SYS", "PLC0"] {
        desk.send(&format!("{prompt}\r"));
        for line in ["GOTO 10", "GOTO there", "GOSUB 10", "GOSUB there", "RETURN", "NEXT", "WEND", "BREAK"] {
            assert_eq!(desk.ask(line), "Unknown Command\r\n", "{prompt} {line}");
        }
    }
    desk.send("PROG0\r");
    assert_eq!(desk.ask("GOTO 10"), "there is no line 10\r\n");
}

#[test]
fn attachments_name_what_the_controller_has() {
    let mut desk = Desk::new();
    assert_eq!(desk.ask("ATTACH AXIS0 ENC20"), "ENC20 does not exist: this controller has ENC0 to ENC9\r\n");
    assert_eq!(desk.ask("ATTACH AXIS0 ENC0 DAC8 ENC0"), "DAC8 does not exist: this controller has DAC0 to DAC7\r\n");
    assert_eq!(desk.ask("ATTACH AXIS4 ENC4 DAC4 ENC9"), "");
    assert_eq!(desk.ask("ATTACH AXIS7 STEPPER7 CMT7"), "");
    desk.send("PROG0\rATTACH MASTER0\r");
    let refusal = "ATTACH SLAVE: `VEL` is no axis name: it is a word of the language\r\n";
    assert_eq!(desk.ask("ATTACH SLAVE1 AXIS1 \"VEL\""), refusal);
    assert_eq!(desk.ask("ATTACH"), "ATTACH MASTER0\r\n");
}

#[test]
fn a_program_that_goes_round_in_a_circle_sees_what_is_typed_at_its_prompt() {
    let mut desk = Desk::with("PROG5\nDIM LV(1)\nPROGRAM\nWHILE (LV0 = 0)\nWEND\nPRINT \"left\"\nENDP\nRUN\n");
    desk.send("PROG5\r");
    desk.wait(100.0);
    assert_eq!(desk.ask("LV0 = 42"), "");
    desk.wait(0.1);
    assert_eq!(desk.log.output.concat(), "left\r\n");
}
