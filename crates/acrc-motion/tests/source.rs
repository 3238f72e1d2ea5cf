//! Ratchets, frequency limiters and programmable limit switches.

use acrc_motion::source::{LimitSwitch, Ratchet, RatchetRule, RateLimiter};

#[test]
fn a_ratchet_buffers_the_way_back() {
    let mut ratchet = Ratchet::from_mode(3).unwrap();
    let passed = [5.0, -3.0, -4.0, 6.0, 2.0, 1.0].map(|counts| ratchet.pass(counts));
    assert_eq!(passed, [5.0, 0.0, 0.0, 0.0, 1.0, 1.0]);
    ratchet.pass(-10.0);
    ratchet.reset();
    assert_eq!(ratchet.pass(2.0), 2.0);
}

#[test]
fn each_direction_has_its_rule() {
    let mut both = Ratchet::from_mode(0).unwrap();
    assert_eq!([4.0, -4.0].map(|counts| both.pass(counts)), [4.0, -4.0]);
    let mut reverse = Ratchet::new(RatchetRule::Block, RatchetRule::Pass);
    assert_eq!([4.0, -4.0, 4.0].map(|counts| reverse.pass(counts)), [0.0, -4.0, 0.0]);
    assert_eq!(Ratchet::from_mode(1), None);
}

#[test]
fn a_limiter_passes_the_excess_later() {
    let mut limiter = RateLimiter::new(4000.0, 2.0);
    let passed = [0.5, 3.0, 0.0, 0.0, 0.0, -4.0].map(|counts| limiter.pass(counts, 0.0005));
    assert_eq!(passed, [1.0, 2.0, 2.0, 2.0, 0.0, -2.0]);
    limiter.reset();
    assert_eq!(limiter.pass(0.0, 0.0005), 0.0);
    assert_eq!(RateLimiter::default().pass(1e6, 0.0005), 1e6);
}

#[test]
fn a_limit_switch_changes_the_bits_of_its_mask() {
    let table = [0b00, 0b01, 0b11, 0b10];
    let switch = LimitSwitch { source_offset: 100.0, ratio: 0.01, mask: 0b11, ..LimitSwitch::default() };
    let outputs = [50.0, 100.0, 250.0, 399.0, 499.0, 500.0].map(|source| switch.outputs(source, &table, 0b101));
    assert_eq!(outputs, [0b101, 0b100, 0b101, 0b111, 0b110, 0b101]);
    let rotary = LimitSwitch { rotary: 4.0, ..switch };
    assert_eq!([-50.0, 550.0].map(|source| rotary.place(source)), [Some(2), Some(0)]);
}
