//! What a question is answered from: the database, the files and the open documents as they were when it was asked.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use acrc_analysis::{Database, Project, SourceFile, unless_cancelled};
use acrc_diagnostics::Span;
use acrc_ide::FilePosition;
use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashMap;
use tower_lsp_server::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp_server::ls_types::{Location, TextDocumentPositionParams, Uri};

use crate::abilities::Abilities;
use crate::lines::Lines;
use crate::scratch::Scratch;
use crate::settings::Settings;
use crate::uri::{path_of, uri_of};

/// A file of a project.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    pub(crate) project: Project,
    pub(crate) file: SourceFile,
}

/// The files of all projects.
#[derive(Clone, Default)]
pub(crate) struct FileTable {
    pub(crate) by_path: BTreeMap<Utf8PathBuf, Place>,
    pub(crate) paths: FxHashMap<SourceFile, Utf8PathBuf>,
    /// Where projects are: their folders, or their only files.
    pub(crate) keys: FxHashMap<Project, Utf8PathBuf>,
}

/// The documents that are open.
#[derive(Clone, Default)]
pub(crate) struct Documents {
    pub(crate) by_path: BTreeMap<Utf8PathBuf, Document>,
    /// The paths of the documents by their URIs as the client writes them.
    pub(crate) by_uri: FxHashMap<String, Utf8PathBuf>,
}

/// An open document; its text is in the database.
#[derive(Clone)]
pub(crate) struct Document {
    /// As the client writes it.
    pub(crate) uri: Uri,
    pub(crate) version: i32,
    pub(crate) lines: Arc<Lines>,
}

/// What a question is answered from.
pub(crate) struct Snapshot {
    pub(crate) db: Database,
    pub(crate) files: Arc<FileTable>,
    pub(crate) documents: Arc<Documents>,
    pub(crate) abilities: Abilities,
    pub(crate) settings: Arc<Settings>,
    pub(crate) scratch: Scratch,
    /// Texts of open `acrc.toml`s.
    pub(crate) configs: Arc<BTreeMap<Utf8PathBuf, String>>,
}

impl Snapshot {
    /// Answers a question. One whose answer an edit has overtaken, and one at which a feature fails, are answered with
    /// an error.
    pub(crate) fn answer<T>(&self, work: impl FnOnce(&Self) -> Result<T>) -> Result<T> {
        let questions = AssertUnwindSafe(|| unless_cancelled(|| work(self)));
        match catch_unwind(questions) {
            Ok(Ok(answer)) => answer,
            Ok(Err(_)) => Err(Error::content_modified()),
            Err(panic) => Err(Error {
                code: ErrorCode::InternalError,
                message: format!("this is a mistake of acrc: {}", reason(panic.as_ref())).into(),
                data: None,
            }),
        }
    }

    /// The file that a client means.
    pub(crate) fn place(&self, uri: &Uri) -> Option<Place> {
        let path = self.documents.by_uri.get(uri.as_str()).cloned().unwrap_or_else(|| path_of(uri));
        self.files.by_path.get(&path).copied()
    }

    /// The place that a client means, with the lines of its file.
    pub(crate) fn position(&self, at: &TextDocumentPositionParams) -> Option<(FilePosition, Arc<Lines>)> {
        let Place { project, file } = self.place(&at.text_document.uri)?;
        let lines = self.lines(file);
        Some((FilePosition { project, file, offset: lines.offset(at.position) }, lines))
    }

    /// The lines of a file.
    pub(crate) fn lines(&self, file: SourceFile) -> Arc<Lines> {
        let open = self.document(file).map(|document| Arc::clone(&document.lines));
        open.unwrap_or_else(|| Arc::new(Lines::new(file.text(&self.db), self.abilities.encoding)))
    }

    pub(crate) fn path(&self, file: SourceFile) -> Option<&Utf8Path> {
        self.files.paths.get(&file).map(Utf8PathBuf::as_path)
    }

    /// The open document of a file.
    pub(crate) fn document(&self, file: SourceFile) -> Option<&Document> {
        self.documents.by_path.get(self.path(file)?)
    }

    /// What the client calls a file.
    pub(crate) fn uri(&self, file: SourceFile) -> Option<Uri> {
        let open = self.document(file).map(|document| document.uri.clone());
        open.or_else(|| uri_of(self.path(file)?))
    }

    pub(crate) fn location(&self, file: SourceFile, span: Span) -> Option<Location> {
        Some(Location::new(self.uri(file)?, self.lines(file).range(span)))
    }
}

/// What a panic said.
pub(crate) fn reason(panic: &(dyn std::any::Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("a feature failed")
}
