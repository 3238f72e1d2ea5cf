//! `acrc state`: what the controller of `acrc sim --state` keeps without power.

use acrc_controller::nonvolatile::{Memory, Saved, SystemParameters};
use acrc_image::UnitName;
use acrc_store::Store;
use anyhow::{Context as _, bail};

use crate::cli::{StateAction, StateArguments};
use crate::exit::Exit;
use crate::output::print;

pub(super) fn run(arguments: &StateArguments) -> anyhow::Result<Exit> {
    if !arguments.folder.is_dir() {
        bail!("{} is no folder", arguments.folder.display());
    }
    let mut store = Store::open(&arguments.folder).context("the state cannot be used")?;
    match arguments.action {
        StateAction::Reset => store.reset().context("the state was not forgotten")?,
        StateAction::Show => {
            let saved = store.load().context("the state cannot be used")?;
            let text = saved.as_ref().map_or_else(|| "nothing was saved yet\n".to_owned(), describe);
            print(|out| out.write_all(text.as_bytes()))?;
        }
    }
    Ok(Exit::Clean)
}

/// What a controller has when it is switched on, a line each.
fn describe(saved: &Saved) -> String {
    let rows = [
        ("model", saved.model.clone()),
        ("battery-backed memory", saved.memory.as_ref().map_or_else(|| "lost: factory settings".to_owned(), memory)),
        ("retained parameters", saved.retained.len().to_string()),
        ("system parameters", saved.parameters.as_ref().map_or_else(|| "not saved".to_owned(), parameters)),
        ("image in flash memory", image(saved)),
    ];
    rows.map(|(what, text)| format!("{what:<22} {text}\n")).concat()
}

fn memory(memory: &Memory) -> String {
    let bytes: u64 = memory.blocks.iter().map(|(_, bytes)| u64::from(*bytes)).sum();
    let compiled = memory.programs.iter().map(|unit| unit.name);
    let mut programs: Vec<UnitName> = compiled.chain(memory.typed.iter().map(|text| text.name)).collect();
    programs.sort_unstable();
    let programs: Vec<String> = programs.iter().map(ToString::to_string).collect();
    let programs = if programs.is_empty() { "no program".to_owned() } else { programs.join(" ") };
    let user = counted(memory.user.len(), "user parameter", "user parameters");
    let aliases = counted(memory.aliases.len(), "alias", "aliases");
    format!("{programs}; {user}, {aliases}; {bytes} bytes given out")
}

fn parameters(saved: &SystemParameters) -> String {
    let axes: usize = saved.masters.iter().map(|master| master.slaves.len()).sum();
    let masters = saved.masters.iter().filter(|master| master.program.is_some()).count();
    let masters = counted(masters, "master", "masters");
    let axes = counted(axes, "axis", "axes");
    format!("saved; {masters} and {axes} attached, {}", counted(saved.settings.len(), "setting", "settings"))
}

fn image(saved: &Saved) -> String {
    let Some(image) = &saved.image else { return "none".to_owned() };
    let state = if image.in_use { "loaded at power-up" } else { "not loaded at power-up" };
    format!("{state}; {}", memory(&image.memory))
}

fn counted(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}
