//! `acrc fmt`: what is written, checked and shown.

mod common;

use common::Bench;

const MESSY: &str = "PROGRAM\r\nif (bit 24)\r\nset34:X10 Y/-5:rem \u{e4}\r\nendif\r\nENDP\r\n";
const NEAT: &str = "PROGRAM\r\nIF (BIT24)\r\n    SET 34 : X10 Y/-5 : REM \u{e4}\r\n    ENDIF\r\nENDP\r\n";

fn latin1(text: &str) -> Vec<u8> {
    text.chars().map(|character| u8::try_from(character).expect("one byte")).collect()
}

#[test]
fn only_what_changes_is_written_in_its_encoding() {
    let bench = Bench::new();
    bench.file("Prog0.8K", latin1(MESSY));
    bench.file("Prog1.8K", NEAT);
    assert_eq!(bench.acrc(["fmt"]).expect(0).stdout, "1 file reformatted, 1 left alone\n");
    assert_eq!(bench.read("Prog0.8K"), latin1(NEAT));
    assert_eq!(bench.acrc(["fmt", "."]).expect(0).stdout, "0 files reformatted, 2 left alone\n");
}

#[test]
fn check_and_diff_write_nothing() {
    let bench = Bench::new();
    bench.file("Prog0.8K", MESSY);
    bench.file("Prog1.8K", NEAT);
    let run = bench.acrc(["fmt", "--check"]).expect(1);
    assert_eq!(run.stdout, "Prog0.8K is not formatted\n1 file would be reformatted, 1 left alone\n");
    assert_eq!(bench.acrc(["fmt", "--check", "--quiet"]).expect(1).stdout, "");
    let run = bench.acrc(["fmt", "--diff"]).expect(1);
    assert!(
        run.stdout.starts_with("--- Prog0.8K\n+++ Prog0.8K\n") && run.stdout.contains("+IF (BIT24)\r\n"),
        "{}",
        run.stdout
    );
    assert_eq!(bench.read("Prog0.8K"), MESSY.as_bytes());
    bench.acrc(["fmt", "Prog1.8K", "--check"]).expect(0);
}

#[test]
fn standard_input_goes_to_standard_output() {
    let bench = Bench::new();
    bench.file("acrc.toml", "[fmt]\nkeyword-case = \"lower\"\nindent = 2\n");
    bench.file("Prog0.8K", "");
    let output = bench.feed(&["fmt", "-"], &latin1(MESSY));
    assert_eq!((output.status.code(), output.stdout), (Some(0), latin1(NEAT)));
    let output = bench.feed(&["fmt", "-", "--stdin-filename", "Prog0.8K"], b"IF (BIT 1)\nSET 32\nENDIF\n");
    assert_eq!(String::from_utf8_lossy(&output.stdout), "if (bit1)\n  set 32\n  endif\n");
    assert_eq!(bench.feed(&["fmt", "-", "--check"], MESSY.as_bytes()).status.code(), Some(1));
}

#[test]
fn a_project_may_leave_files_out() {
    let bench = Bench::new();
    bench.file("acrc.toml", "[fmt]\nexclude = [\"Prog1.8K\"]\nblock-ends = \"opener\"\nalign-remarks = false\n");
    bench.file("Prog0.8K", "IF (BIT1)\nSET 32\nENDIF\n");
    bench.file("Prog1.8K", MESSY);
    bench.acrc(["fmt"]).expect(0);
    assert_eq!(bench.read("Prog0.8K"), b"IF (BIT1)\n    SET 32\nENDIF\n");
    assert_eq!(bench.read("Prog1.8K"), MESSY.as_bytes());
}

#[test]
fn what_cannot_be_read_is_left_and_named() {
    let bench = Bench::new();
    bench.file("Prog0.8K", "PROGRAM\nset32\n)(\nENDP\n");
    let run = bench.acrc(["fmt"]).expect(0);
    assert_eq!(bench.read("Prog0.8K"), b"PROGRAM\nSET 32\n)(\nENDP\n");
    assert_eq!(run.stderr, "warning: Prog0.8K: line 3 can't be read and is left as it is\n");
    bench.file("bad/acrc.toml", "[fmt]\nindent = \"wide\"\n");
    bench.file("bad/Prog0.8K", MESSY);
    bench.file("Prog0.8K", MESSY);
    let run = bench.acrc(["fmt"]).expect(2);
    assert!(run.stderr.contains("bad/acrc.toml"), "{}", run.stderr);
    assert_eq!(bench.read("Prog0.8K"), NEAT.as_bytes(), "the others are formatted");
}

#[test]
fn numbered_lines_get_new_numbers() {
    let bench = Bench::new();
    bench.file("n.8K", "PROG0\n1 GOTO 7\n7 SET 32\n");
    bench.acrc(["fmt", "n.8K", "--renumber", "100,10"]).expect(0);
    assert_eq!(bench.read("n.8K"), b"PROG0\n100 GOTO 110\n110 SET 32\n");
    bench.file("bad.8K", "PROG0\n1 GOTO 8\n7 SET 32\n");
    let run = bench.acrc(["fmt", "bad.8K", "--renumber", "100,10"]).expect(2);
    assert!(run.stderr.contains("bad.8K:2:8: there is neither a line nor a label 8"), "{}", run.stderr);
    assert_eq!(bench.read("bad.8K"), b"PROG0\n1 GOTO 8\n7 SET 32\n");
    for numbering in ["0,10", "100", "x,y"] {
        bench.acrc(["fmt", "n.8K", "--renumber", numbering]).expect(2);
    }
}
