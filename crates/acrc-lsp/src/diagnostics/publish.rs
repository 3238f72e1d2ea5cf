//! Telling the client what is found, without being asked: only what it does not know yet.

use std::collections::BTreeMap;
use std::sync::Arc;

use acrc_analysis::{Project, SourceFile};
use camino::{Utf8Path, Utf8PathBuf};
use parking_lot::Mutex;
use tower_lsp_server::jsonrpc::ErrorCode;
use tower_lsp_server::ls_types::{Diagnostic, Uri};

use super::of_file;
use crate::outgoing::Outgoing;
use crate::snapshot::Snapshot;
use crate::uri::uri_of;

/// What the client was told last.
#[derive(Clone)]
pub(crate) struct Publisher {
    outgoing: Outgoing,
    told: Arc<Mutex<BTreeMap<Utf8PathBuf, Told>>>,
}

/// What was told of a file.
#[derive(PartialEq)]
struct Told {
    /// Of the open document that it is about.
    version: Option<i32>,
    diagnostics: Vec<Diagnostic>,
}

/// Files to look at, in the order in which somebody waits for them.
pub(crate) struct Round {
    pub(crate) files: Vec<(Project, SourceFile)>,
}

impl Round {
    /// The file that was edited, then those that are open, then the rest.
    pub(crate) fn new(snapshot: &Snapshot, mut files: Vec<(Project, SourceFile)>, edited: Option<SourceFile>) -> Self {
        files.sort_by_cached_key(|(_, file)| (Some(*file) != edited, snapshot.document(*file).is_none()));
        Self { files }
    }
}

impl Publisher {
    pub(crate) fn new(outgoing: Outgoing) -> Self {
        Self { outgoing, told: Arc::default() }
    }

    /// Tells what is found. Whether it came to the end, which an edit can prevent.
    pub(crate) fn tell(&self, snapshot: &Snapshot, round: &Round) -> bool {
        round.files.iter().all(|(project, file)| {
            let look = |snapshot: &Snapshot| {
                self.tell_of(snapshot, *project, *file);
                Ok(())
            };
            // A check that fails in one file fails again, and says nothing of the others.
            snapshot.answer(look).err().is_none_or(|error| error.code != ErrorCode::ContentModified)
        })
    }

    fn tell_of(&self, snapshot: &Snapshot, project: Project, file: SourceFile) {
        let diagnostics = of_file(snapshot, project, file);
        let version = snapshot.document(file).map(|document| document.version);
        if let (Some(path), Some(uri)) = (snapshot.path(file), snapshot.uri(file)) {
            self.set(path, uri, Told { version, diagnostics });
        }
    }

    /// Tells what is wrong with a file that is no program.
    pub(crate) fn tell_trouble(&self, path: &Utf8Path, diagnostics: Vec<Diagnostic>) {
        if let Some(uri) = uri_of(path) {
            self.set(path, uri, Told { version: None, diagnostics });
        }
    }

    /// A file is gone, and what was found in it.
    pub(crate) fn forget(&self, path: &Utf8Path) {
        let told = self.told.lock().remove(path);
        if let Some(uri) = told.filter(|told| !told.diagnostics.is_empty()).and_then(|_| uri_of(path)) {
            self.outgoing.publish(uri, Vec::new(), None);
        }
    }

    fn set(&self, path: &Utf8Path, uri: Uri, new: Told) {
        let mut told = self.told.lock();
        let known = match told.get(path) {
            Some(known) => *known == new,
            // The client takes a file of which it was told nothing for one without findings, unless it waits for word.
            None => new.version.is_none() && new.diagnostics.is_empty(),
        };
        if !known {
            self.outgoing.publish(uri, new.diagnostics.clone(), new.version);
            told.insert(path.to_owned(), new);
        }
    }
}
