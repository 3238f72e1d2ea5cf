//! Which projects the paths of the command line stand for, and which of their files are shown.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use acrc_analysis::project::{self, CONFIG_NAME, Disk, FileGlobs, FileKind, Files, LoadedProject};
use camino::{Utf8Path, Utf8PathBuf};

use super::project::utf8;

/// A project to check.
#[derive(Debug)]
pub(crate) struct Target {
    /// For [`project::load`].
    pub(crate) path: Utf8PathBuf,
    /// The files that are shown, without links; all of them when absent.
    only: Option<BTreeSet<PathBuf>>,
    /// Programs around its `acrc.toml`; some may be no part of it.
    around: Vec<Utf8PathBuf>,
}

impl Target {
    /// The whole project at a path.
    pub(crate) fn whole(path: Utf8PathBuf) -> Self {
        Self { path, only: None, around: Vec::new() }
    }

    /// A single file of the project at a path.
    pub(crate) fn file(path: Utf8PathBuf, file: &Utf8Path) -> Self {
        Self { path, only: Some(BTreeSet::from([real(file.as_std_path())])), around: Vec::new() }
    }

    /// Programs around its `acrc.toml` that are no part of the project.
    pub(crate) fn strangers(&self, project: &LoadedProject) -> Vec<Utf8PathBuf> {
        project.strangers(&self.around)
    }

    /// Which files of the project are meant, in their order.
    pub(crate) fn meant(&self, project: &LoadedProject) -> Vec<bool> {
        let is_meant = |path: &Utf8Path| self.only.as_ref().is_none_or(|only| only.contains(&real(path.as_std_path())));
        project.files.iter().map(|file| is_meant(&file.path)).collect()
    }

    /// Two ways to write the same project have the same key.
    fn key(&self) -> PathBuf {
        let config = self.path.join(CONFIG_NAME);
        if config.is_file() { real(config.as_std_path()) } else { real(self.path.as_std_path()) }
    }
}

/// The targets of some paths, each project once, and what could not be looked at.
pub(crate) fn find(paths: &[PathBuf]) -> (Vec<Target>, Vec<anyhow::Error>) {
    let mut targets: Vec<Target> = Vec::new();
    let mut keys: Vec<PathBuf> = Vec::new();
    let mut problems = Vec::new();
    for path in paths {
        for mut target in of_path(path, &mut problems) {
            let key = target.key();
            let known = keys.iter().position(|other| *other == key).and_then(|place| targets.get_mut(place));
            match (known, target.only) {
                (Some(Target { only: Some(known), .. }), Some(more)) => known.extend(more),
                (Some(known), None) => {
                    known.only = None;
                    known.around.append(&mut target.around);
                }
                (Some(_), Some(_)) => {}
                (None, only) => {
                    keys.push(key);
                    targets.push(Target { path: target.path, only, around: target.around });
                }
            }
        }
    }
    (targets, problems)
}

fn of_path(path: &Path, problems: &mut Vec<anyhow::Error>) -> Vec<Target> {
    let path = match utf8(path) {
        Ok(path) => path,
        Err(error) => {
            problems.push(error);
            return Vec::new();
        }
    };
    let is_program = path.file_name() != Some(CONFIG_NAME);
    if is_program && matches!(Disk.kind(path), Ok(FileKind::File { .. })) {
        return match project::owner(&Disk, path) {
            Ok(Some(owner)) => vec![Target::file(owner, path)],
            Ok(None) => vec![Target::whole(path.to_owned())],
            Err(error) => {
                problems.push(error.into());
                Vec::new()
            }
        };
    }
    let search = project::search(path);
    problems.extend(search.problems.into_iter().map(anyhow::Error::from));
    let mut around = search.around;
    let target = |path| Target { around: around.remove(&path).unwrap_or_default(), ..Target::whole(path) };
    search.projects.into_iter().map(target).collect()
}

/// What is said of programs that lie around an `acrc.toml` and are no part of the project. Those that a pattern of
/// `exclude` means are passed over on purpose.
pub(crate) fn note_of_strangers(
    strangers: &[Utf8PathBuf],
    exclude: &FileGlobs,
    project: &LoadedProject,
) -> Option<String> {
    let lint = &project.config.lint;
    let mut open = strangers.iter().filter(|path| exclude.matching(lint.relative(path.as_str())).is_empty());
    let first = display(open.next()?);
    let config = project.root.join(CONFIG_NAME);
    Some(match open.count() + 1 {
        1 => format!(
            "1 program below `{config}` is no part of a project and is passed over, {first}: list it in `files`, name it, or `exclude` it"
        ),
        count => format!(
            "{count} programs below `{config}` are no part of a project and are passed over, {first} first: list them in `files`, name them, or `exclude` them"
        ),
    })
}

/// The path without links, as far as it exists.
pub(crate) fn real(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| {
        let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        match (parent.canonicalize(), path.file_name()) {
            (Ok(parent), Some(name)) => parent.join(name),
            _ => path.to_owned(),
        }
    })
}

/// A path as people write it from the working directory.
pub(crate) fn display(path: &Utf8Path) -> String {
    let plain = path.strip_prefix(".").unwrap_or(path);
    if !plain.starts_with("..") {
        return plain.to_string();
    }
    let working = Path::new(".").canonicalize().unwrap_or_default();
    let near = real(path.as_std_path()).strip_prefix(working).ok().and_then(|near| near.to_str().map(str::to_owned));
    near.unwrap_or_else(|| path.to_string())
}
