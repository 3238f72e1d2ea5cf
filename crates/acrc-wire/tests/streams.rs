//! Bytes as they really come: cut anywhere, incomplete, late, or garbage.

mod support;

use acrc_wire::binary::{Replies, Requests};
use acrc_wire::ethernet::{FastStatus, Subscription, management};
use acrc_wire::{
    ByteOrder, Channel, CurveFields, Decoder, FirstByte, Framing, Item, LONGEST_PACKET, Mode, MovePadding, Reply,
    Request, Side, SplineFields, Waiting, WireOptions,
};
use proptest::prelude::*;
use support::{Seen, channels, see, see_whole};

/// Channels of every kind, with the readings that change lengths.
fn any_channel() -> impl Strategy<Value = Channel> {
    let framings =
        [Framing::Packed, Framing::Bare(Mode::Plain), Framing::Bare(Mode::Prefixed), Framing::Bare(Mode::Stripped)];
    (prop::sample::select(framings.to_vec()), any::<[bool; 5]>()).prop_map(|(framing, other)| {
        let options = WireOptions {
            first_byte: if other[0] { FirstByte::Zero } else { FirstByte::AnyHeader },
            spline_fields: if other[1] { SplineFields::BothByCode3 } else { SplineFields::KnotByCode1 },
            curve_fields: if other[2] { CurveFields::BeforeSlave10 } else { CurveFields::Last },
            move_padding: if other[3] { MovePadding::BehindHeader } else { MovePadding::AtEnd },
            management_order: if other[4] { ByteOrder::LittleEndian } else { ByteOrder::BigEndian },
            ..WireOptions::default()
        };
        Channel { framing, options }
    })
}

/// Garbage with a taste for the bytes that begin packets.
fn garbage() -> impl Strategy<Value = Vec<u8>> {
    let headers = [0x00, 0x04, 0x07, 0x1C, 0x1D, 0x1F, 0x88, 0x90, 0x91, 0x94, b'#', b'&', b'\r', 1, 2, 3, 5, 6, 7];
    let byte = prop_oneof![2 => prop::sample::select(headers.to_vec()), 1 => any::<u8>()];
    prop::collection::vec(byte, 0..600)
}

/// Cuts bytes at places.
fn pieces<'a>(bytes: &'a [u8], cuts: &[prop::sample::Index]) -> Vec<&'a [u8]> {
    let mut places: Vec<_> = cuts.iter().map(|cut| cut.index(bytes.len() + 1)).chain([0, bytes.len()]).collect();
    places.sort_unstable();
    places.windows(2).map(|ends| &bytes[ends[0]..ends[1]]).collect()
}

/// However bytes are cut, the same comes out, and a decoder that has seen them all reads on.
fn check_cuts<S: Side + Clone>(decoder: &Decoder<S>, bytes: &[u8], cuts: &[prop::sample::Index]) {
    let mut whole = decoder.clone();
    let expected = see(&mut whole, [bytes]);
    let mut cut = decoder.clone();
    assert_eq!(see(&mut cut, pieces(bytes, cuts)), expected);
    assert_eq!(cut.waiting(), whole.waiting());
    let mut single = decoder.clone();
    assert_eq!(see(&mut single, bytes.chunks(1)), expected);

    single.time_out();
    assert_ne!(single.waiting(), Waiting::Transfer);
    let lost = whole.time_out();
    assert!(lost < LONGEST_PACKET);
}

/// Reads packets and writes them again: the same bytes as long as the packet is one.
fn write_again(channel: Channel, bytes: &[u8]) {
    let mut decoder = channel.requests();
    let mut input = bytes;
    while let Some(item) = decoder.next_item(&mut input) {
        let Item::Packet(request) = item else { continue };
        let mut first = Vec::new();
        channel.request(&request, &mut first);
        let mut again = channel.requests();
        let mut second = Vec::new();
        match again.next_item(&mut &*first) {
            Some(Item::Packet(request)) => channel.request(&request, &mut second),
            other => panic!("{other:?} of {first:02X?}"),
        }
        assert_eq!(first, second);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn cuts_make_no_difference(
        channel in any_channel(),
        bytes in garbage(),
        cuts in prop::collection::vec(any::<prop::sample::Index>(), 0..12),
    ) {
        check_cuts::<Requests>(&channel.requests(), &bytes, &cuts);
        check_cuts::<Replies>(&channel.replies(), &bytes, &cuts);
        check_cuts(&management::requests(channel.options), &bytes, &cuts);
        check_cuts(&management::replies(channel.options), &bytes, &cuts);
        write_again(channel, &bytes);
    }

    #[test]
    fn packets_are_read_behind_a_timeout(channel in any_channel(), bytes in garbage()) {
        let mut decoder = channel.requests();
        see(&mut decoder, [&*bytes]);
        decoder.time_out();
        // What is left of four bytes of text is completed first.
        let mut sent = Vec::new();
        if decoder.waiting() == Waiting::Text {
            while decoder.waiting() == Waiting::Text {
                see(&mut decoder, [&b"x"[..]]);
            }
        }
        let request = Request::GetLong { parameter: 12288 };
        channel.request(&request, &mut sent);
        let seen = see(&mut decoder, [&*sent]);
        prop_assert_eq!(seen, [Seen::Packet(format!("{request:?}"))]);
    }

    #[test]
    fn moves_keep_their_bytes(channel in any_channel(), codes in any::<[u8; 8]>(), data in prop::collection::vec(any::<u8>(), 110)) {
        // Nothing is converted, so that the bytes can be compared.
        let framing = if channel.framing == Framing::Packed { Framing::Packed } else { Framing::Bare(Mode::Plain) };
        let channel = Channel { framing, options: WireOptions { first_byte: FirstByte::AnyHeader, ..channel.options } };
        let bytes = [&[0x04][..], &codes, &data].concat();
        let mut input = &*bytes;
        let mut decoder = channel.requests();
        let item = decoder.next_item(&mut input);
        let Some(Item::Packet(request @ Request::Move(_))) = item else { panic!("{item:?}") };
        let mut sent = Vec::new();
        channel.request(&request, &mut sent);
        let used = bytes.len() - input.len();
        prop_assert_eq!(sent.len(), used);
        let filled = if framing == Framing::Packed { 3 } else { 0 };
        let differing = sent.iter().zip(&bytes).filter(|(sent, came)| sent != came);
        prop_assert!(differing.clone().count() <= filled && differing.clone().all(|(sent, _)| *sent == 0));
    }

    #[test]
    fn datagrams_of_any_length_are_read(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        if let Ok(subscription) = Subscription::decode(&bytes) {
            prop_assert_eq!(&subscription.encode(), &bytes[..Subscription::LEN]);
        }
        if let Ok(status) = FastStatus::decode(&bytes) {
            prop_assert_eq!(&status.encode(), &bytes[..FastStatus::LEN]);
        }
    }
}

#[test]
fn an_incomplete_transfer_is_given_up_but_text_is_not() {
    let mut decoder = Channel::ethernet().requests();
    assert!(see(&mut decoder, [&b"\x00\x88\x00"[..]]).is_empty());
    assert_eq!(decoder.waiting(), Waiting::Transfer);
    assert_eq!(decoder.time_out(), 3);
    assert_eq!(decoder.waiting(), Waiting::Nothing);

    assert!(see(&mut decoder, [&b"VE"[..]]).is_empty());
    assert_eq!((decoder.waiting(), decoder.time_out()), (Waiting::Text, 0));
    assert_eq!(see(&mut decoder, [&b"L1\r\0\0\0"[..]]), [Seen::Text(b"VEL1\r".to_vec())]);
}

#[test]
fn a_half_escape_is_given_up_too() {
    let mut decoder = Channel::serial().requests();
    assert!(see(&mut decoder, [&b"\x1C#"[..]]).is_empty());
    assert_eq!(decoder.time_out(), 1);
    assert_eq!(see(&mut decoder, [&b"?\r"[..]]), [Seen::Text(b"?\r".to_vec())]);
}

#[test]
fn packets_stand_in_the_middle_of_text() {
    let seen = see_whole(Channel::fifo().requests(), b"VEL\x1C\x08\x0222\r");
    assert_eq!(seen.len(), 3, "a line goes on behind a packet: {seen:?}");
    let answers = see_whole(Channel::ethernet().replies(), b"P00>\x00\x88\x00\x30\x01\x00\x00\x00\x1C\r\n");
    let value = Reply::Long { parameter: 12288, value: 1 };
    assert_eq!(
        answers,
        [
            Seen::Text(b"P00>".to_vec()),
            Seen::Packet(format!("{value:?}")),
            Seen::Text(b"\x1C\r\n".to_vec()), // no header of an answer
        ]
    );
}

#[test]
fn zeros_that_fill_up_are_nothing() {
    let seen = see_whole(Channel::ethernet().requests(), b"A\r\0\0\0\0\0\0\0\0\0\0B\r\0\0");
    assert_eq!(seen, [Seen::Text(b"A\rB\r".to_vec())]);
    let bare = see_whole(Channel::fifo().requests(), &[0; 4]);
    assert!(matches!(&bare[..], [Seen::Packet(_)]), "a request for nothing of group 0");
}

#[test]
fn what_cannot_be_read_costs_its_own_bytes_only() {
    for channel in channels() {
        let mut bytes = Vec::new();
        channel.request(&Request::GetLong { parameter: 1 }, &mut bytes);
        let packet = bytes.clone();
        let mode = if let Framing::Bare(mode) = channel.framing { mode } else { Mode::Plain };
        let broken: [&[u8]; 3] = [
            &[0x00, 0x91, 0x03, 0x01, 0, 0, 0, 0, 1, 2, 3, 4],
            &[0x00, 0x90, 0xFF, 0x01, 0, 0, 0, 0],
            &[0x00, 0x92, 0x00, 0x08],
        ];
        for broken in broken {
            bytes.push(broken[0]);
            bytes.extend(broken[1..].iter().flat_map(|byte| mode.escape(*byte)));
            bytes.extend(&packet);
        }
        let seen = see_whole(channel.requests(), &bytes);
        let unreadable = seen.iter().filter(|seen| matches!(seen, Seen::Unreadable(_))).count();
        assert_eq!((seen.len(), unreadable), (7, 3), "{seen:?}");
    }
    let orders = see_whole(Channel::fifo().replies(), b"\x00\x89\x01\x02SYS>");
    assert_eq!(
        orders,
        [Seen::Unreadable("packets with the ID 0x89 are not answered".into()), Seen::Text(b"SYS>".to_vec())]
    );
}

#[test]
fn the_longest_packets_fit() {
    let poke = [&[0x00, 0x91, 0x00, 0xFF, 0, 0, 0, 0][..], &[7; 4 * 255]].concat();
    let peek = [&[0x00, 0x90, 0x00, 0xFF, 0, 0, 0, 0][..], &[7; 4 * 255]].concat();
    assert_eq!(see(&mut Channel::fifo().requests(), poke.chunks(10)).len(), 1);
    assert_eq!(see(&mut Channel::fifo().replies(), peek.chunks(10)).len(), 1);
    let block = [&[0, 0, 0, 5, 0, 0, 0, 0][..], &[7; 1024]].concat();
    assert_eq!(block.len(), LONGEST_PACKET);
    assert_eq!(see(&mut management::requests(WireOptions::default()), block.chunks(10)).len(), 1);
}
