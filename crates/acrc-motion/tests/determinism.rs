//! The same bits on every machine and with every feature.

use acrc_motion::{
    Arc, ControlPoint, CurveBuilder, Lookahead, Master, Move, MoveSettings, Sine, SpaceArc, Tangent, Target, Turn,
};

/// Of the straight moves below. It changes only when the motion does.
const STRAIGHT_DIGEST: u64 = 0x4c32_5962_a3c3_097d;

/// Of the moves that bend.
const BENT_DIGEST: u64 = 0x74b6_5ab8_ce70_b954;

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
    assert_eq!(state, STRAIGHT_DIGEST, "{state:#018x}");
}

/// Ticks until there is room, with every tick in the digest.
fn wait_for_room(master: &mut Master, mut state: u64) -> u64 {
    while !master.can_accept() {
        master.advance(0.0005);
        for slot in 0..4 {
            state = digest(state, master.position(slot));
            state = digest(state, master.velocity(slot));
            state = digest(state, master.acceleration(slot));
        }
    }
    state
}

#[test]
fn moves_that_bend_have_the_same_bits_everywhere() {
    let mut master = Master::new(2);
    let mut state = 0xcbf2_9ce4_8422_2325;
    let mut curve = CurveBuilder::nurbs(4).unwrap();
    master.set_lookahead(Some(Lookahead { full: 15.0, stop: 100.0 })).unwrap();
    master.set_tangent(Some(Tangent { plane: [0, 1], axis: 3, turn: 360.0, offset: 5.0 })).unwrap();
    for step in 1..=24_u8 {
        let part = f64::from(step) / 7.0;
        let settings = MoveSettings {
            velocity: 3.0 + part,
            acceleration: 30.0 * part,
            deceleration: 40.0 / part,
            jerk: if step % 2 == 0 { 900.0 * part } else { 0.0 },
            ..MoveSettings::default()
        };
        master.set_rotation([0, 1], 10.0 * part, [1.0, part]).unwrap();
        let start = [0, 1, 2].map(|slot| master.programmed_target(slot));
        let command = Move::new(settings);
        let command = match step % 4 {
            0 => command.arc(Arc {
                slots: [0, 1],
                target: [part, -part],
                center: [1.0, part],
                relative_target: false,
                relative_center: true,
                turn: if step % 8 == 0 { Turn::Clockwise } else { Turn::CounterClockwise },
            }),
            1 => command.space_arc(SpaceArc {
                slots: [0, 1, 2],
                via: [start[0] + 1.0, start[1] + part, start[2]],
                target: [start[0] - 1.0, start[1], start[2] + 0.5],
            }),
            2 => command
                .to(0, Target::Sine(Sine { target: part, phase: 30.0 * part, sweep: 200.0, amplitude: 0.7 }))
                .to(1, Target::Relative(1.0)),
            _ => command.to(0, Target::Relative(part)).to(2, Target::Absolute(part)),
        };
        state = wait_for_room(&mut master, state);
        master.push(&command).unwrap();
        let point = ControlPoint { weight: Some(part), ..ControlPoint::new().at(0, part).at(1, start[1]) };
        if let Some(piece) = curve.push(None, Some(&point)).unwrap() {
            state = wait_for_room(&mut master, state);
            master.push_span(&Move::new(settings), &piece).unwrap();
        }
    }
    assert_eq!(state, BENT_DIGEST, "{state:#018x}");
}
