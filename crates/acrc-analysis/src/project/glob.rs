//! Patterns of file names in `acrc.toml`.

use camino::Utf8Path;
use globset::{Glob, GlobBuilder, GlobSet, GlobSetBuilder};
use serde::Deserialize;

/// A pattern such as `Prog1*.8K`, `src/*.8K` or `legacy/`, read as in a `.gitignore`: without a slash before its end it
/// is about a name in any folder, with one about the path from the folder of `acrc.toml`. What means a folder means all
/// that lies below it. `*` does not go beyond a slash, `**` does.
#[derive(Clone, Debug, Deserialize)]
#[serde(try_from = "String")]
pub struct FileGlob {
    pattern: String,
    glob: Glob,
}

impl FileGlob {
    /// Reads a pattern.
    pub fn new(pattern: &str) -> Result<Self, String> {
        let path = pattern.strip_prefix("./").unwrap_or(pattern).trim_end_matches('/');
        if path.is_empty() {
            return Err(format!("`{pattern}` is no pattern of files: it is empty"));
        }
        let path = match path.strip_prefix('/') {
            Some(path) => path.to_owned(),
            None if path.contains('/') => path.to_owned(),
            None => format!("**/{path}"),
        };
        let glob = GlobBuilder::new(&path).literal_separator(true).backslash_escape(false).build();
        let glob = glob.map_err(|error| format!("`{pattern}` is no pattern of files: {}", error.kind()))?;
        Ok(Self { pattern: pattern.to_owned(), glob })
    }

    /// As it was written.
    pub fn as_str(&self) -> &str {
        &self.pattern
    }
}

/// Patterns that are compared with a path all at once.
#[derive(Clone, Debug, Default)]
pub struct FileGlobs(GlobSet);

impl FileGlobs {
    /// Puts patterns together.
    ///
    /// # Errors
    /// They are too long together.
    pub fn new<'g>(patterns: impl IntoIterator<Item = &'g FileGlob>) -> Result<Self, String> {
        let mut set = GlobSetBuilder::new();
        for pattern in patterns {
            set.add(pattern.glob.clone());
        }
        set.build().map(Self).map_err(|error| format!("the patterns of files can't be used together: {}", error.kind()))
    }

    /// Places, in order, of the patterns that mean a path, which is relative to the folder of `acrc.toml`.
    pub fn matching(&self, path: &Utf8Path) -> Vec<usize> {
        if self.0.is_empty() {
            return Vec::new();
        }
        // The path and the folders that it lies in, but for the one of `acrc.toml`.
        let parts = path.ancestors().take_while(|part| !part.as_str().is_empty());
        let mut places: Vec<usize> = parts.flat_map(|part| self.0.matches(part)).collect();
        places.sort_unstable();
        places.dedup();
        places
    }
}

impl TryFrom<String> for FileGlob {
    type Error = String;

    fn try_from(pattern: String) -> Result<Self, String> {
        Self::new(&pattern)
    }
}

impl PartialEq for FileGlob {
    fn eq(&self, other: &Self) -> bool {
        self.pattern == other.pattern
    }
}

impl Eq for FileGlob {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pattern_with_a_slash_is_about_the_path() {
        for (pattern, path, expected) in [
            ("Prog1*.8K", "src/Prog12.8K", true),
            ("Prog1*.8K", "Prog2.8K", false),
            ("src/*.8K", "src/Prog0.8K", true),
            ("src/*.8K", "src/deep/Prog0.8K", false),
            ("src/*.8K", "other/src/Prog0.8K", false),
            ("./src/*.8K", "src/Prog0.8K", true),
            ("legacy/**", "legacy/a/b.8K", true),
            ("**/b.8K", "legacy/a/b.8K", true),
            ("{Setup,Prog0}.8K", "Setup.8K", true),
            ("[ab].8K", "b.8K", true),
            ("src", "src/Prog0.8K", true),
            ("src/", "src/deep/Prog0.8K", true),
            ("deep", "src/deep/Prog0.8K", true),
            ("/deep", "src/deep/Prog0.8K", false),
            ("/src", "src/Prog0.8K", true),
            ("src/de*", "src/deep/Prog0.8K", true),
            ("src", "src2/Prog0.8K", false),
            ("src", "/src/Prog0.8K", true),
        ] {
            let glob = FileGlob::new(pattern).expect("a pattern");
            let matching = FileGlobs::new([&glob]).expect("a short pattern").matching(Utf8Path::new(path));
            assert_eq!(!matching.is_empty(), expected, "{pattern} {path}");
        }
    }

    #[test]
    fn a_broken_pattern_is_refused_by_name() {
        for pattern in ["[ab.8K", "", "/", "./"] {
            let error = FileGlob::new(pattern).expect_err("no pattern");
            assert!(error.starts_with(&format!("`{pattern}` is no pattern of files")), "{error}");
        }
    }
}
