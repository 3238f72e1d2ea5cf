//! `--fix`, `--diff`, `--unsafe`.

use super::{Bench, lint};

const MESSY: &str =
    "PROG0\r\nPROGRAM\r\nCLEAR : DIM LV10\r\nSET 32 ' \u{e4}\r\nIF BIT 5 THEN SET 33 REM x\r\n_A\r\nGOTO a\r\nENDP\r\n";
const CLEAN: &str = "PROG0\r\nPROGRAM\r\nCLEAR : DIM LV(10)\r\nSET 32 : REM \u{e4}\r\nIF (BIT 5) THEN SET 33 : REM x\r\n_A\r\nGOTO a\r\nENDP\r\n";

/// A text in some encoding.
fn encoded(text: &str, encoding: &str) -> Vec<u8> {
    match encoding {
        "utf-8" => text.as_bytes().to_vec(),
        "bom" => [b"\xEF\xBB\xBF", text.as_bytes()].concat(),
        "latin-1" => text.chars().map(|character| u8::try_from(character).expect("one byte")).collect(),
        "ctrl-z" => [text.as_bytes(), b"\x1A"].concat(),
        _ => [0xFF, 0xFE].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect(),
    }
}

#[test]
fn a_file_keeps_its_encoding_and_line_ends() {
    for encoding in ["utf-8", "bom", "latin-1", "ctrl-z", "utf-16"] {
        let bench = Bench::new();
        bench.file("m.8K", encoded(MESSY, encoding));
        let run = bench.acrc(["lint", "m.8K", "--fix"]).expect(1);
        assert!(run.stdout.contains("; 4 fixed"), "{encoding}: {}", run.stdout);
        assert_eq!(bench.read("m.8K"), encoded(CLEAN, encoding), "{encoding}");
        let again = bench.acrc(["lint", "m.8K", "--fix"]).expect(1);
        assert!(again.stdout.contains("; 0 fixed"), "{encoding}: {}", again.stdout);
        assert!(again.stdout.contains("1 finding can be repaired with --fix --unsafe"), "{}", again.stdout);
    }
}

#[test]
fn bold_repairs_are_made_when_asked_for() {
    let bench = Bench::new();
    bench.file("m.8K", MESSY);
    bench.acrc(["lint", "m.8K", "--fix", "--unsafe"]).expect(0);
    assert_eq!(bench.read("m.8K"), CLEAN.replace("GOTO a", "GOTO A").as_bytes());
    bench.acrc(["lint", "m.8K", "--unsafe"]).expect(2);
}

#[test]
fn a_difference_is_shown_and_nothing_written() {
    let bench = Bench::new();
    bench.file("m.8K", MESSY);
    let run = bench.acrc(["lint", "m.8K", "--diff"]).expect(1);
    assert!(run.stdout.starts_with("--- m.8K\n+++ m.8K\n@@ -1,8 +1,8 @@\n PROG0\r\n"), "{}", run.stdout);
    assert!(
        run.stdout.contains("-CLEAR : DIM LV10\r\n") && run.stdout.contains("+CLEAR : DIM LV(10)\r\n"),
        "{}",
        run.stdout
    );
    assert_eq!(run.stderr, "4 findings in 1 file would be repaired\n");
    assert_eq!(bench.read("m.8K"), MESSY.as_bytes());
    bench.file("m.8K", CLEAN);
    let run = bench.acrc(["lint", "m.8K", "--diff"]).expect(0);
    assert_eq!(run.stdout, "");
}

#[test]
fn standard_input_is_repaired_to_standard_output() {
    let bench = Bench::new();
    let output = bench.feed(&["lint", "-", "--fix", "--format", "concise"], &encoded(MESSY, "latin-1"));
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(output.stdout, encoded(CLEAN, "latin-1"));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("<stdin>:7:6: error[ACR101]") && said.contains("4 fixed"), "{said}");
}

#[cfg(unix)]
#[test]
fn what_cannot_be_written_is_named_and_the_rest_is_written() {
    use std::os::unix::fs::PermissionsExt as _;
    let bench = Bench::new();
    let locked = bench.file("Prog0.8K", "PROGRAM\nCLEAR : DIM LV10\nENDP\n");
    let open = bench.file("Prog1.8K", "PROGRAM\nCLEAR : DIM LV10\nENDP\n");
    let mode = |path: &std::path::Path, mode| std::fs::set_permissions(path, std::fs::Permissions::from_mode(mode));
    mode(&locked, 0o444).expect("a file of ours");
    mode(&open, 0o755).expect("a file of ours");
    let run = bench.acrc(["lint", ".", "--fix"]).expect(2);
    assert!(run.stderr.contains("cannot write Prog0.8K: it is read-only"), "{}", run.stderr);
    assert!(run.stdout.contains("1 fixed"), "{}", run.stdout);
    assert_eq!(bench.read("Prog0.8K"), b"PROGRAM\nCLEAR : DIM LV10\nENDP\n");
    assert_eq!(bench.read("Prog1.8K"), b"PROGRAM\nCLEAR : DIM LV(10)\nENDP\n");
    let permissions = std::fs::metadata(open).expect("there").permissions();
    assert_eq!(permissions.mode() & 0o777, 0o755, "permissions are kept");
}

#[test]
fn only_what_is_named_and_heard_is_repaired() {
    let bench = Bench::new();
    bench.file("Prog0.8K", "PROGRAM\nCLEAR : DIM LV10\nPRINT LV0\nSET 32 REM x\nENDP\n");
    bench.file("Prog1.8K", "PROGRAM\nCLEAR : DIM LV10\nENDP\n");
    assert_eq!(lint(&bench, &["Prog0.8K", "--fix", "--ignore", "ACR003"]), [""; 0]);
    assert_eq!(bench.read("Prog0.8K"), b"PROGRAM\nCLEAR : DIM LV(10)\nPRINT LV0\nSET 32 REM x\nENDP\n");
    assert_eq!(bench.read("Prog1.8K"), b"PROGRAM\nCLEAR : DIM LV10\nENDP\n");
}

#[test]
fn a_repaired_machine_runs_as_before() {
    let setup = "DIM P10\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nACC 10 DEC 10 STP 10 VEL 5\n";
    let body = "PROGRAM\nCLEAR : DIM LV10\nP0 = 2 \u{2013} 1.5\nP1 = 0.25\n' acrc: allow(undefined-label)\nDWL P1 ' wait\n_ Go\n\
                IF NOT BIT 24 THEN X5 REM out\nWHILE LV0 < 3\nLV0 = LV0 + 1 : SET 32 : DWL P1 : REM acrc: allow(ACR103)\nCLR 32\nWEND\n\
                PRINT \u{201c}at \u{201d}; P12288\nX0\nENDP\n";
    let bench = Bench::new();
    bench.file("Setup.8K", setup);
    bench.file("Prog0.8K", body);
    let sim = "sim . --run PROG0 --read P12288,BIT32 --trace";
    let run = |trace: &str| bench.acrc(sim.split(' ').chain([trace])).expect(0);
    let before = run("before.csv");
    bench.acrc(["lint", ".", "--fix"]).expect(0);
    assert_ne!(bench.read("Prog0.8K"), body.as_bytes());
    let after = run("after.csv");
    // How long it took, and in which line the program ends, may differ.
    let told = |run: &super::Run| {
        let lines = run.stdout.lines().filter(|line| !line.contains("virtual time") && !line.starts_with("programs"));
        lines.filter(|line| !line.starts_with("trace")).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(told(&before), told(&after));
    assert!(bench.read("before.csv") == bench.read("after.csv"), "the motion is the same to the bit");
}
