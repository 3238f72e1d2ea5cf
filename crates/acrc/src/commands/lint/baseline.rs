//! Findings that were there before: `--baseline`.
//!
//! A finding is known again by its rule, its file and the text of its line, so that lines above it may come and go. Of
//! equal lines as many findings are left out as the file counts.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use acrc_diagnostics::{Diagnostic, LineIndex};
use anyhow::{Context as _, anyhow, bail};
use serde::{Deserialize, Serialize};

use super::checked::Checked;
use crate::commands::targets::real;
use crate::output::write_file;

const VERSION: u32 = 1;

/// By what a finding is known again.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    /// Relative to the folder of the baseline, with forward slashes.
    file: String,
    code: String,
    fingerprint: String,
}

/// What a baseline lists.
#[derive(Debug)]
pub(super) struct Baseline {
    folder: PathBuf,
    /// Message of the first, and how many there are.
    entries: BTreeMap<Key, (String, usize)>,
}

/// What became of the findings of a baseline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Hidden {
    /// Findings that are left out.
    pub(super) known: usize,
    /// Entries without a finding, in files that were checked or are gone.
    pub(super) repaired: usize,
}

/// What is read first: another version may have other members.
#[derive(Deserialize)]
struct Head {
    version: u32,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    #[serde(rename = "version")]
    _version: u32,
    findings: Vec<Entry>,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    file: String,
    code: String,
    message: String,
    fingerprint: String,
    count: usize,
}

impl Baseline {
    /// One that lists nothing, at its place.
    pub(super) fn empty(path: &Path) -> Self {
        let folder = real(path).parent().map(Path::to_owned).unwrap_or_default();
        Self { folder, entries: BTreeMap::new() }
    }

    /// Reads a baseline.
    pub(super) fn read(path: &Path) -> anyhow::Result<Self> {
        if !path.exists() {
            bail!("the baseline {} does not exist; --write-baseline writes it", path.display());
        }
        let refuse = || format!("cannot read the baseline {}", path.display());
        let bytes = std::fs::read(path).with_context(refuse)?;
        let no_baseline = |error: serde_json::Error| {
            let (line, column) = (error.line(), error.column());
            anyhow!("{}: line {line}, column {column} is not as --write-baseline writes it", refuse())
        };
        let Head { version } = serde_json::from_slice(&bytes).map_err(no_baseline)?;
        if version != VERSION {
            bail!("{}: it has version {version}, and this is for version {VERSION}", refuse());
        }
        let document: Document = serde_json::from_slice(&bytes).map_err(no_baseline)?;
        let mut baseline = Self::empty(path);
        for Entry { file, code, message, fingerprint, count } in document.findings {
            let entry = baseline.entries.entry(Key { file, code, fingerprint }).or_insert((message, 0));
            entry.1 = entry.1.saturating_add(count);
        }
        Ok(baseline)
    }

    /// Adds the findings of the files that are shown.
    pub(super) fn add(&mut self, checked: &Checked) {
        for (place, name, text) in checked.shown_files() {
            let file = self.relative(checked, place, name);
            let index = LineIndex::new(text);
            for finding in checked.found.get(place).into_iter().flatten() {
                let entry = self.entries.entry(key(&file, text, &index, finding));
                entry.or_insert_with(|| (finding.message.clone(), 0)).1 += 1;
            }
        }
    }

    /// Leaves out the findings that are listed.
    pub(super) fn hide(&mut self, checked: &mut Checked) -> Hidden {
        let mut hidden = Hidden::default();
        // A rule that is off now finds nothing, which repairs nothing.
        let off: Vec<&str> = acrc_lint::rule_states(&checked.project.config.lint)
            .iter()
            .filter(|state| !state.on)
            .map(|state| state.doc.code.id)
            .collect();
        let shown: Vec<(usize, String, LineIndex)> = checked
            .shown_files()
            .map(|(place, name, text)| (place, self.relative(checked, place, name), LineIndex::new(text)))
            .collect();
        for (place, file, index) in shown {
            let text = checked.project.files.get(place).map_or("", |file| &file.source.text);
            let Some(findings) = checked.found.get_mut(place) else { continue };
            findings.retain(|finding| match self.entries.get_mut(&key(&file, text, &index, finding)) {
                Some((_, count)) if *count > 0 => {
                    *count -= 1;
                    hidden.known += 1;
                    false
                }
                _ => true,
            });
            let first = Key { file: file.clone(), code: String::new(), fingerprint: String::new() };
            let of_file = self.entries.range_mut(first..).take_while(|(key, _)| key.file == file);
            let heard = of_file.filter(|(key, _)| !off.contains(&key.code.as_str()));
            hidden.repaired += heard.map(|(_, (_, count))| std::mem::take(count)).sum::<usize>();
        }
        hidden
    }

    /// How many entries are about files that are gone.
    pub(super) fn gone(&self) -> usize {
        let is_gone = |key: &Key| !self.folder.join(&key.file).exists();
        self.entries.iter().filter(|(key, _)| is_gone(key)).map(|(_, (_, count))| count).sum()
    }

    /// How many findings are listed.
    pub(super) fn len(&self) -> usize {
        self.entries.values().map(|(_, count)| count).sum()
    }

    /// Writes the file, an entry a line.
    pub(super) fn write(&self, path: &Path) -> anyhow::Result<()> {
        let mut text = format!("{{\n  \"version\": {VERSION},\n  \"findings\": [");
        let mut separator = "\n";
        for (Key { file, code, fingerprint }, (message, count)) in &self.entries {
            let (file, code, fingerprint, message) = (file.clone(), code.clone(), fingerprint.clone(), message.clone());
            let entry = serde_json::to_string(&Entry { file, code, message, fingerprint, count: *count })?;
            // Writing to a string does not fail.
            let _ = write!(text, "{separator}    {entry}");
            separator = ",\n";
        }
        text.push_str(if self.entries.is_empty() { "]\n}\n" } else { "\n  ]\n}\n" });
        write_file(path, text.as_bytes())
    }

    /// The path of a file from the folder of the baseline, so that it does not matter from where the file is checked.
    fn relative(&self, checked: &Checked, place: usize, name: &str) -> String {
        let path = checked.project.files.get(place).map(|file| real(file.path.as_std_path()));
        let path = path.unwrap_or_else(|| PathBuf::from(name));
        let common = self.folder.components().zip(path.components()).take_while(|(a, b)| a == b).count();
        let up = self.folder.components().skip(common).map(|_| "..".to_owned());
        let down = path.components().skip(common).map(|part| part.as_os_str().to_string_lossy().into_owned());
        up.chain(down).collect::<Vec<_>>().join("/")
    }
}

fn key(file: &str, text: &str, index: &LineIndex, finding: &Diagnostic) -> Key {
    let line = index.position(finding.span.start).line;
    let line = index.line_span(line).and_then(|span| text.get(span.range())).unwrap_or_default();
    Key { file: file.to_owned(), code: finding.code.id.to_owned(), fingerprint: fingerprint(line) }
}

/// FNV-1a over the words of a line, so that blanks do not matter. It must stay the same from version to version.
fn fingerprint(line: &str) -> String {
    let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
    for word in line.split_whitespace() {
        for byte in word.bytes().chain([b' ']) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
    format!("{hash:016x}")
}

#[cfg(test)]
mod tests {
    use super::fingerprint;

    #[test]
    fn a_line_keeps_its_fingerprint() {
        assert_eq!(fingerprint("GOTO  Start"), fingerprint("\tGOTO Start "));
        assert_ne!(fingerprint("GOTO Start"), fingerprint("GOTOStart"));
        assert_eq!(fingerprint("GOTO Start"), "3ba9eb7933544cbe");
    }
}
