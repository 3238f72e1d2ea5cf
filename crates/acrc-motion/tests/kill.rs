//! The kill flags, by the guide's description and its example.

use acrc_motion::axis::{Groups, KillActions, KillFlags, KillProtocol, Refusal, members};

/// Axes 0 and 1 belong to master 0, axis 2 to master 1; axis 3 is free.
fn groups() -> Groups {
    let mut groups = Groups::default();
    groups.master_of[0] = Some(0);
    groups.master_of[1] = Some(0);
    groups.master_of[2] = Some(1);
    groups
}

fn still(_: usize) -> bool {
    false
}

#[test]
fn a_request_spreads_over_the_axes_of_its_master() {
    let (groups, mut protocol) = (groups(), KillProtocol::default());
    let mut flags = KillFlags { requests: 0b0001, ..KillFlags::default() };
    let actions = protocol.update(&mut flags, &groups, |_| true);
    assert_eq!(actions, KillActions { stop_axes: 0b0011, kill_masters: 0b01, ..KillActions::default() });
    assert_eq!(flags, KillFlags { requests: 0b0011, moves: 0b01, stops: 0 });
    assert_eq!(protocol.update(&mut flags, &groups, still), KillActions::default());
    // The axis without a master stands for itself.
    flags.requests |= 0b1000;
    let actions = protocol.update(&mut flags, &groups, still);
    assert_eq!(actions, KillActions { stop_axes: 0b1000, ..KillActions::default() });
    assert_eq!(flags.moves, 0b01);
}

#[test]
fn motion_is_refused_until_every_request_of_the_master_and_its_moves_are_cleared() {
    let (groups, mut protocol) = (groups(), KillProtocol::default());
    let mut flags = KillFlags { requests: 0b0001, ..KillFlags::default() };
    protocol.update(&mut flags, &groups, still);
    assert_eq!(flags.refusal(&groups, 1, false), Some(Refusal::Request));
    assert_eq!(flags.refusal(&groups, 2, true), None);
    // The guide's example clears 8467 and 8499; a jog is possible then, a move is not.
    flags.requests &= !0b0001;
    assert_eq!(protocol.update(&mut flags, &groups, still), KillActions::default());
    assert_eq!(flags.refusal(&groups, 0, false), Some(Refusal::Request));
    flags.requests &= !0b0010;
    assert_eq!(flags.refusal(&groups, 0, false), None);
    assert_eq!(flags.refusal(&groups, 0, true), Some(Refusal::Moves));
    flags.moves = 0;
    assert_eq!(flags.refusal(&groups, 0, true), None);
    protocol.update(&mut flags, &groups, still);
    flags.requests = 0b0010;
    assert_eq!(protocol.update(&mut flags, &groups, still).stop_axes, 0b0011, "once more");
}

#[test]
fn kill_all_moves_leaves_the_axes_alone() {
    let (groups, mut protocol) = (groups(), KillProtocol::default());
    let mut flags = KillFlags { moves: 0b10, ..KillFlags::default() };
    let actions = protocol.update(&mut flags, &groups, |_| true);
    assert_eq!(actions, KillActions { kill_masters: 0b10, ..KillActions::default() });
    assert_eq!(flags.refusal(&groups, 2, false), None);
    assert_eq!(flags.refusal(&groups, 2, true), Some(Refusal::Moves));
}

#[test]
fn stop_all_moves_waits_for_the_ramp_and_clears_itself() {
    let (groups, mut protocol) = (groups(), KillProtocol::default());
    let mut flags = KillFlags { stops: 0b01, ..KillFlags::default() };
    let ramping = KillActions { ramp_masters: 0b01, ..KillActions::default() };
    assert_eq!(protocol.update(&mut flags, &groups, |_| true), ramping);
    assert_eq!(protocol.update(&mut flags, &groups, |_| true), KillActions::default());
    assert_eq!(flags, KillFlags { stops: 0b01, ..KillFlags::default() });
    let killed = KillActions { kill_masters: 0b01, ..KillActions::default() };
    assert_eq!(protocol.update(&mut flags, &groups, still), killed);
    assert_eq!(flags, KillFlags { moves: 0b01, ..KillFlags::default() });
}

#[test]
fn a_software_limit_stops_the_group_without_requests() {
    let (groups, mut protocol) = (groups(), KillProtocol::default());
    let mut flags = KillFlags::default();
    protocol.software_limit(&mut flags, &groups, 1);
    let actions = protocol.update(&mut flags, &groups, |_| true);
    assert_eq!(actions, KillActions { soft_stop_axes: 0b0011, kill_masters: 0b01, ..KillActions::default() });
    assert_eq!(flags, KillFlags { moves: 0b01, ..KillFlags::default() });
}

#[test]
fn keys_and_drive_on_set_and_clear() {
    let (groups, mut protocol) = (groups(), KillProtocol::default());
    let mut flags = KillFlags::default();
    flags.request_all(0b1111);
    let actions = protocol.update(&mut flags, &groups, still);
    assert_eq!(members(actions.stop_axes).collect::<Vec<_>>(), [0, 1, 2, 3]);
    assert_eq!(members(actions.kill_masters).collect::<Vec<_>>(), [0, 1]);
    flags.drive_enabled(&groups, 2);
    assert_eq!(flags, KillFlags { requests: 0b1011, moves: 0b01, stops: 0 });
    assert_eq!(flags.refusal(&groups, 2, true), None);
    flags.clear_all();
    assert_eq!(flags, KillFlags::default());
}
