//! The file system with some files replaced by texts that are not saved, as an editor has them.

use std::collections::BTreeMap;
use std::io;

use camino::{Utf8Path, Utf8PathBuf};

use super::{Disk, FileKind, Files};

/// The disk, but for some files. They need not be there, nor their folders.
#[derive(Clone, Debug, Default)]
pub struct Overlay {
    /// By their paths without links, as far as the folders exist.
    files: BTreeMap<Utf8PathBuf, Vec<u8>>,
}

impl Overlay {
    /// Lets the file at `path` have these bytes.
    pub fn new(path: &Utf8Path, bytes: Vec<u8>) -> Self {
        let mut overlay = Self::default();
        overlay.insert(path, bytes);
        overlay
    }

    /// Lets one more file have bytes of its own.
    pub fn insert(&mut self, path: &Utf8Path, bytes: Vec<u8>) {
        self.files.insert(real(path), bytes);
    }

    /// What a path leads to, when it is one of the files.
    fn find(&self, path: &Utf8Path) -> Option<(&Utf8PathBuf, &Vec<u8>)> {
        // Looking for links asks the disk.
        let is_likely = self.files.keys().any(|file| file.file_name() == path.file_name());
        if is_likely { self.files.get_key_value(&real(path)) } else { None }
    }

    /// A folder that is not there yet, in which a file is going to be saved.
    fn will_lie_in(&self, folder: &Utf8Path, error: &io::Error) -> bool {
        error.kind() == io::ErrorKind::NotFound && {
            let folder = real(folder);
            self.files.keys().any(|file| file.starts_with(&folder))
        }
    }
}

impl Files for Overlay {
    fn kind(&self, path: &Utf8Path) -> io::Result<FileKind> {
        if let Some((_, bytes)) = self.find(path) {
            return Ok(FileKind::File { len: bytes.len() as u64 });
        }
        match Disk.kind(path) {
            Err(error) if self.will_lie_in(path, &error) => Ok(FileKind::Directory),
            result => result,
        }
    }

    fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        self.find(path).map_or_else(|| Disk.read(path), |(_, bytes)| Ok(bytes.clone()))
    }

    fn list(&self, directory: &Utf8Path) -> io::Result<Vec<String>> {
        let mut names = match Disk.list(directory) {
            Err(error) if self.will_lie_in(directory, &error) => Vec::new(),
            result => result?,
        };
        let directory = real(directory);
        let own =
            self.files.keys().filter(|file| file.parent() == Some(&directory)).filter_map(|file| file.file_name());
        for name in own {
            if names.iter().all(|other| other != name) {
                names.push(name.to_owned());
            }
        }
        Ok(names)
    }

    fn canonical(&self, path: &Utf8Path) -> io::Result<Utf8PathBuf> {
        self.find(path).map_or_else(|| Disk.canonical(path), |(real, _)| Ok(real.clone()))
    }
}

/// The path without links, as far as it is there.
pub(super) fn real(path: &Utf8Path) -> Utf8PathBuf {
    path.canonicalize_utf8().unwrap_or_else(|_| match (path.parent(), path.file_name()) {
        (Some(folder), Some(name)) => real(super::discover::here(folder)).join(name),
        _ => path.to_owned(),
    })
}
