//! The database: where inputs and derived facts are kept.
//!
//! This crate is the only one that knows salsa. Other crates get facts through functions, and have their own work
//! remembered by passing a [`crate::Checker`].

use acrc_syntax::SourceText;
use salsa::{EventKind, Setter};

use crate::SourceFile;

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
