//! `RUN`, `LRUN` and `LISTEN`.

use acrc_controller::PromptState;

use crate::support::{Desk, TWO_AXES};

const COUNTER: &str = "SYS\nDIM P(10)\nPROG0\nPROGRAM\n_next\nP0 = P0 + 1\nPRINT P0\nDWL 1\nGOTO next\nENDP\n";

#[test]
fn run_returns_the_prompt_and_shows_nothing() {
    let mut desk = Desk::with(COUNTER);
    desk.send("PROG0\r");
    assert_eq!(desk.ask("RUN"), "");
    assert_eq!(desk.wait(3.5), "");
    assert_eq!(desk.ask("?P0"), "4\r\n");
}

#[test]
fn lrun_shows_the_output_until_esc() {
    let mut desk = Desk::with(COUNTER);
    desk.send("PROG0\r");
    assert_eq!(desk.send("LRUN\r"), "LRUN\r\n");
    assert_eq!(desk.wait(0.5), "1\r\n");
    assert_eq!(desk.controller.prompt_state(desk.channel), PromptState::Listening);
    assert_eq!(desk.wait(2.0), "2\r\n3\r\n");
    assert_eq!(desk.send("\x1b"), "P00>");
    assert_eq!(desk.wait(2.0), "");
    assert_eq!(desk.ask("?P0"), "5\r\n");
    assert_eq!(desk.send("LISTEN\r"), "LISTEN\r\n");
    assert_eq!(desk.wait(1.0), "6\r\n");
    assert_eq!(desk.send("\x1b"), "P00>");
    assert_eq!(desk.ask("HALT"), "");
    assert_eq!(desk.wait(3.0), "");
}

#[test]
fn esc_behind_lrun_in_one_packet_waits_for_its_turn() {
    let mut desk = Desk::with(COUNTER);
    desk.send("PROG0\r");
    let answer = desk.send("LRUN\r\x1b?7\r");
    assert!(answer.starts_with("LRUN\r\n") && answer.ends_with("P00>?7\r\n7\r\nP00>"), "{answer:?}");
}

#[test]
fn only_the_channel_that_asked_hears_the_program() {
    let mut desk = Desk::with(COUNTER);
    let other = desk.controller.open_channel("STREAM2".parse().expect("a name")).expect("a stream");
    desk.send("LRUN PROG0\r");
    desk.wait(2.5);
    assert_eq!(desk.controller.take_output(other), b"");
    assert_eq!(desk.send("\x1b"), "SYS>");
    desk.controller.receive(other, b"LISTEN PROG0\r");
    assert_eq!(desk.wait(2.0), "");
    assert_eq!(desk.controller.take_output(other), b"LISTEN PROG0\r\n4\r\n5\r\n");
}

#[test]
fn the_prompt_comes_back_when_the_program_ends() {
    let mut desk = Desk::with("PROG0\nPROGRAM\nPRINT \"a\";\nENDP\n");
    desk.send("PROG0\r");
    assert_eq!(desk.send("LRUN\r"), "LRUN\r\n");
    assert_eq!(desk.wait(0.1), "a\r\nP00>");
    assert_eq!(desk.ask("LISTEN"), "");
}

#[test]
fn errors_show_with_their_line() {
    let mut desk = Desk::with("SYS\nDIM P(4)\nPROG0\nPROGRAM\nPRINT 1\n_here : PRINT 2\nP0 = 1 / P0\nPRINT 3\nENDP\n");
    desk.send("PROG0\r");
    desk.send("LRUN\r");
    assert_eq!(desk.wait(0.1), "1\r\n2\r\ndivision by zero [line 30]\r\nP00>");
    assert_eq!(desk.log.faults, ["PROG0 setup.8K line 7 statement 1: division by zero"]);
}

#[test]
fn pause_and_resume_while_listening_elsewhere() {
    let mut desk = Desk::with(&format!("{TWO_AXES}PROGRAM\nX10\nINH -516\nPRINT \"there\"\nENDP\n"));
    let other = desk.controller.open_channel("STREAM2".parse().expect("a name")).expect("a stream");
    desk.send("LRUN PROG0\r");
    desk.wait(0.5);
    desk.controller.receive(other, b"PAUSE PROG0\r");
    assert_eq!(desk.wait(5.0), "");
    desk.controller.receive(other, b"RESUME PROG0\r");
    assert_eq!(desk.wait(1.0), "there\r\nSYS>");
}

#[test]
fn idle_time_with_a_listener_costs_nothing() {
    let mut desk = Desk::with("PROG0\nPROGRAM\nINH 32\nENDP\n");
    desk.send("LRUN PROG0\r");
    assert_eq!(desk.wait(86_400.0), "");
    assert_eq!(desk.controller.seconds().round(), 86_400.0);
    assert_eq!(desk.send("\x1b"), "SYS>");
}

#[test]
fn a_program_asks_those_who_listen_to_it() {
    let mut desk =
        Desk::with("PROG0\nDIM LV(2)\nPROGRAM\nINPUT \"n = \"; LV0\nLV1 = GETCH(0)\nPRINT LV0; \" \"; LV1\nENDP\n");
    desk.send("PROG0\r");
    assert_eq!(desk.send("LRUN\r"), "LRUN\r\n");
    assert_eq!(desk.wait(0.1), "n = ");
    desk.controller.receive(desk.channel, b"4");
    assert_eq!(desk.wait(0.1), "4");
    desk.controller.receive(desk.channel, b"2\r\nA\r?5\r");
    assert_eq!(desk.wait(0.1), "2\r\n42 65\r\nP00>?5\r\n5\r\nP00>");
}

#[test]
fn a_stream_that_a_program_opens_takes_no_commands_until_it_is_closed() {
    let mut desk = Desk::with(
        "PROG0\nDIM $V(1,20)\nPROGRAM\nOPEN \"COM1:\" AS #1\nINPUT #1, \"name: \"; $V0\nPRINT #1, \"hello \"; $V0\nCLOSE #1\nENDP\n",
    );
    assert_eq!(desk.send("RUN PROG0\r"), "RUN PROG0\r\nSYS>");
    assert_eq!(desk.wait(0.1), "name: ");
    desk.controller.receive(desk.channel, b"VER\r");
    assert_eq!(desk.wait(0.1), "VER\r\nhello VER\r\n");
    assert_eq!(desk.ask("?1"), "1\r\n");
}

#[test]
fn talk_to_connects_two_streams_until_esc() {
    let mut desk = Desk::with("PROG0\nPROGRAM\nOPEN \"COM1:\" AS #1\nENDP\n");
    let near = desk.controller.open_channel("STREAM2".parse().expect("a name")).expect("a stream");
    desk.controller.receive(near, b"TALK TO \"COM1:\"\r");
    assert_eq!(desk.wait(0.1), "");
    assert_eq!(desk.controller.prompt_state(near), PromptState::Listening);
    desk.controller.receive(near, b"*IDN\rTPE");
    assert_eq!(desk.wait(0.1), "*IDN\rTPE");
    desk.controller.take_output(near);
    assert_eq!(desk.send("*0\r\n"), "", "what comes in at COM1 is no command meanwhile");
    assert_eq!(desk.controller.take_output(near), b"*0\r\n");
    desk.controller.receive(near, b"\x1bTALK TO \"STREAM2:\"\r");
    desk.wait(0.1);
    let answer: String = desk.controller.take_output(near).into_iter().map(char::from).collect();
    assert_eq!(answer, "SYS>TALK TO \"STREAM2:\"\r\nTALK TO: STREAM2 is the stream at which this was typed\r\nSYS>");
    assert_eq!(desk.ask("?1"), "1\r\n");
    desk.send("RUN PROG0\r");
    desk.controller.receive(near, b"TALK TO \"COM1:\"\r");
    desk.wait(0.1);
    let answer: String = desk.controller.take_output(near).into_iter().map(char::from).collect();
    assert!(answer.contains("COM1 is open already, as #1"), "{answer}");
}

#[test]
fn a_restart_brings_the_prompt_back() {
    let mut desk = Desk::with("PROG0\nPROGRAM\nDWL 0.1\nREBOOT\nENDP\n");
    desk.send("LRUN PROG0\r");
    assert_eq!(desk.wait(0.2), "SYS>");
    desk.send("PROG0\rRUN\r");
    // What a statement waits for is gone as well.
    assert_eq!(desk.send("DWL 5 : ?1\r"), "DWL 5 : ?1\r\nSYS>");
    assert_eq!(desk.ask("?2"), "2\r\n");
}

#[test]
fn plc_programs_are_listened_to() {
    let mut desk = Desk::with(
        "SYS\nDIM PLC0(400)\nDIM P(1)\nPLC0\nPROGRAM\nP0 = P0 + 1\nIF (P0 = 3) THEN PRINT \"third\"\nENDP\n",
    );
    assert_eq!(desk.send("LRUN PLC0\r"), "LRUN PLC0\r\n");
    assert_eq!(desk.wait(0.1), "third\r\n");
    assert_eq!(desk.controller.prompt_state(desk.channel), PromptState::Listening);
    assert_eq!(desk.send("\x1b"), "SYS>");
    assert_eq!(desk.ask("P0 = 0 : LRUN PLC1"), "", "there is no text in PLC1");
    desk.send("PLC0\rP0 = 0\rLISTEN\r");
    assert_eq!(desk.wait(0.1), "third\r\n");
    assert_eq!(desk.send("\x1b"), "PLC0>");
}

#[test]
fn the_mistakes_of_a_plc_program_are_shown_to_who_listens() {
    let mut desk = Desk::with("SYS\nDIM PLC0(400)\nPLC0\nPROGRAM\nP9 = 1\nENDP\n");
    desk.send("LRUN PLC0\r");
    assert_eq!(desk.wait(0.1), "P9 is outside DIM P(0) [line 10]\r\nSYS>");
    assert_eq!(desk.ask("LRUN ALL"), "LRUN expects one program or PLC program\r\n");
    assert_eq!(desk.ask("DTALK AXIS0"), "DTALK is not simulated: a dry run has no drive that could answer\r\n");
}
