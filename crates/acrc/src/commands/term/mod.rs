//! `acrc term`: the terminal of a controller.

mod editor;
mod pipe;
mod tail;

use std::io::IsTerminal as _;

use acrc_link::{LinkError, Protocol};

use super::link::{connect, failed, watch_interrupt};
use crate::cli::{ColorChoice, TermArguments};
use crate::exit::Exit;
use crate::output::Terminal;

pub(super) fn run(arguments: &TermArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let terminal = Terminal::error(color);
    watch_interrupt()?;
    let mut connection = match connect(&arguments.to, Protocol::Text) {
        Ok(connection) => connection,
        Err(error) => return Ok(failed(error, terminal)),
    };
    let result = if std::io::stdin().is_terminal() {
        editor::run(&mut connection, &arguments.to.to.to_string(), Terminal::output(color))
    } else {
        pipe::run(&mut connection, arguments.linger)
    };
    match result {
        Ok(()) => Ok(Exit::Clean),
        Err(error) => match error.downcast::<LinkError>() {
            Ok(error) => Ok(failed(error, terminal)),
            Err(error) => Err(error),
        },
    }
}
