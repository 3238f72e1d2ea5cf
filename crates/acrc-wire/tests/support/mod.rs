//! Packets in a form that outlives the bytes that they came from.

#![allow(dead_code, reason = "each test uses a part")]

use acrc_wire::{Channel, Decoder, Framing, Item, Mode, Side, Waiting, WireOptions};

/// What a decoder found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Seen {
    Text(Vec<u8>),
    Packet(String),
    Unreadable(String),
}

/// Everything that comes out of these pieces; text in one run, however it was cut.
pub(crate) fn see<'p, S: Side>(decoder: &mut Decoder<S>, pieces: impl IntoIterator<Item = &'p [u8]>) -> Vec<Seen> {
    let mut seen = Vec::new();
    for piece in pieces {
        let mut input = piece;
        while let Some(item) = decoder.next_item(&mut input) {
            match (item, seen.last_mut()) {
                (Item::Text(text), Some(Seen::Text(before))) => before.extend(text),
                (Item::Text(text), _) => {
                    assert!(!text.is_empty());
                    seen.push(Seen::Text(text.to_vec()));
                }
                (Item::Packet(packet), _) => seen.push(Seen::Packet(format!("{packet:?}"))),
                (Item::Unreadable(error), _) => seen.push(Seen::Unreadable(error.to_string())),
            }
        }
        assert!(input.is_empty(), "nothing found means that all was used");
    }
    seen
}

/// The same, in one piece, with nothing left over.
pub(crate) fn see_whole<S: Side>(mut decoder: Decoder<S>, bytes: &[u8]) -> Vec<Seen> {
    let seen = see(&mut decoder, [bytes]);
    assert_eq!(decoder.waiting(), Waiting::Nothing, "{bytes:02X?}");
    seen
}

/// Every kind of channel.
pub(crate) fn channels() -> [Channel; 4] {
    [Framing::Packed, Framing::Bare(Mode::Plain), Framing::Bare(Mode::Prefixed), Framing::Bare(Mode::Stripped)]
        .map(|framing| Channel { framing, options: WireOptions::default() })
}
