//! Exit status and the message of a command that could not run.

use crate::output::{Terminal, tell};

/// How a subcommand ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// Done, and nothing to complain about.
    Clean,
    /// Done, with findings or run-time errors.
    Findings,
    /// Could not run.
    Failure,
    /// Ended by Ctrl-C.
    Interrupted,
}

impl Exit {
    /// The status for the shell.
    pub(crate) fn status(self) -> u8 {
        match self {
            Self::Clean => 0,
            Self::Findings => 1,
            Self::Failure => 2,
            Self::Interrupted => 130,
        }
    }
}

/// Says why a command could not run.
pub(crate) fn report(result: anyhow::Result<Exit>, terminal: Terminal) -> Exit {
    result.unwrap_or_else(|error| {
        say(&error, terminal);
        Exit::Failure
    })
}

/// Says what went wrong on standard error.
pub(crate) fn say(error: &anyhow::Error, terminal: Terminal) {
    tell(|err| writeln!(err, "{} {}", terminal.error_word("error:"), visible(&format!("{error:#}"))));
}

/// Says on standard error what is odd, and stops nothing.
pub(crate) fn warn(text: &str, terminal: Terminal) {
    tell(|err| writeln!(err, "{} {}", terminal.warning_word("warning:"), visible(text)));
}

/// Says on standard error what is good to know.
pub(crate) fn note(text: &str, terminal: Terminal) {
    tell(|err| writeln!(err, "{} {}", terminal.heading("note:"), visible(text)));
}

/// A message may quote a file name or a file: a terminal shall not act on it.
fn visible(text: &str) -> String {
    let is_obeyed = |c: char| c.is_control() && !matches!(c, '\n' | '\t');
    text.chars().map(|c| if is_obeyed(c) { char::REPLACEMENT_CHARACTER } else { c }).collect()
}
