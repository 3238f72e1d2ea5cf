//! Every packet that the documents print or lay out, read in place from the corpus when it is there.

mod support;

use std::path::{Path, PathBuf};

use acrc_wire::binary::Requests;
use acrc_wire::ethernet::{FAST_STATUS_PORT, MANAGEMENT_PORT, Subscription, management};
use acrc_wire::{Channel, Decoder, Item, Mode, Side, Unescape, WireOptions};
use toml::{Table, Value};

/// What a byte of a field stands for where a layout names it only by letters: counts are one, all else is zero.
fn placeholder(letters: &str) -> u8 {
    u8::from(letters == "NN")
}

fn folder() -> Option<PathBuf> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
    let folder = std::env::var_os("ACRC_CORPUS").map_or(beside, PathBuf::from).join("wire");
    folder.is_dir().then_some(folder)
}

struct Packet {
    name: String,
    from_controller: bool,
    bytes: Vec<u8>,
    port: Option<u16>,
    meaning: String,
}

fn packets(path: &Path) -> Vec<Packet> {
    let table: Table = std::fs::read_to_string(path).unwrap().parse().unwrap();
    let rows = table.get("packet").and_then(Value::as_array).cloned().unwrap_or_default();
    rows.iter()
        .map(|row| {
            let text = |key: &str| row.get(key).and_then(Value::as_str).unwrap_or_default().to_owned();
            let hex = Some(text("hex_recommended")).filter(|hex| !hex.is_empty()).unwrap_or_else(|| text("hex"));
            Packet {
                name: text("name"),
                from_controller: text("direction") == "from-controller",
                bytes: hex
                    .split_whitespace()
                    .map(|byte| u8::from_str_radix(byte, 16).unwrap_or_else(|_| placeholder(byte)))
                    .collect(),
                port: row.get("port").and_then(Value::as_integer).and_then(|port| port.try_into().ok()),
                meaning: text("meaning"),
            }
        })
        .collect()
}

/// Reads a packet, with as many more bytes as its header asks for, and gives them all.
fn complete<S: Side>(mut decoder: Decoder<S>, packet: &Packet, mut encode: impl FnMut(S::Packet<'_>) -> Vec<u8>) {
    let mut bytes = Vec::new();
    let mut sent = Vec::new();
    let mut rest = packet.bytes.iter().copied().chain(std::iter::repeat(1));
    while sent.len() < packet.bytes.len() {
        let byte = [rest.next().unwrap()];
        bytes.extend(byte);
        match decoder.next_item(&mut &byte[..]) {
            Some(Item::Packet(read)) => sent.extend(encode(read)),
            Some(Item::Text(text)) => {
                sent.extend(text);
                // What a line is filled up with is no part of it.
                sent.resize(bytes.len(), 0);
            }
            Some(Item::Unreadable(error)) => panic!("{}: {error}", packet.name),
            None => assert!(bytes.len() < 2000, "{}", packet.name),
        }
    }
    assert_eq!(sent, bytes, "{}", packet.name);
}

fn check(channel: Channel, packet: &Packet) {
    let options = WireOptions::default();
    let encoded = |put: &dyn Fn(&mut Vec<u8>)| {
        let mut out = Vec::new();
        put(&mut out);
        out
    };
    match (packet.port, packet.from_controller) {
        (Some(FAST_STATUS_PORT), _) => {
            // The status itself has no fixed bytes.
            if !packet.bytes.is_empty() {
                assert_eq!(Subscription::decode(&packet.bytes).unwrap().encode(), *packet.bytes);
            }
        }
        (Some(MANAGEMENT_PORT), false) => {
            complete(management::requests(options), packet, |read| encoded(&|out| read.encode(&options, out)));
        }
        (Some(MANAGEMENT_PORT), true) => {
            complete(management::replies(options), packet, |read| encoded(&|out| read.encode(&options, out)));
        }
        (_, false) => complete(channel.requests(), packet, |read| encoded(&|out| channel.request(&read, out))),
        (_, true) => complete(channel.replies(), packet, |read| encoded(&|out| channel.reply(&read, out))),
    }
}

#[test]
fn every_packet_round_trips() {
    let Some(folder) = folder() else { return };
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        for packet in packets(&path) {
            match packet.port {
                _ if path.ends_with("encoding-modes.toml") => check_mode(&packet),
                Some(_) => check(Channel::ethernet(), &packet),
                None => check(Channel::fifo(), &packet),
            }
            count += 1;
        }
    }
    assert_eq!(count, 61, "the corpus says how many there are");
}

/// `byte 0xC2 in mode 3: ...`
fn check_mode(packet: &Packet) {
    let words: Vec<_> = packet.meaning.split([' ', ':']).collect();
    let byte = words.iter().find_map(|word| u8::from_str_radix(word.strip_prefix("0x")?, 16).ok()).unwrap();
    let number = words.iter().skip_while(|word| **word != "mode").nth(1).unwrap().parse().unwrap();
    let mode = Mode::from_number(number).unwrap();
    assert_eq!(mode.escape(byte).into_iter().collect::<Vec<_>>(), packet.bytes, "{}", packet.name);
    let mut unescape = Unescape::default();
    let decoded: Vec<_> = packet.bytes.iter().filter_map(|byte| unescape.push(mode, *byte)).collect();
    assert_eq!(decoded, [byte], "{}", packet.name);
}

#[test]
fn packets_for_one_port_are_read_whole_from_one_stream() {
    let Some(folder) = folder() else { return };
    let mut decoder: Decoder<Requests> = Channel::ethernet().requests();
    for packet in packets(&folder.join("ethernet.toml")).iter().filter(|packet| packet.port == Some(5006)) {
        let seen = support::see(&mut decoder, [&*packet.bytes]);
        assert!(seen.iter().all(|seen| !matches!(seen, support::Seen::Unreadable(_))), "{}: {seen:?}", packet.name);
        assert_eq!(decoder.waiting(), acrc_wire::Waiting::Nothing, "{}", packet.name);
    }
}
