//! Exit status and the message of a command that could not run.

use std::io::{self, Write as _};

use crate::output::Terminal;

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

/// Says why a command could not run. A reader that went away (`acrc lint | head`) is no error.
pub(crate) fn report(result: anyhow::Result<Exit>, terminal: Terminal) -> Exit {
    let error = match result {
        Ok(exit) => return exit,
        Err(error) => error,
    };
    let broken_pipe = |cause: &(dyn std::error::Error + 'static)| {
        cause.downcast_ref::<io::Error>().is_some_and(|error| error.kind() == io::ErrorKind::BrokenPipe)
    };
    if error.chain().any(broken_pipe) {
        return Exit::Clean;
    }
    say(&error, terminal);
    Exit::Failure
}

/// Says what went wrong on standard error.
pub(crate) fn say(error: &anyhow::Error, terminal: Terminal) {
    let mut stderr = io::stderr().lock();
    // Nothing is left to tell it to when standard error is gone too.
    let _ = writeln!(stderr, "{} {error:#}", terminal.error_word("error:"));
}
