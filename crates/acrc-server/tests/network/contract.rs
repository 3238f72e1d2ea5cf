//! What working client programs rely on, point by point.

use std::time::{Duration, Instant};

use acrc_server::Service;

use crate::common::{Bench, Client, eventually};

fn lines(client: &mut Client, lines: &[&str]) {
    for line in lines {
        let answer = client.ask(line);
        assert_eq!(answer.lines().count(), 2, "a command without a report has echo and prompt: {answer:?}");
    }
}

/// An axis that can be moved.
fn with_axis(bench: &Bench) -> Client {
    let mut client = bench.terminal();
    let setup = [
        "PROG0",
        "ATTACH MASTER0",
        "ATTACH SLAVE0 AXIS0 \"X\"",
        "PPU X 1000",
        "ACC 1000 DEC 1000 STP 1000 VEL 10",
        "DRIVE ON X",
        "JOG VEL X10 JOG ACC X1000 JOG DEC X1000",
    ];
    lines(&mut client, &setup);
    client
}

#[test]
fn a_line_ends_with_cr_or_cr_lf_and_gives_one_prompt() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    for end in ["\r", "\r\n"] {
        client.send(format!("PROG0{end}"));
        assert_eq!(client.some(), b"PROG0\r\nP00>");
        client.send(end);
        assert_eq!(client.some(), b"\r\nP00>");
        client.send(format!("SYS{end}"));
        assert_eq!(client.some(), b"SYS\r\nSYS>");
    }
}

#[test]
fn numbers_and_bits_print_as_clients_read_them() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    lines(&mut client, &["DIM P(10)", "DIM DEF(10)", "P1=12", "P2=3", "SET 32", "CLR 33", "#DEFINE ready BIT32"]);
    for (question, answer) in [
        ("?P1", "12"),
        ("? P1", "12"),
        ("PRINT(P1/P2)", "4"),
        ("?P(12288 + 256)", "0"),
        ("?BIT(516)", "0"),
        ("?BIT32", "-1"),
        ("? ready", "-1"),
        ("PRINT P1;P2", "123"),
        ("?P(0+1", "12"),
    ] {
        assert_eq!(client.report(question), [answer], "{question}");
    }
    let both = client.report("PRINT P1,P2");
    assert_eq!(both[0].split_whitespace().collect::<Vec<_>>(), ["12", "3"]);
}

#[test]
fn a_mistake_is_a_line_and_then_the_prompt() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    assert_eq!(client.ask("FOO"), "FOO\r\nUnknown Command\r\nSYS>");
    assert_eq!(client.ask("VEL 5"), "VEL 5\r\nUnknown Command\r\nSYS>");
}

#[test]
fn a_move_returns_its_prompt_at_once_and_is_in_motion_then() {
    let bench = Bench::new();
    let mut client = with_axis(&bench);
    assert_eq!(client.ask("X 30"), "X 30\r\nP00>");
    assert_eq!(client.report("?BIT516"), ["-1"]);
    assert_eq!(client.report("?BIT792"), ["0"]);
    client.send("\x18");
    eventually(|| (client.report("?BIT516") == ["0"]).then_some(()));
    client.send("\x19");
    lines(&mut client, &["JOG INC X20"]);
    assert_eq!(client.report("?BIT516"), ["0"]);
    assert_eq!(client.report("?BIT792"), ["-1"]);
}

#[test]
fn kill_and_clear_act_on_arrival_and_belong_to_no_statement() {
    let bench = Bench::new();
    let mut client = with_axis(&bench);
    client.send("\x19:AXIS0 JOG ABS 0.01\r");
    assert_eq!(client.until(|read| read.ends_with('>')), ":AXIS0 JOG ABS 0.01\r\nP00>");
    client.send("\x19\r");
    assert_eq!(client.until(|read| read.ends_with('>')), "\r\nP00>");
    client.send("\x1b\r");
    assert_eq!(client.until(|read| read.ends_with('>')), "\r\nP00>");
}

#[test]
fn spellings_in_use_are_taken() {
    let bench = Bench::new();
    let mut client = with_axis(&bench);
    let spellings = [
        "Prog 0",
        "PROG 0",
        "SET 32",
        "SET32",
        "SET BIT32",
        "SET BIT(32)",
        "BIT32=1",
        "BIT 32=1",
        "ACC 5 DEC 5 VEL 15",
        "CLR 8467 CLR8499",
        "SET 32 : CLR 33",
        ":CLR 33",
        "\tset\t32",
        "RES X 0",
        "AXIS0 RES 1.5",
        "AXIS0 JOG REN",
        "IF (0) THEN P12288= 0",
        "vel 5",
    ];
    lines(&mut client, &spellings);
}

#[test]
fn answers_are_well_inside_fifty_milliseconds() {
    let bench = Bench::new();
    let mut client = with_axis(&bench);
    let mut times: Vec<Duration> = (0..50)
        .map(|_| {
            let begun = Instant::now();
            client.ask("?P12288");
            begun.elapsed()
        })
        .collect();
    times.sort_unstable();
    // The median, since a busy machine may keep anybody waiting now and then.
    assert!(times[25] < Duration::from_millis(50), "{times:?}");
}

#[test]
fn packets_that_write_never_answer_and_text_may_lie_between_those_that_read() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Mixed);
    client.send([0x00, 0x89, 0x00, 0x00, 1, 0, 0, 0]);
    client.send([0x1C, 32, 0, 0]);
    client.send([0x00, 0x91, 0, 1, 9, 9, 9, 9, 1, 0, 0, 0]);
    client.send([0x00, 0x95, 0x00, 0x10, 0, 0, 0, 0, 1, 0, 0, 0]);
    assert!(client.is_quiet(Duration::from_millis(100)));
    client.send([0x00, 0x30, 0x02, 0x0F]);
    assert_eq!(client.exactly(20), [[0x00, 0x30, 0x02, 0x0F], [0; 4], [0; 4], [0; 4], [0; 4]].concat());
}
