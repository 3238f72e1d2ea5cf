//! The only door to the file system: a small trait, so that loading can be tested, and later be served from an editor.

use std::fs;
use std::io;

use camino::{Utf8Path, Utf8PathBuf};

/// What a path leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// A regular file and its length in bytes.
    File {
        /// Length in bytes.
        len: u64,
    },
    /// A directory.
    Directory,
    /// A pipe, a device or the like: never opened, because reading it may not end.
    Other,
}

/// The questions that loading a project asks of the file system. Symbolic links are followed.
pub trait Files {
    /// What `path` leads to.
    fn kind(&self, path: &Utf8Path) -> io::Result<FileKind>;

    /// The bytes of a file.
    fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>>;

    /// Names of the entries of a directory, in any order.
    fn list(&self, directory: &Utf8Path) -> io::Result<Vec<String>>;

    /// The absolute path without symbolic links; an error when links go round in a circle.
    fn canonical(&self, path: &Utf8Path) -> io::Result<Utf8PathBuf>;
}

/// The file system of the computer.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Files for Disk {
    fn kind(&self, path: &Utf8Path) -> io::Result<FileKind> {
        let metadata = fs::metadata(path)?;
        Ok(if metadata.is_dir() {
            FileKind::Directory
        } else if metadata.is_file() {
            FileKind::File { len: metadata.len() }
        } else {
            FileKind::Other
        })
    }

    fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        fs::read(path)
    }

    /// Names that are not UTF-8 are left out, unless they end like a program: a program that is silently ignored would
    /// be missing on the machine.
    fn list(&self, directory: &Utf8Path) -> io::Result<Vec<String>> {
        let mut names = Vec::new();
        for entry in fs::read_dir(directory)? {
            match entry?.file_name().into_string() {
                Ok(name) => names.push(name),
                Err(name) if name.to_string_lossy().to_ascii_lowercase().ends_with(".8k") => {
                    let message = format!("the file name `{}` is not UTF-8", name.display());
                    return Err(io::Error::new(io::ErrorKind::InvalidData, message));
                }
                Err(_) => {}
            }
        }
        Ok(names)
    }

    fn canonical(&self, path: &Utf8Path) -> io::Result<Utf8PathBuf> {
        path.canonicalize_utf8()
    }
}
