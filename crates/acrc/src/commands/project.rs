//! Loading, checking and compiling a project, as several subcommands do.

use std::io::Write as _;
use std::path::Path;

use acrc_analysis::Database;
use acrc_analysis::project::{self, LoadedProject};
use acrc_diagnostics::{Diagnostic, FileReport, Severity, SourceFile, Summary, text};
use acrc_image::Image;
use anyhow::Context as _;
use camino::Utf8Path;

use crate::output::Terminal;

/// Loads the project at a path.
pub(crate) fn load(path: &Path) -> anyhow::Result<LoadedProject> {
    let path = Utf8Path::from_path(path).with_context(|| format!("{} is not a path in UTF-8", path.display()))?;
    Ok(project::load(path)?)
}

/// What a person calls a project: a lone file by its path, a folder by its name.
pub(crate) fn title(project: &LoadedProject) -> &str {
    match &project.files[..] {
        [file] if project.config.project.name.is_none() => file.path.as_str(),
        _ => &project.name,
    }
}

/// What is wrong with each file of a project, in their order. The linter knows most; what only the compiler can tell, such as the limits of the
/// stored form, is asked when the linter finds no error.
pub(crate) fn check(project: &LoadedProject) -> Vec<Vec<Diagnostic>> {
    let db = Database::new();
    let input = project.add_to(&db);
    let mut found: Vec<Vec<Diagnostic>> =
        acrc_lint::check(&db, input).into_iter().map(|(_, diagnostics)| diagnostics).collect();
    if !found.iter().flatten().any(|finding| finding.severity == Severity::Error)
        && let Err(errors) = project.compile()
    {
        for error in &errors {
            if let Some(list) = found.get_mut(error.file) {
                list.push(error.into());
            }
        }
    }
    found
}

/// The findings of each file, ready to be shown.
pub(crate) fn reports<'a>(project: &'a LoadedProject, found: &'a [Vec<Diagnostic>]) -> Vec<FileReport<'a>> {
    let files = project.files.iter().zip(found);
    files.map(|(file, list)| FileReport::new(SourceFile::new(file.path.as_str(), &file.source.text), list)).collect()
}

/// Compiles a project. What is wrong with it goes to standard error; `None` then.
pub(crate) fn compile(project: &LoadedProject, terminal: Terminal) -> anyhow::Result<Option<Image>> {
    if let Ok(image) = project.compile() {
        return Ok(Some(image));
    }
    let mut found = check(project);
    for list in &mut found {
        list.retain(|finding| finding.severity == Severity::Error);
    }
    let reports = reports(project, &found);
    let mut stderr = std::io::stderr().lock();
    text::render(&reports, text::Options { color: terminal.color, ..text::Options::default() }, &mut stderr)?;
    writeln!(stderr, "{} does not compile: {}", title(project), Summary::of(&reports))?;
    Ok(None)
}
