//! What working client programs rely on.

use crate::support::{Desk, TWO_AXES};

#[test]
fn an_answer_is_echo_lines_and_prompt() {
    let mut desk = Desk::machine();
    assert_eq!(desk.send("AXIS0 PPU 4000\r"), "AXIS0 PPU 4000\r\nP00>");
    assert_eq!(desk.send("AXIS0 PPU\r"), "AXIS0 PPU\r\n4000\r\nP00>");
}

#[test]
fn a_line_ends_with_cr_lf_or_both_and_gives_one_prompt() {
    let mut desk = Desk::new();
    assert_eq!(desk.send("\n"), "\r\nSYS>");
    assert_eq!(desk.send("\r"), "\r\nSYS>");
    assert_eq!(desk.send("\r\n"), "\r\nSYS>");
    assert_eq!(desk.send("PROG 3\r\nPROG4\r\n"), "PROG 3\r\nP03>PROG4\r\nP04>");
}

#[test]
fn nothing_is_sent_before_something_is_typed() {
    let mut desk = Desk::new();
    assert_eq!(desk.wait(1.0), "");
}

#[test]
fn an_answer_is_complete_well_inside_50_milliseconds() {
    let mut desk = Desk::with(&format!("SYS\nDIM P(10)\n{TWO_AXES}"));
    let streams = ["STREAM1", "STREAM2", "STREAM3"]
        .map(|name| desk.controller.open_channel(name.parse().expect("a name")).expect("a stream of the model"));
    for channel in streams {
        desk.controller.receive(channel, b"SYS\r");
    }
    desk.controller.receive(desk.channel, b"?P0 : ?P1 : ?P2\r");
    assert_eq!(desk.wait(0.01), "?P0 : ?P1 : ?P2\r\n0\r\n0\r\n0\r\nSYS>");
}

#[test]
fn echo_and_level_belong_to_a_channel() {
    let mut desk = Desk::new();
    let other = desk.controller.open_channel("STREAM2".parse().expect("a name")).expect("a stream of the model");
    desk.send("ECHO 4\rPROG0\r");
    desk.controller.receive(other, b"ECHO\r");
    assert_eq!(desk.wait(0.01), "");
    assert_eq!(desk.controller.take_output(other), b"ECHO\r\n1\r\nSYS>");
    assert_eq!(desk.send("?1\r"), "1\r\n");
    assert_eq!(desk.send("ECHO\r"), "4\r\n");
    assert_eq!(desk.send("ECHO 0\r"), "P00>");
    assert_eq!(desk.send("?1\r"), "1\r\nP00>");
    assert_eq!(desk.send("ECHO 1\r"), "P00>");
    assert_eq!(desk.send("?1\r"), "?1\r\n1\r\nP00>");
}

#[test]
fn flags_of_a_stream_are_its_echo() {
    let mut desk = Desk::new();
    let mut open =
        |name: &str| desk.controller.open_channel(name.parse().expect("a name")).expect("a stream of the model");
    let [first, second] = [open("STREAM2"), open("STREAM3")];
    let mut send = |channel, bytes: &[u8]| {
        desk.controller.receive(channel, bytes);
        desk.wait(0.05);
        String::from_utf8(desk.controller.take_output(channel)).expect("ASCII")
    };
    assert_eq!(send(first, b"?BIT1792,BIT1794\r"), "?BIT1792,BIT1794\r\n-1\t0\r\nSYS>");
    assert_eq!(send(first, b"BIT1792=0\r"), "BIT1792=0\r\nSYS>");
    assert_eq!(send(first, b"BIT1794=1\r"), "");
    assert_eq!(send(first, b"?1\r"), "1\r\n");
    assert_eq!(send(first, b"ECHO\r"), "4\r\n");
    assert_eq!(send(second, b"?BIT1792,BIT1824\r"), "?BIT1792,BIT1824\r\n0\t-1\r\nSYS>");
    assert_eq!(send(second, b"ECHO 4\r"), "ECHO 4\r\n");
    assert_eq!(send(second, b"?BIT1824,BIT1826\r"), "0\t-1\r\n");
    // A controller that restarts keeps its channels, and the flags go with them.
    send(first, b"REBOOT\r");
    assert_eq!(send(first, b"?BIT1792,BIT1794\r"), "0\t-1\r\n");
}

#[test]
fn numbers_and_separators() {
    let mut desk = Desk::with("SYS\nDIM P(10)\n");
    desk.ask("P0 = 4 : P1 = 2.5 : P2 = 0.1");
    for (line, answer) in [
        ("?BIT(516)", "0\r\n"),
        ("SET 32 : ?BIT32", "-1\r\n"),
        ("? BIT 32", "-1\r\n"),
        ("?P0", "4\r\n"),
        ("? P1", "2.5\r\n"),
        ("?P2", "0.1\r\n"),
        ("PRINT(P0/P1)", "1.6\r\n"),
        ("?P0;P1;\"mm\"", "42.5mm\r\n"),
        ("?P0,P1", "4\t2.5\r\n"),
        ("?P(12288 + 256)", "0\r\n"),
        ("PRINT \"\"", "\r\n"),
    ] {
        assert_eq!(desk.ask(line), answer, "{line}");
    }
    assert_eq!(desk.send("?P0;\r"), "?P0;\r\n4SYS>");
}

#[test]
fn axes_and_drives_at_the_system_prompt() {
    let mut desk = Desk::with(TWO_AXES);
    assert_eq!(desk.ask("DRIVE ON AXIS0"), "");
    assert!(desk.ask("DRIVE AXIS0").starts_with("DRIVE ON "));
    assert!(desk.ask("DRIVE AXIS1").starts_with("DRIVE OFF "));
    assert_eq!(desk.ask("AXIS1 PPU 8000"), "");
    assert_eq!(desk.ask("AXIS1 PPU"), "8000\r\n");
}

#[test]
fn a_move_returns_its_prompt_at_once_and_moves() {
    let mut desk = Desk::machine();
    assert_eq!(desk.ask("X10"), "");
    assert!(desk.bit(516));
    desk.wait(1.2);
    assert!(!desk.bit(516));
    assert_eq!(desk.ask("?P12288"), "10\r\n");
}

#[test]
fn spellings_of_the_field() {
    let mut desk = Desk::with(&format!("SYS\nDIM P(10)\nDIM DEF(10)\n{TWO_AXES}"));
    assert_eq!(desk.send("Prog 0\r"), "Prog 0\r\nP00>");
    for line in [
        "SET 32",
        "SET32",
        "SET BIT32",
        "SET BIT(32)",
        "BIT32=1",
        "BIT 32=1",
        "CLR 8467 CLR8499",
        "ACC 5 DEC 5 VEL 15",
        "RES X RES Y",
        "VEL 5 : ACC 3",
        ":VEL 7",
        "IF (0) THENP12288= 0",
        "IF (0) THENP0= 1",
        "MOV X 1.5 Y 2",
        "\tvel\t9",
        "' a comment of the download tool",
    ] {
        assert_eq!(desk.ask(line), "", "{line}");
    }
    desk.wait(3.0);
    assert_eq!(desk.ask("?P12288,P0"), "2\t0\r\n");
    assert_eq!(desk.ask("VEL"), "9\r\n");
    assert_eq!(desk.ask("?BIT(516"), "0\r\n");
    assert_eq!(desk.ask("#DEFINE started P1"), "");
    assert_eq!(desk.ask("started = 12 : ? started"), "12\r\n");
}

#[test]
fn one_statement_that_cannot_be_read_does_not_stop_the_others() {
    let mut desk = Desk::machine();
    assert_eq!(desk.ask("VEL 5 : NONSENSE 3 : VEL"), "Unknown Command\r\n5\r\n");
    assert_eq!(desk.ask("IF (0) THEN VEL 6 : NONSENSE 3 : VEL 7"), "Unknown Command\r\n");
    assert_eq!(desk.ask("VEL"), "5\r\n");
}

#[test]
fn streams_are_those_of_the_model() {
    let mut desk = Desk::new();
    let open = |desk: &mut Desk, name: &str| desk.controller.open_channel(name.parse().expect("a name"));
    assert!(open(&mut desk, "FIFO").is_err());
    let usb = open(&mut desk, "STREAM1").expect("free");
    assert_eq!(open(&mut desk, "stream1").expect_err("in use").to_string(), "STREAM1 is in use");
    desk.controller.close_channel(usb);
    assert!(open(&mut desk, "STREAM1").is_ok());
}
