//! Why a project could not be loaded.

use std::io;

use acrc_syntax::DecodeError;
use camino::{Utf8Path, Utf8PathBuf};
use thiserror::Error;

use crate::FileRole;

/// Why a project could not be loaded. Each names the path and what to do about it.
#[derive(Debug, Error)]
pub enum LoadError {
    /// Nothing is there.
    #[error("`{path}` does not exist")]
    Missing {
        /// As it was given.
        path: Utf8PathBuf,
    },
    /// A directory in which nothing looks like a program.
    #[error(
        "`{directory}` holds no program: expected acrc.toml, or files named Setup.8K, Prog0.8K to Prog15.8K, \
         PLC0.8K to PLC7.8K or any other *.8K"
    )]
    NoPrograms {
        /// The directory that was searched.
        directory: Utf8PathBuf,
    },
    /// A description in whose places for programs there are none.
    #[error(
        "`{config}` has no program beside it or in src/: expected files named Setup.8K, Prog0.8K to Prog15.8K, PLC0.8K \
         to PLC7.8K or any other *.8K, or a list `files` in [project]"
    )]
    NoProgramsBeside {
        /// The project description.
        config: Utf8PathBuf,
    },
    /// A compiled image.
    #[error(
        "`{path}` is an image, and no project: expected a program text (*.8K) or a folder of them; `acrc list` shows what is in an image"
    )]
    Image {
        /// The file.
        path: Utf8PathBuf,
    },
    /// The bytes are no text.
    #[error("`{path}` can't be read as a program")]
    Decode {
        /// The file.
        path: Utf8PathBuf,
        /// What is wrong with its bytes.
        source: DecodeError,
    },
    /// More than a text may have.
    #[error("`{path}` has {len} bytes: a program text of more than {} MiB is not read", limit >> 20)]
    TooLarge {
        /// The file.
        path: Utf8PathBuf,
        /// Its length in bytes.
        len: u64,
        /// The most that is read, in bytes.
        limit: u64,
    },
    /// A pipe, a device or the like.
    #[error("`{path}` is neither a file nor a directory")]
    NotAFile {
        /// The path.
        path: Utf8PathBuf,
    },
    /// A folder where a file should be.
    #[error("`{path}` is a folder; a file is expected there")]
    Folder {
        /// The path.
        path: Utf8PathBuf,
    },
    /// The operating system refuses.
    #[error("`{path}` can't be read")]
    Unreadable {
        /// The path.
        path: Utf8PathBuf,
        /// What the operating system says.
        source: io::Error,
    },
    /// `acrc.toml` is not what it should be.
    #[error("`{path}` is not a valid project description:\n{message}")]
    Config {
        /// The file.
        path: Utf8PathBuf,
        /// What is wrong, with the line.
        message: String,
    },
    /// The model is not in the catalogue.
    #[error("`{path}` names an unknown controller model `{model}`{}", did_you_mean(suggestion.as_deref(), known))]
    UnknownModel {
        /// The project description.
        path: Utf8PathBuf,
        /// The name as written.
        model: String,
        /// The nearest known name.
        suggestion: Option<&'static str>,
        /// All known names.
        known: Vec<&'static str>,
    },
    /// The list of files is empty.
    #[error(
        "`{config}` lists no file: name the files of the project, or leave `files` out to find them by their names"
    )]
    NothingListed {
        /// The project description.
        config: Utf8PathBuf,
    },
    /// A listed file is not there.
    #[error("`{config}` lists `{file}`, which does not exist{}", patterns_are_not_read(file))]
    ListedFileMissing {
        /// The project description.
        config: Utf8PathBuf,
        /// The path as listed.
        file: Utf8PathBuf,
    },
    /// A folder is listed.
    #[error(
        "`{config}` lists `{file}`, which is a folder: name the files in it one by one, or leave `files` out to find \
         them beside acrc.toml and in src/"
    )]
    FolderListed {
        /// The project description.
        config: Utf8PathBuf,
        /// The path as listed.
        file: Utf8PathBuf,
    },
    /// A file is listed more than once.
    #[error("`{config}` lists `{file}` twice")]
    ListedTwice {
        /// The project description.
        config: Utf8PathBuf,
        /// The path as listed the second time.
        file: Utf8PathBuf,
    },
    /// A listed file lies outside of the project's directory, directly or through a symbolic link.
    #[error("`{config}` lists `{file}`, which lies outside of the project")]
    OutsideProject {
        /// The project description.
        config: Utf8PathBuf,
        /// The path as listed.
        file: Utf8PathBuf,
    },
    /// Two files would be the same program.
    #[error("`{first}` and `{second}` are both {role}: keep one of them")]
    TwoFiles {
        /// What both are.
        role: FileRole,
        /// The file found first.
        first: Utf8PathBuf,
        /// The other.
        second: Utf8PathBuf,
    },
}

impl LoadError {
    /// The file or folder that is in the way.
    pub fn path(&self) -> &Utf8Path {
        match self {
            Self::Missing { path }
            | Self::Image { path }
            | Self::Decode { path, .. }
            | Self::TooLarge { path, .. }
            | Self::NotAFile { path }
            | Self::Folder { path }
            | Self::Unreadable { path, .. }
            | Self::Config { path, .. }
            | Self::UnknownModel { path, .. }
            | Self::NoPrograms { directory: path }
            | Self::NoProgramsBeside { config: path }
            | Self::NothingListed { config: path }
            | Self::ListedFileMissing { config: path, .. }
            | Self::FolderListed { config: path, .. }
            | Self::ListedTwice { config: path, .. }
            | Self::OutsideProject { config: path, .. }
            | Self::TwoFiles { second: path, .. } => path,
        }
    }
}

fn patterns_are_not_read(file: &Utf8Path) -> &'static str {
    if file.as_str().contains(['*', '?', '[', '{']) {
        ": patterns are not read here, since the order of the files counts; name them one by one, or leave `files` out \
         to find them beside acrc.toml and in src/"
    } else {
        ""
    }
}

fn did_you_mean(suggestion: Option<&str>, known: &[&str]) -> String {
    match suggestion {
        Some(name) => format!(": did you mean `{name}`?"),
        None => format!(": known are {}", known.join(", ")),
    }
}
