//! The derived facts that the database remembers, from the text of a file to the findings in it.
//!
//! ```text
//! text ── parse ─┬─ index ───────────────────────────────┐
//!                ├─ exports ─ symbols ─ environment ─────┤
//!                ├─ memory (see [`crate::memory`]) ──────┤
//!                └─ effects ─ machine, usage ────────────┴─ diagnostics
//! ```
//!
//! (`machine` asks `symbols` and `exports` too: axes have names, flags have aliases.)
//!
//! `exports`, `effects`, `environment`, `machine` and `usage` are the places where the effect of an edit ends: they hold no places
//! in the text, and what is computed from them is computed again only when they really differ.

use acrc_catalog::OperandClass;
use acrc_diagnostics::Diagnostic;
use acrc_syntax::Tree;

use crate::checker::Questions;
use crate::index::{self, Effects, Exports, FileIndex};
use crate::memory::{memory_sites, memory_view};
use crate::usage::SetFlags;
use crate::{Checker, Db, Environment, FileContext, Machine, Project, SourceFile, Symbols, Usage};

/// The tree of a file.
#[salsa::tracked(returns(ref), no_eq)]
pub fn parse(db: &dyn Db, file: SourceFile) -> Tree {
    acrc_syntax::parse(file.text(db))
}

#[salsa::tracked(returns(ref), no_eq)]
fn indexed(db: &dyn Db, file: SourceFile) -> (FileIndex, Exports, Effects) {
    index::build(file.text(db), parse(db, file), file.role(db))
}

/// The index of a file, with places.
pub fn file_index(db: &dyn Db, file: SourceFile) -> &FileIndex {
    &indexed(db, file).0
}

/// What other files see of a file.
#[salsa::tracked(returns(ref))]
pub fn exports(db: &dyn Db, file: SourceFile) -> Exports {
    indexed(db, file).1.clone()
}

/// What a file does to the machine.
#[salsa::tracked(returns(ref))]
pub fn effects(db: &dyn Db, file: SourceFile) -> Effects {
    indexed(db, file).2.clone()
}

/// What the project makes of its controller.
#[salsa::tracked(returns(ref))]
pub fn machine(db: &dyn Db, project: Project) -> Machine {
    let files: Vec<_> = project.files(db).iter().map(|file| (exports(db, *file), effects(db, *file))).collect();
    Machine::new(symbols(db, project), &files)
}

/// The symbols of a project.
#[salsa::tracked(returns(ref))]
pub fn symbols(db: &dyn Db, project: Project) -> Symbols {
    let files: Vec<_> = project.files(db).iter().map(|file| (file.role(db), exports(db, *file))).collect();
    Symbols::new(&files)
}

/// What the project uses by number.
#[salsa::tracked(returns(ref))]
pub fn usage(db: &dyn Db, project: Project) -> Usage {
    let files = project.files(db).iter().map(|file| (exports(db, *file), effects(db, *file)));
    Usage::new(files)
}

/// The user flags that some code of the project sets.
#[salsa::tracked(returns(ref))]
pub(crate) fn set_flags(db: &dyn Db, project: Project) -> SetFlags {
    SetFlags::new(project.files(db).iter().map(|file| effects(db, *file)), symbols(db, project))
}

/// The operands that a file writes by their numbers.
#[salsa::tracked(returns(ref))]
fn numbers(db: &dyn Db, file: SourceFile) -> Vec<(OperandClass, u64)> {
    file_index(db, file).numbers.clone()
}

/// What `file` needs to know of the rest of the project.
#[salsa::tracked(returns(ref))]
pub fn environment(db: &dyn Db, project: Project, file: SourceFile) -> Environment {
    let files = project.files(db);
    // A file that is not of the project sees its symbols, and nothing of them is its own.
    let place = files.iter().position(|other| *other == file).unwrap_or(files.len());
    let name_of = |place: u32| files.get(place as usize).map_or("", |file| file.name(db)).into();
    let numbers = numbers(db, file);
    Environment::new(place as u32, exports(db, file), numbers, symbols(db, project), name_of)
}

/// What `checker` finds in a file.
#[salsa::tracked(returns(ref))]
pub fn diagnostics(db: &dyn Db, project: Project, file: SourceFile, checker: Checker) -> Vec<Diagnostic> {
    let mut found = (checker.run)(&FileContext {
        name: file.name(db),
        lint: &project.config(db).lint,
        text: file.text(db),
        encoding: file.encoding(db),
        tree: parse(db, file),
        index: file_index(db, file),
        environment: environment(db, project, file),
        machine: machine(db, project),
        usage: usage(db, project),
        questions: Questions::new(db, project),
        memory: memory_view(db, project, file),
        memory_sites: memory_sites(db, file),
        model: project.model(db),
        model_is_given: project.config(db).project.model.is_some(),
    });
    found.sort_by(|a, b| {
        let place = (a.span.start, a.span.end).cmp(&(b.span.start, b.span.end));
        place.then(b.severity.cmp(&a.severity)).then(a.code.cmp(&b.code)).then_with(|| a.message.cmp(&b.message))
    });
    found
}
