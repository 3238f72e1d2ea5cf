//! What packets cost, encoded and decoded.
//!
//! Goal: an exchange far below a microsecond, so that a server's time goes into its sockets.

use std::hint::black_box;

use acrc_wire::binary::{DataReply, DataRequest, Move, Slot};
use acrc_wire::ethernet::FastStatus;
use acrc_wire::{Channel, Field, Reply, Request, WireOptions};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

/// Packets in a row, as a client sends them without waiting for answers.
const ROW: usize = 1000;

fn requests() -> [(&'static str, Request<'static>); 3] {
    let slots = || Slot::all().take(8);
    let start = Move::build::<f32>(slots().next().expect("there are sixteen")).velocity(20.0);
    let full = slots().fold(start, |built, slave| built.target(slave, 1.5)).finish(&WireOptions::default());
    [
        ("get_long", Request::GetLong { parameter: 12288 }),
        ("data_eight_axes", Request::Data(DataRequest { group: 0x30, index: 2, mask: 0xFF })),
        ("move_eight_slaves", Request::Move(full)),
    ]
}

fn encode(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("encode");
    let channel = Channel::ethernet();
    let mut out = Vec::with_capacity(2048);
    for (name, request) in requests() {
        group.bench_function(name, |b| {
            b.iter(|| {
                out.clear();
                channel.request(black_box(&request), &mut out);
            });
        });
    }
    let fields = [Field(1); 8];
    let asked = DataRequest { group: 0x30, index: 2, mask: 0xFF };
    let reply = Reply::Data(DataReply::new(asked, &fields).expect("there are eight"));
    for (name, channel) in [("data_reply", Channel::ethernet()), ("data_reply_mode_1", Channel::serial())] {
        group.bench_function(name, |b| {
            b.iter(|| {
                out.clear();
                channel.reply(black_box(&reply), &mut out);
            });
        });
    }
    let status = FastStatus::default();
    group.bench_function("fast_status", |b| b.iter(|| black_box(&status).encode()));
}

fn decode(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("decode");
    group.throughput(Throughput::Elements(ROW as u64));
    for (name, request) in requests() {
        for (kind, channel) in [("packed", Channel::ethernet()), ("mode_1", Channel::serial())] {
            let mut bytes = Vec::new();
            (0..ROW).for_each(|_| channel.request(&request, &mut bytes));
            // One segment of a connection, and pieces that cut packets.
            for piece in [bytes.len(), 7] {
                let name = format!("{name}/{kind}/{}", if piece == 7 { "pieces" } else { "whole" });
                group.bench_function(name, |b| b.iter(|| assert_eq!(count(channel, &bytes, piece), ROW)));
            }
        }
    }
}

fn count(channel: Channel, bytes: &[u8], piece: usize) -> usize {
    let mut decoder = channel.requests();
    let mut count = 0;
    for mut input in bytes.chunks(piece) {
        while let Some(item) = decoder.next_item(&mut input) {
            black_box(item);
            count += 1;
        }
    }
    count
}

criterion_group!(benches, encode, decode);
criterion_main!(benches);
