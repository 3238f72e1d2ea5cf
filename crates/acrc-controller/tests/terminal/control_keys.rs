//! Ctrl-X, Ctrl-Y and Ctrl-Z act when they arrive; ESC leaves what shows or waits.

use crate::support::{Desk, TWO_AXES};

const RUNNING: &str = "PROGRAM\nDRIVE ON X Y\nX1000\nINH -516\nENDP\n";

fn running() -> Desk {
    let mut desk = Desk::with(&format!("{TWO_AXES}{RUNNING}"));
    desk.send("PROG0\rRUN\r");
    desk.wait(1.0);
    assert!(desk.bit(516) && desk.bit(8465) && desk.bit(1024));
    desk
}

#[test]
fn ctrl_x_ends_programs_and_kills_motion_at_once() {
    let mut desk = running();
    desk.controller.receive(desk.channel, b"\x18");
    assert!(!desk.bit(516) && !desk.bit(1024));
    assert!(desk.bit(8467) && desk.bit(8499) && desk.bit(8691) && desk.bit(522));
    assert!(desk.bit(8465), "drives stay on");
    assert_eq!(desk.ask("X0"), "Associated Slave Kill Motion Request Active\r\n");
}

#[test]
fn ctrl_x_drops_moves_of_every_kind() {
    for moves in [
        "CIRCCW X(0, 5) Y(0, 0)",
        "TRG 5\nX10",
        "INT 5 X10",
        "HSINT X(0, 10, 2)",
        "SPLINE MODE 0\nX10\nX20\nX30",
        "SYNC ON MASTER0 MASTER1\nX10",
        "SRC NONE\nX10",
    ] {
        let mut desk = Desk::with(&format!("{TWO_AXES}PROGRAM\nTRG 6\nX1\nTRJ X2\n{moves}\nINH -516\nENDP\n"));
        desk.send("PROG0\rRUN\r");
        desk.wait(0.5);
        assert!(desk.bit(516) && desk.bit(1024), "{moves}");
        desk.controller.receive(desk.channel, b"\x18\x19");
        assert!(!desk.bit(516) && !desk.bit(1024), "{moves}");
        // Nothing of it is left for the next move.
        assert_eq!(desk.ask("SYNC OFF MASTER0 MASTER1"), "");
        assert_eq!(desk.ask("SRC CLOCK"), "");
        assert_eq!(desk.ask("X-3"), "");
        desk.wait(5.0);
        assert_eq!(desk.controller.view().position(0), -3.0, "{moves}");
    }
}

#[test]
fn ctrl_x_ends_plc_programs() {
    let mut desk = Desk::with("SYS\nDIM PLC0(400)\nPLC0\nPROGRAM\nLD NOT 128\nOUT 40\nENDP\nRUN\n");
    desk.wait(0.1);
    assert!(desk.bit(1536));
    desk.controller.receive(desk.channel, b"\x18");
    assert!(!desk.bit(1536));
}

#[test]
fn ctrl_y_clears_the_kill_flags() {
    let mut desk = running();
    desk.controller.receive(desk.channel, b"\x18\x19");
    assert!(!desk.bit(8467) && !desk.bit(8499) && !desk.bit(522));
    assert_eq!(desk.ask("X0"), "");
    assert!(desk.bit(516));
}

#[test]
fn ctrl_z_disables_the_drives_too() {
    let mut desk = running();
    desk.controller.receive(desk.channel, b"\x1a");
    assert!(!desk.bit(516) && !desk.bit(1024) && desk.bit(8467) && !desk.bit(8465) && !desk.bit(8497));
}

/// Both axes jog at 10 units/s and have gone 9.5 units; HLDEC takes another unit of X, and Y has none.
fn jogging() -> Desk {
    let mut desk = Desk::with(&format!("{TWO_AXES}JOG ACC X100 Y100\nJOG DEC X100 Y100\nJOG VEL X10 Y10\nHLDEC X50\n"));
    desk.send("PROG0\rDRIVE ON X Y : JOG FWD X Y\r");
    while desk.controller.view().position(0) < 9.4999 {
        desk.controller.step(1, &mut desk.log);
    }
    desk
}

#[test]
fn ctrl_x_and_ctrl_z_stop_jogs_with_hldec() {
    for (key, drives) in [(b"\x18", true), (b"\x1a", false)] {
        let mut desk = jogging();
        desk.controller.receive(desk.channel, key);
        assert!(desk.bit(8467) && desk.bit(8499) && desk.bit(522) && desk.bit(792) && !desk.bit(796));
        assert_eq!(desk.bit(8465), drives);
        desk.wait(0.5);
        let view = desk.controller.view();
        assert!((view.position(0) - 10.5).abs() < 1e-9 && (view.position(1) - 9.5).abs() < 1e-9);
        assert!(!desk.bit(792) && !desk.bit(824));
        assert_eq!(desk.ask("JOG FWD Y"), "Associated Slave Kill Motion Request Active\r\n");
    }
}

#[test]
fn ctrl_y_starts_nothing_and_lets_axes_jog_again() {
    let mut desk = jogging();
    desk.controller.receive(desk.channel, b"\x18");
    desk.wait(0.5);
    desk.controller.receive(desk.channel, b"\x19");
    desk.wait(0.5);
    assert!((desk.controller.view().position(0) - 10.5).abs() < 1e-9);
    assert_eq!(desk.ask("JOG INC X-1 Y1"), "");
    desk.wait(0.5);
    let view = desk.controller.view();
    assert!((view.position(0) - 9.5).abs() < 1e-9 && (view.position(1) - 10.5).abs() < 1e-9);
}

#[test]
fn they_are_no_part_of_the_line() {
    let mut desk = Desk::machine();
    assert_eq!(desk.send("?\x191\x182\r"), "?12\r\n12\r\nP00>");
    assert!(desk.bit(8467));
    assert_eq!(desk.send("\x19:AXIS0 PPU 5\r"), ":AXIS0 PPU 5\r\nP00>");
    assert!(!desk.bit(8467));
}

#[test]
fn ctrl_x_reaches_programs_while_the_channel_listens() {
    let mut desk = Desk::with("SYS\nDIM P(4)\nPROG0\nPROGRAM\n_again\nPRINT 1\nDWL 10\nGOTO again\nENDP\n");
    desk.send("LRUN PROG0\r");
    desk.controller.receive(desk.channel, b"\x18");
    assert_eq!(desk.wait(0.1), "SYS>");
}

#[test]
fn esc_is_harmless_at_a_prompt() {
    let mut desk = Desk::new();
    assert_eq!(desk.send("\x1b"), "");
    assert_eq!(desk.send("?1\x1b\r"), "?1\r\n1\r\nSYS>");
}
