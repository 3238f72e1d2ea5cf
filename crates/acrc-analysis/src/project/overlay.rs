//! The file system with one file replaced by a text that is not saved, as an editor has it.

use std::io;

use camino::{Utf8Path, Utf8PathBuf};

use super::{Disk, FileKind, Files};

/// The disk, but for one file. The file need not be there.
#[derive(Clone, Debug)]
pub struct Overlay {
    /// Without links, as far as the folders exist.
    real: Utf8PathBuf,
    bytes: Vec<u8>,
}

impl Overlay {
    /// Lets the file at `path` have these bytes.
    pub fn new(path: &Utf8Path, bytes: Vec<u8>) -> Self {
        Self { real: real(path), bytes }
    }

    fn covers(&self, path: &Utf8Path) -> bool {
        path.file_name() == self.real.file_name() && real(path) == self.real
    }
}

impl Files for Overlay {
    fn kind(&self, path: &Utf8Path) -> io::Result<FileKind> {
        if self.covers(path) { Ok(FileKind::File { len: self.bytes.len() as u64 }) } else { Disk.kind(path) }
    }

    fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        if self.covers(path) { Ok(self.bytes.clone()) } else { Disk.read(path) }
    }

    fn list(&self, directory: &Utf8Path) -> io::Result<Vec<String>> {
        let mut names = Disk.list(directory)?;
        if let Some(name) = self.real.file_name()
            && self.covers(&directory.join(name))
            && names.iter().all(|other| other != name)
        {
            names.push(name.to_owned());
        }
        Ok(names)
    }

    fn canonical(&self, path: &Utf8Path) -> io::Result<Utf8PathBuf> {
        if self.covers(path) { Ok(self.real.clone()) } else { Disk.canonical(path) }
    }
}

/// The path without links. Of a file that is not there, that of its folder and its name.
pub(super) fn real(path: &Utf8Path) -> Utf8PathBuf {
    path.canonicalize_utf8().unwrap_or_else(|_| {
        let folder = super::discover::here(path.parent().unwrap_or(Utf8Path::new("")));
        match (folder.canonicalize_utf8(), path.file_name()) {
            (Ok(folder), Some(name)) => folder.join(name),
            _ => path.to_owned(),
        }
    })
}
