//! Programs that are entered and changed at the prompt.

use crate::support::{Desk, TWO_AXES};

/// Types lines; every one is answered with nothing.
#[track_caller]
fn enter(desk: &mut Desk, lines: &str) {
    for line in lines.lines() {
        assert_eq!(desk.ask(line), "", "{line}");
    }
}

#[test]
fn program_to_endp_is_stored_and_not_run() {
    let mut desk = Desk::with("SYS\nDIM P(10)\n");
    enter(&mut desk, "PROG0\nPROGRAM\nP0 = 1\n\n' dropped\nif (P0 = 1)\np1 = 2:p2 = 3\nendif\nENDP");
    assert_eq!(desk.ask("?P0"), "0\r\n");
    assert_eq!(desk.ask("LIST"), "P0 = 1\r\nIF (P0 = 1)\r\n    P1 = 2 : P2 = 3\r\n    ENDIF\r\n");
    enter(&mut desk, "RUN");
    desk.wait(0.1);
    assert_eq!(desk.ask("?P0,P1,P2"), "1\t2\t3\r\n");
}

#[test]
fn program_replaces_what_was_stored() {
    let mut desk = Desk::machine();
    enter(&mut desk, "PROGRAM\nVEL 1\nENDP\nPROGRAM\nVEL 2\nENDP");
    assert_eq!(desk.ask("LIST"), "VEL 2\r\n");
    enter(&mut desk, "NEW");
    assert_eq!(desk.ask("LIST"), "");
}

#[test]
fn a_whole_program_on_one_line() {
    let mut desk = Desk::machine();
    assert_eq!(desk.ask("PROGRAM : VEL 3 : ACC 4 : ENDP : ?1"), "1\r\n");
    assert_eq!(desk.ask("LIST"), "VEL 3 : ACC 4\r\n");
}

#[test]
fn numbered_lines_take_their_places() {
    let mut desk = Desk::machine();
    enter(&mut desk, "PROGRAM\nVEL 1\nVEL 2\nVEL 3\nENDP\n15 VEL 1000\n20 VEL 22");
    assert_eq!(desk.ask("LIST"), "VEL 1\r\n15 VEL 1000\r\n20 VEL 22\r\nVEL 3\r\n");
    enter(&mut desk, "SET 5651");
    assert_eq!(desk.ask("LIST"), "10 VEL 1\r\n15 VEL 1000\r\n20 VEL 22\r\n30 VEL 3\r\n");
    enter(&mut desk, "20\n10\n99");
    assert_eq!(desk.ask("LIST"), "15 VEL 1000\r\n30 VEL 3\r\n");
    enter(&mut desk, "RUN");
    desk.wait(0.1);
    assert_eq!(desk.ask("VEL"), "3\r\n");
}

#[test]
fn numbers_between_program_and_endp_order_the_lines_that_have_them() {
    let mut desk = Desk::machine();
    enter(&mut desk, "PROGRAM\n10 VEL 1\n5 VEL 2\n10 VEL 3\nENDP");
    assert_eq!(desk.ask("LIST"), "5 VEL 2\r\n10 VEL 3\r\n");
    enter(&mut desk, "PROGRAM\nVEL 1\nVEL 2\n10 VEL 3\nVEL 4\n5 VEL 5\nENDP");
    assert_eq!(desk.ask("LIST"), "VEL 1\r\nVEL 2\r\n5 VEL 5\r\n10 VEL 3\r\nVEL 4\r\n");
}

#[test]
fn plc_programs_are_entered_run_and_erased() {
    let mut desk = Desk::with("SYS\nDIM PLC0(400)\n");
    enter(&mut desk, "PLC0\nPROGRAM\nLD 128\nOUT 40\nENDP\nRUN\nSET 128");
    desk.wait(0.1);
    assert!(desk.bit(40) && desk.bit(1536));
    assert_eq!(desk.ask("20 OUT 41"), "Program is running\r\n");
    enter(&mut desk, "HALT\n20 OUT 41\nRUN PLC0");
    desk.wait(0.1);
    assert!(desk.bit(41) && desk.bit(1536));
    enter(&mut desk, "NEW PLC0");
    assert_eq!(desk.ask("LIST"), "");
    enter(&mut desk, "RUN");
    assert!(!desk.bit(1536));
}

#[test]
fn a_plc_program_with_mistakes_says_so_when_it_is_started() {
    let mut desk = Desk::with("SYS\nDIM PLC0(400)\n");
    enter(&mut desk, "PLC0\nPROGRAM\nBOGUS 1\nENDP\nRUN");
    desk.wait(0.1);
    assert_eq!(desk.log.faults.len(), 1, "{:?}", desk.log.faults);
    assert!(desk.log.faults[0].starts_with("PLC0 line 10 statement 1: "), "{:?}", desk.log.faults);
}

#[test]
fn pboot_starts_a_text_that_was_edited() {
    let mut desk = Desk::with("SYS\nDIM P(4)\nDIM PLC0(400)\n");
    enter(&mut desk, "PLC0\nPROGRAM\nPBOOT\nLD NOT 128\nOUT 40\nENDP\nPROG0\nPROGRAM\nPBOOT\nP0 = 5\nENDP\nSYS\nPBOOT");
    desk.wait(0.1);
    assert!(desk.bit(40));
    assert_eq!(desk.ask("?P0"), "5\r\n");
}

#[test]
fn a_range_of_lines_is_listed() {
    let mut desk = Desk::machine();
    enter(&mut desk, "PROGRAM\nVEL 1\nVEL 2\nVEL 3\nVEL 4\nENDP");
    assert_eq!(desk.ask("LIST 20, 30"), "VEL 2\r\nVEL 3\r\n");
    assert_eq!(desk.ask("LIST 40"), "VEL 4\r\n");
    assert_eq!(desk.ask("LIST 45, 60"), "");
}

#[test]
fn programs_of_the_project_can_be_changed() {
    let mut desk = Desk::with(&format!("{TWO_AXES}PROGRAM\n_again\nVEL 1\nGOTO again\nENDP\n"));
    enter(&mut desk, "PROG0\n15 DWL 1");
    assert_eq!(desk.ask("LIST"), "_again\r\n15 DWL 1\r\nVEL 1\r\nGOTO again\r\n");
    enter(&mut desk, "RUN");
    desk.wait(1.5);
    assert_eq!(desk.ask("VEL"), "1\r\n");
}

#[test]
fn a_running_program_cannot_be_changed_and_its_lines_are_not_executed() {
    let mut desk = Desk::with(&format!("{TWO_AXES}PROGRAM\nINH 32\nENDP\n"));
    enter(&mut desk, "PROG0\nRUN");
    assert_eq!(desk.ask("15 VEL 5"), "Program is running\r\n");
    assert_eq!(desk.ask("PROGRAM"), "Program is running\r\n");
    enter(&mut desk, "VEL 77\nX10\nENDP");
    assert_eq!(desk.ask("VEL"), "10\r\n");
    assert!(!desk.bit(516));
    enter(&mut desk, "HALT");
    assert_eq!(desk.ask("LIST"), "INH 32\r\n");
    enter(&mut desk, "15 VEL 5");
}

#[test]
fn a_text_that_does_not_fit_is_refused() {
    let mut desk = Desk::with("SYS\nCLEAR\nDIM PROG0(20)\n");
    enter(&mut desk, "PROG0\nPROGRAM\nSET 1\nSET 2\nENDP");
    assert_eq!(desk.ask("MEM"), "4\r\n");
    assert_eq!(desk.ask("15 SET 3"), "PROG0 needs 32 bytes but DIM PROG0 gives 20\r\n");
    enter(&mut desk, "PROGRAM\nSET 3\nSET 4\nSET 5");
    assert_eq!(desk.ask("ENDP"), "PROG0 needs 24 bytes but DIM PROG0 gives 20\r\n");
    assert_eq!(desk.ask("LIST"), "SET 1\r\nSET 2\r\n");
}

#[test]
fn mistakes_are_silent_at_entry_and_told_to_lrun() {
    let mut desk = Desk::machine();
    enter(&mut desk, "PROGRAM\nVEL 1\nVEL =\nGOTO nowhere\nENDP");
    assert_eq!(desk.ask("LIST"), "VEL 1\r\nVEL =\r\nGOTO nowhere\r\n");
    enter(&mut desk, "RUN");
    assert_eq!(
        desk.send("LRUN\r"),
        "LRUN\r\nSyntax error: expected a value after `VEL`, found `=` [line 20]\r\n\
         the label `nowhere` is not defined in this program [line 30]\r\nP00>"
    );
    enter(&mut desk, "20 VEL 8\n30 END\nRUN");
    desk.wait(0.1);
    assert_eq!(desk.ask("VEL"), "8\r\n");
}

#[test]
fn a_block_that_does_not_close_shows_in_the_listing_and_in_lrun() {
    let mut desk = Desk::machine();
    enter(&mut desk, "PROGRAM\nIF (BIT 1)\nVEL 1\nVEL 2\nENDP");
    assert_eq!(desk.ask("LIST"), "IF (BIT1)\r\n    VEL 1\r\n    VEL 2\r\n");
    assert_eq!(desk.send("LRUN\r"), "LRUN\r\nIF without ENDIF [line 10]\r\nP00>");
}

#[test]
fn aliases_of_an_entered_text_are_defined() {
    let mut desk = Desk::with("SYS\nDIM P(10)\nDIM DEF(2)\n");
    enter(&mut desk, "PROG0\nPROGRAM\n#DEFINE count P1\ncount = count + 1\nENDP\nRUN");
    desk.wait(0.1);
    assert_eq!(desk.ask("? count"), "1\r\n");
    assert_eq!(desk.ask("LIST"), "#DEFINE count P1\r\ncount = count + 1\r\n");
}

#[test]
fn a_password_keeps_programs_from_being_listed() {
    let mut desk = Desk::machine();
    enter(&mut desk, "PROGRAM\nVEL 1\nENDP\nSYS\nPASSWORD ON \"secret\"\nPROG0");
    assert_eq!(desk.ask("LIST"), "Program is protected\r\n");
    enter(&mut desk, "SYS");
    assert_eq!(desk.ask("PASSWORD OFF \"guess\""), "Wrong password\r\n");
    enter(&mut desk, "PASSWORD OFF \"secret\"\nPROG0");
    assert_eq!(desk.ask("LIST"), "VEL 1\r\n");
}

#[test]
fn plc_programs_are_entered_at_their_prompt() {
    let mut desk = Desk::with("SYS\nDIM PLC0(200)\n");
    assert_eq!(desk.send("PLC 0\r"), "PLC 0\r\nPLC0>");
    enter(&mut desk, "PROGRAM\nLD 5\nOUT 32\nENDP");
    assert_eq!(desk.ask("LIST"), "LD 5\r\nOUT 32\r\n");
}

#[test]
fn a_text_with_mistakes_outlasts_a_reset() {
    let mut desk = Desk::new();
    enter(&mut desk, "PROG0\n10 PRINT 1 : GARBAGE GARBAGE\nREBOOT\nPROG0");
    assert_eq!(desk.ask("LIST"), "10 PRINT 1 : GARBAGE GARBAGE\r\n");
    assert!(desk.send("LRUN\r").contains(" [line 10]\r\n"));
    enter(&mut desk, "10 PRINT 1");
    assert_eq!(desk.send("LRUN\r") + &desk.wait(0.1), "LRUN\r\n1\r\nP00>");
}

#[test]
fn line_numbers_beyond_the_stored_form_are_refused() {
    let mut desk = Desk::machine();
    let refusal = "the number 4294967296 is too large: line numbers go up to 2147483647\r\n";
    assert_eq!(desk.ask("4294967296 VEL 1"), refusal);
    assert_eq!(desk.ask("LIST"), "");
}
