//! How other crates look for findings in a file and have the result remembered.

use std::fmt;
use std::hash::{Hash, Hasher};

use acrc_catalog::Model;
use acrc_diagnostics::{Diagnostic, Span};
use acrc_syntax::Tree;
use acrc_syntax::ast::StatementKind;

use crate::memory::{MemorySites, MemoryView};
use crate::project::LintConfig;
use crate::{Db, Environment, FileIndex, Machine, Project, SourceFile, Usage, query};

/// Everything that a check of one file may look at. It may look at nothing else: what it finds is remembered until
/// one of these changes.
#[derive(Clone, Copy, Debug)]
pub struct FileContext<'a> {
    /// The path, as it is shown.
    pub name: &'a str,
    /// What the configuration says of checking.
    pub lint: &'a LintConfig,
    /// The text.
    pub text: &'a str,
    /// What was found while decoding it.
    pub encoding: &'a [Diagnostic],
    /// Its tree.
    pub tree: &'a Tree,
    /// Its sections, labels and jumps.
    pub index: &'a FileIndex,
    /// The symbols of the other files, as far as this one uses them.
    pub environment: &'a Environment,
    /// What the project makes of its controller.
    pub machine: &'a Machine,
    /// What the project uses by number.
    pub usage: &'a Usage,
    /// What few files ask.
    pub questions: Questions<'a>,
    /// The memory of the project, as far as this file uses it.
    pub memory: &'a MemoryView,
    /// Where the file itself gives and clears memory.
    pub memory_sites: &'a MemorySites,
    /// The controller model.
    pub model: &'static Model,
    /// The project names the model; otherwise it is the default one.
    pub model_is_given: bool,
}

/// Questions about the whole project that few files ask. What a file does not ask it does not depend on.
#[derive(Clone, Copy)]
pub struct Questions<'a> {
    db: &'a dyn Db,
    project: Project,
}

impl<'a> Questions<'a> {
    pub(crate) fn new(db: &'a dyn Db, project: Project) -> Self {
        Self { db, project }
    }

    /// Whether some code of the project may set this user flag.
    pub fn may_set_flag(&self, flag: u32) -> bool {
        query::set_flags(self.db, self.project).may_set(flag)
    }

    /// Where the project defines an alias: trees and texts of files, with the statements in them.
    pub fn definitions(&self, alias: &str) -> Vec<(&'a Tree, &'a str, Span)> {
        let of_file = |file: &SourceFile| {
            let (tree, text): (&'a Tree, &'a str) = (query::parse(self.db, *file), file.text(self.db));
            let defined = tree.statements().iter().filter_map(move |statement| match &statement.kind {
                StatementKind::Define(define) if text.get(define.name.range()) == Some(alias) => Some(define.name),
                _ => None,
            });
            defined.map(move |name| (tree, text, name))
        };
        self.project.files(self.db).iter().flat_map(of_file).collect()
    }

    /// The name of a file by its place in the project; empty when there is none.
    pub fn file_name(&self, place: u32) -> &'a str {
        self.project.files(self.db).get(place as usize).map_or("", |file| file.name(self.db))
    }
}

impl fmt::Debug for Questions<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Questions").finish_non_exhaustive()
    }
}

/// A check of one file.
#[derive(Clone, Copy)]
pub struct Checker {
    /// Its name, by which results are remembered: two checkers of one name must be the same.
    pub name: &'static str,
    /// Looks at a file. The findings may come in any order.
    pub run: fn(&FileContext<'_>) -> Vec<Diagnostic>,
}

impl PartialEq for Checker {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Checker {}

impl Hash for Checker {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

impl fmt::Debug for Checker {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Checker").field(&self.name).finish()
    }
}
