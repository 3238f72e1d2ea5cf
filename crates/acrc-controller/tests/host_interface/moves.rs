//! Moves.

use acrc_controller::{
    Coordinate, HostArc, HostMove, HostPath, MoveExtras, MoveMode, MoveStart, Options, Override, Queued,
};

use crate::support::{Bench, TWO_AXES};

const KILL_ALL_MOVES: u32 = 522;
const STOPS: MoveStart = MoveStart::Lockouts { final_velocity: false, feedrate_override: false, stop_ramp: true };

/// A move of master 0 to targets in units.
fn to(targets: &[(usize, f32)]) -> HostMove {
    let mut all = [None; 16];
    for (slave, target) in targets {
        all[*slave] = Some(Coordinate::Units(*target));
    }
    HostMove {
        master: 0,
        velocity: None,
        final_velocity: None,
        acceleration: None,
        start: STOPS,
        extras: MoveExtras::default(),
        incremental: false,
        targets: all,
        path: HostPath::Line,
    }
}

fn order(bench: &mut Bench, ordered: &HostMove) -> Result<Queued, String> {
    bench.controller.host_move(ordered, &mut bench.log).map_err(|error| error.to_string())
}

/// Offers moves until each is taken.
fn order_all(bench: &mut Bench, moves: &[HostMove]) {
    for ordered in moves {
        while order(bench, ordered) == Ok(Queued::NoRoom) {
            bench.pass(0.001);
        }
    }
}

#[test]
fn a_line_takes_the_time_of_a_statement() {
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(order(&mut bench, &to(&[(0, 6.0), (1, 8.0)])), Ok(Queued::Yes));
    bench.pass(1.0995);
    assert!(bench.position(0) < 6.0);
    bench.pass(0.001);
    assert_eq!((bench.position(0), bench.position(1)), (6.0, 8.0));
}

#[test]
fn whole_numbers_are_pulses() {
    let mut bench = Bench::new(TWO_AXES);
    let mut ordered = to(&[]);
    ordered.targets[0] = Some(Coordinate::Pulses(2500));
    assert_eq!(order(&mut bench, &ordered), Ok(Queued::Yes));
    bench.pass(5.0);
    assert_eq!((bench.position(0), bench.controller.parameter_long(12288)), (2.5, Some(2500)));
}

#[test]
fn incremental_targets_count_from_where_the_move_before_ends() {
    let mut bench = Bench::new(TWO_AXES);
    let ordered = HostMove { incremental: true, ..to(&[(0, 2.0)]) };
    order_all(&mut bench, &[ordered, ordered, ordered]);
    bench.pass(5.0);
    assert_eq!(bench.position(0), 6.0);
}

#[test]
fn a_move_without_room_is_to_be_offered_again() {
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(order(&mut bench, &to(&[(0, 1.0)])), Ok(Queued::Yes));
    assert_eq!(order(&mut bench, &to(&[(0, 2.0)])), Ok(Queued::Yes));
    let faster = HostMove { velocity: Some(50.0), ..to(&[(0, 3.0)]) };
    assert_eq!(order(&mut bench, &faster), Ok(Queued::NoRoom));
    bench.ask("PROG0");
    assert_eq!(bench.ask("VEL"), "10");
    bench.pass(0.5);
    assert_eq!(order(&mut bench, &faster), Ok(Queued::Yes));
    bench.pass(5.0);
    assert_eq!((bench.position(0), bench.ask("VEL")), (3.0, "50".to_owned()));
}

#[test]
fn velocities_stay_with_the_master() {
    let mut bench = Bench::new(TWO_AXES);
    let ordered =
        HostMove { velocity: Some(20.0), final_velocity: Some(0.0), acceleration: Some(50.0), ..to(&[(0, 1.0)]) };
    assert_eq!(order(&mut bench, &ordered), Ok(Queued::Yes));
    bench.ask("PROG0");
    assert_eq!(bench.ask("VEL : ACC : DEC : FVEL : STP"), "20 50 50 0 100");
}

#[test]
fn a_move_without_stop_ramp_hands_its_velocity_over() {
    let mut bench = Bench::new(TWO_AXES);
    let start = MoveStart::Lockouts { final_velocity: false, feedrate_override: false, stop_ramp: false };
    order_all(&mut bench, &[HostMove { start, ..to(&[(0, 10.0)]) }, to(&[(0, 20.0)])]);
    // 0.1 s up, 1.9 s across and 0.1 s down.
    bench.pass(2.0995);
    assert!(bench.position(0) < 20.0);
    bench.pass(0.01);
    assert_eq!(bench.position(0), 20.0);
}

#[test]
fn an_override_can_be_locked_out() {
    let mut bench = Bench::new(TWO_AXES);
    bench.controller.set_override(Override::Feedrate, 1, 0.5, &mut bench.log).expect("a factor");
    let start = MoveStart::Lockouts { final_velocity: true, feedrate_override: true, stop_ramp: true };
    assert_eq!(order(&mut bench, &HostMove { start, ..to(&[(0, 100.0)]) }), Ok(Queued::Yes));
    bench.pass(1.0);
    assert_eq!(bench.controller.view().motion(0).0, 10.0);
}

#[test]
fn a_rapid_move_follows_the_rapid_override() {
    let mut bench = Bench::new(TWO_AXES);
    bench.controller.set_override(Override::Feedrate, 1, 0.25, &mut bench.log).expect("a factor");
    bench.controller.set_override(Override::Rapid, 1, 0.5, &mut bench.log).expect("a factor");
    let start = MoveStart::Mode { mode: MoveMode::Rapid, override_lockout: false };
    assert_eq!(order(&mut bench, &HostMove { start, ..to(&[(0, 100.0)]) }), Ok(Queued::Yes));
    bench.pass(1.0);
    assert_eq!(bench.controller.view().motion(0).0, 5.0);
}

#[test]
fn rapid_move_modes_are_on_when_their_flag_is_set() {
    let flag = Options { rapid_move_modes: Some(1920), ..Options::default() };
    let mut bench = Bench::with(TWO_AXES, flag);
    assert!(!bench.controller.has_rapid_move_modes(0));
    bench.ask("SET 1952");
    assert!(bench.controller.has_rapid_move_modes(1) && !bench.controller.has_rapid_move_modes(0));
    assert!(!Bench::new(TWO_AXES).controller.has_rapid_move_modes(0));
}

/// A quarter of a circle about the origin of its center.
fn quarter(counterclockwise: bool, incremental: bool) -> HostMove {
    let path = HostPath::Arc(HostArc {
        slaves: [0, 1],
        counterclockwise,
        center: [Coordinate::Units(10.0), Coordinate::Units(0.0)],
        incremental,
        scaling: None,
    });
    HostMove { path, ..to(&[(0, 10.0), (1, 10.0)]) }
}

#[test]
fn an_arc_runs_about_its_center() {
    for incremental in [false, true] {
        let mut bench = Bench::new(TWO_AXES);
        assert_eq!(order(&mut bench, &quarter(false, incremental)), Ok(Queued::Yes));
        bench.pass(0.8);
        let [x, y] = [bench.position(0), bench.position(1)];
        assert!(((x - 10.0).hypot(y) - 10.0).abs() < 1e-6, "{x} {y}");
        assert!(x < 10.0 && y > 0.0);
        bench.pass(3.0);
        assert_eq!((bench.position(0), bench.position(1)), (10.0, 10.0));
    }
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(order(&mut bench, &quarter(true, false)), Ok(Queued::Yes));
    bench.pass(1.0);
    assert!(bench.position(1) < 0.0, "the other way round");
}

#[test]
fn an_arc_without_targets_is_a_circle() {
    let mut bench = Bench::new(TWO_AXES);
    let circle = HostMove { targets: [None; 16], ..quarter(false, true) };
    assert_eq!(order(&mut bench, &circle), Ok(Queued::Yes));
    bench.pass(3.2);
    assert!((bench.position(0) - 20.0).abs() < 1.0, "{}", bench.position(0));
    bench.pass(5.0);
    assert_eq!((bench.position(0), bench.position(1)), (0.0, 0.0));
}

#[test]
fn a_spline_goes_through_its_points() {
    let mut bench = Bench::new(TWO_AXES);
    let mut points: Vec<HostMove> = [(1.0, 1.0), (2.0, 0.0), (3.0, 1.0)]
        .iter()
        .zip([1.0, 2.0, 3.0])
        .map(|((x, y), knot)| HostMove { path: HostPath::Spline { knot: Some(knot) }, ..to(&[(0, *x), (1, *y)]) })
        .collect();
    points.insert(0, HostMove { path: HostPath::Spline { knot: Some(0.0) }, ..to(&[(0, 0.0), (1, 0.0)]) });
    points.push(HostMove { path: HostPath::Spline { knot: Some(-1.0) }, ..to(&[]) });
    order_all(&mut bench, &points);
    bench.pass(5.0);
    assert_eq!((bench.position(0), bench.position(1)), (3.0, 1.0));
}

#[test]
fn a_line_ends_a_curve() {
    let mut bench = Bench::new(TWO_AXES);
    let nurb = |x, y| HostMove { path: HostPath::Nurb { knot: None, weight: Some(1.0) }, ..to(&[(0, x), (1, y)]) };
    let moves = [nurb(0.0, 0.0), nurb(1.0, 2.0), nurb(3.0, 2.0), nurb(4.0, 0.0), to(&[(0, 10.0)])];
    order_all(&mut bench, &moves);
    bench.pass(5.0);
    assert_eq!((bench.position(0), bench.position(1)), (10.0, 0.0));
}

#[test]
fn masters_move_at_the_same_time() {
    let mut bench = Bench::new(&format!(
        "{TWO_AXES}PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"Z\"\nPPU Z1000\nACC 100 DEC 100 STP 100 VEL 5\n"
    ));
    assert_eq!(order(&mut bench, &to(&[(0, 100.0)])), Ok(Queued::Yes));
    assert_eq!(order(&mut bench, &HostMove { master: 1, ..to(&[(0, 100.0)]) }), Ok(Queued::Yes));
    bench.pass(1.0);
    let view = bench.controller.view();
    assert_eq!((view.motion(0).0, view.motion(2).0), (10.0, 5.0));
}

#[test]
fn a_move_buffer_takes_more_moves() {
    let mut bench = Bench::new(&format!("{TWO_AXES}DIM MBUF(5)\nMBUF ON\n"));
    let step = HostMove { incremental: true, ..to(&[(0, 1.0)]) };
    let taken = (0..10).take_while(|_| order(&mut bench, &step) == Ok(Queued::Yes)).count();
    assert_eq!(taken, 6);
}

#[test]
fn what_a_statement_would_be_refused_is_refused() {
    let mut bench = Bench::new(TWO_AXES);
    let refused = |bench: &mut Bench, ordered: HostMove| order(bench, &ordered).expect_err("it is refused");
    assert_eq!(
        refused(&mut bench, HostMove { master: 9, ..to(&[(0, 1.0)]) }),
        "MASTER9 does not exist: this controller has MASTER0 to MASTER7"
    );
    assert_eq!(refused(&mut bench, to(&[(2, 1.0)])), "SLAVE2 of MASTER0 has no axis");
    assert_eq!(refused(&mut bench, to(&[(0, f32::NAN)])), "NaN is no finite number");
    assert_eq!(refused(&mut bench, HostMove { velocity: Some(-1.0), ..to(&[(0, 1.0)]) }), "VEL: -1 is negative");
    assert_eq!(
        refused(&mut bench, HostMove { velocity: Some(0.0), ..to(&[(0, 1.0)]) }),
        "MOV: the velocity of master 0 is 0, so the move would never end; VEL sets it"
    );
    bench.set_flag(KILL_ALL_MOVES, true).expect("a flag");
    assert_eq!(
        refused(&mut bench, to(&[(0, 1.0)])),
        "master 0 has its Kill All Moves flag set (BIT522): it must be cleared before a move"
    );
    bench.pass(1.0);
    assert_eq!(bench.position(0), 0.0);
}

#[test]
fn a_scaled_arc_is_refused() {
    let mut bench = Bench::new(TWO_AXES);
    let mut ordered = quarter(false, false);
    if let HostPath::Arc(arc) = &mut ordered.path {
        arc.scaling = Some([2.0, 1.0]);
    }
    assert_eq!(order(&mut bench, &ordered), Err("scaling of the radius of an arc is not simulated".to_owned()));
}

#[test]
fn what_has_no_effect_is_noted() {
    let mut bench = Bench::new(TWO_AXES);
    assert_eq!(
        order(
            &mut bench,
            &HostMove { extras: MoveExtras { counts: true, ..MoveExtras::default() }, ..to(&[(0, 1.0)]) }
        ),
        Ok(Queued::Yes)
    );
    let notes: Vec<&str> = bench.controller.notes().filter(|note| note.contains("host")).collect();
    assert_eq!(notes, ["a host's move of master 0 asked for the move counter: that has no effect"]);
}
