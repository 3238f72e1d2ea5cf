//! Why something could not be done on a connection.

use std::io;
use std::time::Duration;

use thiserror::Error;

/// Why something could not be done on a connection.
#[derive(Debug, Error)]
pub enum LinkError {
    /// There is no connection to begin with.
    #[error("could not connect to {endpoint}: {reason}")]
    Connect {
        /// `HOST:PORT`
        endpoint: String,
        /// What the system says.
        reason: io::Error,
    },
    /// The connection is there, but nothing answers as a controller does.
    #[error("{endpoint} accepted the connection but shows no prompt: {what}")]
    NoPrompt {
        /// `HOST:PORT`
        endpoint: String,
        /// What came instead.
        what: String,
    },
    /// Packets are answered with text.
    #[error(
        "{endpoint} answers packets with text (at `{line}`), as a port for text does (5002): --text speaks text to it, and \
         packets go to the port that stands for 5006"
    )]
    TextOnly {
        /// `HOST:PORT`
        endpoint: String,
        /// What was asked for by a packet.
        line: String,
    },
    /// No complete answer came in time.
    #[error("timed out after {} s waiting for the answer to `{line}`", .after.as_secs_f64())]
    Timeout {
        /// The line that was sent, or what was asked for by a packet.
        line: String,
        /// How long was waited.
        after: Duration,
    },
    /// The controller ended the connection.
    #[error("the controller closed the connection while the answer to `{line}` was waited for")]
    Closed {
        /// The line that was sent, or what was asked for by a packet.
        line: String,
    },
    /// The connection broke.
    #[error("the connection broke at `{line}`: {reason}")]
    Broken {
        /// The line that was being sent or waited for.
        line: String,
        /// What the system says.
        reason: io::Error,
    },
    /// What comes has no end.
    #[error("the answer to `{line}` has no end: more than {bytes} bytes came without a prompt")]
    Endless {
        /// The line that was sent, or what was asked for by a packet.
        line: String,
        /// How much is read at most.
        bytes: usize,
    },
    /// The controller does not do what a line says.
    #[error("the controller refused `{line}`: {text}")]
    Refused {
        /// The line that was sent.
        line: String,
        /// The error text of the controller.
        text: String,
    },
    /// The answer has a form that is not known.
    #[error("the answer to `{line}` is not understood: {answer}")]
    NotUnderstood {
        /// The line that was sent, or what was asked for by a packet.
        line: String,
        /// What came, or a description of it.
        answer: String,
    },
    /// A line that cannot be sent as one line.
    #[error("`{line}` cannot be sent: {problem}")]
    NotSendable {
        /// The line.
        line: String,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// The user gave up.
    #[error("interrupted")]
    Interrupted,
}

impl LinkError {
    /// The connection cannot be used any more, as opposed to a controller that refuses.
    pub fn is_broken(&self) -> bool {
        !matches!(self, Self::Refused { .. } | Self::NotUnderstood { .. } | Self::NotSendable { .. })
    }
}
