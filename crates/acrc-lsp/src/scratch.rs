//! Files that a session makes for the client to open: pages of rules, pages of dry runs. They go with the session.

use std::fs;
use std::io;
use std::path::Path;
use std::sync::{Arc, OnceLock};

use parking_lot::Mutex;
use rustc_hash::FxHashMap;
use tempfile::TempDir;
use tower_lsp_server::ls_types::Uri;

/// The folder of a session, made when it is needed.
#[derive(Clone, Default)]
pub(crate) struct Scratch(Arc<Inner>);

#[derive(Default)]
struct Inner {
    folder: OnceLock<TempDir>,
    /// The pages of rules by their codes.
    pages: Mutex<FxHashMap<&'static str, Option<Uri>>>,
}

impl Scratch {
    /// The folder.
    pub(crate) fn folder(&self) -> io::Result<&Path> {
        if let Some(folder) = self.0.folder.get() {
            return Ok(folder.path());
        }
        let folder = tempfile::Builder::new().prefix("acrc-lsp-").tempdir()?;
        // Of two threads one makes the folder that stays.
        Ok(self.0.folder.get_or_init(|| folder).path())
    }

    /// The page of a rule, by its code: what `acrc explain` says of it. `None` when there is none, or no place for it.
    pub(crate) fn rule_page(&self, code: &'static str) -> Option<Uri> {
        self.0.pages.lock().entry(code).or_insert_with(|| self.write_page(code)).clone()
    }

    fn write_page(&self, code: &str) -> Option<Uri> {
        let rule = acrc_lint::explain(code)?;
        let path = self.folder().ok()?.join(format!("{code}-{}.txt", rule.code.name));
        fs::write(&path, rule.render()).ok()?;
        Uri::from_file_path(path)
    }
}
