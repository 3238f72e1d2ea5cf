//! The alias table of a project: `#DEFINE` wherever it stands, known to all programs (guide, "Aliases").

use acrc_diagnostics::Span;
use acrc_image::{Alias, Node};
use acrc_syntax::ast::{Define, StatementKind};
use rustc_hash::FxHashMap;

use crate::encoder::Encoder;
use crate::error::{CompileError, CompileErrorKind};
use crate::project::SourceUnit;
use crate::scope::NoNames;

/// Collects aliases in the order of their definitions.
#[derive(Default)]
pub(crate) struct AliasTable {
    /// The table of the image.
    pub(crate) aliases: Vec<Alias>,
    /// The place of each name in it.
    pub(crate) places: FxHashMap<String, u16>,
    /// File and name of each entry.
    origins: Vec<(usize, Span)>,
}

impl AliasTable {
    /// The definitions of all files.
    pub(crate) fn collect(files: &[SourceUnit<'_>], errors: &mut Vec<CompileError>) -> Self {
        let mut table = Self::default();
        for (file, source) in files.iter().enumerate() {
            for statement in source.tree.statements() {
                if let StatementKind::Define(define) = &statement.kind {
                    table.define(file, source.text, define, errors);
                }
            }
        }
        table
    }

    fn define(&mut self, file: usize, text: &str, define: &Define, errors: &mut Vec<CompileError>) {
        let mut report = |span, kind| errors.push(CompileError { file, span, kind });
        let (Alias { name, target }, mistakes) = read(text, define);
        for (span, kind) in mistakes {
            report(span, kind);
        }
        let Some(&place) = self.places.get(&name) else {
            match u16::try_from(self.aliases.len()) {
                Ok(place) => {
                    self.places.insert(name.clone(), place);
                }
                Err(_) => report(
                    define.name,
                    CompileErrorKind::Limit { what: "the number of aliases", value: 65_537, limit: 65_536 },
                ),
            }
            self.aliases.push(Alias { name, target });
            self.origins.push((file, define.name));
            return;
        };
        let same = self.aliases.get(usize::from(place)).is_some_and(|alias| alias.target == target);
        if !same {
            let origin = self.origins.get(usize::from(place));
            let first = origin.and_then(|&(first_file, first)| (first_file == file).then_some(first));
            report(define.name, CompileErrorKind::ConflictingAlias { name, first });
        }
    }
}

/// Reads a definition, as a terminal needs it, where the table is that of a running controller.
///
/// # Errors
/// The mistakes in it.
pub fn read_alias(text: &str, define: &Define) -> Result<Alias, Vec<CompileErrorKind>> {
    let (alias, mistakes) = read(text, define);
    if mistakes.is_empty() { Ok(alias) } else { Err(mistakes.into_iter().map(|(_, kind)| kind).collect()) }
}

/// The alias that a definition makes, and what is wrong with it.
fn read(text: &str, define: &Define) -> (Alias, Vec<(Span, CompileErrorKind)>) {
    let mut encoder = Encoder::new(text, &NoNames);
    let name = encoder.slice(define.name).to_owned();
    let target = encoder.expression(&define.operand);
    let mut mistakes = encoder.errors;
    for (_, kind) in &mut mistakes {
        if matches!(kind, CompileErrorKind::UndefinedAlias(_)) {
            *kind = CompileErrorKind::AliasOperand;
        }
    }
    if mistakes.is_empty() && !has_place(&target) {
        mistakes.push((define.operand.span, CompileErrorKind::AliasOperand));
    }
    (Alias { name, target }, mistakes)
}

/// Can an alias stand for it?
fn has_place(target: &Node) -> bool {
    target.is_constant() || matches!(target, Node::String { .. } | Node::Scalar { .. } | Node::Array { .. })
}
