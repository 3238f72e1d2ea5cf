//! Which texts of an image a run may execute: the setup code, the programs that are started, and those that one of them starts.
//!
//! A start that stands in the text counts, whether the run gets there or not. Flags and programs whose numbers are computed are not followed.

use std::collections::BTreeSet;

use acrc_catalog::{Keyword, ObjectKind, OperandClass, command, law};
use acrc_image::{Image, Instruction, Node, Unit, UnitName};

use super::boots;

/// The stored texts that may be executed when these are started, in the order of the image.
pub(super) fn reached(image: &Image, first: impl IntoIterator<Item = UnitName>) -> Vec<&Unit> {
    let mut search = Search { image, found: first.into_iter().collect(), looked_at: BTreeSet::new() };
    search.look_into(&image.boot);
    while let Some(unit) = search.next() {
        search.look_into(unit);
    }
    image.programs.iter().filter(|unit| search.found.contains(&unit.name)).collect()
}

struct Search<'i> {
    image: &'i Image,
    found: BTreeSet<UnitName>,
    looked_at: BTreeSet<UnitName>,
}

impl<'i> Search<'i> {
    /// A text that was found and not looked into.
    fn next(&mut self) -> Option<&'i Unit> {
        let Self { image, found, looked_at } = self;
        image.programs.iter().find(|unit| found.contains(&unit.name) && looked_at.insert(unit.name))
    }

    /// Finds what a text starts.
    fn look_into(&mut self, unit: &Unit) {
        // The text whose prompt the setup code is at.
        let mut level = Some(unit.name).filter(|name| *name != UnitName::Boot);
        for instruction in unit.decode().unwrap_or_default() {
            let number = || match instruction.items.first().map(|item| &item.node) {
                Some(Node::Long(number)) => u8::try_from(*number).ok(),
                _ => None,
            };
            match instruction.command {
                command::SYS => level = None,
                command::PROG => level = number().map(UnitName::Program),
                command::PLC => level = number().map(UnitName::Plc),
                command::RUN | command::LRUN => self.run(&instruction, level),
                command::PBOOT if unit.name == UnitName::Boot => self.find(boots),
                command::REBOOT => self.find(boots),
                command::SET | command::ASSIGNMENT | command::BIT => {
                    let target = instruction.items.first().and_then(|item| self.flag(&item.node));
                    self.found.extend(target.and_then(started_by_flag));
                }
                _ => {}
            }
        }
    }

    /// `RUN` and `LRUN` of the named texts, or of the own one.
    fn run(&mut self, instruction: &Instruction, own: Option<UnitName>) {
        if instruction.items.is_empty() {
            self.found.extend(own);
        }
        for item in &instruction.items {
            let number = |index: u16| u8::try_from(index).unwrap_or(u8::MAX);
            match item.node {
                Node::Word { keyword: Keyword::All, .. } => self.find(|_| true),
                Node::Object { kind: ObjectKind::Prog, index: Some(index), .. } => {
                    self.found.insert(UnitName::Program(number(index)));
                }
                Node::Object { kind: ObjectKind::Plc, index: Some(index), .. } => {
                    self.found.insert(UnitName::Plc(number(index)));
                }
                _ => {}
            }
        }
    }

    fn find(&mut self, wanted: impl Fn(&Unit) -> bool) {
        self.found.extend(self.image.programs.iter().filter(|unit| wanted(unit)).map(|unit| unit.name));
    }

    /// The number of a flag that is written as one, or as an alias.
    fn flag(&self, node: &Node) -> Option<u32> {
        match node {
            Node::Long(number) => u32::try_from(*number).ok(),
            Node::Scalar { class: OperandClass::Bit, index, .. } => self.flag(index),
            Node::Alias { index, .. } => {
                self.image.aliases.get(usize::from(*index)).and_then(|alias| self.flag(&alias.target))
            }
            _ => None,
        }
    }
}

/// The text that a request flag starts.
fn started_by_flag(flag: u32) -> Option<UnitName> {
    let number = |index: u32| u8::try_from(index).ok();
    let program = law::RUN_REQUEST.index_of(flag).and_then(number).map(UnitName::Program);
    program.or_else(|| law::PLC_RUN_REQUEST.index_of(flag).and_then(number).map(UnitName::Plc))
}
