//! A project with what was found in it.

use acrc_analysis::project::{FileGlobs, LoadedProject, Selection};
use acrc_analysis::{Database, Project, SourceFile as Input};
use acrc_diagnostics::{Diagnostic, FileReport, SourceFile};
use camino::Utf8PathBuf;

use crate::cli::SelectionArguments;
use crate::commands::targets::{Target, display, note_of_strangers};

/// A project, its database and its findings.
pub(super) struct Checked {
    pub(super) project: LoadedProject,
    pub(super) db: Database,
    pub(super) input: Project,
    /// Which files are shown, in their order.
    pub(super) shown: Vec<bool>,
    /// The names under which they are shown.
    pub(super) names: Vec<String>,
    /// Programs around its `acrc.toml` that are no part of it.
    pub(super) strangers: Vec<Utf8PathBuf>,
    /// What was found in each.
    pub(super) found: Vec<Vec<Diagnostic>>,
}

impl Checked {
    /// Checks a project with the rules of its configuration and of the command line.
    pub(super) fn new(target: &Target, mut project: LoadedProject, selection: &Selection) -> Self {
        project.config.lint.command_line = selection.clone();
        let db = Database::new();
        let input = project.add_to(&db);
        let names = project.files.iter().map(|file| display(&file.path)).collect();
        let lint = &project.config.lint;
        let exclude = FileGlobs::new(&lint.exclude).unwrap_or_default();
        let is_excluded = |path: &str| !exclude.matching(lint.relative(path)).is_empty();
        let shown = target.meant(&project).into_iter().zip(&project.files);
        let shown = shown.map(|(meant, file)| meant && !is_excluded(file.path.as_str())).collect();
        let strangers = target.strangers(&project);
        let mut checked = Self { shown, project, db, input, names, strangers, found: Vec::new() };
        checked.take(acrc_lint::check_in_parallel(&checked.db, input));
        checked
    }

    /// Checks again what was changed.
    pub(super) fn check(&mut self) {
        self.take(acrc_lint::check(&self.db, self.input));
    }

    /// Takes over what was found in each file.
    pub(super) fn take(&mut self, found: Vec<(Input, Vec<Diagnostic>)>) {
        self.found = found.into_iter().map(|(_, findings)| findings).collect();
    }

    /// What is odd about the patterns of the project.
    pub(super) fn warnings(&self) -> Vec<String> {
        self.project.idle_lint_patterns(&self.strangers)
    }

    /// What is passed over.
    pub(super) fn note(&self) -> Option<String> {
        let exclude = FileGlobs::new(&self.project.config.lint.exclude).unwrap_or_default();
        note_of_strangers(&self.strangers, &exclude, &self.project)
    }

    /// The findings of the files that are shown.
    pub(super) fn reports(&self) -> impl Iterator<Item = FileReport<'_>> {
        self.shown_files().map(|(place, name, text)| {
            FileReport::new(SourceFile::new(name, text), self.found.get(place).into_iter().flatten())
        })
    }

    /// The findings of the files that are shown, in no order.
    pub(super) fn found_in_shown(&self) -> impl Iterator<Item = &Diagnostic> {
        self.found.iter().zip(&self.shown).filter(|(_, shown)| **shown).flat_map(|(found, _)| found)
    }

    /// Place, name and text of the files that are shown.
    pub(super) fn shown_files(&self) -> impl Iterator<Item = (usize, &str, &str)> {
        let files = self.project.files.iter().zip(&self.names).zip(&self.shown).enumerate();
        let shown = files.filter(|(_, (_, shown))| **shown);
        shown.map(|(place, ((file, name), _))| (place, name.as_str(), file.source.text.as_str()))
    }
}

impl From<&SelectionArguments> for Selection {
    fn from(arguments: &SelectionArguments) -> Self {
        Self {
            select: arguments.select.clone(),
            extend_select: arguments.extend_select.clone(),
            ignore: arguments.ignore.clone(),
        }
    }
}
