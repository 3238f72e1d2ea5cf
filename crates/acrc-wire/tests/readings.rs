//! The other readings where the documents contradict each other. Those of moves are in `moves.rs`.

mod support;

use std::time::Duration;

use acrc_wire::binary::{FlagChange, Override, OverrideKind};
use acrc_wire::ethernet::{Watchdog, management};
use acrc_wire::{
    ByteOrder, Channel, FirstByte, FlagHeaders, Item, OverrideMasks, Request, RovHeader, WatchdogUnit, WireOptions,
};
use support::{Seen, see_whole};

fn sent(channel: Channel, request: Request<'_>) -> Vec<u8> {
    let mut out = Vec::new();
    channel.request(&request, &mut out);
    out
}

#[test]
fn zero_alone_may_begin_a_packet_on_port_5006() {
    let options = WireOptions { first_byte: FirstByte::Zero, ..WireOptions::default() };
    let bytes = b"\x1C\x08\x02\0";
    let packed = see_whole(Channel::ethernet().with_options(options).requests(), bytes);
    assert_eq!(packed, [Seen::Text(b"\x1C\x08\x02".to_vec())]);
    let bare = see_whole(Channel::fifo().with_options(options).requests(), &bytes[..3]);
    assert!(matches!(&bare[..], [Seen::Packet(_)]), "other channels have no such rule");
}

#[test]
fn set_and_clear_may_be_exchanged() {
    let options = WireOptions { flag_headers: FlagHeaders::SetIs1D, ..WireOptions::default() };
    let channel = Channel::ethernet().with_options(options);
    for set in [true, false] {
        let request = Request::Flag(FlagChange { flag: 520, set });
        let exchanged = sent(channel, request);
        assert_eq!(exchanged, sent(Channel::ethernet(), Request::Flag(FlagChange { flag: 520, set: !set })));
        assert_eq!(channel.requests().next_item(&mut &*exchanged), Some(Item::Packet(request)));
    }
}

#[test]
fn a_rapid_override_may_be_sent_as_printed() {
    let options = WireOptions { rov_header: RovHeader::Is07, ..WireOptions::default() };
    let rapid = Override::new(OverrideKind::Rapid, 1 << 3, 0.5);
    let printed = sent(Channel::fifo().with_options(options), Request::Override(rapid));
    assert_eq!(printed, [0x07, 0x08, 0x00, 0x00, 0x00, 0x00, 0x00, 0x3F]);
    let feedrate = Override::new(OverrideKind::Feedrate, 1 << 3, 0.5);
    assert_eq!(Channel::fifo().requests().next_item(&mut &*printed), Some(Item::Packet(Request::Override(feedrate))));
}

#[test]
fn masks_of_an_override_may_count_together() {
    let together = WireOptions { override_masks: OverrideMasks::Together, ..WireOptions::default() };
    for (masks, default, other) in [
        ([0x08, 0x00, 0x00], 0x0008, 0x0008),
        ([0x00, 0x02, 0x01], 0x0102, 0x0102),
        ([0x08, 0x02, 0x01], 0x0008, 0x010A),
        ([0x00, 0x00, 0x00], 0x0000, 0x0000),
    ] {
        let change = Override { kind: OverrideKind::Feedrate, masks, value: 1.0 };
        assert_eq!([change.masters(&WireOptions::default()), change.masters(&together)], [default, other]);
    }
}

#[test]
fn a_watchdog_may_count_seconds() {
    let watchdog =
        Watchdog { timer: 501, ticker: 3, address: [10, 0, 0, 1].into(), command_port: 1, fast_status_port: 2 };
    assert_eq!(watchdog.patience(WatchdogUnit::Milliseconds), Some(Duration::from_millis(1503)));
    assert_eq!(watchdog.patience(WatchdogUnit::Seconds), Some(Duration::from_secs(1503)));
    assert_eq!(Watchdog { timer: 0, ..watchdog }.patience(WatchdogUnit::Milliseconds), None);
    let longest = Watchdog { timer: u32::MAX, ticker: u32::MAX, ..watchdog };
    assert!(longest.patience(WatchdogUnit::Seconds).is_some());
}

#[test]
fn management_may_have_the_low_byte_first() {
    let options = WireOptions { management_order: ByteOrder::LittleEndian, ..WireOptions::default() };
    let mut bytes = Vec::new();
    management::Request::UserAlarms { filter: 0x0102 }.encode(&options, &mut bytes);
    assert_eq!(bytes, [2, 0, 0, 0, 2, 1, 0, 0]);
    let request = Item::Packet(management::Request::UserAlarms { filter: 0x0102 });
    assert_eq!(management::requests(options).next_item(&mut &*bytes), Some(request));
}
