//! Whether a controller has what a project says.

use std::collections::BTreeMap;

use acrc_catalog::Model;
use acrc_image::Alias;
use acrc_syntax::units::Level;

use super::immediate::Special;
use super::listing::Names;
use super::plan::{Plan, numbers_flag};
use super::script::{Kind, Script};
use super::send::{Cause, Event, Failure, Sender, Watcher};
use super::state::{Fate, State};
use super::survey::{self, Listed, list_program, numbers_lines};
use crate::Console;

/// Compares the programs, the memory and the aliases of a controller with a project.
///
/// # Errors
/// The first difference, or that the controller does not answer.
pub fn verify(
    console: &mut dyn Console,
    script: &Script,
    watcher: &mut dyn Watcher,
    model: &Model,
    state: State,
) -> Result<State, Box<Failure>> {
    let mut sender = Sender { console, watcher, state, model, script, step: None };
    let result = survey::begin(sender.console).map_err(Cause::from).and_then(|()| sender.verify(None));
    match result {
        Ok(()) => Ok(sender.state),
        Err(cause) => Err(Box::new(Failure { cause, step: None, state: sender.state, tidied: None })),
    }
}

impl Sender<'_> {
    /// Lists every program of the project and compares it; then memory and aliases, as far as their reports are understood.
    pub(super) fn verify(&mut self, plan: Option<&Plan>) -> Result<(), Cause> {
        let numbered = numbers_lines(self.console)?;
        if numbered {
            self.quietly(&format!("CLR {}", numbers_flag()))?;
        }
        let names = Names::new(&self.script.image.aliases, &[]);
        let script = self.script;
        for unit in script.units() {
            if self.watcher.interrupted() {
                return Err(Cause::Interrupted);
            }
            self.watcher.event(Event::Verifying(unit.name));
            match list_program(self.console, unit.name)? {
                Listed::Text(listing) => {
                    listing.compare(unit, &names).map_err(|difference| Cause::Different(unit.name, difference))?;
                }
                Listed::Protected(text) => return Err(Cause::Refused(text)),
                Listed::Missing => return Err(Cause::Refused(format!("it has no {}", unit.name))),
            }
            self.state.set(unit.name, Fate::Verified);
        }
        self.switch(Level::System)?;
        if numbered {
            self.quietly(&format!("SET {}", numbers_flag()))?;
        }
        if plan.is_some_and(|plan| plan.whole) {
            self.verify_memory()?;
        }
        self.verify_aliases()
    }

    fn verify_memory(&mut self) -> Result<(), Cause> {
        let Some(found) = survey::dimensions(&self.ask("DIM", false)?.lines) else {
            self.watcher.event(Event::Note("what DIM reports is not understood, so memory was not compared"));
            return Ok(());
        };
        let mut expected = BTreeMap::new();
        for line in &self.script.lines {
            if let Kind::Immediate(traits) = &line.kind {
                match traits.special {
                    Some(Special::Clear) => expected.clear(),
                    Some(Special::Dim(Some((block, size)))) => _ = expected.insert(block, size),
                    _ => {}
                }
            }
        }
        for (block, size) in expected {
            if found.get(&block) != Some(&size) {
                let found = found.get(&block).map_or("nothing".to_owned(), ToString::to_string);
                return Err(Cause::Unequal { what: format!("DIM {block}"), expected: size.to_string(), found });
            }
        }
        Ok(())
    }

    fn verify_aliases(&mut self) -> Result<(), Cause> {
        let script = self.script;
        if script.image.aliases.is_empty() {
            return Ok(());
        }
        let lines = self.ask("DEF", false)?.lines;
        let Some(found) = survey::definitions(&lines) else {
            self.watcher.event(Event::Note("what DEF reports is not understood, so aliases were not compared"));
            return Ok(());
        };
        for alias in &script.image.aliases {
            let same_name = |other: &&Alias| other.name == alias.name;
            let other = found.iter().find(same_name);
            if other != Some(alias) {
                let what = format!("the alias {}", alias.name);
                let found = if other.is_some() { "another operand" } else { "nothing" };
                return Err(Cause::Unequal { what, expected: "its operand".to_owned(), found: found.to_owned() });
            }
        }
        Ok(())
    }
}
