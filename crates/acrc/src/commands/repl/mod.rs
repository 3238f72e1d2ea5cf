//! `acrc repl`: the terminal of a virtual controller.
//!
//! With a terminal, lines are edited here and sent when they are complete, and the channel neither echoes nor prompts. With a pipe the bytes go to
//! the channel and come back as they are.

mod complete;
mod editor;
mod pipe;
mod session;
mod watch;

use std::io::IsTerminal as _;

use anyhow::Context as _;

pub(super) use self::complete::Vocabulary;
pub(super) use self::editor::{ControllerPrompt, editor, is_shown};
use self::session::Session;
pub(super) use self::watch::{Pressed, RawMode, pressed};
use super::nonvolatile::State;
use super::virtual_controller::{Wanted, power_up};
use crate::cli::{ColorChoice, ReplArguments, Speed};
use crate::exit::Exit;
use crate::output::Terminal;

pub(super) fn run(arguments: &ReplArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let state = arguments.state.as_deref().map(State::open).transpose()?;
    let wanted = Wanted {
        project: arguments.project.as_deref(),
        model: arguments.model,
        world: arguments.world.as_deref(),
        battery: !arguments.no_battery,
        seed: arguments.seed,
        user_alarm: None,
        rapid_move_modes: None,
    };
    let Some((name, mut controller)) = power_up(&wanted, state.as_ref(), color)? else { return Ok(Exit::Findings) };
    let first = || controller.model().streams.first().and_then(|name| name.parse().ok());
    let stream = arguments.stream.or_else(first).context("this model has no communication stream")?;
    let channel = controller.open_channel(stream)?;

    let interactive = std::io::stdin().is_terminal();
    let speed = arguments.speed.unwrap_or(if interactive { Speed::Factor(1.0) } else { Speed::Max });
    let mut session = Session::new(controller, (channel, stream), speed, state, Terminal::error(color));
    session.power_up();
    if interactive {
        editor::run(&mut session, &name, Terminal::output(color))?;
    } else {
        pipe::run(&mut session, arguments.linger)?;
    }
    session.power_off()?;
    Ok(Exit::Clean)
}
