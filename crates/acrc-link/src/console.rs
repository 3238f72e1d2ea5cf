//! A command line of a controller.

use std::time::Duration;

use crate::{Answer, LinkError};

/// A command line of a controller: one channel with its own prompt level.
pub trait Console {
    /// Sends a line and waits until the controller has answered and shows its prompt.
    ///
    /// The controller refusing the line is no error here: [`Answer::refusal`], [`Answer::silence`] and
    /// [`Answer::number`] say what the answer means.
    ///
    /// # Errors
    /// When no complete answer comes. What the controller made of the line is unknown then.
    fn command(&mut self, line: &str) -> Result<Answer, LinkError>;

    /// The same for a line that the controller takes longer for, such as one that writes to flash memory.
    ///
    /// # Errors
    /// As [`Console::command`].
    fn command_within(&mut self, line: &str, patience: Duration) -> Result<Answer, LinkError>;

    /// Sends a character that acts at once (Ctrl-X, Ctrl-Y, Ctrl-Z, ESC) and does not wait for an answer. What it makes the
    /// controller send is not part of the next answer.
    ///
    /// # Errors
    /// When it cannot be sent.
    fn send_key(&mut self, key: u8) -> Result<(), LinkError>;
}
