//! `[lint]` of `acrc.toml`: which rules are on, how loud they are, and for which files.
//!
//! What a selector means is known to the linter, not here: it is kept as it was written.

use std::any::Any;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Arc, OnceLock};

use acrc_diagnostics::Severity;
use camino::{Utf8Path, Utf8PathBuf};
use serde::Deserialize;

use super::FileGlob;

/// `[lint]`
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, default, rename_all = "kebab-case")]
pub struct LintConfig {
    /// The least severity that makes `acrc lint` fail; warnings when absent.
    pub fail_on: Option<FailOn>,
    /// The rules that are on, by code, prefix of a code, name or group, or `ALL`; those that are on by themselves when
    /// absent.
    pub select: Option<Vec<String>>,
    /// Rules that are on besides.
    pub extend_select: Vec<String>,
    /// Rules that are off.
    pub ignore: Vec<String>,
    /// How loud rules are, by selector.
    pub severity: BTreeMap<String, Level>,
    /// Files that are not checked, though other files see what they define.
    pub exclude: Vec<FileGlob>,
    /// Rules that are off in some files, whatever else is said.
    pub per_file_ignores: FileIgnores,
    /// Other choices for some files.
    #[serde(rename = "override")]
    pub overrides: Vec<Override>,
    /// What the command line says, which comes after all of this but the ignores of files.
    #[serde(skip)]
    pub command_line: Selection,
    /// The directory that the patterns are relative to. Set by the loader.
    #[serde(skip)]
    pub root: Utf8PathBuf,
    /// What a checker made of this.
    #[serde(skip)]
    pub prepared: Prepared,
}

/// `[lint.per-file-ignores]`: patterns and the selectors of the rules that are off in their files.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(try_from = "BTreeMap<String, Vec<String>>")]
pub struct FileIgnores(pub Vec<(FileGlob, Vec<String>)>);

impl TryFrom<BTreeMap<String, Vec<String>>> for FileIgnores {
    type Error = String;

    fn try_from(written: BTreeMap<String, Vec<String>>) -> Result<Self, String> {
        let ignores = written.into_iter().map(|(pattern, selectors)| Ok((FileGlob::new(&pattern)?, selectors)));
        ignores.collect::<Result<_, String>>().map(Self)
    }
}

/// A choice of rules by selectors.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection {
    /// Only these are on.
    pub select: Option<Vec<String>>,
    /// These are on too.
    pub extend_select: Vec<String>,
    /// These are off.
    pub ignore: Vec<String>,
}

/// `[[lint.override]]`
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Override {
    /// The files that it is about.
    pub files: Vec<FileGlob>,
    /// Only these rules are on in them.
    #[serde(default)]
    pub select: Option<Vec<String>>,
    /// These are on too.
    #[serde(default)]
    pub extend_select: Vec<String>,
    /// These are off.
    #[serde(default)]
    pub ignore: Vec<String>,
    /// How loud rules are, by selector.
    #[serde(default)]
    pub severity: BTreeMap<String, Level>,
}

/// How loud a rule is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Level {
    /// Its findings are errors.
    Error,
    /// Its findings are warnings.
    Warning,
    /// Its findings are advice.
    Advice,
    /// It is not heard.
    Off,
}

impl Level {
    /// The severity, `None` for off.
    pub const fn severity(self) -> Option<Severity> {
        match self {
            Self::Error => Some(Severity::Error),
            Self::Warning => Some(Severity::Warning),
            Self::Advice => Some(Severity::Advice),
            Self::Off => None,
        }
    }
}

/// From which severity on a check counts as failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FailOn {
    /// Errors only.
    Error,
    /// Errors and warnings.
    Warning,
    /// Every finding.
    Advice,
    /// Nothing.
    Never,
}

impl FailOn {
    /// Whether a finding of this severity makes the check fail.
    pub fn fails(self, severity: Severity) -> bool {
        match self {
            Self::Error => severity >= Severity::Error,
            Self::Warning => severity >= Severity::Warning,
            Self::Advice => true,
            Self::Never => false,
        }
    }
}

impl LintConfig {
    /// The path of a file as patterns see it. `path` is the one that is shown.
    pub fn relative<'p>(&self, path: &'p str) -> &'p Utf8Path {
        let path = Utf8Path::new(path);
        path.strip_prefix(&self.root).unwrap_or(path)
    }

    /// All patterns and what they are for; those of one override stand together.
    pub fn patterns(&self) -> impl Iterator<Item = (&FileGlob, PatternUse)> {
        let exclude = self.exclude.iter().map(|glob| (glob, PatternUse::Exclude));
        let overrides = self.overrides.iter().enumerate().flat_map(|(place, part)| {
            let files = part.files.iter();
            files.map(move |glob| (glob, PatternUse::Override(place)))
        });
        let ignores = self.per_file_ignores.0.iter().enumerate();
        exclude.chain(overrides).chain(ignores.map(|(place, (glob, _))| (glob, PatternUse::Ignore(place))))
    }
}

/// What a pattern of `[lint]` is for. Displays as the key under which it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PatternUse {
    /// Its files are not checked.
    Exclude,
    /// Of an override, by its place.
    Override(usize),
    /// Of the ignores of files, by its place.
    Ignore(usize),
}

impl fmt::Display for PatternUse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exclude => f.write_str("lint.exclude"),
            Self::Override(place) => write!(f, "lint.override {}", place + 1),
            Self::Ignore(_) => f.write_str("lint.per-file-ignores"),
        }
    }
}

/// A place for what a checker computes from a configuration once, instead of once for each file. It has no part in
/// what the configuration says: two that differ in it only are equal, and a copy begins empty.
#[derive(Default)]
pub struct Prepared(OnceLock<Arc<dyn Any + Send + Sync>>);

impl Prepared {
    /// What was computed before, or the result of `make`. `None` when something of another type lies here.
    pub fn get_or_init<T: Any + Send + Sync>(&self, make: impl FnOnce() -> T) -> Option<&T> {
        self.0.get_or_init(|| Arc::new(make())).downcast_ref()
    }
}

impl Clone for Prepared {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for Prepared {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for Prepared {}

impl fmt::Debug for Prepared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Prepared")
    }
}
