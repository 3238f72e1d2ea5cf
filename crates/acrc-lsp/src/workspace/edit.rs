//! Documents: opened, edited, closed.

use std::sync::Arc;

use acrc_analysis::project::CONFIG_NAME;
use camino::Utf8Path;
use tower_lsp_server::ls_types::{
    TextDocumentContentChangeEvent, TextDocumentItem, Uri, VersionedTextDocumentIdentifier,
};

use super::Workspace;
use crate::lines::Lines;
use crate::snapshot::Document;

/// Why an edit was not made. The text stays as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Refused {
    /// The document is not open.
    NotOpen,
    /// A range ends before it begins.
    Range,
}

impl Workspace {
    pub(crate) fn open(&mut self, item: TextDocumentItem) {
        let path = self.key_of(&item.uri);
        let lines = Arc::new(Lines::new(&item.text, self.abilities.encoding));
        let documents = Arc::make_mut(&mut self.documents);
        documents.by_uri.insert(item.uri.as_str().to_owned(), path.clone());
        documents.by_path.insert(path.clone(), Document { uri: item.uri, version: item.version, lines });
        if is_config(&path) {
            Arc::make_mut(&mut self.configs).insert(path.clone(), item.text);
            self.load_around(&path);
            return;
        }
        match self.files.by_path.get(&path) {
            Some(place) => self.set_text(place.file, &path, item.text),
            None => self.adopt(&path, Some(item.text)),
        }
    }

    pub(crate) fn change(
        &mut self,
        document: &VersionedTextDocumentIdentifier,
        changes: Vec<TextDocumentContentChangeEvent>,
    ) -> Result<(), Refused> {
        let path = self.key_of(&document.uri);
        let open = self.documents.by_path.get(&path).ok_or(Refused::NotOpen)?;
        let lines = Arc::clone(&open.lines);
        let file = self.files.by_path.get(&path).map(|place| place.file);
        let text = match file {
            Some(file) => file.text(self.db()).to_owned(),
            None => self.configs.get(&path).cloned().ok_or(Refused::NotOpen)?,
        };
        let (text, lines) = apply(text, lines, changes)?;
        if let Some(open) = Arc::make_mut(&mut self.documents).by_path.get_mut(&path) {
            open.version = document.version;
            open.lines = lines;
        }
        match file {
            Some(file) => self.set_text(file, &path, text),
            None => {
                Arc::make_mut(&mut self.configs).insert(path.clone(), text);
                self.load_around(&path);
            }
        }
        Ok(())
    }

    pub(crate) fn close(&mut self, uri: &Uri) {
        let path = self.key_of(uri);
        let documents = Arc::make_mut(&mut self.documents);
        documents.by_uri.remove(uri.as_str());
        if documents.by_path.remove(&path).is_none() {
            return;
        }
        Arc::make_mut(&mut self.configs).remove(&path);
        // What was not saved is gone, and a file that was never saved with it.
        self.read_again(&path);
    }

    fn set_text(&mut self, file: acrc_analysis::SourceFile, path: &Utf8Path, text: String) {
        let project = self.key_of_file(path);
        self.changes.projects.extend(project);
        self.changes.edited = Some(file);
        self.set_file_text(file, text);
    }
}

/// Whether a file describes a project.
pub(super) fn is_config(path: &Utf8Path) -> bool {
    path.file_name() == Some(CONFIG_NAME)
}

/// Applies changes one after the other, each to what the one before left.
fn apply(
    mut text: String,
    mut lines: Arc<Lines>,
    changes: Vec<TextDocumentContentChangeEvent>,
) -> Result<(String, Arc<Lines>), Refused> {
    for change in changes {
        let Some(range) = change.range else {
            text = change.text;
            lines = Arc::new(Lines::new(&text, lines.encoding()));
            continue;
        };
        let span = lines.span(range).ok_or(Refused::Range)?;
        // The lines are those of the text, so the span lies between characters.
        text.get(span.range()).ok_or(Refused::Range)?;
        text.replace_range(span.range(), &change.text);
        Arc::make_mut(&mut lines).edit(&text, span, change.text.len() as u32);
    }
    Ok((text, lines))
}
