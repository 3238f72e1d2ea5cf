//! Alarms on their way from the controller to the management connections.

use acrc_controller::HostAlarm;
use acrc_wire::ethernet::ControllerAlarm;

/// Alarms that may wait for a client; of more it misses the oldest.
pub(crate) const WAITING: usize = 256;

/// An alarm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Alarm {
    /// Of a program: the value that it gave.
    User(u32),
    /// Of the controller.
    Controller(ControllerAlarm),
}

impl From<HostAlarm> for Alarm {
    fn from(alarm: HostAlarm) -> Self {
        match alarm {
            HostAlarm::User { value } => Self::User(value),
            HostAlarm::Controller { kind, object, count } => {
                Self::Controller(ControllerAlarm { code: kind.code(), object, count })
            }
        }
    }
}
