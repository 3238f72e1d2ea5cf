//! The database: where inputs and derived facts are kept.
//!
//! This crate is the only one that knows salsa. Other crates get facts through functions, and have their own work
//! remembered by passing a [`crate::Checker`].

use std::collections::BTreeMap;

use acrc_syntax::SourceText;
use salsa::{EventKind, Setter};

use crate::project::LoadedProject;
use crate::{FileRole, Project, SourceFile};

/// What the queries need of a database.
#[salsa::db]
pub trait Db: salsa::Database {}

/// Keeps inputs and what was derived from them. A clone is a snapshot for reading in another thread.
#[salsa::db]
#[derive(Clone)]
pub struct Database {
    storage: salsa::Storage<Self>,
}

#[salsa::db]
impl salsa::Database for Database {}

#[salsa::db]
impl Db for Database {}

impl Default for Database {
    fn default() -> Self {
        Self { storage: salsa::Storage::new(None) }
    }
}

impl Database {
    /// An empty database.
    pub fn new() -> Self {
        Self::default()
    }

    /// Replaces the text of a file. What depends on it is computed anew at the next question.
    pub fn edit(&mut self, file: SourceFile, text: String) {
        file.set_text(self).to(text);
        // What was found while the file was decoded is about bytes that are no longer these.
        if !file.encoding(self).is_empty() {
            file.set_encoding(self).to(Vec::new());
        }
    }

    /// Replaces a file by what was read from disk. Nothing is computed anew when it is as before.
    pub fn replace(&mut self, file: SourceFile, source: &SourceText) {
        if file.text(self) != source.text {
            file.set_text(self).to(source.text.clone());
        }
        let encoding = source.diagnostics();
        if *file.encoding(self) != encoding {
            file.set_encoding(self).to(encoding);
        }
    }

    /// Gives a file another name and the role that goes with it.
    pub fn rename(&mut self, file: SourceFile, name: String, role: FileRole) {
        if file.name(self) != name {
            file.set_name(self).to(name);
        }
        if file.role(self) != role {
            file.set_role(self).to(role);
        }
    }

    /// Replaces a project by what was read again. Files that it had before, by their names, stay what they are, and
    /// nothing is computed anew for what is as before.
    pub fn reload(&mut self, project: Project, loaded: &LoadedProject) {
        let before: BTreeMap<String, SourceFile> =
            project.files(self).iter().map(|file| (file.name(self).to_owned(), *file)).collect();
        let mut files = Vec::with_capacity(loaded.files.len());
        for file in &loaded.files {
            files.push(match before.get(file.path.as_str()) {
                Some(known) => {
                    self.replace(*known, &file.source);
                    self.rename(*known, file.path.to_string(), file.role);
                    *known
                }
                None => file.add_to(self),
            });
        }
        if project.files(self) != files {
            project.set_files(self).to(files);
        }
        if project.model(self) != loaded.model {
            project.set_model(self).to(loaded.model);
        }
        if *project.config(self) != loaded.config {
            project.set_config(self).to(loaded.config.clone());
        }
    }

    /// An empty database that tells `observer` about each query that is really computed, not taken from memory, by
    /// its name and argument, such as `parse(Id(0))`.
    pub fn observed(observer: impl Fn(&str) + Send + Sync + 'static) -> Self {
        let storage = salsa::Storage::new(Some(Box::new(move |event| {
            if let EventKind::WillExecute { database_key } = event.kind {
                observer(&format!("{database_key:?}"));
            }
        })));
        Self { storage }
    }
}
