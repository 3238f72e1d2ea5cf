//! How a connection is made.

use std::time::Duration;

/// How a connection is made and how long is waited.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// For a connection.
    pub connect: Duration,
    /// For an answer, or for the next piece of one.
    pub answer: Duration,
    /// How often connecting is tried again.
    pub retries: u32,
    /// Whether the user has given up.
    pub interrupted: fn() -> bool,
}

impl Default for Settings {
    fn default() -> Self {
        let five = Duration::from_secs(5);
        Self { connect: five, answer: five, retries: 0, interrupted: || false }
    }
}
