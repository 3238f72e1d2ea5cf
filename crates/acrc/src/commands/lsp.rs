//! `acrc lsp`: serves an editor.

use anyhow::Context as _;

use crate::cli::LspArguments;
use crate::exit::Exit;
use crate::output::tell;

/// Serves one client until it leaves.
pub(crate) fn run(arguments: &LspArguments) -> anyhow::Result<Exit> {
    let ended_well = match arguments.port {
        Some(port) => acrc_lsp::run_tcp(port, |port| tell(|err| writeln!(err, "listening at 127.0.0.1:{port}"))),
        None => acrc_lsp::run_stdio(),
    };
    // The protocol wants 1 when `exit` comes without `shutdown`.
    Ok(if ended_well.context("the client can't be served")? { Exit::Clean } else { Exit::Findings })
}
