//! What goes wrong around an axis (guide, "Error Handling", "Kill All Motion Request vs. Kill All Moves", "Troubleshooting").

use crate::support::Sim;

fn states(body: &str, world: &str) -> Vec<String> {
    let body = format!("HLDEC X100 Y100\nEXC X0.5\nDRIVE ON X Y\nX100 Y10\n{body}");
    Sim::program(&body).world(world).until(30.0).prints()
}

#[test]
fn an_axis_that_is_held_has_a_following_error() {
    let world = "[[event]]\nat = 0.5\njam = [0]\n[[event]]\nat = 2.5\nfree = [0]\n";
    let body = "DWL 0.4\nPRINT BIT 769; P12291\nDWL 1\nPRINT BIT 769; P12291 > 5; BIT 768; BIT 8467\nDWL 2\nPRINT BIT 769; P12291";
    assert_eq!(states(body, world), ["-10", "0-1-10", "-10"]);
}

#[test]
fn an_excess_error_kills_and_disables_where_it_is_told_to() {
    let world = "[[event]]\nat = 0.5\njam = [0]\n";
    let body = "SET 8469\nINH 8467\nPRINT P12291 > 0.5; P12291 < 0.6\nPRINT BIT 8479; BIT 8465; BIT 8467; BIT 8499; BIT 522; BIT 8497\n\
                CLR 8467 : CLR 8499 : CLR 522\nDWL 0.5\nPRINT BIT 8467; BIT 8479\nREN X\nDRIVE ON X\nDWL 0.01\nPRINT BIT 8479; BIT 8465; BIT 769";
    let lines = states(body, world);
    assert_eq!(lines[1..], ["-10-1-1-1-1", "0-1", "0-1-1"]);
}

#[test]
fn a_drive_fault_kills_the_axis_and_is_latched() {
    let world = "[[event]]\nat = 0.5\ndrive_fault = [1]\n";
    let body = "INH 8509\nPRINT BIT 8497; BIT 8465; BIT 8467; BIT 8499; BIT 522; BIT 8511\nINH -792\nDRIVE ON Y\nPRINT BIT 8509; BIT 8497";
    assert_eq!(states(body, world), ["0-1-1-1-10", "0-1"]);
}

#[test]
fn a_kill_disables_the_drive_where_it_is_told_to() {
    let body = "SET 8471\nDWL 0.2\nSET 8467\nPRINT BIT 8465; BIT 8497; BIT 8499";
    assert_eq!(states(body, ""), ["0-1-1"]);
}

#[test]
fn an_open_motion_enable_input_stops_everything_until_it_is_reset() {
    let world = "[[event]]\nat = 0.5\nmotion_enable = false\n[[event]]\nat = 1.5\nmotion_enable = true\n";
    let body = "INH 5645\nPRINT BIT 5646; BIT 8467; BIT 8499; BIT 8465; BIT 522\nDWL 0.5\nSET 5647\nDRIVE ON X\nPRINT BIT 5645; BIT 8465\n\
                INH -5646\nPRINT BIT 5645\nDRIVE ON X\nPRINT BIT 8465\nSET 5647\nINH -5647\nPRINT BIT 5645\nDRIVE ON X\nPRINT BIT 8465";
    assert_eq!(states(body, world), ["-1-1-10-1", "-10", "-1", "0", "0", "-1"]);
}

#[test]
fn a_lost_encoder_disables_its_axis() {
    let world = "[[event]]\nat = 0.5\nencoder_lost = [0]\n[[event]]\nat = 3\nencoder_back = [0]\n";
    let body = "INH 2561\nP0 = P12290\nPRINT BIT 8467; BIT 8465; BIT 8497\nDWL 1\nPRINT P12290 = P0\nENC0 RES\nPRINT BIT 2561\nDWL 2\nENC0 RES\nPRINT BIT 2561";
    assert_eq!(states(body, world), ["-10-1", "-1", "-1", "0"]);
}

#[test]
fn the_flag_of_the_motion_enable_input_may_be_set_by_itself() {
    let world = "[[event]]\nat = 0.5\nset = [5646]\n";
    assert_eq!(states("INH 5645\nPRINT BIT 8467", world), ["-1"]);
}
