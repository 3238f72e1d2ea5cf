//! Which files belong to a project, and in which order they are sent: setup, programs, PLC programs, the rest by name.

use std::collections::{BTreeMap, BTreeSet};

use camino::{Utf8Path, Utf8PathBuf};

use super::{FileKind, Files, LoadError};
use crate::FileRole;
use crate::role::is_program_extension;

/// Where the sources of a project with an `acrc.toml` are looked for besides its own directory.
const SOURCE_DIRECTORY: &str = "src";

/// The programs in `directory`; its subdirectories are not searched.
pub(super) fn in_directory(files: &dyn Files, directory: &Utf8Path) -> Result<Vec<Utf8PathBuf>, LoadError> {
    let found = programs(files, directory)?;
    if found.is_empty() {
        return Err(LoadError::NoPrograms { directory: directory.to_owned() });
    }
    Ok(in_order(found))
}

/// The programs next to the description `config` in `root` and in `src/`.
pub(super) fn beside_config(
    files: &dyn Files,
    config: &Utf8Path,
    root: &Utf8Path,
) -> Result<Vec<Utf8PathBuf>, LoadError> {
    let source = root.join(SOURCE_DIRECTORY);
    let mut found = programs(files, here(root))?;
    if matches!(files.kind(&source), Ok(FileKind::Directory)) {
        found.extend(programs(files, &source)?);
    }
    if found.is_empty() {
        return Err(LoadError::NoProgramsBeside { config: config.to_owned() });
    }
    Ok(in_order(found))
}

/// The files that an `acrc.toml` lists, in its order. Every one must exist and lie below `root`.
pub(super) fn listed(
    files: &dyn Files,
    config: &Utf8Path,
    root: &Utf8Path,
    listed: &[Utf8PathBuf],
) -> Result<Vec<Utf8PathBuf>, LoadError> {
    if listed.is_empty() {
        return Err(LoadError::NothingListed { config: config.to_owned() });
    }
    let canonical = |path: &Utf8Path| files.canonical(path).map_err(|source| super::io_error(path, source));
    let inside = canonical(here(root))?;
    let mut seen = BTreeSet::new();
    let mut check = |file: &Utf8PathBuf| {
        let path = root.join(file);
        let (config, file) = (config.to_owned(), file.clone());
        match canonical(&path) {
            Ok(real) if !real.starts_with(&inside) => Err(LoadError::OutsideProject { config, file }),
            Ok(_) if matches!(files.kind(&path), Ok(FileKind::Directory)) => {
                Err(LoadError::FolderListed { config, file })
            }
            Ok(real) => seen.insert(real).then_some(path).ok_or(LoadError::ListedTwice { config, file }),
            Err(LoadError::Missing { .. }) => Err(LoadError::ListedFileMissing { config, file }),
            Err(error) => Err(error),
        }
    };
    listed.iter().map(&mut check).collect()
}

/// Gives each file its role; a program or setup that is there twice is an error.
pub(super) fn with_roles(paths: Vec<Utf8PathBuf>) -> Result<Vec<(FileRole, Utf8PathBuf)>, LoadError> {
    let mut taken: BTreeMap<FileRole, Utf8PathBuf> = BTreeMap::new();
    let mut files = Vec::with_capacity(paths.len());
    for path in paths {
        let role = path.file_name().map_or(FileRole::Any, FileRole::of);
        if role != FileRole::Any
            && let Some(first) = taken.insert(role, path.clone())
        {
            return Err(LoadError::TwoFiles { role, first, second: path });
        }
        files.push((role, path));
    }
    Ok(files)
}

pub(super) fn programs(files: &dyn Files, directory: &Utf8Path) -> Result<Vec<Utf8PathBuf>, LoadError> {
    let names = files.list(directory).map_err(|source| super::io_error(directory, source))?;
    let is_program = |path: &Utf8PathBuf| {
        path.extension().is_some_and(is_program_extension) && !matches!(files.kind(path), Ok(FileKind::Directory))
    };
    let place = |name: String| if directory == "." { Utf8PathBuf::from(name) } else { directory.join(name) };
    Ok(names.into_iter().map(place).filter(is_program).collect())
}

fn in_order(mut paths: Vec<Utf8PathBuf>) -> Vec<Utf8PathBuf> {
    paths.sort_by_cached_key(|path| (path.file_name().map_or(FileRole::Any, FileRole::of), path.clone()));
    paths
}

/// The empty path means the working directory, which file systems want to be named.
pub(super) fn here(root: &Utf8Path) -> &Utf8Path {
    if root.as_str().is_empty() { Utf8Path::new(".") } else { root }
}
