//! A whole project in its stored form.

use acrc_catalog::command;

use crate::error::{ImageError, Problem};
use crate::node::Node;
use crate::unit::{Unit, UnitName};
use crate::verify;

/// The version of the file format that this crate writes.
pub const VERSION: u16 = 1;

/// An entry of the alias table (`#DEFINE`). Costs 48 bytes of system memory, and the table 16.
#[derive(Clone, Debug, PartialEq)]
pub struct Alias {
    /// Its name, case-sensitive.
    pub name: String,
    /// What it stands for: an expression without aliases in it.
    pub target: Node,
}

/// Immediate statements, stored programs and aliases of a project.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// The controller it was made for, as the catalogue names it.
    pub model: String,
    /// The alias table.
    pub aliases: Vec<Alias>,
    /// The immediate statements; [`crate::UnitName::Boot`].
    pub boot: Unit,
    /// The stored texts, in the order in which the boot unit installs them.
    pub programs: Vec<Unit>,
    /// Names of the source files, for the debug maps.
    pub files: Vec<String>,
    /// Version of the file format; [`VERSION`] in a new image.
    pub version: u16,
}

impl Image {
    /// An image in which nothing is.
    pub fn empty(model: &str) -> Self {
        Self {
            model: model.to_owned(),
            aliases: Vec::new(),
            boot: Unit { name: UnitName::Boot, words: Vec::new(), strings: Vec::new(), debug: None },
            programs: Vec::new(),
            files: Vec::new(),
            version: VERSION,
        }
    }

    /// The boot unit and the programs.
    pub fn units(&self) -> impl Iterator<Item = &Unit> {
        std::iter::once(&self.boot).chain(&self.programs)
    }

    /// Removes what leads back to the source: file names and debug maps.
    pub fn strip(&mut self) {
        self.files.clear();
        for unit in std::iter::once(&mut self.boot).chain(&mut self.programs) {
            unit.debug = None;
        }
    }

    /// Decodes every unit and checks what crosses units: aliases and the programs that the boot unit installs.
    pub fn verify(&self) -> Result<(), ImageError> {
        for alias in &self.aliases {
            if verify::greatest_alias(&alias.target).is_some() || !alias.target.is_expression() {
                return Err(ImageError::AliasTarget {
                    name: alias.name.clone(),
                    problem: Problem::Misplaced("an alias"),
                });
            }
        }
        self.verify_unit(&self.boot, true)?;
        self.programs.iter().try_for_each(|unit| self.verify_unit(unit, false))
    }

    fn verify_unit(&self, unit: &Unit, is_boot: bool) -> Result<(), ImageError> {
        let (aliases, programs) = (self.aliases.len(), self.programs.len());
        for instruction in unit.decode()? {
            let refuse = |problem| Err(ImageError::Word { unit: unit.name, address: instruction.address, problem });
            let greatest = instruction.items.iter().filter_map(|item| verify::greatest_alias(&item.node)).max();
            if let Some(index) = greatest.filter(|&index| usize::from(index) >= aliases) {
                return refuse(Problem::NoSuchAlias { index, aliases });
            }
            if is_boot && instruction.command == command::PROGRAM {
                match instruction.items.first().map(|item| &item.node) {
                    Some(&Node::Long(index)) if usize::try_from(index).is_ok_and(|index| index < programs) => {}
                    Some(&Node::Long(index)) => return refuse(Problem::NoSuchProgram { index, programs }),
                    _ => return refuse(Problem::Operands("PROGRAM carries the index of a text")),
                }
            }
        }
        Ok(())
    }
}
