//! Port 5006.

use std::time::Duration;

use acrc_server::Service;
use acrc_wire::binary::{Move, Slot};
use acrc_wire::{Channel, Request};

use crate::common::{Bench, Client, eventually};

fn packed(client: &mut Client, text: &str) {
    let mut bytes = Vec::new();
    Channel::ethernet().text(text.as_bytes(), &mut bytes);
    client.send(bytes);
}

fn ask(client: &mut Client, line: &str) -> String {
    packed(client, &format!("{line}\r"));
    client.until(|read| read.ends_with('>'))
}

#[test]
fn text_and_packets_share_a_connection() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Mixed);
    assert_eq!(ask(&mut client, "DIM P(10)"), "DIM P(10)\r\nSYS>");
    assert_eq!(ask(&mut client, "P3=7"), "P3=7\r\nSYS>");
    client.send([0x00, 0x88, 3, 0]);
    assert_eq!(client.exactly(8), [0x00, 0x88, 3, 0, 7, 0, 0, 0]);
    client.send([0x00, 0x8A, 3, 0]);
    assert_eq!(client.exactly(8), [0x00, 0x8A, 3, 0, 0, 0, 0xE0, 0x40]);
    // Writing has no answer; what is read behind it has the new value.
    client.send([0x00, 0x89, 3, 0, 9, 0, 0, 0, 0x00, 0x88, 3, 0]);
    assert_eq!(client.exactly(8), [0x00, 0x88, 3, 0, 9, 0, 0, 0]);
    assert_eq!(ask(&mut client, "?P3"), "?P3\r\n9\r\nSYS>");
}

#[test]
fn flags_are_set_and_cleared_at_once() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Mixed);
    client.send([0x1C, 32, 0, 0]);
    assert_eq!(ask(&mut client, "?BIT32"), "?BIT32\r\n-1\r\nSYS>");
    client.send([0x1D, 32, 0, 0]);
    assert_eq!(ask(&mut client, "?BIT32"), "?BIT32\r\n0\r\nSYS>");
}

#[test]
fn many_requests_in_one_piece_are_answered_in_their_order() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Mixed);
    let mut requests = Vec::new();
    let mut expected = Vec::new();
    for number in 0..2000_u16 {
        let parameter = 12288 + number % 64;
        Channel::ethernet().request(&Request::GetLong { parameter }, &mut requests);
        let [low, high] = parameter.to_le_bytes();
        expected.extend([0x00, 0x88, low, high]);
    }
    client.send(requests);
    let answer = client.exactly(2000 * 8);
    let heads: Vec<u8> = answer.chunks(8).flat_map(|reply| reply[..4].to_vec()).collect();
    assert_eq!(heads, expected);
}

#[test]
fn a_request_may_come_in_pieces() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Mixed);
    for byte in [0x00, 0x88, 0x00, 0x30] {
        client.send([byte]);
    }
    assert_eq!(client.exactly(4), [0x00, 0x88, 0x00, 0x30]);
}

#[test]
fn a_request_that_breaks_off_is_given_up() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Mixed);
    client.send([0x00, 0x88]);
    // Longer than a pause between two bytes may be, on a busy machine too.
    assert!(client.is_quiet(Duration::from_millis(500)));
    assert_eq!(ask(&mut client, "PROG0"), "PROG0\r\nP00>");
}

#[test]
fn four_characters_at_a_time_are_taken() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Mixed);
    client.send("PROG0\r");
    assert_eq!(client.until(|read| read.ends_with('G')), "PROG");
    assert!(client.is_quiet(Duration::from_millis(100)));
    client.send("\0\0");
    assert_eq!(client.until(|read| read.ends_with('>')), "0\r\nP00>");
}

#[test]
fn memory_is_read_and_written_by_address() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Mixed);
    ask(&mut client, "DIM PROG0(1000)");
    ask(&mut client, "PROG0");
    ask(&mut client, "DIM LV(3)");
    ask(&mut client, "LV1=-5");
    client.send([0x00, 0x92, 0, 4]);
    let reply = client.exactly(8);
    assert_eq!(reply[..4], [0x00, 0x92, 0, 4]);
    let address = u32::from_le_bytes([reply[4], reply[5], reply[6], reply[7]]);
    assert_ne!(address, 0);
    let mut peek = vec![0x00, 0x90, 0, 3];
    peek.extend(address.to_le_bytes());
    client.send(&peek);
    let mut expected = peek.clone();
    for value in [3, 0, -5_i32] {
        expected.extend(value.to_le_bytes());
    }
    assert_eq!(client.exactly(expected.len()), expected);
    let mut poke = vec![0x00, 0x91, 0, 1];
    poke.extend((address + 1).to_le_bytes());
    poke.extend(77_i32.to_le_bytes());
    client.send(poke);
    assert_eq!(ask(&mut client, "?LV0"), "?LV0\r\n77\r\nP00>");
}

#[test]
fn moves_wait_for_room_and_so_does_what_is_sent_behind_them() {
    let bench = Bench::new();
    let mut watcher = bench.terminal();
    let mut client = bench.connect(Service::Mixed);
    let setup =
        ["PROG0", "ATTACH MASTER0", "ATTACH SLAVE0 AXIS0 \"X\"", "PPU X 1000", "DRIVE ON X", "ACC 0 DEC 0 STP 0 VEL 2"];
    for line in setup {
        assert_eq!(ask(&mut client, line), format!("{line}\r\nP00>"));
    }
    // Each takes 20 ms, and a master takes no more than a few in advance.
    let channel = Channel::ethernet();
    let [master, slave] = [0, 0].map(|number| Slot::new(number).expect("it exists"));
    let step = Move::build(master).incremental().target(slave, 40_i32).finish(&channel.options);
    let steps = 50;
    let mut bytes = Vec::new();
    for _ in 0..steps {
        channel.request(&Request::Move(step), &mut bytes);
    }
    let position = Request::GetLong { parameter: 12288 };
    channel.request(&position, &mut bytes);
    client.send(bytes);
    // Nobody else waits.
    assert_eq!(watcher.ask("PROG1"), "PROG1\r\nP01>");
    let mut read = || {
        let reply = client.exactly(8);
        i32::from_le_bytes([reply[4], reply[5], reply[6], reply[7]])
    };
    assert!(read() > 20 * 40, "the request has not overtaken the moves");
    eventually(|| (watcher.report("?P12288") == [(steps * 40).to_string()]).then_some(()));
}
