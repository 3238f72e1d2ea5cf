//! Whether a controller can take what was compiled: texts that it cannot execute, or that do not fit their memory, are not stored there.
//!
//! The linter says the same with more knowledge, but it can be told to be quiet.

use acrc_analysis::Database;
use acrc_analysis::memory::{Space, report};
use acrc_analysis::project::LoadedProject;
use acrc_image::Image;
use acrc_vm::Code;
use anyhow::Context as _;

/// Why texts of the image cannot be loaded, each behind its place.
pub(in crate::commands) fn problems(project: &LoadedProject, image: &Image) -> anyhow::Result<Vec<String>> {
    let mut problems: Vec<String> = image
        .units()
        .filter_map(|unit| {
            let error = Code::load(unit, &image.aliases).err()?;
            let file = error.location.source.and_then(|source| image.files.get(source.file as usize));
            let file = file.map_or_else(|| unit.name.to_string(), Clone::clone);
            Some(format!("{file}:{}: {}", error.location.source_line(), error.kind))
        })
        .collect();
    let db = Database::new();
    let input = project.add_to(&db);
    let report = report(&db, input, image).context("the compiled project can't be read")?;
    for program in &report.programs {
        let (needed, space) = (program.text.total(), program.space.map(Space::bytes));
        if let Some(space) = space.filter(|space| needed > *space) {
            let level = program.level;
            problems.push(format!("{level}: its text needs {needed} bytes, and DIM {level} gives {space}"));
        }
    }
    Ok(problems)
}
