//! Loading a project from disk: which files it has, in which order they are sent, what each is.
//!
//! A project is given by a path to one of four things: a directory with an `acrc.toml`, that file itself, a directory
//! with the files that the vendor's editor saves (`Setup.8K`, `ProgN.8K`, `PLCn.8K`), or a single file. What comes out
//! is a pure description with the texts in it; nothing is read from disk later.

mod config;
mod discover;
mod error;
mod files;
mod glob;
mod lint_config;
mod overlay;
mod search;

use std::collections::BTreeSet;

use acrc_catalog::Model;
use acrc_compile::{CompileError, SourceUnit};
use acrc_image::Image;
use acrc_syntax::{SourceText, Tree};
use camino::{Utf8Path, Utf8PathBuf};

pub use config::{
    Angles, Backlash, BlockEnds, CONFIG_NAME, Config, FmtConfig, KeywordCase, ProjectConfig, RunTarget, SimConfig,
    SimTime,
};
pub use error::LoadError;
pub use files::{Disk, FileKind, Files};
pub use glob::{FileGlob, FileGlobs};
pub use lint_config::{FailOn, FileIgnores, Level as LintLevel, LintConfig, Override, PatternUse, Prepared, Selection};
pub use overlay::Overlay;
pub use search::{Search, holds_programs, owner, search};

use crate::{Database, FileRole, Project, SourceFile};

/// The most bytes that are read from one file.
const FILE_LIMIT: u64 = acrc_syntax::MAX_BYTES as u64;

/// A project as it was found.
#[derive(Clone, Debug)]
pub struct LoadedProject {
    /// Its name.
    pub name: String,
    /// The controller model.
    pub model: &'static Model,
    /// The directory that the paths of the configuration are relative to.
    pub root: Utf8PathBuf,
    /// The configuration, empty when there is no `acrc.toml`.
    pub config: Config,
    /// The files in the order in which they are sent.
    pub files: Vec<LoadedFile>,
}

/// One file of a project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadedFile {
    /// Its path as it is shown to the user.
    pub path: Utf8PathBuf,
    /// What it is to the project.
    pub role: FileRole,
    /// Its text.
    pub source: SourceText,
}

impl LoadedFile {
    pub(crate) fn add_to(&self, db: &Database) -> SourceFile {
        let Self { path, role, source } = self;
        SourceFile::new(db, path.to_string(), source.text.clone(), *role, source.diagnostics())
    }

    /// Whether the whole text, of which `tree` is the tree, is the text of a program, without `PROGRAM` and `ENDP`.
    pub fn is_implicit_program(&self, tree: &Tree) -> bool {
        crate::index::is_implicit_program(self.role, tree)
    }
}

/// Loads the project at `path` from disk.
pub fn load(path: impl AsRef<Utf8Path>) -> Result<LoadedProject, LoadError> {
    load_from(&Disk, path.as_ref())
}

/// Loads the project at `path` through `files`.
pub fn load_from(files: &dyn Files, path: &Utf8Path) -> Result<LoadedProject, LoadError> {
    match kind(files, path)? {
        FileKind::Directory => {
            let config = path.join(CONFIG_NAME);
            match kind(files, &config) {
                Err(LoadError::Missing { .. }) => {
                    from_paths(files, path, Config::default(), discover::in_directory(files, path)?)
                }
                // One that is there and can't be read must not be passed over.
                _ => from_config(files, &config),
            }
        }
        FileKind::File { .. } if path.file_name() == Some(CONFIG_NAME) => from_config(files, path),
        FileKind::File { .. } => {
            let root = path.parent().unwrap_or(Utf8Path::new(""));
            from_paths(files, root, Config::default(), vec![path.to_owned()])
        }
        FileKind::Other => Err(LoadError::NotAFile { path: path.to_owned() }),
    }
}

fn from_config(files: &dyn Files, path: &Utf8Path) -> Result<LoadedProject, LoadError> {
    let invalid = |message| LoadError::Config { path: path.to_owned(), message };
    let bytes = read(files, path)?;
    let text = String::from_utf8(bytes).map_err(|error| invalid(error.to_string()))?;
    let mut config = config::parse(&text).map_err(invalid)?;

    let root = path.parent().unwrap_or(Utf8Path::new(""));
    root.clone_into(&mut config.lint.root);
    let paths = match &config.project.files {
        Some(listed) => discover::listed(files, path, root, listed)?,
        None => discover::beside_config(files, path, root)?,
    };
    let model = config.project.model.as_deref().map_or(Ok(acrc_catalog::default_model()), |name| model(path, name))?;
    Ok(LoadedProject { model, ..from_paths(files, root, config, paths)? })
}

/// Reads the files at `paths`. The model is the default one.
fn from_paths(
    files: &dyn Files,
    root: &Utf8Path,
    config: Config,
    paths: Vec<Utf8PathBuf>,
) -> Result<LoadedProject, LoadError> {
    let sources = discover::with_roles(paths)?
        .into_iter()
        .map(|(role, path)| {
            let bytes = read(files, &path)?;
            if bytes.starts_with(acrc_image::MAGIC) {
                return Err(LoadError::Image { path });
            }
            let source =
                SourceText::decode(&bytes).map_err(|source| LoadError::Decode { path: path.clone(), source })?;
            Ok(LoadedFile { path, role, source })
        })
        .collect::<Result<Vec<_>, LoadError>>()?;
    let name = config.project.name.clone().or_else(|| directory_name(files, root));
    Ok(LoadedProject {
        name: name.unwrap_or_else(|| "project".to_owned()),
        model: acrc_catalog::default_model(),
        root: root.to_owned(),
        config,
        files: sources,
    })
}

/// The name of the directory `root`, which may be written as `.`.
fn directory_name(files: &dyn Files, root: &Utf8Path) -> Option<String> {
    let real = files.canonical(discover::here(root)).ok()?;
    real.file_name().map(str::to_owned)
}

impl LoadedProject {
    /// Hands the project to the database.
    pub fn add_to(&self, db: &Database) -> Project {
        let files = self.files.iter().map(|file| file.add_to(db)).collect();
        Project::new(db, files, self.model, self.config.clone())
    }

    /// Patterns of `[lint]` that mean neither a file of the project nor one of the `others`, a sentence each: most are
    /// slips.
    pub fn idle_lint_patterns(&self, others: &[Utf8PathBuf]) -> Vec<String> {
        self.idle(self.config.lint.patterns().map(|(glob, usage)| (glob, usage.to_string())), others)
    }

    /// Patterns of `[fmt]` that mean neither a file of the project nor one of the `others`, a sentence each.
    pub fn idle_fmt_patterns(&self, others: &[Utf8PathBuf]) -> Vec<String> {
        self.idle(self.config.fmt.exclude.iter().map(|glob| (glob, "fmt.exclude".to_owned())), others)
    }

    /// The programs among those around an `acrc.toml` that are no part of the project.
    pub fn strangers(&self, around: &[Utf8PathBuf]) -> Vec<Utf8PathBuf> {
        let own: BTreeSet<&Utf8Path> = self.files.iter().map(|file| file.path.as_path()).collect();
        let mut others: Vec<_> = around.iter().filter(|path| !own.contains(path.as_path())).cloned().collect();
        if !others.is_empty() {
            // One file may be written in two ways.
            let mut seen: BTreeSet<Utf8PathBuf> = own.iter().map(|path| overlay::real(path)).collect();
            others.retain(|path| seen.insert(overlay::real(path)));
        }
        others
    }

    fn idle<'g>(&self, patterns: impl Iterator<Item = (&'g FileGlob, String)>, others: &[Utf8PathBuf]) -> Vec<String> {
        let (globs, keys): (Vec<&FileGlob>, Vec<String>) = patterns.unzip();
        let all = FileGlobs::new(globs.iter().copied()).unwrap_or_default();
        let paths = self.files.iter().map(|file| &file.path).chain(others);
        let paths = paths.map(|path| self.config.lint.relative(path.as_str()));
        let used: BTreeSet<usize> = paths.flat_map(|path| all.matching(path)).collect();
        let config = self.root.join(CONFIG_NAME);
        let idle = globs.iter().zip(keys).enumerate().filter(|(place, _)| !used.contains(place));
        idle.map(|(_, (glob, key))| format!("`{config}`: {key}: `{}` means no file of the project", glob.as_str()))
            .collect()
    }

    /// Compiles the project into an image; every reason why it can't be is reported.
    pub fn compile(&self) -> Result<Image, Vec<CompileError>> {
        let trees: Vec<_> = self.files.iter().map(|file| acrc_syntax::parse(&file.source.text)).collect();
        let units: Vec<_> = self
            .files
            .iter()
            .zip(&trees)
            .map(|(file, tree)| SourceUnit {
                name: file.path.as_str(),
                text: &file.source.text,
                tree,
                start: file.role.start(),
                implicit_program: file.is_implicit_program(tree),
            })
            .collect();
        acrc_compile::compile(&units, self.model.name)
    }
}

fn model(config: &Utf8Path, name: &str) -> Result<&'static Model, LoadError> {
    acrc_catalog::model(name).ok_or_else(|| {
        let known: Vec<_> = acrc_catalog::models().iter().map(|model| model.name).collect();
        LoadError::UnknownModel {
            path: config.to_owned(),
            model: name.to_owned(),
            suggestion: crate::near::nearest(&name.to_ascii_uppercase(), known.iter().copied()),
            known,
        }
    })
}

fn kind(files: &dyn Files, path: &Utf8Path) -> Result<FileKind, LoadError> {
    files.kind(path).map_err(|source| io_error(path, source))
}

fn read(files: &dyn Files, path: &Utf8Path) -> Result<Vec<u8>, LoadError> {
    match kind(files, path)? {
        FileKind::File { len } if len > FILE_LIMIT => {
            Err(LoadError::TooLarge { path: path.to_owned(), len, limit: FILE_LIMIT })
        }
        FileKind::File { .. } => files.read(path).map_err(|source| io_error(path, source)),
        FileKind::Directory => Err(LoadError::Folder { path: path.to_owned() }),
        FileKind::Other => Err(LoadError::NotAFile { path: path.to_owned() }),
    }
}

fn io_error(path: &Utf8Path, source: std::io::Error) -> LoadError {
    match source.kind() {
        std::io::ErrorKind::NotFound => LoadError::Missing { path: path.to_owned() },
        _ => LoadError::Unreadable { path: path.to_owned(), source },
    }
}
