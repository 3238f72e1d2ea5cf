//! Answers of a controller.

use acrc_link::{Console as _, LinkError};
use acrc_syntax::units::Level;

use crate::support::Machine;

const AXIS: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nACC 100 DEC 100 STP 100 VEL 10\n";

#[test]
fn lines_and_prompts_are_told_apart() {
    let machine = Machine::with(AXIS);
    let mut console = machine.connect();
    let answer = console.command("PROG0").expect("an answer");
    assert_eq!((answer.lines.len(), answer.prompt), (0, Level::Program(0)));
    let answer = console.command("ATTACH").expect("an answer");
    assert_eq!(answer.lines, ["ATTACH MASTER0", "ATTACH SLAVE0 AXIS0 \"X\""]);
    assert_eq!(console.command("ACC").and_then(|answer| answer.number()).ok(), Some(100.0));
    assert_eq!(console.command("PLC3").expect("an answer").prompt, Level::Plc(3));
    assert_eq!(console.command("").expect("an answer").lines, [""; 0]);
}

#[test]
fn a_refused_line_is_an_answer() {
    let mut console = Machine::new().connect();
    let answer = console.command("BLURB").expect("an answer");
    assert_eq!(answer.refusal(), Some("Unknown Command"));
    let error = answer.silence().expect_err("it was refused");
    assert_eq!(error.to_string(), "the controller refused `BLURB`: Unknown Command");
    assert!(!error.is_broken());
    assert!(console.command("? 1").is_ok());
}

#[test]
fn echo_and_prompt_can_be_off_when_a_connection_begins() {
    for echo in ["ECHO 0", "ECHO 4", "ECHO 5"] {
        let machine = Machine::new();
        let mut line = machine.line();
        machine.look(|controller| controller.receive(line.channel(), format!("{echo}\r").as_bytes()));
        machine.pass(0.1);
        line.forget();
        let mut console = line.connect();
        let number = console.command("? 3").and_then(|answer| answer.number());
        assert_eq!(number.ok(), Some(3.0), "{echo}");
        let open = console.command("? \"a\";").expect("an answer");
        assert_eq!((open.lines, open.prompt), (vec!["a".to_owned()], Level::System), "{echo}");
    }
}

#[test]
fn a_listening_channel_is_brought_back() {
    let machine = Machine::with("PROG0\nPROGRAM\n10 PRINT \"on\"\n20 DWL 0.01\n30 GOTO 10\nENDP\n");
    let mut line = machine.line();
    machine.look(|controller| controller.receive(line.channel(), b"PROG0\rLRUN\r"));
    machine.pass(0.2);
    line.forget();
    let mut console = line.connect();
    assert_eq!(console.command("? 5").and_then(|answer| answer.number()).ok(), Some(5.0));
}

#[test]
fn keys_do_not_disturb_the_next_answer() {
    let mut console = Machine::with(AXIS).connect();
    for key in [0x18, 0x19, 0x1b] {
        console.send_key(key).expect("it is sent");
        assert_eq!(console.command("? 7").and_then(|answer| answer.number()).ok(), Some(7.0));
    }
    assert_eq!(console.command("?BIT8467").and_then(|answer| answer.number()).ok(), Some(0.0));
}

#[test]
fn waiting_has_an_end_and_the_next_line_is_answered() {
    let machine = Machine::new();
    let mut console = machine.connect();
    let error = console.command("PROG0 INH 32").expect_err("the input does not come");
    assert_eq!(error.to_string(), "timed out after 5 s waiting for the answer to `PROG0 INH 32`");
    assert!(matches!(error, LinkError::Timeout { .. }));
    assert_eq!(console.command("? 7").and_then(|answer| answer.number()).ok(), Some(7.0));
}

#[test]
fn only_lines_are_sent_as_lines() {
    let mut console = Machine::new().connect();
    for line in ["VEL 5\rVEL 6", "VEL 5\n", "\u{18}", "? \"€\""] {
        assert!(matches!(console.command(line), Err(LinkError::NotSendable { .. })), "{line:?}");
    }
}
