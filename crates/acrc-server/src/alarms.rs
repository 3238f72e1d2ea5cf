//! Alarms on their way from the controller to the management connections.

use acrc_wire::ethernet::ControllerAlarm;

/// Alarms that may wait for a client; of more it misses the oldest.
pub(crate) const WAITING: usize = 256;

/// An alarm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(dead_code, reason = "the controller raises no alarms yet")]
pub(crate) enum Alarm {
    /// Of a program: the value that it gave.
    User(u32),
    /// Of the controller.
    Controller(ControllerAlarm),
}
