//! The commands, by group.

use std::fmt::Write as _;

use acrc_catalog::{Command, all_commands};

use super::{cell, heading};

pub(super) fn page() -> String {
    let mut page = heading("Commands", "`crates/acrc-catalog/data/commands`");
    page.push_str("`{}` is optional, `|` a choice, `...` a repetition. Confidence says how well a row is attested.\n");
    let mut groups: Vec<&str> = Vec::new();
    for command in all_commands() {
        if !groups.contains(&command.group) {
            groups.push(command.group);
        }
    }
    for group in groups {
        let _ =
            writeln!(page, "\n## {group}\n\n| Command | Form | Meaning | Levels | Confidence |\n|---|---|---|---|---|");
        for command in all_commands().filter(|command| command.group == group) {
            row(&mut page, command);
        }
    }
    page
}

fn row(page: &mut String, command: &Command) {
    let levels = [(command.levels.sys(), "sys"), (command.levels.prog(), "prog"), (command.levels.plc(), "plc")];
    let levels: Vec<&str> = levels.into_iter().filter(|(has, _)| *has).map(|(_, name)| name).collect();
    let _ = writeln!(
        page,
        "| {} | `{}` | {} | {} | {} |",
        cell(command.name),
        cell(command.signature),
        cell(command.summary),
        levels.join(" "),
        command.confidence.label()
    );
}
