//! The same bits on every machine and with every feature.

use acrc_motion::{Master, Move, MoveSettings, Target};

/// Of everything below. It changes only when the motion does.
const DIGEST: u64 = 0x6d69_a40c_96bc_909d;

/// Adds the bits of a number to a digest (FNV-1a).
fn digest(seed: u64, value: f64) -> u64 {
    value.to_le_bytes().iter().fold(seed, |digest, byte| (digest ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

#[test]
fn a_run_has_the_same_bits_everywhere() {
    let mut master = Master::new(4);
    let mut state = 0xcbf2_9ce4_8422_2325;
    for step in 1..=40_u8 {
        let part = f64::from(step) / 7.0;
        let settings = MoveSettings {
            velocity: 3.0 + part,
            acceleration: 11.0 * part,
            deceleration: 40.0 / part,
            stop: if step % 3 == 0 { 0.0 } else { 17.0 },
            jerk: if step % 2 == 0 { 90.0 * part } else { 0.0 },
            final_velocity: 0.5,
            time: if step % 5 == 0 { part } else { 0.0 },
            ..MoveSettings::default()
        };
        let command = Move::new(settings)
            .to(0, Target::Relative(part))
            .to(1, Target::Absolute(-part))
            .to(2, Target::Relative(1.0 / part));
        while !master.can_accept() {
            master.advance(0.0005);
            for slot in 0..3 {
                state = digest(state, master.position(slot));
                state = digest(state, master.velocity(slot));
            }
        }
        master.set_feedrate_override(0.4 + part / 5.0).unwrap();
        master.push(&command).unwrap();
    }
    assert_eq!(state, DIGEST, "{state:#018x}");
}
