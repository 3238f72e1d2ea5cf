//! Which file belongs to which project.

use std::collections::BTreeSet;
use std::sync::Arc;

use acrc_analysis::project::{self, CONFIG_NAME, Config, LoadError, LoadedProject, Overlay};
use acrc_analysis::{Database, FileRole, Project, SourceFile};
use camino::{Utf8Path, Utf8PathBuf};
use tower_lsp_server::ls_types::{Uri, WorkspaceFolder, WorkspaceFoldersChangeEvent};

use super::edit::is_config;
use super::{Entry, Workspace, real};
use crate::snapshot::Place;
use crate::uri::{is_on_disk, path_of};

/// What is wrong with the description of a project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Trouble {
    pub(crate) message: String,
    /// Line and column from 1, when the message names them.
    pub(crate) place: Option<(u32, u32)>,
    /// The project can't be used as it is.
    pub(crate) fatal: bool,
}

impl Workspace {
    pub(super) fn db(&self) -> &Database {
        &self.db
    }

    /// The project of a file of the session.
    pub(super) fn key_of_file(&self, path: &Utf8Path) -> Option<Utf8PathBuf> {
        let project = self.files.by_path.get(path)?.project;
        self.files.keys.get(&project).cloned()
    }

    pub(super) fn set_file_text(&mut self, file: SourceFile, text: String) {
        if file.text(&self.db) != text {
            self.db.edit(file, text);
        }
    }

    /// Finds the project of a file that belongs to none. `text` is that of the document, when it was just opened.
    pub(super) fn adopt(&mut self, path: &Utf8Path, text: Option<String>) {
        if is_on_disk(path) {
            let mut overlay = self.overlay();
            if let Some(text) = &text {
                overlay.insert(path, text.clone().into_bytes());
            }
            match project::owner(&overlay, path) {
                Ok(Some(owner)) => self.load_with(&overlay, key(&owner)),
                Ok(None) => {}
                Err(error) => self.blame(path, &error),
            }
        }
        match (self.files.by_path.get(path).copied(), text) {
            (Some(place), Some(text)) => {
                self.changes.edited = Some(place.file);
                self.set_file_text(place.file, text);
            }
            (None, text) => self.add_alone(path, text),
            (Some(_), None) => {}
        }
    }

    /// Loads a project that a search found, unless it is there.
    pub(crate) fn load(&mut self, found: &Utf8Path) {
        let key = key(found);
        if !self.projects.contains_key(key) && !self.files.by_path.contains_key(key) {
            let overlay = self.overlay();
            self.load_with(&overlay, key);
        }
    }

    /// The client saw a file on disk change.
    pub(crate) fn disk_changed(&mut self, uri: &Uri) {
        let path = real(&path_of(uri));
        if !self.configs.contains_key(&path) {
            self.read_again(&path);
        }
    }

    /// Takes over the folders of the client, and returns those that are new.
    pub(crate) fn change_folders(&mut self, event: &WorkspaceFoldersChangeEvent) -> Vec<Utf8PathBuf> {
        let path = |folder: &WorkspaceFolder| real(&path_of(&folder.uri));
        let removed: Vec<Utf8PathBuf> = event.removed.iter().map(path).collect();
        self.roots.retain(|root| !removed.contains(root));
        let added: Vec<Utf8PathBuf> = event.added.iter().map(path).collect();
        self.roots.extend(added.iter().cloned());
        let is_outside = |key: &Utf8PathBuf| {
            removed.iter().any(|root| key.starts_with(root)) && !self.roots.iter().any(|root| key.starts_with(root))
        };
        let keys: Vec<_> = self.projects.keys().filter(|key| is_outside(key)).cloned().collect();
        for key in keys {
            let is_open = |(path, _): &(Utf8PathBuf, SourceFile)| self.documents.by_path.contains_key(path);
            if !self.projects.get(&key).is_some_and(|entry| entry.files.iter().any(is_open)) {
                self.remove(&key);
            }
        }
        added
    }

    /// Something happened to a file on disk, or to the text of an `acrc.toml`.
    pub(crate) fn read_again(&mut self, path: &Utf8Path) {
        if let Some(place) = self.files.by_path.get(path).copied().filter(|_| !is_config(path)) {
            let is_open = self.documents.by_path.contains_key(path);
            let on_disk = project::load(path).ok().and_then(|loaded| loaded.files.into_iter().next());
            match on_disk {
                Some(file) if !is_open => {
                    self.db.replace(place.file, &file.source);
                    self.changes.projects.extend(self.key_of_file(path));
                    // A file outside of the folders is of interest only while it is open.
                    if self.is_alone(path) && !self.roots.iter().any(|root| path.starts_with(root)) {
                        self.remove(path);
                    }
                    return;
                }
                Some(_) => return,
                None if self.is_alone(path) && !is_open => {
                    self.remove(path);
                    return;
                }
                None => {}
            }
        }
        self.load_around(path);
    }

    /// Loads the projects again to which a file may belong or which it describes.
    pub(super) fn load_around(&mut self, path: &Utf8Path) {
        let overlay = self.overlay();
        let mut keys: BTreeSet<Utf8PathBuf> =
            path.ancestors().filter(|folder| self.projects.contains_key(*folder)).map(Utf8Path::to_owned).collect();
        if is_config(path) {
            keys.extend(path.parent().map(Utf8Path::to_owned));
        } else if !self.files.by_path.contains_key(path) {
            let owner = project::owner(&overlay, path).ok().flatten();
            keys.extend(owner.as_deref().map(|owner| key(owner).to_owned()));
        }
        for key in keys {
            self.load_with(&overlay, &key);
        }
        self.adopt_open();
    }

    /// Gives every open document a project.
    fn adopt_open(&mut self) {
        let open = self.documents.by_path.keys();
        let strays: Vec<_> =
            open.filter(|path| !is_config(path) && !self.files.by_path.contains_key(*path)).cloned().collect();
        for path in strays {
            self.adopt(&path, None);
        }
    }

    fn load_with(&mut self, overlay: &Overlay, key: &Utf8Path) {
        let config = key.join(CONFIG_NAME);
        match project::load_from(overlay, key) {
            Ok(loaded) => {
                let problems = acrc_lint::problems(&loaded.config.lint);
                let trouble =
                    (!problems.is_empty()).then(|| Trouble { message: problems.join("\n"), place: None, fatal: false });
                self.changes.troubles.push((config, trouble));
                self.put(key, loaded);
            }
            Err(LoadError::Missing { .. } | LoadError::NoPrograms { .. }) => {
                self.changes.troubles.push((config, None));
                self.remove(key);
            }
            Err(error) => self.blame(&config, &error),
        }
    }

    fn blame(&mut self, path: &Utf8Path, error: &LoadError) {
        let message = error.to_string();
        let place = place_in(&message);
        let describes = path.ancestors().map(|folder| folder.join(CONFIG_NAME)).find(|config| config.exists());
        let path = describes.unwrap_or_else(|| path.to_owned());
        self.changes.troubles.push((path, Some(Trouble { message, place, fatal: true })));
    }

    /// Takes a project as it was loaded.
    fn put(&mut self, key: &Utf8Path, mut loaded: LoadedProject) {
        let root = loaded.root.clone();
        let paths: Vec<Utf8PathBuf> = loaded.files.iter().map(|file| file.path.clone()).collect();
        // Messages name files as seen from the project.
        for file in &mut loaded.files {
            if let Ok(name) = file.path.strip_prefix(&root) {
                file.path = name.to_owned();
            }
        }
        loaded.config.lint.root = Utf8PathBuf::new();
        for path in &paths {
            if self.is_alone(path) && path != key {
                self.remove(path);
            }
        }
        let before = self.projects.get(key).cloned();
        let project = match &before {
            Some(entry) => {
                self.db.reload(entry.project, &loaded);
                entry.project
            }
            None => loaded.add_to(&self.db),
        };
        let files: Vec<_> = paths.into_iter().zip(project.files(&self.db).iter().copied()).collect();
        self.forget(before.as_ref());
        let alone = files.len() == 1 && files.first().is_some_and(|(path, _)| path == key);
        self.remember(key, Entry { project, files, alone });
        let gone = before.into_iter().flat_map(|entry| entry.files).map(|(path, _)| path);
        let gone: Vec<_> = gone.filter(|path| !self.files.by_path.contains_key(path)).collect();
        self.changes.gone.extend(gone);
    }

    /// Makes a file a project by itself. Its text is that on disk unless it is given.
    fn add_alone(&mut self, path: &Utf8Path, text: Option<String>) {
        let on_disk = || project::load(path).ok()?.files.into_iter().next().map(|file| file.source.text);
        let text = text.or_else(on_disk).unwrap_or_default();
        let name = path.file_name().unwrap_or(path.as_str()).to_owned();
        let role = FileRole::of(&name);
        let (project, file) = self.spare_project();
        self.db.rename(file, name, role);
        self.set_file_text(file, text);
        self.changes.edited = Some(file);
        self.remember(path, Entry { project, files: vec![(path.to_owned(), file)], alone: true });
    }

    fn spare_project(&mut self) -> (Project, SourceFile) {
        self.spare.pop().unwrap_or_else(|| {
            let file = SourceFile::new(&self.db, String::new(), String::new(), FileRole::Any, Vec::new());
            let model = acrc_catalog::default_model();
            (Project::new(&self.db, vec![file], model, Config::default()), file)
        })
    }

    fn is_alone(&self, path: &Utf8Path) -> bool {
        self.projects.get(path).is_some_and(|entry| entry.alone)
    }

    /// Removes a project. Its open documents are without one until they are adopted.
    pub(super) fn remove(&mut self, key: &Utf8Path) {
        let Some(entry) = self.projects.remove(key) else { return };
        self.forget(Some(&entry));
        self.changes.projects.remove(key);
        if entry.alone
            && let [(_, file)] = *entry.files.as_slice()
        {
            self.db.edit(file, String::new());
            self.spare.push((entry.project, file));
        }
        self.changes.gone.extend(entry.files.into_iter().map(|(path, _)| path));
    }

    fn remember(&mut self, key: &Utf8Path, entry: Entry) {
        let files = Arc::make_mut(&mut self.files);
        for (path, file) in &entry.files {
            files.by_path.insert(path.clone(), Place { project: entry.project, file: *file });
            files.paths.insert(*file, path.clone());
        }
        files.keys.insert(entry.project, key.to_owned());
        self.changes.gone.retain(|path| !files.by_path.contains_key(path));
        self.changes.projects.insert(key.to_owned());
        self.projects.insert(key.to_owned(), entry);
    }

    fn forget(&mut self, entry: Option<&Entry>) {
        let files = Arc::make_mut(&mut self.files);
        if let Some(entry) = entry {
            files.keys.remove(&entry.project);
        }
        for (path, file) in entry.iter().flat_map(|entry| &entry.files) {
            files.by_path.remove(path);
            files.paths.remove(file);
        }
    }

    /// The disk with the open documents over it.
    fn overlay(&self) -> Overlay {
        let mut overlay = Overlay::default();
        for path in self.documents.by_path.keys().filter(|path| is_on_disk(path)) {
            let text = match self.files.by_path.get(path) {
                Some(place) => place.file.text(&self.db),
                None => match self.configs.get(path) {
                    Some(text) => text,
                    None => continue,
                },
            };
            overlay.insert(path, text.as_bytes().to_vec());
        }
        overlay
    }
}

/// The folder of a project, or the path of a file that is one.
fn key(project: &Utf8Path) -> &Utf8Path {
    if is_config(project) { project.parent().unwrap_or(project) } else { project }
}

/// The place that the message of a reader of TOML names.
fn place_in(message: &str) -> Option<(u32, u32)> {
    let number = |after: &str| {
        let (_, rest) = message.split_once(after)?;
        let digits = rest.split(|c: char| !c.is_ascii_digit()).next()?;
        digits.parse::<u32>().ok()
    };
    Some((number("line ")?, number("column ")?))
}
