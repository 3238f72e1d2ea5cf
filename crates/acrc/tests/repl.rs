//! `acrc repl`: the terminal of a virtual controller, through a pipe.

mod common;

use common::{Bench, gantry};

const MACHINE: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPPU X1000\nACC 100 DEC 100 STP 100 VEL 10\n\
                       PROGRAM\nX10\nINH -516\nPRINT \"there\"\nENDP\n";

/// What the controller sends for what is typed.
#[track_caller]
fn talk(bench: &Bench, arguments: &[&str], input: &str) -> String {
    let arguments: Vec<&str> = ["repl"].iter().chain(arguments).copied().collect();
    let output = bench.feed(&arguments, input.as_bytes());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("ASCII in these tests")
}

#[test]
fn a_pipe_gets_exactly_the_bytes_of_the_controller() {
    let bench = Bench::new();
    bench.file("machine.8K", MACHINE);
    assert_eq!(talk(&bench, &["machine.8K"], "PROG0\rACC\r"), "PROG0\r\nP00>ACC\r\n100\r\nP00>");
    assert_eq!(talk(&bench, &["machine.8K"], "PROG0\r\nACC\r\n"), "PROG0\r\nP00>ACC\r\n100\r\nP00>");
    assert_eq!(talk(&bench, &[], ""), "");
}

#[test]
fn stored_programs_wait_for_run() {
    let bench = Bench::new();
    bench.file("machine.8K", MACHINE);
    assert_eq!(
        talk(&bench, &["machine.8K"], "?P12288\rLRUN PROG0\r?P12288\r"),
        "?P12288\r\n0\r\nSYS>LRUN PROG0\r\nthere\r\nSYS>?P12288\r\n10000\r\nSYS>"
    );
}

#[test]
fn a_terminal_starts_what_power_up_starts_and_no_more() {
    let bench = Bench::new();
    bench.file(
        "machine/Setup.8K",
        "SYS\nDIM P(1)\nDIM PLC1(400)\nPLC1\nPROGRAM\nP0 = P0 + 1\nENDP\nPROG0\nPROGRAM\nPRINT SIN(90)\nENDP\n",
    );
    bench.file("machine/acrc.toml", "[sim]\nrun = [\"PROG0\", \"PLC1\"]\nangles = \"degrees\"\nplc-scan = \"20ms\"\n");
    assert_eq!(talk(&bench, &["machine"], "?BIT1032,BIT1568,P0\r"), "?BIT1032,BIT1568,P0\r\n0\t0\t0\r\nSYS>");
    let typed = "LRUN PROG0\rRUN PLC1\rPROG0\rDWL 0.1 : HALT PLC1 : ?P0\r";
    let heard = talk(&bench, &["machine"], typed);
    assert!(heard.starts_with("LRUN PROG0\r\n1\r\n") && heard.ends_with("\r\n5\r\nP00>"), "{heard}");
}

#[test]
fn programs_with_pboot_run() {
    let bench = Bench::new();
    bench.file("boot.8K", "SYS\nDIM P(4)\nPROG0\nPROGRAM\nPBOOT\nP0 = 7\nENDP\n");
    assert_eq!(talk(&bench, &["boot.8K"], "?P0\r"), "?P0\r\n7\r\nSYS>");
}

#[test]
fn a_state_folder_outlasts_the_session() {
    let bench = Bench::new();
    let state = ["--state", "kept"];
    let no_battery = ["--state", "kept", "--no-battery"];
    let enter = "PROG0\rPROGRAM\rPBOOT\rPRINT \"up\"\rENDP\r";
    let text = "PROG0\r\nP00>LIST\r\nPBOOT\r\nPRINT \"up\"\r\nP00>";
    talk(&bench, &state, enter);
    assert_eq!(talk(&bench, &state, "PROG0\rLIST\r"), text);
    // What is in the memory is lost when power goes off without a battery.
    assert_eq!(talk(&bench, &no_battery, "PROG0\rLIST\r"), text);
    assert_eq!(talk(&bench, &state, "PROG0\rLIST\r"), "PROG0\r\nP00>LIST\r\nP00>");
    talk(&bench, &no_battery, &format!("{enter}FLASH SAVE\r"));
    assert_eq!(talk(&bench, &state, "PROG0\rLIST\r"), text);
}

#[test]
fn what_still_goes_on_is_waited_for_and_no_longer_than_asked() {
    let bench = Bench::new();
    bench.file("loop.8K", "PROG0\nPROGRAM\n_again\nPRINT \"tick\"\nDWL 1\nGOTO again\nENDP\n");
    assert_eq!(talk(&bench, &[], "DWL 5 : ?1\r"), "DWL 5 : ?1\r\nUnknown Command\r\n1\r\nSYS>");
    assert_eq!(talk(&bench, &[], "PROG0\rDWL 5 : ?1\r"), "PROG0\r\nP00>DWL 5 : ?1\r\n1\r\nP00>");
    let heard = talk(&bench, &["loop.8K", "--linger", "3500ms"], "LRUN PROG0\r");
    assert_eq!(heard, "LRUN PROG0\r\ntick\r\ntick\r\ntick\r\ntick\r\n");
    assert_eq!(
        talk(&bench, &["loop.8K"], "LRUN PROG0\r\u{1b}HALT PROG0\r"),
        "LRUN PROG0\r\ntick\r\nSYS>HALT PROG0\r\nSYS>"
    );
}

#[test]
fn control_keys_do_not_overtake_what_was_typed_before() {
    let bench = Bench::new();
    bench.file("machine.8K", MACHINE);
    let answer = talk(&bench, &["machine.8K"], "PROG0\rX10\r?BIT516\r\u{18}?BIT516\rX0\r\u{19}X0\r");
    assert_eq!(
        answer,
        "PROG0\r\nP00>X10\r\nP00>?BIT516\r\n-1\r\nP00>?BIT516\r\n0\r\nP00>X0\r\n\
         Associated Slave Kill Motion Request Active\r\nP00>X0\r\nP00>"
    );
}

#[test]
fn a_program_is_entered_listed_and_run() {
    let bench = Bench::new();
    let input = "SYS\rDIM P(4)\rPROG3\rPROGRAM\rP0 = 2\rPRINT P0 * 21\rENDP\r15 P0 = P0 + 1\rLIST\rLRUN\r";
    let answer = talk(&bench, &[], input);
    assert!(
        answer.ends_with("LIST\r\nP0 = 2\r\n15 P0 = P0 + 1\r\nPRINT P0 * 21\r\nP03>LRUN\r\n63\r\nP03>"),
        "{answer:?}"
    );
}

#[test]
fn model_and_stream_are_chosen() {
    let bench = Bench::new();
    assert_eq!(talk(&bench, &["--stream", "STREAM2"], "STREAM\r"), "STREAM\r\nSTREAM2\r\nSYS>");
    let answer = talk(&bench, &["--model", "ACR8020"], "STREAM\rVER\r");
    assert!(answer.starts_with("STREAM\r\nDPCB\r\n") && answer.contains("ACR8020"), "{answer:?}");
    let refused = bench.acrc(["repl", "--model", "ACR8020", "--stream", "STREAM2"]).expect(2);
    assert!(refused.stderr.contains("ACR8020 has no STREAM2"), "{}", refused.stderr);
    let refused = bench.acrc(["repl", "--model", "ACR1"]).expect(2);
    assert!(refused.stderr.contains("the models are ACR9000"), "{}", refused.stderr);
    bench.acrc(["repl", "--speed", "0"]).expect(2);
}

#[test]
fn real_time_is_kept() {
    let bench = Bench::new();
    let answer = talk(&bench, &["--speed", "100"], "PROG0\rDWL 2 : ?1\r");
    assert_eq!(answer, "PROG0\r\nP00>DWL 2 : ?1\r\n1\r\nP00>");
}

#[test]
fn a_project_that_does_not_compile_is_not_started() {
    let bench = Bench::new();
    bench.file("bad.8K", "PROG0\nPROGRAM\nGOTO nowhere\nENDP\n");
    let run = bench.acrc(["repl", "bad.8K"]).expect(1);
    assert!(run.stdout.is_empty() && run.stderr.contains("nowhere"), "{}", run.stderr);
}

#[test]
fn what_no_channel_shows_goes_to_standard_error() {
    let bench = Bench::new();
    bench.file("setup.8K", "PRINT \"hello\"\nDIM PROG0(100)\n");
    let output = bench.feed(&["repl", "setup.8K"], b"?1\r");
    assert_eq!(output.stdout, b"?1\r\n1\r\nSYS>");
    let notes = String::from_utf8(output.stderr).expect("UTF-8");
    assert!(notes.contains("note: setup: hello\n") && notes.contains("Re-dimensioned block"), "{notes}");
}

#[test]
fn the_example_machine_answers() {
    let bench = Bench::new();
    let folder = gantry();
    let folder = folder.to_str().expect("UTF-8");
    let answer = talk(&bench, &[folder], "PROG0\rATTACH\r");
    assert_eq!(
        answer,
        "PROG0\r\nP00>ATTACH\r\nATTACH MASTER0\r\nATTACH SLAVE0 AXIS0 \"X\"\r\nATTACH SLAVE1 AXIS1 \"Y\"\r\nP00>"
    );
}

#[test]
fn a_mistake_is_told_once() {
    let bench = Bench::new();
    let output = bench.feed(&["repl"], b"PROG0\rPROGRAM\rNEXT\rENDP\rLRUN\r");
    assert!(String::from_utf8_lossy(&output.stdout).contains("NEXT without FOR [line 10]"));
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    let output = bench.feed(&["repl"], b"PROG0\rPROGRAM\rNEXT\rENDP\rRUN\r");
    assert!(String::from_utf8_lossy(&output.stderr).contains("NEXT without FOR"));
}

#[test]
fn what_goes_out_at_another_stream_is_told() {
    let bench = Bench::new();
    let output = bench.feed(&["repl"], b"OPEN \"COM2:\" AS #1\rPRINT #1, \"ready\"\r");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "note: COM2: ready\n");
}

#[test]
fn a_short_program_ends_before_what_is_typed_behind_it() {
    let bench = Bench::new();
    let typed = "PROG0\rPROGRAM\rPRINT \"one\"\rPRINT \"two\"\rENDP\rLRUN\r?3\r\x1b?4\r";
    let answer = talk(&bench, &[], typed);
    assert!(answer.ends_with("P00>LRUN\r\none\r\ntwo\r\nP00>?3\r\n3\r\nP00>?4\r\n4\r\nP00>"), "{answer}");
}

#[test]
fn a_text_with_mistakes_is_still_there_after_the_power_was_off() {
    let bench = Bench::new();
    talk(&bench, &["--state", "kept"], "PROG0\r10 PRINT 1 : GARBAGE GARBAGE\r");
    let answer = talk(&bench, &["--state", "kept"], "PROG0\rLIST\rLRUN\r");
    assert!(answer.contains("\r\n10 PRINT 1 : GARBAGE GARBAGE\r\nP00>"), "{answer}");
    assert!(answer.ends_with(" [line 10]\r\nP00>"), "{answer}");
    let shown = bench.acrc(["state", "show", "kept"]).expect(0).stdout;
    assert!(shown.contains("battery-backed memory  PROG0; "), "{shown}");
}

#[test]
fn an_image_is_no_project() {
    let bench = Bench::new();
    bench.file("machine.8K", MACHINE);
    bench.acrc(["build", "machine.8K", "-o", "machine.acrx"]).expect(0);
    let said = bench.acrc(["repl", "machine.acrx"]).expect(2).stderr;
    assert!(said.contains("`machine.acrx` is an image, and no project: expected a program text"), "{said}");
}
