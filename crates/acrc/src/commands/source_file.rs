//! Replacing the text of a source file.

use std::fs;
use std::path::Path;

use anyhow::{Context as _, bail};

use crate::output::write_file;

/// Replaces a file at once: it has the old bytes or the new ones, and keeps its permissions. A file that is read-only,
/// or that has no longer the bytes that were read, is left as it is.
pub(crate) fn replace(path: &Path, before: &[u8], after: &[u8]) -> anyhow::Result<()> {
    let refuse = || format!("cannot write {}", path.display());
    if fs::metadata(path).with_context(refuse)?.permissions().readonly() {
        bail!("{}: it is read-only", refuse());
    }
    if fs::read(path).with_context(refuse)? != before {
        bail!("{}: it was changed while it was looked at; nothing of that is touched", refuse());
    }
    write_file(path, after)
}
