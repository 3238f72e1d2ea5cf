//! `acrc upload`: reads what a controller has back into files.

use std::path::PathBuf;

use acrc_link::Protocol;
use acrc_link::download::{Script, survey, upload};
use anyhow::{Context as _, bail};
use serde_json::json;

use super::link::{connect, failed, watch_interrupt};
use super::project::{compile, load};
use crate::cli::{ColorChoice, UploadArguments};
use crate::exit::Exit;
use crate::output::{Terminal, print, write_file};

pub(super) fn run(arguments: &UploadArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let terminal = Terminal::error(color);
    let project = arguments.project.as_deref().map(load).transpose()?;
    let local = match &project {
        None => None,
        Some(project) => {
            let Some(image) = compile(project, "has no text to compare with", terminal) else {
                return Ok(Exit::Failure);
            };
            // Lines that cannot be sent do not keep their comments from being found.
            Some(Script::any(project, image))
        }
    };
    let model = project.as_ref().map_or_else(acrc_catalog::default_model, |project| project.model);
    watch_interrupt()?;
    let survey = connect(&arguments.to, Protocol::Text).and_then(|mut connection| {
        let survey = survey(&mut connection, model)?;
        connection.close();
        Ok(survey)
    });
    let survey = match survey {
        Ok(survey) => survey,
        Err(error) => return Ok(failed(error, terminal)),
    };
    let upload = upload(&survey, local.as_ref());
    let paths: Vec<PathBuf> = upload.files.iter().map(|file| arguments.out.join(&file.name)).collect();
    let there: Vec<String> = paths.iter().filter(|path| path.exists()).map(|path| path.display().to_string()).collect();
    if !there.is_empty() && !arguments.force {
        bail!("{} would be replaced: --force allows it; nothing was written", there.join(", "));
    }
    std::fs::create_dir_all(&arguments.out).with_context(|| format!("cannot make {}", arguments.out.display()))?;
    for (file, path) in upload.files.iter().zip(&paths) {
        write_file(path, file.text.as_bytes())?;
    }
    for note in &upload.notes {
        crate::exit::warn(note, terminal);
    }
    print(|out| {
        if arguments.json {
            let file = |(file, path): (&acrc_link::download::UploadedFile, &PathBuf)| json!({ "path": path.display().to_string(), "lines": file.lines, "recovered": file.recovered });
            let files: Vec<_> = upload.files.iter().zip(&paths).map(file).collect();
            return writeln!(out, "{}", json!({ "files": files, "notes": upload.notes }));
        }
        for (file, path) in upload.files.iter().zip(&paths) {
            let lines = if file.lines == 1 { "1 line".to_owned() } else { format!("{} lines", file.lines) };
            let recovered = match file.recovered {
                0 => String::new(),
                count => format!(", {count} as in the project"),
            };
            writeln!(out, "{}: {lines}{recovered}", path.display())?;
        }
        Ok(())
    })?;
    Ok(if upload.notes.is_empty() { Exit::Clean } else { Exit::Findings })
}
