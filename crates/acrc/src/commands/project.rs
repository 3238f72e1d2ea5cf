//! Loading and compiling a project, as several subcommands do.

use std::path::Path;

use acrc_analysis::project::{self, LoadedProject};
use acrc_diagnostics::{Diagnostic, FileReport, SourceFile, Summary, text};
use acrc_image::Image;
use anyhow::Context as _;
use camino::Utf8Path;

use crate::output::Terminal;

/// Loads the project at a path.
pub(crate) fn load(path: &Path) -> anyhow::Result<LoadedProject> {
    let path = Utf8Path::from_path(path).with_context(|| format!("{} is not a path in UTF-8", path.display()))?;
    Ok(project::load(path)?)
}

/// Compiles a project. What is wrong with it goes to standard error; `None` then.
pub(crate) fn compile(project: &LoadedProject, terminal: Terminal) -> anyhow::Result<Option<Image>> {
    let errors = match project.compile() {
        Ok(image) => return Ok(Some(image)),
        Err(errors) => errors,
    };
    let mut found: Vec<Vec<Diagnostic>> = vec![Vec::new(); project.files.len()];
    for error in &errors {
        if let Some(list) = found.get_mut(error.file) {
            list.push(error.into());
        }
    }
    let sources: Vec<SourceFile> =
        project.files.iter().map(|file| SourceFile::new(file.path.as_str(), &file.source.text)).collect();
    let reports: Vec<FileReport> =
        sources.into_iter().zip(&found).map(|(source, list)| FileReport::new(source, list)).collect();
    let mut stderr = std::io::stderr().lock();
    text::render(&reports, text::Options { color: terminal.color, ..text::Options::default() }, &mut stderr)?;
    use std::io::Write as _;
    writeln!(stderr, "{} does not compile: {}", project.name, Summary::of(&reports))?;
    Ok(None)
}
