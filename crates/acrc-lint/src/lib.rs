//! The linter: rules over the semantic layer.
//!
//! [`check`] looks at a project; [`rules`] lists what it looks for; [`explain`] is the page of one rule. Each rule is
//! one file below `rules/` that holds its code, its documentation, its check and its tests; the registry lists them.
//! The parser's and the compiler's own findings have their pages here too. [`fix`] repairs what can be repaired,
//! [`problems`] says what of a configuration is not understood.
//!
//! **Invariants.** A file is passed over once, whatever the number of rules. A rule sees only the file and the part of
//! the project's symbols that the file uses, so that its findings can be remembered. What rests on a row of the
//! catalogue of low confidence is never an error.

mod configuration;
mod consequences;
mod context;
pub mod fix;
mod flow;
mod locals;
mod motions;
mod near_command;
mod operands;
mod pass;
mod plan;
mod references;
mod registry;
mod rule;
mod rules;
mod selector;
mod settings;
mod suppress;
#[cfg(test)]
mod testing;

use acrc_analysis::{Checker, Database, Db, Project, SourceFile, parallel};
use acrc_diagnostics::Diagnostic;

pub use configuration::{RuleState, problems, rule_states};
pub(crate) use context::{Context, level_name};
pub use registry::{explain, rules};
pub use rule::{Group, Mark, RuleDoc};
pub use suppress::allowed_rules;

/// The linter, for [`acrc_analysis::diagnostics`].
pub const CHECKER: Checker = Checker { name: "lint", run: pass::run };

/// The same as [`check`], with as many threads as the machine has processors: for a project that nobody has looked at
/// yet.
pub fn check_in_parallel(db: &Database, project: Project) -> Vec<(SourceFile, Vec<Diagnostic>)> {
    parallel::read_all(db, project);
    parallel::for_each(db, project.files(db), |db, file| {
        acrc_analysis::diagnostics(db, project, file, CHECKER);
    });
    check(db, project)
}

/// What is wrong with the files of a project, in their order, and in each by place.
pub fn check(db: &dyn Db, project: Project) -> Vec<(SourceFile, Vec<Diagnostic>)> {
    let check_file = |file: &SourceFile| (*file, acrc_analysis::diagnostics(db, project, *file, CHECKER).clone());
    project.files(db).iter().map(check_file).collect()
}
