//! The arguments of `acrc term`.

use std::time::Duration;

use clap::Args;

use super::link::{ToArguments, parse_wait};

/// `acrc term`
#[derive(Args, Debug)]
#[command(
    after_help = "Lines are edited here and sent when they are complete. What LRUN and LISTEN show appears as it comes.\n\n\
                        Keys: Tab completes, Up and Ctrl-R find earlier lines, Ctrl-C or Ctrl-D quits.\n\
                        The controller has ESC (leaves LRUN and LISTEN), Ctrl-X (ends all programs and kills all motion),\n\
                        Ctrl-Y (clears the kill flags) and Ctrl-Z (Ctrl-X, and all drives off); these act at once.\n\
                        Quitting stops nothing: programs and motion go on.\n\n\
                        With standard input from a pipe or a file, standard output gets exactly the bytes of the\n\
                        controller. A line is sent when the one before it is answered, or nothing came for 0.2 s.\n\n\
                        Examples:\n  \
                        acrc term --to 192.168.10.40\n  \
                        printf 'PROG0\\rATTACH\\r' | acrc term --to 192.168.10.40\n\n\
                        Exit status: 0 the session ended, 2 the connection failed, 130 a pipe was interrupted."
)]
pub(crate) struct TermArguments {
    #[command(flatten)]
    pub(crate) to: ToArguments,
    /// A session from a pipe ends when the input is over and nothing came for so long
    #[arg(long, value_name = "TIME", default_value = "1s", value_parser = parse_wait)]
    pub(crate) linger: Duration,
}
