//! The commands that the controller executes: one table from the catalogue's commands to what carries them out.
//!
//! A command that is in none of the tables is refused before a run starts ([`supported`]), never skipped.

mod arcs;
mod arguments;
mod attach;
mod axis;
mod buffer;
mod captures;
mod channel;
mod curves;
mod fast_status;
mod follow;
mod interrupts;
mod io;
mod jog;
mod kinematics;
mod ladder;
mod logic;
mod master_settings;
mod moves;
mod network;
mod nonvolatile;
mod path;
mod profile;
mod record;
mod reports;
mod settings;
mod stored;
mod system;
mod timebase;
mod typed;

use std::sync::LazyLock;

use acrc_catalog::{CommandId, all_commands};
use acrc_image::UnitName;
use acrc_syntax::units::Level;
use acrc_vm::{Call, Outcome};

use crate::controller::{Observer, Pace};
use crate::error::ControllerError;
use crate::footprint::{Footprint, Places};
use crate::machine::Machine;
use crate::plc::Ladder;
use crate::program::Alarm;
use crate::request::{Origin, Query, Request};
use crate::terminal::ChannelId;

pub(crate) use buffer::UNBUFFERED;
pub(crate) use curves::{CUBIC, Curve, LAST_KNOT, Line as CurveLine};
pub(crate) use io::deliver;
pub(crate) use kinematics::Kinematics;
pub(crate) use moves::moving_velocity;
pub(crate) use timebase::TimeBase;

/// What a command handler works on.
pub(crate) struct Context<'a> {
    pub(crate) machine: &'a mut Machine,
    /// The program that executes the command; `None` for setup code at the system prompt.
    pub(crate) program: Option<u8>,
    /// The rungs of the PLC program that executes the command.
    pub(crate) ladder: Option<&'a mut Ladder>,
    /// Tick at which the held command of this program goes on (`DWL`).
    pub(crate) release: &'a mut Option<u64>,
    /// When the held command of this program looks again by itself (`IHPOS`).
    pub(crate) alarm: &'a mut Alarm,
    pub(crate) observer: &'a mut dyn Observer,
    /// When the lines of the program are executed.
    pub(crate) pace: Pace,
    /// Moves that the move buffer of the program holds.
    pub(crate) moves: u32,
    /// What has been touched.
    pub(crate) footprint: Footprint,
    /// The command is typed or setup code, not part of a running program.
    pub(crate) immediate: bool,
    /// The channel at which it was typed.
    pub(crate) channel: Option<ChannelId>,
}

type Handler = fn(&mut Context, &Call) -> Result<Outcome, ControllerError>;

/// How a command is executed.
#[derive(Clone, Copy)]
enum Action {
    /// By a function.
    Run(Handler),
    /// It answers, whatever stands behind it.
    Answer(fn(&mut Context)),
    /// By a function that keeps the account of what it reads and changes ([`Footprint`]) itself.
    Precise(Handler),
    /// It only matters to the real controller (saving, communication): nothing to do in a dry run.
    Nothing,
}

/// One row of a table of commands.
type Entry = (CommandId, Action);

static TABLE: LazyLock<Vec<Option<Action>>> = LazyLock::new(|| {
    let tables = [
        attach::COMMANDS,
        axis::COMMANDS,
        buffer::COMMANDS,
        captures::COMMANDS,
        channel::COMMANDS,
        curves::COMMANDS,
        fast_status::COMMANDS,
        follow::COMMANDS,
        interrupts::COMMANDS,
        io::COMMANDS,
        jog::COMMANDS,
        kinematics::COMMANDS,
        ladder::COMMANDS,
        logic::COMMANDS,
        moves::COMMANDS,
        network::COMMANDS,
        nonvolatile::COMMANDS,
        path::COMMANDS,
        profile::COMMANDS,
        record::COMMANDS,
        reports::COMMANDS,
        settings::COMMANDS,
        stored::COMMANDS,
        system::COMMANDS,
        timebase::COMMANDS,
    ];
    let mut table = vec![None; 1024];
    for (command, action) in tables.into_iter().flatten() {
        let place = &mut table[usize::from(command.0)];
        debug_assert!(place.is_none(), "{} has two handlers", command.info().name);
        *place = Some(*action);
    }
    for info in all_commands() {
        let place = &mut table[usize::from(info.id.0)];
        *place = place.or_else(|| settings::action(info));
    }
    table
});

/// Whether this controller executes a command itself. Program flow, assignments and local variables are the VM's business.
pub(crate) fn supported(command: CommandId) -> bool {
    action(command).is_some()
}

fn action(command: CommandId) -> Option<Action> {
    TABLE.get(usize::from(command.0)).copied().flatten()
}

impl Context<'_> {
    /// Executes one command.
    pub(crate) fn execute(&mut self, call: &Call) -> Result<Outcome, ControllerError> {
        if self.channel.is_some() {
            typed::admit(call, self.machine.level)?;
        }
        let done = match action(call.command) {
            Some(Action::Run(handler)) => handler(self, call).inspect(|outcome| {
                if *outcome == Outcome::Again {
                    self.footprint.reads |= Places::MACHINE;
                } else {
                    self.footprint.write(Places::ALL);
                }
            }),
            Some(Action::Answer(answer)) => {
                answer(self);
                self.footprint.write(Places::ALL);
                Ok(Outcome::Done)
            }
            Some(Action::Precise(handler)) => handler(self, call),
            Some(Action::Nothing) => Ok(Outcome::Done),
            None => Err(ControllerError::NotSimulated(call.command)),
        };
        if self.channel.is_some() { done.map_err(|error| typed::refusal(call, error)) } else { done }
    }

    /// Asks the controller for an answer that its programs give.
    fn ask(&mut self, query: Query) {
        let origin = self.origin();
        self.machine.requests.push(Request::Report(query, origin));
    }

    /// Who gave the command.
    fn origin(&self) -> Origin {
        let level = match (self.unit(), self.immediate) {
            (_, true) | (UnitName::Boot, _) => self.machine.level,
            (UnitName::Program(number), false) => Level::Program(number),
            (UnitName::Plc(number), false) => Level::Plc(number),
        };
        Origin { level, channel: self.channel, immediate: self.immediate }
    }

    /// The text that executes the command.
    fn unit(&self) -> UnitName {
        match (&self.ladder, self.program) {
            (Some(ladder), _) => UnitName::Plc(ladder.number()),
            (None, Some(program)) => UnitName::Program(program),
            (None, None) => UnitName::Boot,
        }
    }

    /// The program, for commands that need one.
    fn program(&self, call: &Call) -> Result<u8, ControllerError> {
        self.program.ok_or_else(|| ControllerError::WrongLevel {
            command: call.command.info().name,
            level: self.machine.level.to_string(),
        })
    }
}
