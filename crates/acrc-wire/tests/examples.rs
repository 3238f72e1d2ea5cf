//! The packets that the documents print, byte for byte.

mod support;

use acrc_wire::binary::{
    Address, BitMask, Conversion, DataReply, DataRequest, FlagChange, Override, OverrideKind, Peek, PeekReply, Poke,
    VariableKind,
};
use acrc_wire::{Channel, Field, Item, Reply, Request};

/// Encodes and decodes a request.
fn check(channel: Channel, request: Request<'_>, bytes: &[u8]) {
    let mut sent = Vec::new();
    channel.request(&request, &mut sent);
    assert_eq!(sent, bytes, "{request:?}");
    let mut decoder = channel.requests();
    assert_eq!(decoder.next_item(&mut &*sent), Some(Item::Packet(request)));
}

fn check_reply(channel: Channel, reply: Reply<'_>, bytes: &[u8]) {
    let mut sent = Vec::new();
    channel.reply(&reply, &mut sent);
    assert_eq!(sent, bytes, "{reply:?}");
    let mut decoder = channel.replies();
    assert_eq!(decoder.next_item(&mut &*sent), Some(Item::Packet(reply)));
}

/// On a FIFO channel and on port 5006.
fn check_both(request: Request<'_>, bytes: &[u8]) {
    check(Channel::fifo(), request, bytes);
    check(Channel::ethernet(), request, bytes);
}

fn check_reply_both(reply: Reply<'_>, bytes: &[u8]) {
    check_reply(Channel::fifo(), reply, bytes);
    check_reply(Channel::ethernet(), reply, bytes);
}

#[test]
fn data_packets() {
    let request = DataRequest { group: 0x30, index: 2, mask: 0x2C };
    check_both(Request::Data(request), &[0x00, 0x30, 0x02, 0x2C]);
    let fields = [Field(0x2322_2120), Field(0x3332_3130), Field(0x5352_5150)];
    let reply = DataReply::new(request, &fields).unwrap();
    #[rustfmt::skip]
    check_reply_both(
        Reply::Data(reply),
        &[0x00, 0x30, 0x02, 0x2C, 0x20, 0x21, 0x22, 0x23, 0x30, 0x31, 0x32, 0x33, 0x50, 0x51, 0x52, 0x53],
    );
    check_both(Request::Data(DataRequest { group: 0x30, index: 2, mask: 0x0F }), &[0x00, 0x30, 0x02, 0x0F]);
    assert!(DataReply::new(request, &[Field(1)]).is_none(), "three fields were asked for");
}

#[test]
fn parameters() {
    check_both(Request::GetLong { parameter: 12288 }, &[0x00, 0x88, 0x00, 0x30]);
    check_both(Request::GetLong { parameter: 12546 }, &[0x00, 0x88, 0x02, 0x31]);
    check_both(Request::GetSingle { parameter: 8193 }, &[0x00, 0x8A, 0x01, 0x20]);
    check_both(Request::SetLong { parameter: 12288, value: -2 }, &[0x00, 0x89, 0x00, 0x30, 0xFE, 0xFF, 0xFF, 0xFF]);
    check_both(Request::SetSingle { parameter: 8193, value: 0.5 }, &[0x00, 0x8B, 0x01, 0x20, 0x00, 0x00, 0x00, 0x3F]);
    check_reply_both(
        Reply::Long { parameter: 12288, value: 0x0012_1110 },
        &[0x00, 0x88, 0x00, 0x30, 0x10, 0x11, 0x12, 0x00],
    );
    check_reply_both(Reply::Single { parameter: 8193, value: 0.5 }, &[0x00, 0x8A, 0x01, 0x20, 0x00, 0x00, 0x00, 0x3F]);
}

#[test]
fn peek_and_poke() {
    let peek = Peek { conversion: Conversion::Long, count: 3, address: 0x0040_5000 };
    let fields = [Field(0x1312_1110), Field(0x2322_2120), Field(0x3332_3130)];
    let data = [0x10, 0x11, 0x12, 0x13, 0x20, 0x21, 0x22, 0x23, 0x30, 0x31, 0x32, 0x33];
    let head = |id| [0x00, id, 0x00, 0x03, 0x00, 0x50, 0x40, 0x00];
    check_both(Request::Peek(peek), &head(0x90));
    check_reply_both(Reply::Peek(PeekReply::new(peek, &fields).unwrap()), &[&head(0x90)[..], &data].concat());
    let poke = Poke::new(Conversion::Long, 0x0040_5000, &fields).unwrap();
    check_both(Request::Poke(poke), &[&head(0x91)[..], &data].concat());
    assert!(Poke::new(Conversion::Long, 0, &[Field(0); 256]).is_none());
    assert!(PeekReply::new(peek, &[Field(0); 2]).is_none());
}

#[test]
fn addresses() {
    let request = Address { program: 5, kind: VariableKind::SingleVariables };
    check_both(Request::Address(request), &[0x00, 0x92, 0x05, 0x02]);
    check_reply_both(
        Reply::Address { request, address: 0x0040_8000 },
        &[0x00, 0x92, 0x05, 0x02, 0x00, 0x80, 0x40, 0x00],
    );
    check_both(Request::ParameterAddress { parameter: 12288 }, &[0x00, 0x93, 0x00, 0x30]);
    check_reply_both(
        Reply::ParameterAddress { parameter: 12288, address: 0x0040_5031 },
        &[0x00, 0x93, 0x00, 0x30, 0x31, 0x50, 0x40, 0x00],
    );
}

#[test]
fn masks() {
    let mask = BitMask { clear: u32::MAX, set: 1 };
    let masks = [0xFF, 0xFF, 0xFF, 0xFF, 0x01, 0x00, 0x00, 0x00];
    let by_address = [&[0x00, 0x94, 0x00, 0x00, 0x43, 0x60, 0x40, 0x00][..], &masks].concat();
    check_both(Request::Mask { address: 0x0040_6043, mask }, &by_address);
    check_both(Request::ParameterMask { parameter: 4097, mask }, &[&[0x00, 0x95, 0x01, 0x10][..], &masks].concat());
    assert_eq!(mask.apply(0xDEAD_BEEF), 1);
    assert_eq!(BitMask { clear: 0b0110, set: 0b0011 }.apply(0b1100), 0b1011);
}

#[test]
fn flags() {
    for (flag, set, bytes) in [
        (520, true, [0x1C, 0x08, 0x02]),
        (32, false, [0x1D, 0x20, 0x00]),
        (8465, true, [0x1C, 0x11, 0x21]),
        (8467, false, [0x1D, 0x13, 0x21]),
    ] {
        let request = Request::Flag(FlagChange { flag, set });
        check(Channel::fifo(), request, &bytes);
        check(Channel::ethernet(), request, &[&bytes[..], &[0]].concat());
    }
}

#[test]
fn overrides() {
    let half = [0x00, 0x00, 0x00, 0x3F];
    let eighth = [0x6D, 0xE7, 0xFB, 0x3D];
    for (kind, header) in [(OverrideKind::Feedrate, 0x07), (OverrideKind::Rapid, 0x1F)] {
        let master_3 = Override::new(kind, 1 << 3, 0.5);
        check_both(Request::Override(master_3), &[&[header, 0x08, 0x00, 0x00][..], &half].concat());
        let masters_0_and_2 = Override::new(kind, 0b101, 0.123);
        check_both(Request::Override(masters_0_and_2), &[&[header, 0x05, 0x00, 0x00][..], &eighth].concat());
        let masters_3_and_8 = Override::new(kind, 0x0108, 0.5);
        check_both(Request::Override(masters_3_and_8), &[&[header, 0x00, 0x08, 0x01][..], &half].concat());
        assert_eq!(masters_3_and_8.masters(&Channel::fifo().options), 0x0108);
    }
}

#[test]
fn text_and_packets_share_a_connection() {
    let channel = Channel::ethernet();
    let request = Request::Data(DataRequest { group: 0x30, index: 2, mask: 0x2C });
    let mut sent = Vec::new();
    channel.text(b"VEL22\r", &mut sent);
    channel.request(&request, &mut sent);
    assert_eq!(sent, [0x56, 0x45, 0x4C, 0x32, 0x32, 0x0D, 0x00, 0x00, 0x00, 0x30, 0x02, 0x2C]);
    let seen = support::see_whole(channel.requests(), &sent);
    assert_eq!(seen, [support::Seen::Text(b"VEL22\r".to_vec()), support::Seen::Packet(format!("{request:?}"))]);
}

#[test]
fn every_row_has_its_place() {
    for row in acrc_wire::PACKETS {
        assert_eq!(*row.kind.row(), row);
    }
}
