//! Patterns of file names in `acrc.toml`.

use camino::Utf8Path;
use globset::{GlobBuilder, GlobMatcher};
use serde::Deserialize;

/// A pattern such as `Prog1*.8K`, `src/*.8K` or `legacy/**`. Without a slash it is about the name of a file wherever it
/// lies, with one about the path from the folder of `acrc.toml`. `*` does not go beyond a slash, `**` does.
#[derive(Clone, Debug, Deserialize)]
#[serde(try_from = "String")]
pub struct FileGlob {
    pattern: String,
    matcher: GlobMatcher,
    whole_path: bool,
}

impl FileGlob {
    /// Reads a pattern.
    pub fn new(pattern: &str) -> Result<Self, String> {
        let invalid = |error: globset::Error| format!("`{pattern}` is no pattern of files: {}", error.kind());
        let written = pattern.strip_prefix("./").unwrap_or(pattern);
        let glob = GlobBuilder::new(written).literal_separator(true).backslash_escape(false).build();
        let matcher = glob.map_err(invalid)?.compile_matcher();
        Ok(Self { pattern: pattern.to_owned(), matcher, whole_path: written.contains('/') })
    }

    /// Whether a path, relative to the folder of `acrc.toml`, is meant.
    pub fn matches(&self, path: &Utf8Path) -> bool {
        let path = if self.whole_path { path } else { path.file_name().map_or(path, Utf8Path::new) };
        self.matcher.is_match(path)
    }

    /// As it was written.
    pub fn as_str(&self) -> &str {
        &self.pattern
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
        ] {
            let glob = FileGlob::new(pattern).expect("a pattern");
            assert_eq!(glob.matches(Utf8Path::new(path)), expected, "{pattern} {path}");
        }
    }

    #[test]
    fn a_broken_pattern_is_refused_by_name() {
        let error = FileGlob::new("[ab.8K").expect_err("no pattern");
        assert!(error.starts_with("`[ab.8K` is no pattern of files"), "{error}");
    }
}
