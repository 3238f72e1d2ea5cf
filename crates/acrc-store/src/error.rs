//! Why a state cannot be used.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

/// Why the folder of a state cannot be used.
#[derive(Debug, Error)]
pub enum StoreError {
    /// A file operation failed.
    #[error("{}: {problem}", .path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// Why. Part of the message, so that who prints the chain of errors does not say it twice.
        problem: io::Error,
    },
    /// Another process has it.
    #[error("{} is in use by another process", .0.display())]
    InUse(PathBuf),
    /// A folder of something else.
    #[error("{} holds {name}, so it is no folder of a controller's state: name an empty folder or a new one", .folder.display())]
    Foreign {
        /// The folder.
        folder: PathBuf,
        /// A file in it.
        name: String,
    },
    /// The state is not as it was written.
    #[error("{} cannot be used: {problem}{}", .path.display(), hint(.older.as_ref()))]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        problem: ReadError,
        /// The state before it, when there is one.
        older: Option<PathBuf>,
    },
    /// A state that no file can hold.
    #[error("the state cannot be written: {0}")]
    Unwritable(String),
}

fn hint(older: Option<&PathBuf>) -> String {
    older.map_or_else(String::new, |older| format!("; without it, the state before it is used ({})", older.display()))
}

/// What is wrong with the bytes of a state.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ReadError {
    /// Not written by this program.
    #[error("it does not begin as a controller's state does")]
    Foreign,
    /// Written by a later version.
    #[error("it has version {found}, this program reads versions up to {newest}")]
    NewerVersion {
        /// Version of the file.
        found: u32,
        /// Newest version that can be read.
        newest: u32,
    },
    /// Too short or too long.
    #[error("it has {found} bytes behind its first line instead of {expected}")]
    Length {
        /// By its first line.
        expected: usize,
        /// In the file.
        found: usize,
    },
    /// The checksum differs.
    #[error("it was altered: checksum {computed:08x} instead of {stored:08x}")]
    Altered {
        /// By its first line.
        stored: u32,
        /// Of the bytes.
        computed: u32,
    },
    /// The checksum is right and the contents make no sense.
    #[error("{0}")]
    Malformed(String),
}
