//! The conversions of serial channels.

mod support;

use acrc_wire::binary::FlagChange;
use acrc_wire::{Channel, Framing, Item, Mode, Reply, Request, Unescape, WireOptions};

fn escaped(mode: Mode, byte: u8) -> Vec<u8> {
    mode.escape(byte).into_iter().collect()
}

#[test]
fn modes_have_numbers() {
    let modes = [0, 1, 2, 3, 4].map(Mode::from_number);
    assert_eq!(modes, [Some(Mode::Plain), Some(Mode::Prefixed), Some(Mode::Plain), Some(Mode::Stripped), None]);
}

#[test]
fn bytes_take_the_documented_form() {
    for (mode, byte, form) in [
        (Mode::Prefixed, 0x01, &b"#A"[..]),
        (Mode::Prefixed, b'#', b"##"),
        (Mode::Prefixed, b'&', b"&"),
        (Mode::Prefixed, 0x7F, b"#?"),
        (Mode::Prefixed, 0x91, b"\x91"),
        (Mode::Stripped, 0xC2, b"&B"),
        (Mode::Stripped, 0x83, b"&#C"),
        (Mode::Stripped, b'&', b"#&"),
        (Mode::Stripped, 0xA3, b"&##"),
        (Mode::Stripped, 0xA6, b"&#&"),
        (Mode::Stripped, 0xFF, b"&#?"),
        (Mode::Plain, 0x01, b"\x01"),
    ] {
        assert_eq!(escaped(mode, byte), form, "{byte:#04X}");
    }
}

#[test]
fn every_byte_comes_back() {
    for mode in [Mode::Plain, Mode::Prefixed, Mode::Stripped] {
        for byte in 0..=u8::MAX {
            let mut unescape = Unescape::default();
            let form = escaped(mode, byte);
            let decoded: Vec<_> = form.iter().filter_map(|byte| unescape.push(mode, *byte)).collect();
            assert_eq!(decoded, [byte], "{form:02X?}");
            assert_eq!(unescape, Unescape::default());
            let seven_bits = mode != Mode::Stripped || form.iter().all(|byte| *byte < 0x80);
            let flow_control = mode != Mode::Plain && form.iter().any(|byte| [0x11, 0x13].contains(byte));
            assert!(seven_bits && !flow_control);
        }
    }
}

#[test]
fn a_prefix_takes_back_its_range_only() {
    let mut unescape = Unescape::default();
    let mut read = |byte| unescape.push(Mode::Prefixed, byte);
    for (byte, decoded) in [(0x3E, 0x3E), (0x3F, 0x7F), (0x40, 0x00), (0x5F, 0x1F), (0x60, 0x60)] {
        assert_eq!((read(b'#'), read(byte)), (None, Some(decoded)));
    }
}

#[test]
fn the_header_and_text_are_never_converted() {
    let channel = Channel { framing: Framing::Bare(Mode::Stripped), options: WireOptions::default() };
    let request = Request::Flag(FlagChange { flag: 0x0283, set: true });
    let mut sent = Vec::new();
    channel.text(b"#&\x01", &mut sent);
    channel.request(&request, &mut sent);
    assert_eq!(sent, b"#&\x01\x1C&#C#B");
    let seen = support::see_whole(channel.requests(), &sent);
    assert_eq!(seen, [support::Seen::Text(b"#&\x01".to_vec()), support::Seen::Packet(format!("{request:?}"))]);

    let mut answer = Vec::new();
    Channel::serial().reply(&Reply::Long { parameter: 1, value: 2 }, &mut answer);
    assert_eq!(answer, b"\x00\x88#A#@#B#@#@#@");
}

#[test]
fn a_mode_can_change() {
    let mut decoder = Channel::serial().requests();
    let prefixed = b"\x1C#H#B";
    let plain = b"\x1C\x08\x02";
    let request = Item::Packet(Request::Flag(FlagChange { flag: 520, set: true }));
    assert_eq!(decoder.next_item(&mut &prefixed[..]), Some(request));
    decoder.set_mode(Mode::Plain);
    assert_eq!(decoder.next_item(&mut &plain[..]), Some(request));

    let mut packed = Channel::ethernet().requests();
    packed.set_mode(Mode::Prefixed);
    assert_eq!(packed.next_item(&mut &b"\x1C\x08\x02\0"[..]), Some(request), "packed channels convert nothing");
}
