//! Time: how it is cut into ticks, and into calls, changes nothing.

use acrc_motion::{Advanced, Master, Move, MoveSettings, Target};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// What happens to a master between two stretches of time.
#[derive(Clone, Debug)]
enum Event {
    Push(Box<Move>),
    Override(f64),
    Hold,
    Start,
    Stop,
    Kill,
    OpenGate,
    Interrupt,
    Redirect(f64),
    Replace(Box<Move>),
}

fn event() -> impl Strategy<Value = Event> {
    prop_oneof![
        8 => moves().prop_map(|command| Event::Push(Box::new(command))),
        2 => (0.0..2.0_f64).prop_map(Event::Override),
        1 => Just(Event::Override(0.0)),
        1 => Just(Event::Hold),
        2 => Just(Event::Start),
        1 => Just(Event::Stop),
        1 => Just(Event::Kill),
        2 => Just(Event::OpenGate),
        1 => Just(Event::Interrupt),
        1 => (-10.0..10.0_f64).prop_map(Event::Redirect),
        1 => moves().prop_map(|command| Event::Replace(Box::new(command))),
    ]
}

prop_compose! {
    fn moves()(
        x in -10.0..10.0_f64,
        y in -10.0..10.0_f64,
        velocity in 0.1..100.0_f64,
        ramps in prop::array::uniform3(1.0..1000.0_f64),
        blends in any::<bool>(),
        curved in any::<bool>(),
        initial_velocity in 0.0..2.0_f64,
        gated in prop::bool::weighted(0.1),
        interruptible in prop::bool::weighted(0.2),
    ) -> Move {
        let [acceleration, deceleration, stop] = ramps;
        let settings = MoveSettings {
            velocity, acceleration, deceleration, initial_velocity,
            stop: if blends { 0.0 } else { stop },
            jerk: if curved { 2000.0 } else { 0.0 },
            ..MoveSettings::default()
        };
        let mut command = Move::new(settings).to(0, Target::Absolute(x)).to(1, Target::Relative(y));
        command.gate = gated.then_some(1);
        command.interrupt = interruptible.then_some(2);
        command
    }
}

fn apply(master: &mut Master, event: &Event) {
    match event {
        // A full queue or a stop refuses the move, which is as good a case as any.
        Event::Push(command) => drop(master.push(command)),
        Event::Override(factor) => master.set_feedrate_override(*factor).unwrap(),
        Event::Hold => master.feedhold(),
        Event::Start => master.cycle_start(),
        Event::Stop => master.stop(),
        Event::Kill => master.kill(),
        Event::OpenGate => master.open_gate(),
        Event::Interrupt => master.interrupt(),
        Event::Redirect(end) => drop(master.redirect(0, *end)),
        Event::Replace(command) => drop(master.replace(command)),
    }
}

/// Everything a caller can see, to the bit.
fn seen(master: &Master) -> Vec<u64> {
    let mut values = vec![master.vector_velocity(), master.vector_acceleration()];
    for slot in 0..2 {
        values.extend([master.position(slot), master.target(slot), master.velocity(slot)]);
    }
    let mut seen: Vec<u64> = values.into_iter().map(f64::to_bits).collect();
    seen.extend([u64::from(master.in_motion()), master.waiting() as u64]);
    seen
}

fn add(sum: &mut Advanced, part: Advanced) {
    sum.started += part.started;
    sum.completed += part.completed;
    sum.stopped |= part.stopped;
}

/// The same cases in every run.
fn config() -> ProptestConfig {
    ProptestConfig { cases: 1000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn a_jump_equals_its_ticks_to_the_bit(
        script in prop::collection::vec((event(), 0_u64..2000), 1..20),
        dt in prop_oneof![Just(0.0005), 1e-5..0.01_f64],
    ) {
        let mut jumping = Master::new(3);
        let mut ticking = Master::new(3);
        for (event, ticks) in script {
            apply(&mut jumping, &event);
            apply(&mut ticking, &event);
            let jumped = jumping.advance_ticks(ticks, dt);
            let mut ticked = Advanced::default();
            for _ in 0..ticks {
                add(&mut ticked, ticking.advance(dt));
            }
            prop_assert_eq!((jumped.started, jumped.completed, jumped.stopped), (ticked.started, ticked.completed, ticked.stopped));
            prop_assert_eq!(seen(&jumping), seen(&ticking));
        }
    }

    #[test]
    fn the_tick_does_not_change_the_motion(commands in prop::collection::vec(moves(), 1..8), seconds in 0.0..5.0_f64) {
        let mut coarse = Master::new(8);
        let mut fine = Master::new(8);
        for command in &commands {
            let mut command = *command;
            command.gate = None;
            command.interrupt = None;
            coarse.push(&command).unwrap();
            fine.push(&command).unwrap();
        }
        coarse.advance(seconds);
        fine.advance_ticks(1000, seconds / 1000.0);
        for slot in 0..2 {
            let difference = (coarse.position(slot) - fine.position(slot)).abs();
            prop_assert!(difference <= 1e-7, "slot {slot}: {difference}");
        }
    }

    #[test]
    fn nothing_leaves_its_limits(script in prop::collection::vec((event(), 0_u64..200), 1..20)) {
        let dt = 0.0005;
        let mut master = Master::new(3);
        // No move is faster than 100 u/s, no override above 2, and there are two axes.
        let fastest = 200.0;
        for (event, ticks) in script {
            apply(&mut master, &event);
            for _ in 0..ticks {
                let before = [master.position(0), master.position(1)];
                let running = master.in_motion();
                let advanced = master.advance(dt);
                let velocity = master.vector_velocity();
                prop_assert!((0.0..=fastest * (1.0 + 1e-9)).contains(&velocity), "{velocity}");
                prop_assert!(running || advanced.completed == 0);
                for (slot, before) in before.into_iter().enumerate() {
                    let way = (master.position(slot) - before).abs();
                    prop_assert!(way <= fastest * dt * (1.0 + 1e-6), "{way}");
                }
            }
        }
    }
}

#[test]
fn a_long_move_does_not_drift() {
    let mut master = Master::new(1);
    let settings = MoveSettings { velocity: 1.0, ..MoveSettings::default() };
    master.push(&Move::new(settings).to(0, Target::Absolute(1e6))).unwrap();
    for _ in 0..1_000_000 {
        master.advance(0.0003);
    }
    assert_eq!(master.position(0), 1_000_000.0 * 0.0003);
}

#[test]
fn a_changed_tick_goes_on_from_where_it_is() {
    let mut master = Master::new(1);
    let settings = MoveSettings { velocity: 1.0, ..MoveSettings::default() };
    master.push(&Move::new(settings).to(0, Target::Absolute(10.0))).unwrap();
    master.advance(0.5);
    master.advance(0.25);
    master.advance(0.25);
    assert_eq!(master.position(0), 1.0);
}

#[test]
fn no_time_passes_in_a_tick_that_is_none() {
    let mut master = Master::new(1);
    let settings = MoveSettings { velocity: 1.0, ..MoveSettings::default() };
    master.push(&Move::new(settings).to(0, Target::Absolute(10.0))).unwrap();
    for dt in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(master.advance(dt), Advanced::default());
    }
    assert_eq!(master.position(0), 0.0);
    assert_eq!(master.advance(1.0).started, 1);
}
