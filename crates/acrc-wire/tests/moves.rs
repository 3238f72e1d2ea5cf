//! Binary moves: what the header announces, and what it means.

mod support;

use acrc_wire::binary::{
    Arc, ArcDirection, ArcPlane, Counter, Move, MoveField, MoveMode, Number, Path, RapidMoveModes, Slot, StartRule,
};
use acrc_wire::{Channel, CurveFields, Item, MovePadding, Request, SplineFields, WireOptions};
use support::{Seen, channels, see_whole};

fn slot(number: u8) -> Slot {
    Slot::new(number).unwrap()
}

fn bytes(channel: Channel, move_: Move) -> Vec<u8> {
    let mut out = Vec::new();
    channel.request(&Request::Move(move_), &mut out);
    out
}

/// Encodes a move, and makes sure that it comes back on every kind of channel.
fn fifo(move_: Move) -> Vec<u8> {
    for channel in channels() {
        let seen = see_whole(channel.requests(), &bytes(channel, move_));
        assert_eq!(seen, [Seen::Packet(format!("{:?}", Request::Move(move_)))]);
    }
    bytes(Channel::fifo(), move_)
}

const OPTIONS: fn() -> WireOptions = WireOptions::default;

#[test]
fn a_line_with_long_integers_has_a_header_of_four_bytes() {
    let line = Move::build::<i32>(slot(2)).target(slot(0), 1000).target(slot(7), -1).finish(&OPTIONS());
    assert_eq!(fifo(line), [0x04, 0x00, 0x02, 0x81, 0xE8, 0x03, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF]);
    assert_eq!(line.master(), slot(2));
    assert_eq!(line.path(), Path::Line);
    let targets: Vec<_> = line.targets().collect();
    assert_eq!(targets, [(slot(0), Number::Long(1000)), (slot(7), Number::Long(-1))]);
    assert_eq!([line.velocity(), line.final_velocity(), line.acceleration()], [None; 3]);
    assert!(!line.is_incremental());
}

#[test]
fn singles_need_header_code_3() {
    let line = Move::build::<f32>(slot(0))
        .velocity(0.5)
        .final_velocity(0.25)
        .acceleration(2.0)
        .incremental()
        .block_skip()
        .interrupt()
        .counter(Counter::Down)
        .target(slot(1), 1.0)
        .finish(&OPTIONS());
    #[rustfmt::skip]
    assert_eq!(
        fifo(line),
        [
            0x04, 0xF8, 0x08, 0x02, 0x35, // code 3 present, VEL, ACC, counter down; interrupt; slave 1; code 3
            0x00, 0x00, 0x00, 0x3F, 0x00, 0x00, 0x80, 0x3E, 0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x80, 0x3F,
        ]
    );
    assert_eq!([line.velocity(), line.final_velocity(), line.acceleration()], [Some(0.5), Some(0.25), Some(2.0)]);
    assert_eq!(line.targets().collect::<Vec<_>>(), [(slot(1), Number::Single(1.0))]);
    assert_eq!(line.counter(), Some(Counter::Down));
    assert!(line.is_incremental() && line.interrupts() && line.checks_block_skip());
}

#[test]
fn masters_and_slaves_beyond_eight_need_the_extended_codes() {
    let line = Move::build::<i32>(slot(13)).target(slot(9), 7).finish(&OPTIONS());
    assert_eq!(
        fifo(line),
        [0x04, 0x08, 0x05, 0x00, 0x80, 0x08, 0x00, 0x02, 0x00, 0x07, 0x00, 0x00, 0x00],
        "nine bytes of header"
    );
    assert_eq!(line.master(), slot(13));
    assert_eq!(Slot::new(16), None);
    let long = Move::build::<i32>(slot(0)).extended().target(slot(0), 7).finish(&OPTIONS());
    assert_eq!(fifo(long), [0x04, 0x08, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x07, 0x00, 0x00, 0x00]);
    let full = Slot::all().fold(Move::build::<i32>(slot(0)), |built, slave| built.target(slave, 1));
    assert_eq!(fifo(full.finish(&OPTIONS())).len(), 9 + 16 * 4);
}

#[test]
fn arcs_carry_their_center_and_maybe_scaling() {
    let arc = Arc {
        plane: Some(ArcPlane::Slaves12),
        direction: ArcDirection::Counterclockwise,
        center: [3, 4],
        incremental: true,
        scaling: None,
    };
    let built = Move::build::<i32>(slot(1)).target(slot(1), 1).target(slot(2), 2);
    let plain = built.arc(arc).finish(&OPTIONS());
    assert_eq!(
        fifo(plain),
        [0x04, 0x08, 0x71, 0x06, 0x02, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0],
        "targets in front of centers"
    );
    let center = arc.center.map(Number::Long);
    let read = |scaling| {
        let Arc { plane, direction, incremental, .. } = arc;
        Path::Arc(Arc { plane, direction, center, incremental, scaling })
    };
    assert_eq!(plain.path(), read(None));
    assert_eq!(ArcPlane::Slaves12.axes(), [slot(1), slot(2)]);

    let scaled = built.arc(Arc { scaling: Some([2.0, 0.5]), ..arc }).finish(&OPTIONS());
    assert_eq!(fifo(scaled).len(), 5 + 6 * 4);
    assert_eq!(scaled.path(), read(Some([2.0, 0.5])));

    let reserved = built.arc(Arc { plane: None, ..arc }).finish(&OPTIONS());
    assert!(matches!(reserved.path(), Path::Arc(Arc { plane: None, .. })));
}

#[test]
fn curves_carry_knot_and_weight() {
    let built = Move::build::<f32>(slot(0)).target(slot(0), 1.0);
    let nurb = built.nurb(0.5, 2.0).finish(&OPTIONS());
    let (one, half, two) = ([0x00, 0x00, 0x80, 0x3F], [0x00, 0x00, 0x00, 0x3F], [0x00, 0x00, 0x00, 0x40]);
    assert_eq!(fifo(nurb), [&[0x04, 0x08, 0x40, 0x01, 0x4C][..], &one, &half, &two].concat());
    assert_eq!(nurb.path(), Path::Nurb { knot: Some(0.5), weight: Some(2.0) });

    let bare = built.spline(None).finish(&OPTIONS());
    assert_eq!(fifo(bare), [&[0x04, 0x08, 0x80, 0x01, 0x44][..], &one].concat());
    assert_eq!(bare.path(), Path::Spline { knot: None });

    let spline = built.spline(Some(0.5)).finish(&OPTIONS());
    assert_eq!(fifo(spline), [&[0x04, 0x08, 0xA0, 0x01, 0x4C][..], &one, &half].concat());
    assert_eq!(spline.path(), Path::Spline { knot: Some(0.5) });
    assert_eq!(spline.field(MoveField::SecondaryScalingOrWeight), None);
}

#[test]
fn a_spline_may_carry_both_fields() {
    let options = WireOptions { spline_fields: SplineFields::BothByCode3, ..OPTIONS() };
    let channel = Channel::fifo().with_options(options);
    let spline = Move::build::<i32>(slot(0)).spline(Some(0.5)).finish(&options);
    let sent = bytes(channel, spline);
    assert_eq!(sent, [0x04, 0x08, 0xA0, 0x00, 0x48, 0x00, 0x00, 0x00, 0x3F, 0x00, 0x00, 0x80, 0x3F]);
    assert_eq!(channel.requests().next_item(&mut &*sent), Some(Item::Packet(Request::Move(spline))));
    assert_eq!(spline.path(), Path::Spline { knot: Some(0.5) });
}

#[test]
fn knot_and_weight_may_stand_in_front_of_slave_10() {
    let options = WireOptions { curve_fields: CurveFields::BeforeSlave10, ..OPTIONS() };
    let channel = Channel::fifo().with_options(options);
    let low = Move::build::<i32>(slot(0)).target(slot(7), 1).nurb(0.5, 2.0).finish(&options);
    assert_eq!(bytes(channel, low), bytes(Channel::fifo(), low), "no difference without slaves 8 to 15");

    let built = Move::build::<i32>(slot(0)).target(slot(9), 9).target(slot(10), 10);
    let high = built.nurb(0.5, 2.0).finish(&options);
    let sent = bytes(channel, high);
    assert_eq!(sent[9..], [9, 0, 0, 0, 0x00, 0x00, 0x00, 0x3F, 0x00, 0x00, 0x00, 0x40, 10, 0, 0, 0]);
    assert_eq!(channel.requests().next_item(&mut &*sent), Some(Item::Packet(Request::Move(high))));
}

#[test]
fn a_packed_channel_fills_up_the_end_or_the_header() {
    let line = Move::build::<f32>(slot(0)).target(slot(0), 1.0).finish(&OPTIONS());
    let sent = bytes(Channel::ethernet(), line);
    assert_eq!(sent, [0x04, 0x08, 0x00, 0x01, 0x04, 0x00, 0x00, 0x80, 0x3F, 0x00, 0x00, 0x00]);

    let options = WireOptions { move_padding: MovePadding::BehindHeader, ..OPTIONS() };
    let channel = Channel::ethernet().with_options(options);
    let sent = bytes(channel, line);
    assert_eq!(sent, [0x04, 0x08, 0x00, 0x01, 0x04, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3F]);
    assert_eq!(channel.requests().next_item(&mut &*sent), Some(Item::Packet(Request::Move(line))));
}

#[test]
fn header_code_0_has_two_meanings() {
    for (mode, bits) in [
        (MoveMode::FeedContinuous, 0b000),
        (MoveMode::FeedCornering, 0b100),
        (MoveMode::FeedStopping, 0b001),
        (MoveMode::Rapid, 0b101),
    ] {
        for override_lockout in [false, true] {
            let rule = StartRule::Mode { mode, override_lockout };
            let built = Move::build::<i32>(slot(0)).rule(rule).finish(&OPTIONS());
            assert_eq!(fifo(built)[1], bits | u8::from(override_lockout) << 1);
            assert_eq!(built.rule(RapidMoveModes::Enabled), rule);
            let lockouts = StartRule::Lockouts {
                final_velocity: bits & 1 != 0,
                feedrate_override: override_lockout,
                stop_ramp: bits & 4 != 0,
            };
            assert_eq!(built.rule(RapidMoveModes::Disabled), lockouts);
            assert_eq!(Move::build::<i32>(slot(0)).rule(lockouts).finish(&OPTIONS()), built);
        }
    }
}
