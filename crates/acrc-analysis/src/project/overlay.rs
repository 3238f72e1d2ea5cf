//! The file system with one file replaced by a text that is not saved, as an editor has it.

use std::io;

use camino::{Utf8Path, Utf8PathBuf};

use super::{Disk, FileKind, Files};

/// The disk, but for one file. The file need not be there, nor its folder.
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

    /// A folder that is not there yet, in which the file is going to be saved.
    fn will_lie_in(&self, folder: &Utf8Path, error: &io::Error) -> bool {
        error.kind() == io::ErrorKind::NotFound && self.real.starts_with(real(folder))
    }
}

impl Files for Overlay {
    fn kind(&self, path: &Utf8Path) -> io::Result<FileKind> {
        if self.covers(path) {
            return Ok(FileKind::File { len: self.bytes.len() as u64 });
        }
        match Disk.kind(path) {
            Err(error) if self.will_lie_in(path, &error) => Ok(FileKind::Directory),
            result => result,
        }
    }

    fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        if self.covers(path) { Ok(self.bytes.clone()) } else { Disk.read(path) }
    }

    fn list(&self, directory: &Utf8Path) -> io::Result<Vec<String>> {
        let mut names = match Disk.list(directory) {
            Err(error) if self.will_lie_in(directory, &error) => Vec::new(),
            result => result?,
        };
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

/// The path without links, as far as it is there.
pub(super) fn real(path: &Utf8Path) -> Utf8PathBuf {
    path.canonicalize_utf8().unwrap_or_else(|_| match (path.parent(), path.file_name()) {
        (Some(folder), Some(name)) => real(super::discover::here(folder)).join(name),
        _ => path.to_owned(),
    })
}
