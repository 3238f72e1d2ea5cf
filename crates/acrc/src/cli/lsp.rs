//! The arguments of `acrc lsp`.

use clap::Args;

/// `acrc lsp`
#[derive(Args, Debug)]
#[command(
    after_help = "An editor starts this and talks the language server protocol over standard input and output;\n\
                        docs/lsp.md says how to set up yours.\n\
                        Exit status: 0 ended by the client, 1 the client went away, 2 could not run."
)]
pub(crate) struct LspArguments {
    /// Wait for one client at this port of the computer instead, for debugging; 0 is any free port
    #[arg(long, value_name = "PORT")]
    pub(crate) port: Option<u16>,
    /// Talk over standard input and output, which is the default; some editors say it
    #[arg(long, conflicts_with = "port")]
    pub(crate) stdio: bool,
}
