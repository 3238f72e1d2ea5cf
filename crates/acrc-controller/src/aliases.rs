//! The alias table of a running controller (guide, "Aliases").
//!
//! Stored programs refer to entries by their place, so entries stay; what a name means to statements that are typed from now on is a table of
//! its own. A name that is defined again gets another entry, and programs that are stored already keep the meaning they were stored with.

use acrc_catalog::memory::{ALIASES, SystemBlock};
use acrc_catalog::{Model, check_alias_name};
use acrc_compile::{Scope, Tables};
use acrc_image::Alias;

use crate::error::ControllerError;
use crate::memory::SystemMemory;

/// The aliases of a controller.
#[derive(Clone, Debug, Default)]
pub(crate) struct Aliases {
    entries: Vec<Alias>,
    names: Tables,
}

impl Aliases {
    /// Those of an image.
    pub(crate) fn new(entries: &[Alias]) -> Self {
        let mut aliases = Self::default();
        for entry in entries {
            aliases.add(entry.clone());
        }
        aliases
    }

    /// Every entry, also those whose names mean something else by now.
    pub(crate) fn entries(&self) -> &[Alias] {
        &self.entries
    }

    /// The place of an alias, which is added when it is new, and is what its name means from now on. `None` when the table has no room.
    pub(crate) fn merge(&mut self, alias: &Alias) -> Option<u16> {
        let known = self.entries.iter().position(|entry| entry == alias).unwrap_or(self.entries.len());
        let place = u16::try_from(known).ok()?;
        if known < self.entries.len() {
            self.names.aliases.insert(alias.name.clone(), place);
        } else {
            self.add(alias.clone());
        }
        Some(place)
    }

    /// What the names mean.
    pub(crate) fn names(&self) -> &Tables {
        &self.names
    }

    /// The aliases that can be used, in the order of their definitions.
    pub(crate) fn known(&self) -> impl Iterator<Item = &Alias> {
        self.known_places().filter_map(|place| self.entries.get(usize::from(place)))
    }

    /// The places of the aliases that can be used, rising.
    pub(crate) fn known_places(&self) -> impl Iterator<Item = u16> {
        let entries = (0..).zip(&self.entries);
        entries.filter(|(place, alias)| self.names.alias(&alias.name) == Some(*place)).map(|(place, _)| place)
    }

    /// `#DEFINE` at a prompt or in a text that was entered: needs a name that an alias may have, and room in the table that `DIM DEF` gives.
    pub(crate) fn define(&mut self, alias: Alias, model: &Model, memory: &SystemMemory) -> Result<(), ControllerError> {
        check_alias_name(&alias.name, model)
            .map_err(|problem| ControllerError::AliasName { name: alias.name.clone(), problem })?;
        if let Some(place) = self.names.alias(&alias.name)
            && self.entries.get(usize::from(place)) == Some(&alias)
        {
            return Ok(());
        }
        let used = self.names.aliases.len() as u64 + u64::from(self.names.alias(&alias.name).is_none());
        let room = memory.size(SystemBlock::Aliases).unwrap_or(0);
        if ALIASES.bytes(used, 0) > u64::from(room) || self.entries.len() > usize::from(u16::MAX) {
            return Err(ControllerError::AliasTableFull { name: alias.name, room: SystemBlock::Aliases.size(room) });
        }
        self.add(alias);
        Ok(())
    }

    /// `CLEAR` at a system prompt: the names mean nothing any more.
    pub(crate) fn clear(&mut self) {
        self.names.aliases.clear();
    }

    fn add(&mut self, alias: Alias) {
        // The image format and `define` keep the table within 16 bits.
        let place = self.entries.len() as u16;
        self.names.aliases.insert(alias.name.clone(), place);
        self.entries.push(alias);
    }
}
