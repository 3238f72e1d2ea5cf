//! What one file needs to know of the others, cut down to that: two files share nothing but the names that both use,
//! so an edit is felt only where it matters.

use acrc_catalog::OperandClass;
use acrc_syntax::units::Level;
use rustc_hash::FxHashMap;

use crate::Conflict;
use crate::index::{AliasOperand, AliasTarget, Exports, Name};
use crate::near::nearest;
use crate::symbols::{AliasSymbol, AxisTable, Symbols};

/// The part of the project's symbols that one file uses.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Environment {
    aliases: FxHashMap<Name, AliasFact>,
    axes: Vec<(Level, AxisTable)>,
    /// What the aliases that this file is the first to define are to the rest of the project.
    own: FxHashMap<Name, OwnAlias>,
    /// Aliases for the operands that this file writes by their numbers.
    named: FxHashMap<(OperandClass, u64), Name>,
    /// The place of this file in the project.
    pub place: u32,
    /// Attachments of this file that contradict an earlier one.
    pub conflicts: Vec<Conflict>,
    /// See [`Symbols::fragment`].
    pub fragment: bool,
    /// See [`Symbols::excerpt`].
    pub excerpt: bool,
    /// Aliases of the project that are words of the language, and are read as such wherever they are used.
    pub words: Vec<Name>,
    /// No file of the project defines an alias.
    pub nameless: bool,
}

/// What an alias that a file defines is to the project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OwnAlias {
    /// The levels at which it is used, sorted, each once.
    pub used_at: Vec<Level>,
    /// A program that has an axis of this name.
    pub axis_of: Option<Level>,
    /// An alias whose name differs in case only and that is defined earlier.
    pub twin: Option<Name>,
    /// An alias that is defined earlier and stands for the same parameter, bit or variable.
    pub synonym: Option<Name>,
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
        /// That file is sent after this one.
        later: bool,
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
    pub(crate) fn new(
        file: u32,
        exports: &Exports,
        numbers: &[(OperandClass, u64)],
        symbols: &Symbols,
        name_of: impl Fn(u32) -> Name,
    ) -> Self {
        let defined = || exports.aliases.iter().map(|(name, _)| name);
        let names = exports.uses.iter().map(|(name, _)| name).chain(defined());
        let fact = |name: &Name| match symbols.alias(name) {
            Some(symbol) => AliasFact::Defined {
                operand: symbol.operand.clone(),
                first: if symbol.file == file {
                    DefinedIn::This(symbol.define)
                } else {
                    DefinedIn::Other(name_of(symbol.file))
                },
                later: symbol.file > file,
            },
            None => AliasFact::Undefined { near: near(name, &symbols.aliases) },
        };
        Self {
            aliases: names.map(|name| (name.clone(), fact(name))).collect(),
            axes: symbols.axes.iter().filter(|(level, _)| exports.levels.contains(level)).cloned().collect(),
            own: defined()
                .filter_map(|name| symbols.alias(name).filter(|symbol| symbol.file == file))
                .map(|symbol| (symbol.name.clone(), OwnAlias::new(symbol, symbols)))
                .collect(),
            named: numbers
                .iter()
                .filter_map(|key| Some((*key, symbols.alias_for(key.0, key.1)?.name.clone())))
                .collect(),
            place: file,
            conflicts: symbols.conflicts.iter().filter(|conflict| conflict.file == file).cloned().collect(),
            fragment: symbols.fragment,
            excerpt: symbols.excerpt,
            words: symbols.aliases.iter().map(|alias| &alias.name).filter(|name| is_word(name)).cloned().collect(),
            nameless: symbols.aliases.is_empty(),
        }
    }

    /// What is known of `name`. `None` for a name that the file neither uses nor defines.
    pub fn alias(&self, name: &str) -> Option<&AliasFact> {
        self.aliases.get(name)
    }

    /// What the alias `name` is to the project. `None` unless its first definition is in this file.
    pub fn own_alias(&self, name: &str) -> Option<&OwnAlias> {
        self.own.get(name)
    }

    /// The first alias for an operand that this file writes by its number.
    pub fn alias_for(&self, class: OperandClass, number: u64) -> Option<&str> {
        self.named.get(&(class, number)).map(|name| &**name)
    }

    /// The axis names that are valid at `level`. `None` when nothing attaches an axis there.
    pub fn axes_at(&self, level: Level) -> Option<&AxisTable> {
        self.axes.iter().find(|(at, _)| *at == level).map(|(_, table)| table)
    }
}

impl OwnAlias {
    fn new(symbol: &AliasSymbol, symbols: &Symbols) -> Self {
        let axis_of = symbols.axes.iter().find(|(_, table)| table.has(&symbol.name)).map(|(level, _)| *level);
        let twin = symbol.twin.and_then(|place| symbols.aliases.get(place as usize)).map(|twin| twin.name.clone());
        let synonym = match symbol.operand.target {
            AliasTarget::Operand(class, Some(number)) => symbols.alias_for(class, number),
            _ => None,
        };
        let synonym = synonym.filter(|other| other.name != symbol.name).map(|other| other.name.clone());
        Self { used_at: symbol.used_at.clone(), axis_of, twin, synonym }
    }
}

fn is_word(name: &str) -> bool {
    acrc_catalog::word(name).is_some_and(|word| word.stands_alone())
}

/// The alias that `name` was probably meant to be.
fn near(name: &str, aliases: &[AliasSymbol]) -> Option<Name> {
    let other_case = aliases.iter().find(|alias| alias.name.eq_ignore_ascii_case(name));
    let near = || nearest(name, aliases.iter().map(|alias| &*alias.name));
    other_case.map(|alias| alias.name.clone()).or_else(|| near().map(Name::from))
}
