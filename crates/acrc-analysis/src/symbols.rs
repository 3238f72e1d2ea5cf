//! What the files of a project know together: aliases, axis names by program, attachments in the order in which the
//! setup makes them.

use acrc_catalog::OperandClass;
use acrc_syntax::units::Level;
use rustc_hash::FxHashMap;

use crate::FileRole;
use crate::attachments::{Conflict, conflicts};
use crate::index::{AliasOperand, AliasTarget, Attachment, AttachmentKind, Exports, Name};

/// The symbols of a project.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Symbols {
    /// The aliases by name, in the order of their first definition. Aliases are global (guide, "Aliases").
    pub aliases: Vec<AliasSymbol>,
    /// Position in `aliases` by name.
    by_name: FxHashMap<Name, u32>,
    /// Position in `aliases` of the first one for an operand.
    by_operand: FxHashMap<(OperandClass, u64), u32>,
    /// Axis names by the level that they are valid at.
    pub axes: Vec<(Level, AxisTable)>,
    /// Attachments that contradict what stands when they are made, by file and by place in [`Exports::attachments`].
    pub conflicts: Vec<Conflict>,
    /// The files are a piece of code without its surroundings: one file that is not a setup and neither switches the
    /// prompt nor attaches anything. Axis names that such a piece does not declare may well be declared elsewhere.
    pub fragment: bool,
    /// Nothing in the piece shows that it is complete: it holds no `PROGRAM` and defines no alias either.
    pub excerpt: bool,
}

/// An alias of the project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AliasSymbol {
    /// Its name, case-sensitive.
    pub name: Name,
    /// What it stands for by its first definition.
    pub operand: AliasOperand,
    /// The file of the first definition, by its place in the project.
    pub file: u32,
    /// The definition's place in [`Exports::aliases`] of that file.
    pub define: u32,
    /// The levels at which the project uses it, sorted, each once.
    pub used_at: Vec<Level>,
    /// An earlier alias whose name differs in case only, by its place in [`Symbols::aliases`].
    pub twin: Option<u32>,
}

/// The axis names of one program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AxisTable {
    /// Names in capital letters with the axis, in the order of the attachments.
    pub names: Vec<(Name, Option<u32>)>,
    /// Some attachment does not say its name as a text, so that there may be more names.
    pub open: bool,
}

impl AxisTable {
    /// Whether the program has an axis of this name, in any case.
    pub fn has(&self, name: &str) -> bool {
        self.find(name).is_some()
    }

    /// The axis of this name, in any case.
    pub fn find(&self, name: &str) -> Option<&(Name, Option<u32>)> {
        self.names.iter().find(|(known, _)| known.eq_ignore_ascii_case(name))
    }
}

impl Symbols {
    /// Puts together what the files export. `files` are in the order of the project.
    pub(crate) fn new(files: &[(FileRole, &Exports)]) -> Self {
        let mut symbols = Self {
            fragment: matches!(files, [(role, only)] if *role != FileRole::Setup && is_fragment(only)),
            ..Self::default()
        };
        symbols.excerpt =
            symbols.fragment && files.iter().all(|(_, only)| !only.has_program && only.aliases.is_empty());
        for (file, (_, exports)) in (0..).zip(files) {
            symbols.add_aliases(file, exports);
            for attachment in &exports.attachments {
                symbols.add_axis(attachment);
            }
        }
        symbols.add_uses(files);
        symbols.conflicts = conflicts(files.iter().map(|(_, exports)| *exports));
        symbols
    }

    /// The alias of this name.
    pub fn alias(&self, name: &str) -> Option<&AliasSymbol> {
        self.aliases.get(*self.by_name.get(name)? as usize)
    }

    /// The first alias for a parameter, bit or variable.
    pub fn alias_for(&self, class: OperandClass, number: u64) -> Option<&AliasSymbol> {
        self.aliases.get(*self.by_operand.get(&(class, number))? as usize)
    }

    /// The axis names that are valid at `level`. `None` when nothing attaches an axis there.
    pub fn axes_at(&self, level: Level) -> Option<&AxisTable> {
        self.axes.iter().find(|(at, _)| *at == level).map(|(_, table)| table)
    }

    fn add_aliases(&mut self, file: u32, exports: &Exports) {
        for (define, (name, operand)) in (0..).zip(&exports.aliases) {
            if !self.by_name.contains_key(name) {
                let place = self.aliases.len() as u32;
                self.by_name.insert(name.clone(), place);
                if let AliasTarget::Operand(class, Some(number)) = operand.target {
                    self.by_operand.entry((class, number)).or_insert(place);
                }
                let (name, operand) = (name.clone(), operand.clone());
                self.aliases.push(AliasSymbol { name, operand, file, define, used_at: Vec::new(), twin: None });
            }
        }
    }

    /// Adds to the aliases where they are used and which of them are alike.
    fn add_uses(&mut self, files: &[(FileRole, &Exports)]) {
        for (name, level) in files.iter().flat_map(|(_, exports)| &exports.uses) {
            let place = self.by_name.get(name).copied();
            if let Some(alias) = place.and_then(|place| self.aliases.get_mut(place as usize)) {
                alias.used_at.push(*level);
            }
        }
        let mut folded: FxHashMap<Name, u32> = FxHashMap::default();
        for (place, alias) in (0..).zip(&mut self.aliases) {
            alias.used_at.sort_unstable();
            alias.used_at.dedup();
            let first = *folded.entry(alias.name.to_ascii_lowercase().into()).or_insert(place);
            alias.twin = (first != place).then_some(first);
        }
    }

    fn add_axis(&mut self, attachment: &Attachment) {
        let AttachmentKind::Slave { axis, name, .. } = &attachment.kind else { return };
        let place = self.axes.iter().position(|(level, _)| *level == attachment.level).unwrap_or_else(|| {
            self.axes.push((attachment.level, AxisTable::default()));
            self.axes.len() - 1
        });
        let Some((_, table)) = self.axes.get_mut(place) else { return };
        match name {
            Some(name) if table.has(name) => {}
            Some(name) => table.names.push((name.clone(), *axis)),
            None => table.open = true,
        }
    }
}

fn is_fragment(only: &Exports) -> bool {
    let names_axes = |attachment: &Attachment| {
        !matches!(attachment.kind, AttachmentKind::Master { .. } | AttachmentKind::Axis { .. })
    };
    !only.switches_level && !only.attachments.iter().any(names_axes)
}
