//! The register figures of the guide, number by number.

use acrc_motion::axis::{Backlash, BacklashRule, GantryLock, Registers};
use proptest::prelude::*;

/// The registers of Figure 2 once REN has made the error zero: C 2, J 2, G 3, K 4.
const FIGURE: Registers =
    Registers { coordinated: 2.0, jog: 2.0, gear: 3.0, cam: 4.0, backlash: 0.0, ballscrew: 0.0, actual: 11.0 };

#[test]
fn setpoints_are_sums() {
    let compensated = Registers { backlash: 0.25, ballscrew: 0.5, actual: 11.5, ..FIGURE };
    assert_eq!(FIGURE.primary_setpoint(), 11.0);
    assert_eq!(FIGURE.secondary_setpoint(), 11.0);
    assert_eq!(compensated.secondary_setpoint(), 11.75);
    assert_eq!(compensated.following_error(), 0.25);
}

#[test]
fn ren_computes_back_from_the_actual_position() {
    let before = Registers { coordinated: 7.5, ..FIGURE };
    assert_eq!(before.following_error(), 5.5);
    let after = before.match_actual();
    assert_eq!(after, FIGURE);
    assert_eq!((after.secondary_setpoint(), after.primary_setpoint()), (11.0, 11.0));
    let compensated = Registers { backlash: 1.0, ..before }.match_actual();
    assert_eq!((compensated.secondary_setpoint(), compensated.primary_setpoint()), (11.0, 10.0));
    assert_eq!(compensated.coordinated, 1.0);
}

#[test]
fn res_preloads_every_register() {
    let after = FIGURE.reset(10.0);
    assert_eq!(after, Registers { coordinated: 10.0, actual: 10.0, ..Registers::default() });
    assert_eq!((after.primary_setpoint(), after.secondary_setpoint()), (10.0, 10.0));
    assert_eq!(FIGURE.reset(0.0), Registers::default());
}

#[test]
fn jog_ren_and_jog_res_move_the_difference() {
    assert_eq!(FIGURE.coordinated_into_jog(0.0), Registers { coordinated: 0.0, jog: 4.0, ..FIGURE });
    let preload = Registers { coordinated: 5.0, jog: 1.0, ..FIGURE };
    assert_eq!(preload.coordinated_into_jog(2.0), Registers { coordinated: 2.0, jog: 4.0, ..FIGURE });
    assert_eq!(FIGURE.jog_into_coordinated(0.0), Registers { coordinated: 4.0, jog: 0.0, ..FIGURE });
    let preload = Registers { coordinated: 1.0, jog: 5.0, ..FIGURE };
    assert_eq!(preload.jog_into_coordinated(2.0), Registers { coordinated: 4.0, jog: 2.0, ..FIGURE });
}

#[test]
fn cam_res_moves_the_difference_and_gear_res_does_not() {
    assert_eq!(FIGURE.cam_into_coordinated(0.0), Registers { coordinated: 6.0, cam: 0.0, ..FIGURE });
    assert_eq!(FIGURE.cam_into_coordinated(1.0), Registers { coordinated: 5.0, cam: 1.0, ..FIGURE });
    assert_eq!(FIGURE.reset_gear(1.0), Registers { gear: 1.0, ..FIGURE });
    assert_eq!(FIGURE.reset_gear(1.0).primary_setpoint(), 9.0);
}

#[test]
fn a_rotary_position_is_folded_into_one_turn() {
    let turned = Registers { coordinated: 730.0, actual: 729.5, ..Registers::default() };
    let folded = turned.normalized(360.0);
    assert_eq!((folded.coordinated, folded.actual), (10.0, 9.5));
    let back = Registers { coordinated: -10.0, actual: -10.0, ..Registers::default() }.normalized(360.0);
    assert_eq!((back.coordinated, back.actual), (350.0, 350.0));
}

#[test]
fn a_locked_axis_keeps_its_distance_and_stands_when_it_is_released() {
    let lock = GantryLock::new(100.0, 11.0);
    assert_eq!(lock.primary_setpoint(120.0), 31.0);
    let released = lock.released(120.0, &FIGURE);
    assert_eq!(released, Registers { coordinated: 22.0, ..FIGURE });
    assert_eq!(released.primary_setpoint(), 31.0);
}

#[test]
fn backlash_follows_the_setpoint_or_the_travel() {
    let mut literal = Backlash::new(0.5, BacklashRule::PositiveSetpoint);
    let mut travel = Backlash::new(0.5, BacklashRule::PositiveTravel);
    let added = [-2.0, -1.0, 0.0, 1.0, 1.0, 0.5, -1.0].map(|psp| (literal.update(psp), travel.update(psp)));
    let expected = [(0.0, 0.0), (0.0, 0.5), (0.0, 0.5), (0.5, 0.5), (0.5, 0.5), (0.5, 0.0), (0.0, 0.0)];
    assert_eq!(added, expected);
}

proptest! {
    #[test]
    fn transfers_never_move_the_axis(
        values in prop::array::uniform7(-1e6..1e6_f64),
        to in -1e6..1e6_f64,
    ) {
        let [coordinated, jog, gear, cam, backlash, ballscrew, actual] = values;
        let before = Registers { coordinated, jog, gear, cam, backlash, ballscrew, actual };
        for after in [before.coordinated_into_jog(to), before.jog_into_coordinated(to), before.cam_into_coordinated(to)] {
            prop_assert!((after.primary_setpoint() - before.primary_setpoint()).abs() < 1e-8);
            prop_assert!((after.secondary_setpoint() - before.secondary_setpoint()).abs() < 1e-8);
        }
        prop_assert!(before.match_actual().following_error().abs() < 1e-8);
        prop_assert_eq!(before.reset(to).following_error(), 0.0);
        let folded = before.normalized(360.0);
        prop_assert!((0.0..360.0).contains(&folded.coordinated));
        prop_assert!((folded.following_error() - before.following_error()).abs() < 1e-8);
    }
}
