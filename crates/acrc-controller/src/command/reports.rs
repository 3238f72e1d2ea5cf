//! Commands that report on the controller as a whole. The layouts are not documented, but for `ATTACH`: they repeat the form of the command that
//! would make what they report.

use acrc_catalog::{Command, Levels, all_commands, command, law, word};
use acrc_syntax::units::Level;
use acrc_vm::{Arg, Call, Outcome, Value};

use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::request::Query;

pub(super) const COMMANDS: &[Entry] = &[
    (command::ATTACH, Action::Answer(attachments)),
    (command::CONFIG, Action::Run(config)),
    (command::CONFIG_CLEAR, Action::Answer(config_clear)),
    (command::DIM, Action::Answer(dimensions)),
    (command::MEM, Action::Answer(free_memory)),
    (command::DEF, Action::Answer(aliases)),
    (command::HELP, Action::Answer(help)),
    (command::VER, Action::Answer(version)),
    (command::CPU, Action::Answer(load)),
    (command::DIAG, Action::Answer(diagnosis)),
    (command::IP, Action::Run(network)),
    (command::IP_MASK, Action::Run(network)),
    (command::IP_GATE, Action::Run(network)),
];

/// Hardware with factory settings.
const FACTORY_CONFIG: &str = "ENC8 DAC4 DAC4 ADC8";
/// Commands on a line of `HELP`.
const HELP_COLUMNS: usize = 6;
/// Characters of each of its columns.
const HELP_WIDTH: usize = 13;

/// At a program prompt the master and its slaves, at the system prompt what each axis uses.
fn attachments(context: &mut Context) {
    let lines = match context.program {
        Some(program) => program_attachments(context.machine, program),
        None => axis_attachments(context.machine),
    };
    context.report_lines(&lines);
}

fn program_attachments(machine: &Machine, program: u8) -> Vec<String> {
    let Some(attachment) = machine.attachments.get(usize::from(program)) else { return Vec::new() };
    let Some(master) = attachment.master else { return Vec::new() };
    let mut lines = vec![format!("ATTACH MASTER{master}")];
    for (slot, axis) in machine.masters[usize::from(master)].attached() {
        let name = attachment.names.get(slot).copied().flatten().map_or_else(String::new, |name| name.to_string());
        lines.push(format!("ATTACH SLAVE{slot} AXIS{axis} \"{name}\""));
    }
    lines
}

fn axis_attachments(machine: &Machine) -> Vec<String> {
    let axes = machine.axes.iter().enumerate();
    axes.map(|(number, axis)| match &axis.signals {
        Some(signals) => format!("ATTACH AXIS{number} {signals}"),
        None => format!("ATTACH AXIS{number} ENC{number} DAC{number} ENC{number}"),
    })
    .collect()
}

fn config(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    if call.arguments.is_empty() {
        let line = format!("{command} {}", context.machine.hardware());
        context.report_text(&line);
        return Ok(Outcome::Done);
    }
    let words: Option<Vec<String>> = call.arguments.iter().map(hardware_word).collect();
    let words = words.ok_or(ControllerError::Expected { command, expected: "the hardware: ENC8 DAC4 DAC4 ADC8" })?;
    context.machine.config = Some(words.join(" "));
    Ok(Outcome::Done)
}

/// A word of `CONFIG`: an object with its number, or a word such as `NONE`.
pub(super) fn hardware_word(argument: &Arg) -> Option<String> {
    let (word, index) = match argument {
        Arg::Object { kind, index, .. } => (kind.name(), *index),
        Arg::Word { keyword, index } => (keyword.name(), *index),
        _ => return None,
    };
    Some(index.map_or_else(|| word.to_owned(), |index| format!("{word}{index}")))
}

fn config_clear(context: &mut Context) {
    context.machine.config = None;
}

fn dimensions(context: &mut Context) {
    context.ask(Query::Dimensions(command::DIM));
}

fn free_memory(context: &mut Context) {
    context.ask(Query::FreeMemory);
}

fn aliases(context: &mut Context) {
    context.ask(Query::Aliases);
}

/// The commands of the present prompt.
fn help(context: &mut Context) {
    let at: fn(Levels) -> bool = match context.origin().level {
        Level::System => Levels::sys,
        // A program prompt takes the commands of the system too.
        Level::Program(_) => |levels| levels.prog() || levels.sys(),
        Level::Plc(_) => Levels::plc,
    };
    // Labels, assignments and moves have no word of their own.
    let begins = |row: &&Command| word(row.name).is_some_and(|word| word.command == Some(row.id));
    let words = all_commands().filter(|row| at(row.levels) && row.parent.is_none() && !row.clause).filter(begins);
    let mut names: Vec<&str> = words.map(|row| row.name).collect();
    names.sort_unstable();
    let line = |names: &[&str]| {
        let columns: Vec<String> = names.iter().map(|name| format!("{name:<HELP_WIDTH$}")).collect();
        columns.concat().trim_end().to_owned()
    };
    let lines: Vec<String> = names.chunks(HELP_COLUMNS).map(line).collect();
    context.report_lines(&lines);
}

fn version(context: &mut Context) {
    let line = context.machine.version();
    context.report_text(&line);
}

impl Machine {
    /// What `VER` answers.
    pub(crate) fn version(&self) -> String {
        format!("{} virtual controller, acrc {}", self.model.name, env!("CARGO_PKG_VERSION"))
    }

    /// The hardware of `CONFIG`.
    pub(crate) fn hardware(&self) -> &str {
        self.config.as_deref().unwrap_or(FACTORY_CONFIG)
    }
}

/// A virtual controller always has the time that it needs.
fn load(context: &mut Context) {
    context.report_text("FOREGROUND 0 %");
    context.report_text("BACKGROUND 0 %");
    let period = acrc_vm::format::number(&Value::Double(context.machine.clock.period()));
    context.report_text(&format!("PERIOD {period}"));
}

/// What keeps the machine from moving.
fn diagnosis(context: &mut Context) {
    let machine = &*context.machine;
    let mut lines = Vec::new();
    for axis in
        (0..machine.model.axes).filter(|axis| machine.flags.get(law::KILL_ALL_MOTION_REQUEST.at(u32::from(*axis))))
    {
        lines.push(format!("AXIS{axis} KILL ALL MOTION REQUEST"));
    }
    let masters = 0..u32::from(machine.model.masters);
    for master in masters.filter(|master| law::KILL_ALL_MOVES.get(*master).is_some_and(|bit| machine.flags.get(bit))) {
        lines.push(format!("MASTER{master} KILL ALL MOVES"));
    }
    if lines.is_empty() {
        lines.push("NO FAULTS".to_owned());
    }
    context.report_lines(&lines);
}

/// `IP` reports address, mask and gateway, or changes one of them.
fn network(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let network = &mut context.machine.network;
    let place = match call.command {
        command::IP_MASK => &mut network.mask,
        command::IP_GATE => &mut network.gateway,
        _ => &mut network.address,
    };
    match call.arguments {
        [] if call.command == command::IP => {
            let network = network.clone();
            context.report_lines(&[network.address, network.mask, network.gateway]);
        }
        [] => {
            let text = place.clone();
            context.report_text(&text);
        }
        [Arg::Value(Value::Text(text), _)] if text.to_string().parse::<std::net::Ipv4Addr>().is_ok() => {
            *place = text.to_string();
        }
        _ => {
            let command = call.command.info().name;
            return Err(ControllerError::Expected { command, expected: "an address in quotes: \"192.168.10.40\"" });
        }
    }
    Ok(Outcome::Done)
}

impl Context<'_> {
    /// Lines that answer a command.
    fn report_lines(&mut self, lines: &[String]) {
        for line in lines {
            self.report_text(line);
        }
    }
}
