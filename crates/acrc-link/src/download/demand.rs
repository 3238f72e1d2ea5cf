//! What a project needs of the controller as a whole, and what of it is there already.

use std::collections::{BTreeMap, BTreeSet};

use acrc_catalog::memory::SystemBlock;
use acrc_image::{Alias, Unit, UnitName};
use acrc_syntax::units::Level;

use super::immediate::{Detached, Special};
use super::listing::Names;
use super::script::{Kind, Script};
use super::survey::Survey;

/// What a project says of the memory and the programs of the whole controller, in the order in which it says it.
#[derive(Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "independent things that a project says or not")]
pub(super) struct Demand {
    /// `CLEAR` at the system prompt.
    clears: bool,
    /// What it dimensions; `None` when a size is computed or a block is dimensioned twice.
    pub(super) memory: Option<BTreeMap<SystemBlock, u64>>,
    dims: bool,
    /// `NEW ALL`
    pub(super) erases_all: bool,
    /// It erases all programs before it clears or dimensions.
    pub(super) erases_first: bool,
    /// It clears before it dimensions.
    pub(super) clears_first: bool,
    /// The programs that it attaches something to without detaching before.
    pub(super) attaches: BTreeSet<Level>,
    /// The programs that it gives variables to without clearing them before.
    pub(super) dims_locals: BTreeSet<Level>,
    /// The last line of each text.
    pub(super) ends: BTreeMap<UnitName, usize>,
}

impl Demand {
    pub(super) fn of(script: &Script) -> Self {
        let mut demand = Self { memory: Some(BTreeMap::new()), ..Self::default() };
        let (mut detached, mut cleared) = (BTreeSet::new(), BTreeSet::new());
        let mut all_detached = false;
        for (index, line) in script.lines.iter().enumerate() {
            if let Some(unit) = line.unit() {
                demand.ends.insert(unit, index);
            }
            let Kind::Immediate(traits) = &line.kind else { continue };
            demand.special(traits.special.as_ref());
            match traits.detaches {
                Some(Detached::All) => all_detached = true,
                Some(Detached::Program) => _ = detached.insert(line.level),
                None if traits.attaches && !all_detached && !detached.contains(&line.level) => {
                    demand.attaches.insert(line.level);
                }
                None => {}
            }
            if traits.clears_locals {
                cleared.insert(line.level);
            }
            if traits.dims_locals && !cleared.contains(&line.level) {
                demand.dims_locals.insert(line.level);
            }
        }
        demand
    }

    fn special(&mut self, special: Option<&Special>) {
        match special {
            Some(Special::EraseAll) => {
                self.erases_all = true;
                self.erases_first |= !self.clears && !self.dims;
            }
            Some(Special::Clear) => {
                self.clears = true;
                self.clears_first |= !self.dims;
                // What was given before is gone.
                self.memory = Some(BTreeMap::new());
            }
            Some(Special::Dim(block)) => {
                self.dims = true;
                let new = block.filter(|(block, size)| {
                    self.memory.as_mut().is_some_and(|memory| memory.insert(*block, *size).is_none())
                });
                if new.is_none() {
                    self.memory = None;
                }
            }
            _ => {}
        }
    }

    pub(super) fn shares_memory(&self) -> bool {
        self.clears || self.dims
    }

    /// Whether the controller has the memory, no other programs and no other aliases.
    pub(super) fn is_met_by(&self, script: &Script, survey: &Survey) -> bool {
        let own = |unit: &UnitName| script.unit(*unit).is_some();
        let known = |alias: &Alias| script.image.aliases.contains(alias);
        survey.protected.is_none()
            && self.memory.is_some()
            && survey.memory == self.memory
            && survey.programs.keys().all(own)
            && survey.aliases.as_ref().is_some_and(|aliases| aliases.iter().all(known))
    }
}

/// The programs that the controller has as the project has them, with the same meaning of their names.
pub(super) fn kept(script: &Script, survey: &Survey) -> Vec<UnitName> {
    let names = Names::new(&script.image.aliases, survey.aliases.as_deref().unwrap_or_default());
    let same = |unit: &&Unit| {
        let listing = survey.programs.get(&unit.name);
        listing.is_some_and(|listing| listing.compare(unit, &names).is_ok()) && means_the_same(unit, script, survey)
    };
    script.units().filter(same).map(|unit| unit.name).collect()
}

fn means_the_same(unit: &Unit, script: &Script, survey: &Survey) -> bool {
    let places = unit.aliases().unwrap_or_default();
    places.into_iter().all(|place| {
        let alias = script.image.aliases.get(usize::from(place));
        alias.zip(survey.aliases.as_ref()).is_some_and(|(alias, known)| known.contains(alias))
    })
}
