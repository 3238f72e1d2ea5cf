//! Alarms of the controller itself (Ethernet specification, "Alarms to Clients").

/// An alarm of the controller's firmware.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ControllerAlarm {
    /// Its code.
    pub code: u32,
    /// Which object of the controller caused it.
    pub object: u32,
    /// How often it has occurred.
    pub count: u32,
}

impl ControllerAlarm {
    /// Whether a client with this filter gets it.
    pub const fn passes(&self, filter: u32) -> bool {
        super::management::passes(self.code, filter)
    }
}
