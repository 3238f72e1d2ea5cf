//! The projects in and below a folder, and the project that a file belongs to.
//!
//! Folders are searched as version control sees them: what `.gitignore` names is passed over. Of what files a project
//! consists is no matter of version control, nor is a path that was named.

use std::collections::BTreeMap;
use std::io;

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};
use ignore::WalkBuilder;

use super::overlay::real;
use super::{CONFIG_NAME, Disk, FileKind, Files, LoadError, discover};
use crate::FileRole;
use crate::role::is_program_extension;

/// What was found in and below a folder.
#[derive(Debug, Default)]
pub struct Search {
    /// Paths for [`super::load`], in order.
    pub projects: Vec<Utf8PathBuf>,
    /// By projects with an `acrc.toml`, as in `projects`: the programs beside it and below it that no other project is
    /// nearer to. Some may be no part of it.
    pub around: BTreeMap<Utf8PathBuf, Vec<Utf8PathBuf>>,
    /// Folders and files that could not be looked at.
    pub problems: Vec<LoadError>,
}

/// Finds the projects that `path` stands for: a file for itself, a folder for those in it and below it. They are the
/// folders with an `acrc.toml`, else those with files named as the vendor's editor names them, else single programs.
/// What lies below an `acrc.toml` belongs to it, unless it has one of its own. A folder without any is given as it is,
/// so that loading it says what is missing.
pub fn search(path: &Utf8Path) -> Search {
    let mut search = Search::default();
    if !matches!(Disk.kind(path), Ok(FileKind::Directory)) {
        search.projects.push(path.to_owned());
        return search;
    }
    let folders = search.walk(path);
    // The working directory is no part of the paths that are found.
    let root = path.strip_prefix(".").unwrap_or(path);
    let holds_programs = discover::programs(&Disk, path).is_ok_and(|programs| !programs.is_empty());
    let is_project = holds_programs || has_config(path);
    if has_config(path) && root.as_str().is_empty() {
        // So that no file of it is called `./...`.
        search.projects.push(CONFIG_NAME.into());
    } else if is_project {
        search.projects.push(path.to_owned());
    }
    // Folders with an `acrc.toml`, and the paths of their projects.
    let mut described: Vec<(&Utf8Path, Utf8PathBuf)> = Vec::new();
    if has_config(path) {
        described.extend(search.projects.first().map(|project| (root, project.clone())));
    }
    for (folder, found) in &folders {
        // A folder comes before what lies in it.
        if found.config && !(is_project && *folder == root) {
            described.push((folder, folder.clone()));
            search.projects.push(folder.clone());
        }
        if let Some((_, project)) = described.iter().rfind(|(outer, _)| folder.starts_with(outer)) {
            search.around.entry(project.clone()).or_default().extend(found.programs.iter().cloned());
        } else if is_project && *folder == root {
            // It is there already.
        } else if found.vendor {
            search.projects.push(folder.clone());
        } else {
            search.projects.extend(found.programs.iter().cloned());
        }
    }
    if search.projects.is_empty() && search.problems.is_empty() {
        search.projects.push(path.to_owned());
    }
    search
}

/// Whether programs or projects lie in a folder or below it.
pub fn holds_programs(folder: &Utf8Path) -> bool {
    !Search::default().walk(folder).is_empty()
}

/// What of interest lies directly in a folder.
#[derive(Default)]
struct Folder {
    config: bool,
    /// A file is named as the vendor's editor names it.
    vendor: bool,
    programs: Vec<Utf8PathBuf>,
}

impl Search {
    fn walk(&mut self, root: &Utf8Path) -> BTreeMap<Utf8PathBuf, Folder> {
        let mut folders: BTreeMap<Utf8PathBuf, Folder> = BTreeMap::new();
        let walk = WalkBuilder::new(root).require_git(false).sort_by_file_name(Ord::cmp).build();
        for entry in walk {
            let entry = match entry {
                Ok(entry) => entry,
                Err(error) => {
                    self.problems.push(problem(root, error));
                    continue;
                }
            };
            let path = match Utf8PathBuf::from_path_buf(entry.into_path()) {
                Ok(path) => path,
                Err(path) => {
                    // A program that is passed over would be missing on the machine.
                    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("8k")) {
                        let message = format!("the file name `{}` is not UTF-8", path.display());
                        let source = io::Error::new(io::ErrorKind::InvalidData, message);
                        self.problems.push(LoadError::Unreadable { path: root.to_owned(), source });
                    }
                    continue;
                }
            };
            let path = path.strip_prefix(".").map_or(path.clone(), Utf8Path::to_owned);
            let is_config = path.file_name() == Some(CONFIG_NAME);
            let is_program = path.extension().is_some_and(is_program_extension);
            if !(is_config || is_program) || !matches!(Disk.kind(&path), Ok(FileKind::File { .. })) {
                continue;
            }
            let folder = folders.entry(path.parent().unwrap_or(Utf8Path::new("")).to_owned()).or_default();
            if is_config {
                folder.config = true;
            } else {
                folder.vendor |= path.file_name().map_or(FileRole::Any, FileRole::of) != FileRole::Any;
                folder.programs.push(path);
            }
        }
        folders
    }
}

fn problem(root: &Utf8Path, error: ignore::Error) -> LoadError {
    let path = match &error {
        ignore::Error::WithPath { path, .. } => Utf8Path::from_path(path).unwrap_or(root).to_owned(),
        _ => root.to_owned(),
    };
    let message = error.to_string();
    let source = error.into_io_error().unwrap_or_else(|| io::Error::other(message));
    LoadError::Unreadable { path, source }
}

fn has_config(folder: &Utf8Path) -> bool {
    Disk.kind(&folder.join(CONFIG_NAME)).is_ok()
}

/// The project that the program at `path` is part of: a path for [`super::load`]. Its folder and those above it are
/// searched for an `acrc.toml`; without one, a file named as the vendor's editor names it belongs to its folder. `None`
/// when it stands alone.
///
/// # Errors
/// The description that was found can't be loaded.
pub fn owner(files: &dyn Files, path: &Utf8Path) -> Result<Option<Utf8PathBuf>, LoadError> {
    let file = real(path);
    if let Some(config) = config_above(files, path, &file) {
        let project = super::load_from(files, &config)?;
        let is_part = project.files.iter().any(|other| real(&other.path) == file);
        return Ok(is_part.then_some(config));
    }
    let is_vendor = path.file_name().map_or(FileRole::Any, FileRole::of) != FileRole::Any;
    let folder = discover::here(path.parent().unwrap_or(Utf8Path::new("")));
    Ok(is_vendor.then(|| folder.to_owned()))
}

/// The nearest `acrc.toml` in the folder of a file or above it, written relative to where `path` starts.
fn config_above(files: &dyn Files, path: &Utf8Path, real: &Utf8Path) -> Option<Utf8PathBuf> {
    let exists = |config: &Utf8PathBuf| files.kind(config).is_ok();
    if path.is_absolute() || path.components().any(|part| part == Utf8Component::ParentDir) {
        return real.ancestors().skip(1).map(|folder| folder.join(CONFIG_NAME)).find(exists);
    }
    let below = path.ancestors().skip(1).map(|folder| folder.join(CONFIG_NAME)).find(exists);
    if below.is_some() {
        return below;
    }
    // Above the working directory.
    let working = Utf8Path::new(".").canonicalize_utf8().ok()?;
    let above = working.ancestors().zip(std::iter::successors(Some(Utf8PathBuf::new()), |up| Some(up.join(".."))));
    let mut configs = above.skip(1).filter(|(folder, _)| real.starts_with(folder));
    configs.find_map(|(_, up)| Some(up.join(CONFIG_NAME)).filter(exists))
}
