//! Loading, checking and compiling a project, as several subcommands do.

use std::path::{Path, PathBuf};

use acrc_analysis::Database;
use acrc_analysis::project::{self, CONFIG_NAME, Disk, Files, LoadError, LoadedProject};
use acrc_diagnostics::{Diagnostic, FileReport, Severity, SourceFile, Summary, text};
use acrc_image::Image;
use anyhow::Context as _;
use camino::Utf8Path;

use crate::output::{Terminal, tell};

/// Loads the project at a path.
pub(crate) fn load(path: &Path) -> anyhow::Result<LoadedProject> {
    load_from(&Disk, utf8(path)?)
}

/// Loads the project at a path through a file system.
pub(crate) fn load_from(files: &dyn Files, path: &Utf8Path) -> anyhow::Result<LoadedProject> {
    let project = project::load_from(files, path)?;
    let problems = acrc_lint::problems(&project.config.lint);
    if !problems.is_empty() {
        let path = project.root.join(CONFIG_NAME);
        return Err(LoadError::Config { path, message: problems.join("\n") }.into());
    }
    Ok(project)
}

/// A path in UTF-8.
pub(crate) fn utf8(path: &Path) -> anyhow::Result<&Utf8Path> {
    Utf8Path::from_path(path).with_context(|| format!("{} is not a path in UTF-8", path.display()))
}

/// What a person calls a project: a lone file by its path, a folder by its name.
pub(crate) fn title(project: &LoadedProject) -> &str {
    match &project.files[..] {
        [file] if project.config.project.name.is_none() => file.path.as_str(),
        _ => &project.name,
    }
}

/// What the linter finds in each file of a project, in their order.
pub(crate) fn check(project: &LoadedProject) -> Vec<Vec<Diagnostic>> {
    let db = Database::new();
    let input = project.add_to(&db);
    acrc_lint::check_in_parallel(&db, input).into_iter().map(|(_, diagnostics)| diagnostics).collect()
}

/// The files that a project is read from.
pub(crate) fn inputs(project: &LoadedProject) -> Vec<PathBuf> {
    let files = project.files.iter().map(|file| file.path.clone());
    let world = project.config.sim.world.iter().map(|path| project.root.join(path));
    let config = std::iter::once(project.root.join(CONFIG_NAME));
    files.chain(world).chain(config).map(camino::Utf8PathBuf::into_std_path_buf).collect()
}

/// The findings of each file, ready to be shown.
pub(crate) fn reports<'a>(project: &'a LoadedProject, found: &'a [Vec<Diagnostic>]) -> Vec<FileReport<'a>> {
    let files = project.files.iter().zip(found);
    files.map(|(file, list)| FileReport::new(SourceFile::new(file.path.as_str(), &file.source.text), list)).collect()
}

/// Compiles a project. What is wrong with it goes to standard error, and what is `undone` for it; `None` then.
pub(crate) fn compile(project: &LoadedProject, undone: &str, terminal: Terminal) -> Option<Image> {
    let errors = match project.compile() {
        Ok(image) => return Some(image),
        Err(errors) => errors,
    };
    // The linter says the same with more knowledge of the whole project; what only the compiler knows is left to it.
    let mut found = errors_of(check(project));
    if found.iter().all(Vec::is_empty) {
        for error in &errors {
            if let Some(list) = found.get_mut(error.file) {
                list.push(error.into());
            }
        }
    }
    show_errors(project, &found, undone, terminal);
    None
}

/// Only the errors among findings.
pub(crate) fn errors_of(mut found: Vec<Vec<Diagnostic>>) -> Vec<Vec<Diagnostic>> {
    for list in &mut found {
        list.retain(|finding| finding.severity == Severity::Error);
    }
    found
}

/// Shows errors on standard error, and says what is `undone` for them.
pub(crate) fn show_errors(project: &LoadedProject, found: &[Vec<Diagnostic>], undone: &str, terminal: Terminal) {
    let reports = reports(project, found);
    tell(|err| {
        text::render(&reports, text::Options { color: terminal.color, ..text::Options::default() }, err)?;
        writeln!(err, "{} {undone}: {}", title(project), Summary::of(&reports))
    });
}
