//! The projects and documents of a session, and the database that holds their texts.

mod edit;
mod load;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use acrc_analysis::{Database, Project, SourceFile};
use camino::{Utf8Path, Utf8PathBuf};
use tower_lsp_server::ls_types::Uri;

use crate::abilities::Abilities;
use crate::scratch::Scratch;
use crate::settings::Settings;
use crate::snapshot::{Documents, FileTable, Snapshot};
use crate::uri::{is_on_disk, path_of};

pub(crate) use edit::Refused;
pub(crate) use load::Trouble;

/// Everything that the writer owns.
#[derive(Default)]
pub(crate) struct Workspace {
    db: Database,
    pub(crate) abilities: Abilities,
    pub(crate) settings: Arc<Settings>,
    pub(crate) scratch: Scratch,
    /// Folders of the client.
    pub(crate) roots: Vec<Utf8PathBuf>,
    /// By the folder of a project, or by the path of a file that is a project by itself.
    projects: BTreeMap<Utf8PathBuf, Entry>,
    files: Arc<FileTable>,
    documents: Arc<Documents>,
    /// Texts of open `acrc.toml`s.
    configs: Arc<BTreeMap<Utf8PathBuf, String>>,
    /// Projects of one file that are no longer there; the database can't forget them, so they are used again.
    spare: Vec<(Project, SourceFile)>,
    /// What changed since it was last asked.
    changes: Changes,
}

/// A project of the session.
#[derive(Clone, Debug)]
struct Entry {
    project: Project,
    files: Vec<(Utf8PathBuf, SourceFile)>,
    /// It is one file that no project is about.
    alone: bool,
}

/// What has to be told to the client.
#[derive(Default)]
pub(crate) struct Changes {
    /// Projects whose findings may be others now.
    pub(crate) projects: BTreeSet<Utf8PathBuf>,
    /// The file that was edited last.
    pub(crate) edited: Option<SourceFile>,
    /// Files that are gone.
    pub(crate) gone: Vec<Utf8PathBuf>,
    /// Files that describe projects, with what is wrong with them; `None` when nothing is any more.
    pub(crate) troubles: Vec<(Utf8PathBuf, Option<Trouble>)>,
}

impl Workspace {
    /// Nothing yet; files that are made for the client go to `scratch`.
    pub(crate) fn new(scratch: Scratch) -> Self {
        Self { scratch, ..Self::default() }
    }

    /// What questions are answered from now.
    pub(crate) fn snapshot(&self) -> Snapshot {
        Snapshot {
            db: self.db.clone(),
            files: Arc::clone(&self.files),
            documents: Arc::clone(&self.documents),
            abilities: self.abilities,
            settings: Arc::clone(&self.settings),
            scratch: self.scratch.clone(),
            configs: Arc::clone(&self.configs),
        }
    }

    /// What changed since the last call.
    pub(crate) fn take_changes(&mut self) -> Changes {
        std::mem::take(&mut self.changes)
    }

    /// The files of a project.
    pub(crate) fn project_files(&self, key: &Utf8Path) -> Option<(Project, Vec<SourceFile>)> {
        let entry = self.projects.get(key)?;
        Some((entry.project, entry.files.iter().map(|(_, file)| *file).collect()))
    }

    /// All projects have to be looked at again.
    pub(crate) fn touch_all(&mut self) {
        self.changes.projects.extend(self.projects.keys().cloned());
    }

    /// What a document is known by: its path without links, as far as it is there.
    fn key_of(&self, uri: &Uri) -> Utf8PathBuf {
        self.documents.by_uri.get(uri.as_str()).cloned().unwrap_or_else(|| real(&path_of(uri)))
    }
}

/// The path without links, as far as it is there.
pub(crate) fn real(path: &Utf8Path) -> Utf8PathBuf {
    if !is_on_disk(path) {
        return path.to_owned();
    }
    path.canonicalize_utf8().unwrap_or_else(|_| match (path.parent(), path.file_name()) {
        (Some(folder), Some(name)) => real(folder).join(name),
        _ => path.to_owned(),
    })
}
