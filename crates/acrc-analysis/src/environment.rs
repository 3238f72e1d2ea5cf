//! What one file needs to know of the others, cut down to that: two files share nothing but the names that both use,
//! so an edit is felt only where it matters.

use acrc_syntax::units::Level;
use rustc_hash::FxHashMap;

use crate::index::{AliasOperand, Exports, Name};
use crate::near::nearest;
use crate::symbols::{AliasSymbol, AxisTable, Conflict, Symbols};

/// The part of the project's symbols that one file uses.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Environment {
    aliases: FxHashMap<Name, AliasFact>,
    axes: Vec<(Level, AxisTable)>,
    /// Attachments of this file that contradict an earlier one.
    pub conflicts: Vec<Conflict>,
    /// See [`Symbols::fragment`].
    pub fragment: bool,
    /// See [`Symbols::excerpt`].
    pub excerpt: bool,
}

/// What is known of a name that is used or defined as an alias.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AliasFact {
    /// It is defined.
    Defined {
        /// What it stands for by its first definition.
        operand: AliasOperand,
        /// Where that is.
        first: DefinedIn,
    },
    /// It is not; this name is near.
    Undefined {
        /// An alias whose name differs in a letter or two, or in case.
        near: Option<Name>,
    },
}

/// Where an alias is defined first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DefinedIn {
    /// In this file, at this place of [`crate::FileIndex::defines`].
    This(u32),
    /// In another file, of this name.
    Other(Name),
}

impl Environment {
    pub(crate) fn new(file: u32, exports: &Exports, symbols: &Symbols, name_of: impl Fn(u32) -> Name) -> Self {
        let names = exports.uses.iter().chain(exports.aliases.iter().map(|(name, _)| name));
        let fact = |name: &Name| match symbols.alias(name) {
            Some(symbol) => AliasFact::Defined {
                operand: symbol.operand.clone(),
                first: if symbol.file == file {
                    DefinedIn::This(symbol.define)
                } else {
                    DefinedIn::Other(name_of(symbol.file))
                },
            },
            None => AliasFact::Undefined { near: near(name, &symbols.aliases) },
        };
        Self {
            aliases: names.map(|name| (name.clone(), fact(name))).collect(),
            axes: symbols.axes.iter().filter(|(level, _)| exports.levels.contains(level)).cloned().collect(),
            conflicts: symbols.conflicts.iter().filter(|conflict| conflict.file == file).cloned().collect(),
            fragment: symbols.fragment,
            excerpt: symbols.excerpt,
        }
    }

    /// What is known of `name`. `None` for a name that the file neither uses nor defines.
    pub fn alias(&self, name: &str) -> Option<&AliasFact> {
        self.aliases.get(name)
    }

    /// The axis names that are valid at `level`. `None` when nothing attaches an axis there.
    pub fn axes_at(&self, level: Level) -> Option<&AxisTable> {
        self.axes.iter().find(|(at, _)| *at == level).map(|(_, table)| table)
    }
}

/// The alias that `name` was probably meant to be.
fn near(name: &str, aliases: &[AliasSymbol]) -> Option<Name> {
    let other_case = aliases.iter().find(|alias| alias.name.eq_ignore_ascii_case(name));
    let near = || nearest(name, aliases.iter().map(|alias| &*alias.name));
    other_case.map(|alias| alias.name.clone()).or_else(|| near().map(Name::from))
}
