//! Port 5002.

use std::time::Duration;

use acrc_server::{Service, Speed};

use crate::common::{Bench, eventually};

#[test]
fn an_answer_comes_in_one_piece() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    for _ in 0..20 {
        client.send("?P12288\r");
        assert_eq!(client.some(), b"?P12288\r\n0\r\nSYS>");
        client.send("PROG0\r\n");
        assert_eq!(client.some(), b"PROG0\r\nP00>");
        client.send("SYS\r");
        assert_eq!(client.some(), b"SYS\r\nSYS>");
    }
}

#[test]
fn characters_are_echoed_as_they_are_typed() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    for character in ["P", "L", "C", "0"] {
        client.send(character);
        assert_eq!(client.some(), character.as_bytes());
    }
    client.send("\r");
    assert_eq!(client.some(), b"\r\nPLC0>");
}

#[test]
fn echo_mode_and_level_belong_to_the_connection() {
    let bench = Bench::new();
    let mut first = bench.terminal();
    let mut second = bench.terminal();
    first.ask("PROG3");
    first.send("ECHO 4\r?P12288\r");
    assert_eq!(first.until(|read| read.ends_with("0\r\n")), "ECHO 4\r\n0\r\n");
    assert_eq!(second.ask(""), "\r\nSYS>");
    drop(first);
    // Whoever comes next on the same stream begins anew.
    let mut third = bench.terminal();
    assert_eq!(third.ask("?P12288"), "?P12288\r\n0\r\nSYS>");
}

#[test]
fn four_clients_have_a_stream_and_a_fifth_is_turned_away_until_one_leaves() {
    let bench = Bench::new();
    let mut clients = [bench.terminal(), bench.terminal(), bench.terminal()];
    let mixed = bench.connect(Service::Mixed);
    eventually(|| (bench.handle().statistics().clients >= 4).then_some(()));
    for service in [Service::Ascii, Service::Mixed] {
        let mut fifth = bench.connect(service);
        assert!(fifth.has_ended());
    }
    assert_eq!(clients[2].ask("PROG1"), "PROG1\r\nP01>");
    drop(mixed);
    let mut next = bench.terminal();
    assert_eq!(next.ask("PROG2"), "PROG2\r\nP02>");
}

#[test]
fn keys_act_in_the_middle_of_a_line() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    // Ctrl-X sets the kill flag of every axis, Ctrl-Y clears it.
    client.send("?BIT84\x1867\r");
    assert_eq!(client.until(|read| read.ends_with('>')), "?BIT8467\r\n-1\r\nSYS>");
    client.send("?BIT84\x1967\r");
    assert_eq!(client.until(|read| read.ends_with('>')), "?BIT8467\r\n0\r\nSYS>");
}

#[test]
fn escape_leaves_a_statement_that_waits_and_its_echo_does_not() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    client.ask("PROG0");
    client.send("DWL 1000\r");
    // What is complete is kept back for a moment only.
    assert_eq!(client.some(), b"DWL 1000\r\n");
    client.send("\x1b");
    assert_eq!(client.some(), b"P00>");
}

#[test]
fn what_was_sent_is_answered_though_the_client_sends_nothing_more() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Ascii);
    client.send("PROG0\rDWL 0.1\r?P12288\r");
    assert_eq!(client.leave(), b"PROG0\r\nP00>DWL 0.1\r\nP00>?P12288\r\n0\r\nP00>");
}

#[test]
fn a_listener_gets_what_its_program_prints() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    let mut other = bench.terminal();
    for line in ["DIM PROG0(4000)", "PROG0", "PROGRAM", "PRINT \"one\"", "DWL 0.05", "PRINT \"two\"", "ENDP"] {
        client.ask(line);
    }
    client.send("LRUN\r");
    assert_eq!(client.until(|read| read.ends_with('>')), "LRUN\r\none\r\ntwo\r\nP00>");
    assert!(other.is_quiet(Duration::from_millis(50)));
}

#[test]
fn at_full_speed_a_wait_takes_no_time() {
    let bench = Bench::with(|config| config.speed = Speed::Max);
    let mut client = bench.terminal();
    client.ask("PROG0");
    assert_eq!(client.ask("DWL 36000"), "DWL 36000\r\nP00>");
}

#[test]
fn at_another_speed_time_passes_accordingly() {
    let bench = Bench::with(|config| config.speed = Speed::Factor(500.0));
    let mut client = bench.terminal();
    client.ask("PROG0");
    assert_eq!(client.ask("DWL 500"), "DWL 500\r\nP00>");
}

#[test]
fn reboot_ends_the_connections() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    let mut other = bench.connect(Service::Mixed);
    client.send("REBOOT\r");
    assert!(client.has_ended());
    assert!(other.has_ended());
    drop((client, other));
    assert_eq!(bench.terminal().ask("PROG0"), "PROG0\r\nP00>");
}

#[test]
fn the_end_of_the_server_is_the_end_of_its_connections() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    client.ask("DIM P(10)");
    client.ask("P3=7");
    let waits = std::thread::spawn(move || client.has_ended());
    let finished = bench.finish();
    assert!(waits.join().expect("the client ends"));
    assert!(finished.statistics.clients >= 1);
}
