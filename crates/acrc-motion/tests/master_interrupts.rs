//! Moves that wait, that are cut short, redirected or replaced, and time that an external source gives.

use acrc_motion::{Master, Move, MoveSettings, PushError, Target, start_together};

const TICK: f64 = 0.0005;

fn settings() -> MoveSettings {
    MoveSettings { velocity: 20.0, acceleration: 10.0, deceleration: 40.0, stop: 10.0, ..MoveSettings::default() }
}

fn blending() -> MoveSettings {
    MoveSettings { velocity: 10.0, ..MoveSettings::default() }
}

fn to(settings: MoveSettings, x: f64) -> Move {
    Move::new(settings).to(0, Target::Absolute(x))
}

fn run(master: &mut Master) {
    for _ in 0..1_000_000 {
        if !master.in_motion() {
            return;
        }
        master.advance(TICK);
    }
    panic!("the master never comes to rest");
}

#[track_caller]
fn assert_near(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{actual} is not {expected}");
}

#[test]
fn a_gated_move_waits_for_its_gate() {
    let mut master = Master::new(2);
    master.push(&to(settings(), 10.0).gated(32)).unwrap();
    assert_eq!((master.gate(), master.in_motion(), master.advance(1.0).started), (Some(32), true, 0));
    master.open_gate();
    assert_eq!((master.gate(), master.advance(0.5).started), (None, 1));
    assert_eq!(master.vector_velocity(), 5.0);
}

#[test]
fn a_gate_matters_only_when_its_move_is_next() {
    let mut master = Master::new(2);
    master.push(&to(settings(), 10.0)).unwrap();
    master.push(&to(settings(), 20.0).gated(7)).unwrap();
    assert_eq!(master.gate(), None);
    master.open_gate();
    master.advance(5.0);
    assert_eq!((master.gate(), master.position(0)), (Some(7), 10.0));
    master.feedhold();
    assert_eq!(master.gate(), None);
    master.cycle_start();
    assert_eq!((master.gate(), master.advance(1.0).started), (Some(7), 0));
    master.open_gate();
    run(&mut master);
    assert_eq!(master.position(0), 20.0);
}

#[test]
fn a_gate_opened_in_the_tick_of_the_end_keeps_the_velocity() {
    let mut gated = Master::new(2);
    let mut free = Master::new(2);
    gated.push(&to(blending(), 1.0)).unwrap();
    free.push(&to(blending(), 1.0)).unwrap();
    gated.push(&to(blending(), 5.0).gated(1)).unwrap();
    free.push(&to(blending(), 5.0)).unwrap();
    gated.advance(0.15);
    free.advance(0.15);
    gated.open_gate();
    assert_eq!(gated.position(0), free.position(0));
    assert_eq!(gated.advance(0.1).dropped_velocity, 0.0);

    let mut late = Master::new(2);
    late.push(&to(blending(), 1.0)).unwrap();
    late.push(&to(settings(), 5.0).gated(1)).unwrap();
    late.advance(0.15);
    assert_eq!(late.advance(0.1).dropped_velocity, 10.0);
    late.open_gate();
    assert_eq!(late.vector_velocity(), 0.0);
}

#[test]
fn an_interrupted_move_ends_where_it_comes_to_rest() {
    let mut master = Master::new(2);
    master.push(&to(settings(), 200.0).interruptible(5)).unwrap();
    assert_eq!(master.interruptible(), Some(5));
    assert!(!master.can_accept());
    assert_eq!(master.push(&to(settings(), 0.0)), Err(PushError::OpenEnd));
    master.advance(3.0);
    master.interrupt();
    assert_eq!((master.interruptible(), master.can_accept()), (None, false));
    // 20 u/s come down in half a second.
    master.advance(0.25);
    assert_eq!(master.vector_velocity(), 10.0);
    let advanced = master.advance(0.25);
    assert_eq!((advanced.interrupted, advanced.completed, advanced.dropped_velocity), (true, 1, 0.0));
    assert_eq!((master.in_motion(), master.position(0), master.target(0)), (false, 45.0, 45.0));
    master.push(&Move::new(settings()).to(0, Target::Relative(5.0))).unwrap();
    run(&mut master);
    assert_eq!(master.position(0), 50.0);
}

#[test]
fn an_interruptible_move_that_nothing_interrupts_is_like_any_other() {
    let mut master = Master::new(2);
    master.push(&to(settings(), 200.0).interruptible(5)).unwrap();
    assert_eq!(master.next_event(), Some(12.0));
    assert!(!master.advance(12.0).interrupted);
    assert!(master.can_accept());
    master.interrupt();
    assert_eq!(master.position(0), 200.0);
}

#[test]
fn an_interruption_too_late_ends_at_the_target() {
    let mut master = Master::new(2);
    master.push(&to(settings(), 200.0).interruptible(5)).unwrap();
    master.advance(11.9);
    master.interrupt();
    run(&mut master);
    // 1 u/s comes down within an eightieth of a unit.
    assert_near(master.position(0), 200.0 - 0.05 + 0.0125);
}

#[test]
fn a_redirected_move_goes_on_to_its_new_end() {
    let mut master = Master::new(2);
    master.push(&to(settings(), 200.0).interruptible(777)).unwrap();
    master.advance(3.0);
    assert_eq!(master.redirect(0, 100.0), Ok(true));
    assert_eq!((master.target(0), master.vector_velocity()), (100.0, 20.0));
    // 40 u are covered; 40 u across and 20 u down.
    assert_near(master.next_event().unwrap(), 4.0);
    assert!(master.can_accept());
    run(&mut master);
    assert_eq!(master.position(0), 100.0);
}

#[test]
fn a_redirected_move_returns_when_its_end_is_too_near() {
    for end in [50.0, 44.0, 20.0] {
        let mut master = Master::new(2);
        master.push(&to(settings(), 200.0).interruptible(777)).unwrap();
        master.advance(3.0);
        assert_eq!(master.redirect(0, end), Ok(true));
        master.advance(0.5);
        assert_eq!((master.position(0), master.in_motion()), (45.0, true));
        run(&mut master);
        assert_eq!((master.position(0), master.target(0)), (end, end));
    }
}

#[test]
fn a_move_queued_behind_a_redirected_one_waits_for_its_return() {
    let mut master = Master::new(2);
    master.push(&to(settings(), 200.0).interruptible(777)).unwrap();
    master.advance(3.0);
    master.redirect(0, 44.0).unwrap();
    master.push(&Move::new(settings()).to(0, Target::Relative(6.0))).unwrap();
    let mut turns = Vec::new();
    while master.in_motion() {
        if master.advance(TICK).completed > 0 {
            turns.push(master.position(0).round());
        }
    }
    assert_eq!(turns, [45.0, 44.0, 50.0]);
}

#[test]
fn only_an_interruptible_straight_move_is_redirected() {
    let mut master = Master::new(2);
    assert_eq!(master.redirect(0, 1.0), Ok(false));
    master.push(&to(settings(), 200.0)).unwrap();
    assert_eq!(master.redirect(0, 1.0), Ok(false));
    assert!(master.redirect(0, f64::NAN).is_err());
    master.interrupt();
    assert_eq!(master.next_event(), Some(12.0));
}

#[test]
fn a_stop_drops_the_return_of_a_redirected_move() {
    let mut master = Master::new(2);
    master.push(&to(settings(), 200.0).interruptible(777)).unwrap();
    master.advance(3.0);
    master.redirect(0, 20.0).unwrap();
    master.stop();
    let advanced = master.advance(2.0);
    assert!(advanced.stopped && !master.in_motion());
    assert_eq!((master.position(0), master.target(0)), (45.0, 45.0));
}

#[test]
fn a_replaced_move_hands_its_velocity_over_at_once() {
    let mut master = Master::new(2);
    master.push(&to(settings(), 200.0)).unwrap();
    master.push(&to(settings(), 300.0)).unwrap();
    master.advance(3.0);
    master.replace(&Move::new(settings()).to(1, Target::Absolute(60.0))).unwrap();
    assert_eq!((master.vector_velocity(), master.velocity(0), master.velocity(1)), (20.0, 0.0, 20.0));
    assert_eq!((master.position(0), master.target(0), master.waiting()), (40.0, 40.0, 0));
    // 40 u across, 20 u down.
    assert_near(master.next_event().unwrap(), 4.0);
    run(&mut master);
    assert_eq!((master.position(0), master.position(1)), (40.0, 60.0));
}

#[test]
fn a_replacement_at_rest_is_a_move() {
    let mut master = Master::new(2);
    master.replace(&to(settings(), 200.0)).unwrap();
    assert_eq!(master.next_event(), Some(12.0));
}

#[test]
fn synchronised_masters_start_in_the_same_tick() {
    let mut first = Master::new(2);
    let mut second = Master::new(2);
    let mut alone = Master::new(2);
    for master in [&mut first, &mut second] {
        master.set_synchronised(true);
    }
    first.push(&to(settings(), 10.0)).unwrap();
    alone.push(&to(settings(), 10.0)).unwrap();
    assert!(!start_together(&mut [&mut first, &mut second, &mut alone]));
    assert_eq!(first.advance(TICK).started, 0);
    second.push(&to(settings(), -90.0)).unwrap();
    assert!(start_together(&mut [&mut first, &mut second, &mut alone]));
    for master in [&mut first, &mut second] {
        assert_eq!(master.advance(TICK).started, 1);
    }
    assert!(!start_together(&mut [&mut first, &mut second]));
    first.push(&to(settings(), 0.0)).unwrap();
    first.advance(100.0);
    assert_eq!((first.position(0), first.is_ready()), (10.0, true));
    first.set_synchronised(false);
    assert_eq!(first.advance(TICK).started, 1);
}

#[test]
fn counts_of_a_source_are_ticks() {
    let mut counted = Master::new(2);
    let mut ticked = Master::new(2);
    for master in [&mut counted, &mut ticked] {
        master.push(&to(settings(), 200.0)).unwrap();
        master.push(&to(settings(), 100.0)).unwrap();
    }
    for counts in [0, 1, 700, 0, 23_500, 5] {
        counted.advance_counts(counts, TICK);
        for _ in 0..counts {
            ticked.advance(TICK);
        }
        assert_eq!(counted.position(0), ticked.position(0));
    }
}

#[test]
fn counts_back_go_back_on_the_path() {
    let mut master = Master::new(2);
    master.push(&to(settings(), 200.0)).unwrap();
    master.advance_counts(4000, TICK);
    assert_eq!(master.position(0), 20.0);
    master.advance_counts(2000, TICK);
    master.advance_counts(-4000, TICK);
    assert_eq!((master.position(0), master.vector_velocity()), (5.0, 10.0));
    // Beyond the start they are lost.
    master.advance_counts(-9000, TICK);
    assert_eq!(master.position(0), 0.0);
    master.advance_counts(2000, TICK);
    assert_eq!(master.position(0), 5.0);
}
