//! `acrc`: the command line. One file a subcommand; the work is done in the libraries.
//!
//! Exit status of every subcommand: 0 done and clean, 1 findings or run-time errors, 2 could not run, 130 interrupted.

mod cli;
mod commands;
mod exit;
mod output;

use std::process::ExitCode;

use clap::Parser;
use clap::error::{ContextKind, ErrorKind};

use crate::exit::Exit;

/// A check allocates many small things that live until the end, from several threads: with this allocator it takes little
/// more than half the time. Without huge pages, which the kernel has to clear and to find first (feature `no_thp`).
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    // A usage error ends here with status 2, `--help` and `--version` with 0.
    let arguments = cli::Arguments::try_parse().unwrap_or_else(|mut error| {
        if error.kind() == ErrorKind::ArgumentConflict {
            // It would show one of the two as if it were needed.
            error.remove(ContextKind::Usage);
        }
        error.exit()
    });
    let result = commands::run(&arguments);
    exit::report(result, output::Terminal::error(arguments.color)).into()
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit.status())
    }
}
