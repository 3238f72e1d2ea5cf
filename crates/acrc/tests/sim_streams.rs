//! `acrc sim`: streams as files, standard input and the scripted world.

mod common;

use common::Bench;

/// Asks at COM1 for two numbers and says their sum at the default device.
const ADDER: &str = "PROG0\nDIM LV(2)\nPROGRAM\nOPEN \"COM1:9600,n,8,1\" AS #1\nINPUT #1, \"a, b = \"; LV0, LV1\n\
                     PRINT #1, \"sum \"; LV0 + LV1\nPRINT \"added\"\nCLOSE #1\nENDP\n";

#[test]
fn files_stand_for_streams() {
    let bench = Bench::new();
    bench.file("add.8K", ADDER);
    bench.file("typed.txt", "1\n20, 22\n");
    let report =
        bench.sim("add.8K --run PROG0 --input COM1=typed.txt --output com1=com1.txt --output PROG0=listener.txt");
    assert_eq!(report["stopped"], "ended");
    assert_eq!(bench.read("com1.txt"), b"a, b = 1\r\na, b = 20, 22\r\nsum 42\r\n");
    assert_eq!(bench.read("listener.txt"), b"added\r\n");
    let output = &report["output"];
    assert_eq!(
        (&output[1]["text"], &output[1]["stream"], &output[1]["device"]),
        (&"a, b = 20, 22".into(), &"COM1".into(), &1.into())
    );
    assert_eq!((&output[3]["text"], &output[3]["stream"]), (&"added".into(), &serde_json::Value::Null));
}

#[test]
fn standard_input_is_typed_and_output_shows_its_stream() {
    let bench = Bench::new();
    bench.file("add.8K", ADDER);
    let run = bench.feed(&["sim", "add.8K", "--run", "PROG0", "--input", "COM1=-"], b"2,3");
    assert!(String::from_utf8_lossy(&run.stdout).contains("note: PROG0 waits for input at COM1: --input COM1=FILE"));
    let run = bench.feed(&["sim", "add.8K", "--run", "PROG0", "--input", "COM1=-"], b"2,3\n");
    let shown = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(shown.contains("0.000 s  PROG0 COM1  sum 5\n") && shown.contains("0.000 s  PROG0     added\n"), "{shown}");
}

#[test]
fn a_program_that_waits_for_input_does_not_hang_the_run() {
    let bench = Bench::new();
    bench.file("ask.8K", "PROG3\nDIM LV(1)\nPROGRAM\nINPUT LV0\nENDP\n");
    let report = bench.sim("ask.8K --run PROG3 --until 1h");
    assert_eq!((&report["stopped"], &report["virtual_seconds"]), (&"until".into(), &3600.0.into()));
    assert_eq!(
        (&report["programs"][0]["state"], &report["programs"][0]["awaits"]),
        (&"waiting".into(), &"PROG3".into())
    );
    let note = report["notes"][0].as_str().expect("a note");
    assert!(
        note.starts_with("PROG3 waits for input from whoever listens to it: --input PROG3=FILE types there"),
        "{note}"
    );
}

#[test]
fn the_world_types() {
    let bench = Bench::new();
    bench.file("add.8K", ADDER);
    bench.file("world.toml", "[[event]]\nat = 2\nstream = \"COM1\"\ntext = \"20,22\\n\"\nnote = \"operator\"\n");
    let run = bench.acrc(["sim", "add.8K", "--run", "PROG0", "--world", "world.toml"]).expect(0);
    let lines: Vec<&str> = run.stdout.lines().take(4).map(str::trim_start).collect();
    let expected = [
        "2.000 s  world     types \"20,22\\r\" at COM1",
        "0.000 s  PROG0 COM1  a, b = 20,22",
        "2.000 s  PROG0 COM1  sum 42",
        "2.000 s  PROG0     added",
    ];
    assert_eq!(lines, expected);
}

#[test]
fn what_cannot_be_typed_or_written_is_refused() {
    let bench = Bench::new();
    bench.file("add.8K", ADDER);
    bench.file("typed.txt", "1\n");
    bench.file("fifo.toml", "[[event]]\nat = 1\nstream = \"FIFO\"\ntext = \"a\"\n");
    for (arguments, expected) in [
        ("--input FIFO=typed.txt", "ACR9000 has no FIFO"),
        ("--input COM9=typed.txt", "`COM9` is no stream"),
        ("--input PROG99=typed.txt", "`PROG99` is no stream"),
        ("--input COM1", "write NAME=FILE"),
        ("--input COM1=gone.txt", "cannot read gone.txt"),
        ("--input COM1=- --input COM2=-", "standard input can be typed at one place only"),
        ("--output COM1=a.txt --output COM1=b.txt", "COM1 is named twice"),
        ("--output COM1=add.8K", "it would be replaced"),
        ("--input COM1=typed.txt --output COM1=typed.txt", "it would be replaced"),
        ("--world fifo.toml", "the world: event 1 in order of time"),
    ] {
        let run = bench.acrc("sim add.8K --run PROG0".split(' ').chain(arguments.split(' '))).expect(2);
        assert!(run.stderr.contains(expected), "{arguments}\n{}", run.stderr);
    }
}
