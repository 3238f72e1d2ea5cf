//! Commands without arguments.

use crate::support::{Desk, TWO_AXES};

#[test]
fn settings_of_a_master_and_of_axes() {
    let mut desk = Desk::machine();
    desk.ask("ACC 10000 : FBVEL X 0.0001 Y 0.0002");
    assert_eq!(desk.ask("ACC"), "10000\r\n");
    assert_eq!(desk.ask("FBVEL X"), "0.0001\r\n");
    assert_eq!(desk.ask("FBVEL X Y"), "0.0001\r\n0.0002\r\n");
    assert_eq!(desk.ask("VEL"), "10\r\n");
    assert_eq!(desk.ask("FOV"), "1\r\n");
}

#[test]
fn attachments() {
    let mut desk = Desk::with(&format!("SYS\nATTACH AXIS1 ENC2 STEPPER3 ENC2\n{TWO_AXES}"));
    let lines = desk.ask("ATTACH");
    assert!(lines.starts_with("ATTACH AXIS0 ENC0 DAC0 ENC0\r\nATTACH AXIS1 ENC2 STEPPER3 ENC2\r\n"), "{lines:?}");
    desk.send("PROG0\r");
    assert_eq!(desk.ask("ATTACH"), "ATTACH MASTER0\r\nATTACH SLAVE0 AXIS0 \"X\"\r\nATTACH SLAVE1 AXIS1 \"Y\"\r\n");
    desk.send("PROG1\r");
    assert_eq!(desk.ask("ATTACH"), "");
}

#[test]
fn memory_of_the_system() {
    let mut desk = Desk::new();
    assert_eq!(desk.ask("DIM").lines().last(), Some("DIM PROG7(65536)"));
    for line in ["CLEAR", "DIM PROG0(8192)", "DIM PLC1(200)", "DIM P(100)", "DIM DEF(50)", "DIM STREAM2(512)"] {
        assert_eq!(desk.ask(line), "");
    }
    assert_eq!(
        desk.ask("DIM"),
        "DIM PROG0(8192)\r\nDIM PLC1(200)\r\nDIM P(100)\r\nDIM DEF(50)\r\nDIM STREAM2(512)\r\n"
    );
    assert_eq!(desk.ask("MEM"), format!("{}\r\n", 1_048_576 - 8192 - 200 - 800 - 2416 - 512));
}

#[test]
fn buffers_of_streams() {
    let mut desk = Desk::new();
    let free: u32 = desk.ask("MEM").trim().parse().expect("a number");
    assert_eq!(desk.ask("DIM COM2(300) : DIM STREAM5(100)"), "");
    assert_eq!(desk.ask("DIM COM2(400)"), "Re-dimensioned block\r\n");
    assert_eq!(desk.ask("MEM"), format!("{}\r\n", free - 400));
    assert_eq!(desk.ask("CLEAR COM2 : DIM COM2(400) : CLEAR STREAM5"), "");
    assert_eq!(desk.ask("MEM"), format!("{}\r\n", free - 400));
    for (line, stream) in [("CLEAR FIFO", "FIFO"), ("DIM DPCB(100)", "DPCB"), ("DIM STREAM6(100)", "STREAM6")] {
        assert!(desk.ask(line).starts_with(&format!("ACR9000 has no {stream}: its streams are COM1")), "{line}");
    }
}

#[test]
fn one_kind_of_memory() {
    let mut desk = Desk::machine();
    for line in ["DIM LV(4)", "DIM LA(2)", "DIM LA0(10)", "DIM $V(3, 20)"] {
        assert_eq!(desk.ask(line), "", "{line}");
    }
    assert_eq!(desk.ask("DIM LA"), "DIM LA(2)\r\nDIM LA0(10)\r\n");
    assert_eq!(desk.ask("DIM LV"), "DIM LV(4)\r\n");
    assert_eq!(desk.ask("DIM MBUF"), "");
    desk.send("SYS\r");
    assert_eq!(desk.ask("DIM P(10) : DIM P"), "DIM P(10)\r\n");
}

#[test]
fn the_move_buffer() {
    let mut desk = Desk::machine();
    let free: u32 = desk.ask("MEM").trim().parse().expect("a number");
    assert_eq!(desk.ask("DIM MBUF(10)"), "");
    assert_eq!(desk.ask("DIM MBUF"), "DIM MBUF(10)\r\n");
    assert_eq!(desk.ask("MEM"), format!("{}\r\n", free - 10 * 136));
    assert_eq!(desk.ask("DIM MBUF(5)"), "Re-dimensioned block\r\n");
    assert_eq!(desk.ask("CLEAR MBUF"), "");
    assert_eq!(desk.ask("MEM"), format!("{free}\r\n"));
    let most = free / 136;
    let refused = desk.ask(&format!("DIM MBUF({})", most + 1));
    assert_eq!(
        refused,
        format!("{} bytes do not fit into the {free} bytes that the program has left\r\n", (most + 1) * 136)
    );
    assert_eq!(desk.ask(&format!("DIM MBUF({most}) : CLEAR : DIM MBUF(2)")), "");
}

#[test]
fn memory_of_a_program() {
    let mut desk = Desk::machine();
    for line in ["DIM LV(4)", "DIM $V(3, 20)", "DIM LA(2)", "DIM LA0(10)", "DIM $A(1)", "DIM $A0(5, 8)"] {
        assert_eq!(desk.ask(line), "", "{line}");
    }
    assert_eq!(
        desk.ask("DIM"),
        "DIM LV(4)\r\nDIM $V(3, 20)\r\nDIM LA(2)\r\nDIM LA0(10)\r\nDIM $A(1)\r\nDIM $A0(5, 8)\r\n"
    );
    let free: u32 = desk.ask("MEM").trim().parse().expect("a number");
    assert!(free < 65_536 - 16 - 60 - 40, "{free}");
    desk.ask("CLEAR");
    assert_eq!(desk.ask("DIM"), "");
    assert_eq!(desk.ask("MEM"), "65536\r\n");
}

#[test]
fn aliases() {
    let mut desk = Desk::with("SYS\nDIM P(4)\nDIM DEF(4)\n#DEFINE ready BIT32\n#DEFINE limit 2.5\n");
    desk.ask("#DEFINE count P1");
    assert_eq!(desk.ask("DEF"), "#DEFINE ready BIT32\r\n#DEFINE limit 2.5\r\n#DEFINE count P1\r\n");
}

#[test]
fn the_channel() {
    let mut desk = Desk::new();
    for (line, answer) in
        [("ECHO", "1\r\n"), ("MODE", "1\r\n"), ("MODE 3", ""), ("MODE", "3\r\n"), ("STREAM", "COM1\r\n")]
    {
        assert_eq!(desk.ask(line), answer, "{line}");
    }
    assert_eq!(desk.ask("ECHO 9"), "ECHO: 9 is not a whole number from 0 to 7\r\n");
}

#[test]
fn the_controller() {
    let mut desk = Desk::new();
    assert_eq!(desk.ask("PERIOD"), "0.0005\r\n");
    assert!(desk.ask("VER").starts_with("ACR9000 "));
    assert_eq!(desk.ask("CONFIG"), "CONFIG ENC8 DAC4 DAC4 ADC8\r\n");
    assert_eq!(desk.ask("CONFIG ENC4 DAC4 NONE NONE"), "");
    assert_eq!(desk.ask("CONFIG"), "CONFIG ENC4 DAC4 NONE NONE\r\n");
    desk.ask("CONFIG CLEAR");
    assert_eq!(desk.ask("CONFIG"), "CONFIG ENC8 DAC4 DAC4 ADC8\r\n");
    assert_eq!(desk.ask("IP"), "192.168.10.40\r\n255.255.255.0\r\n0.0.0.0\r\n");
    assert_eq!(desk.ask("IP \"10.0.0.5\" : IP MASK \"255.0.0.0\""), "");
    assert_eq!(desk.ask("IP"), "10.0.0.5\r\n255.0.0.0\r\n0.0.0.0\r\n");
    assert_eq!(desk.ask("IP \"10.0.0\""), "IP expects an address in quotes: \"192.168.10.40\"\r\n");
    assert_eq!(desk.ask("DIAG"), "NO FAULTS\r\n");
    assert!(desk.ask("CPU").ends_with("PERIOD 0.0005\r\n"));
}

#[test]
fn diagnosis_names_what_keeps_the_machine_from_moving() {
    let mut desk = Desk::machine();
    desk.ask("SET 8467 : SET 522");
    assert_eq!(
        desk.ask("DIAG"),
        "AXIS0 KILL ALL MOTION REQUEST\r\nAXIS1 KILL ALL MOTION REQUEST\r\nMASTER0 KILL ALL MOVES\r\n"
    );
}

#[test]
fn help_lists_the_commands_of_the_prompt() {
    let mut desk = Desk::new();
    let system = desk.ask("HELP");
    assert!(system.contains("ESAVE") && !system.contains("GOSUB"), "{system}");
    assert!(!system.contains("assignment"), "{system}");
    desk.send("PROG0\r");
    assert!(desk.ask("HELP").contains("GOSUB"));
}

#[test]
fn a_program_that_has_ended_has_no_subroutine_open() {
    let mut desk = Desk::new();
    desk.send("PROG0\rPROGRAM\rGOSUB S\r_S\rEND\rENDP\r");
    let free = desk.ask("MEM");
    desk.send("RUN\r");
    desk.wait(0.1);
    assert_eq!(desk.ask("MEM"), free);
}

#[test]
fn aliases_are_lost_with_the_memory_they_were_in() {
    let mut desk = Desk::new();
    desk.send("DIM DEF(2)\r#DEFINE speed P38912\rREBOOT\r");
    assert_eq!(desk.ask("DEF"), "#DEFINE speed P38912\r\n");
    desk.send("BRESET\rREBOOT\r");
    assert_eq!(desk.ask("DEF"), "");
    assert_eq!(desk.ask("?speed"), "the name `speed` is not defined\r\n");
}

#[test]
fn a_text_that_cannot_be_executed_outlasts_a_reset() {
    let mut desk = Desk::new();
    desk.send("PROG0\rPROGRAM\rPRINT 1\rIF (1)\rENDP\rPROG1\rPROGRAM\rPRINT 2\rENDP\rREBOOT\rPROG0\r");
    assert_eq!(desk.ask("LIST"), "PRINT 1\r\nIF (1)\r\n");
    let told = desk.send("LRUN\r") + &desk.wait(0.1);
    assert_eq!(told, "LRUN\r\nIF without ENDIF [line 20]\r\nP00>");
    desk.send("PROG1\r");
    assert_eq!(desk.ask("LIST"), "PRINT 2\r\n");
    assert_eq!(
        desk.log.faults,
        ["PROG0 line 20 statement 1: IF without ENDIF"],
        "LRUN has found it, and not the reset"
    );
}

#[test]
fn forgotten_aliases_do_not_come_back_with_the_power() {
    let mut desk = Desk::new();
    desk.send("DIM DEF(3)\r#DEFINE old P1\r#DEFINE moved P4\rCLEAR\rDIM P(9)\rDIM DEF(3)\rDIM PROG0(400)\r");
    desk.send(
        "#DEFINE fresh P2\r#DEFINE moved P5\rPROG0\rPROGRAM\rmoved = 7\rENDP\rLIST\rSYS\r#DEFINE moved P6\rREBOOT\r",
    );
    assert_eq!(desk.ask("DEF"), "#DEFINE fresh P2\r\n#DEFINE moved P6\r\n");
    desk.send("RUN PROG0\r");
    desk.wait(0.1);
    assert_eq!(desk.ask("?P4 : ?P5 : ?P6"), "0\r\n7\r\n0\r\n");
    assert_eq!(desk.ask("? old"), "the name `old` is not defined\r\n");
}

#[test]
fn help_has_all_that_a_prompt_takes() {
    let mut desk = Desk::new();
    let words = |help: String| help.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let system = words(desk.ask("HELP"));
    desk.send("PROG0\r");
    let program = words(desk.ask("HELP"));
    assert!(system.iter().all(|word| program.contains(word)), "{system:?}\n{program:?}");
    assert!(["ESAVE", "CONFIG", "IP", "FLASH", "VEL"].iter().all(|word| program.contains(&(*word).to_owned())));
    assert!(!system.contains(&"VEL".to_owned()));
}

#[test]
fn a_move_buffer_reports_whether_it_is_on() {
    let mut desk = Desk::machine();
    assert_eq!(desk.ask("MBUF : MBUF ON : MBUF : MASTER0 MBUF"), "MBUF OFF\r\nMBUF ON\r\nMBUF ON\r\n");
    desk.send("SYS\r");
    assert_eq!(desk.ask("MBUF"), "Unknown Command\r\n");
}
