//! Pages of commands, keywords and objects.

use super::{Sheet, numbers};
use crate::{Argument, Command, CommandId, Keyword, ObjectKind, all_commands};

pub(super) fn command(command: &Command) -> Sheet {
    let arguments: Vec<[&str; 5]> = command.arguments.iter().map(cells).collect();
    Sheet::new(command.name, &what(command))
        .summary(command.summary)
        .code("form", command.signature)
        .table(["argument", "kind", "unit", "range", "default"], &arguments)
        .fact("levels", levels(command))
        .fact("reports", command.report)
        .fact("kept in", numbers::set_by(command.id))
        .list("prefixes", prefixes(command).iter().map(String::as_str))
        .list("daughters", command.daughters.iter().map(|daughter| daughter.info().word))
        .list("see also", related(command))
        .fact("models", command.models)
        .fact("note", command.note)
        .origin(command.source, command.confidence)
}

fn cells(argument: &Argument) -> [&str; 5] {
    [argument.name, argument.kind, argument.unit, argument.range, argument.default]
}

fn what(command: &Command) -> String {
    let what = match (command.clause, command.daughter_required) {
        (true, _) => "part of a statement",
        (false, true) => "command with daughters",
        (false, false) => "command",
    };
    format!("{what}, {}", command.group)
}

fn levels(command: &Command) -> String {
    let names = [(command.levels.sys(), "system"), (command.levels.prog(), "program"), (command.levels.plc(), "PLC")];
    let names: Vec<&str> = names.into_iter().filter(|(accepted, _)| *accepted).map(|(_, name)| name).collect();
    if names.is_empty() { "none: it never reaches the controller".to_owned() } else { names.join(", ") }
}

fn prefixes(command: &Command) -> Vec<String> {
    command.prefixes.iter().map(|kind| format!("{kind}n")).collect()
}

fn related(command: &Command) -> impl Iterator<Item = &'static str> {
    let ids: Vec<CommandId> = command.belongs_to.iter().chain(&command.parent).chain(command.parts).copied().collect();
    ids.into_iter().map(|id| id.info().name)
}

pub(super) fn keyword(keyword: Keyword) -> Sheet {
    let written = |command: &Command| {
        command.signature.split_whitespace().any(|word| word.trim_matches(['{', '}']) == keyword.name())
    };
    let uses = all_commands().filter(|command| !command.clause && command.name != keyword.name() && written(command));
    Sheet::new(keyword.name(), "part of a statement").list("in", uses.map(|command| command.name))
}

pub(super) fn object(kind: ObjectKind) -> Sheet {
    let written = format!("{kind}n");
    let uses = all_commands().filter(|command| command.signature.contains(&written));
    Sheet::new(&written, "numbered object").list("in", uses.map(|command| command.name))
}
