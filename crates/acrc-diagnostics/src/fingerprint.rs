//! Names for findings that stay the same while the text around them changes, so that a service can tell a new finding
//! from one that it has seen in an earlier report.

use std::collections::HashMap;
use std::hash::Hasher as _;

use siphasher::sip::SipHasher13;

use crate::unchecked::NOT_CHECKED;
use crate::{Diagnostic, SourceFile};

/// Gives each finding of a report a name of its own.
///
/// The name is made of the code of the finding, the text of the line on which it begins, without the white space around
/// it, and a count of the findings that agree in both. Lines that are added or removed elsewhere, another indentation or
/// another wording of the message do not change it. The hash is SipHash-1-3 with the key zero: never another one, or
/// every service would show every finding as new.
#[derive(Default)]
pub(crate) struct Fingerprints {
    scope: u64,
    /// The line looked at last, with the hash of its text: findings come by place, and a line may be long.
    line: Option<(u32, u64)>,
    /// How often each hash has occurred.
    seen: HashMap<u64, u32>,
}

impl Fingerprints {
    /// What follows is of another file. Findings of files whose `scope` differs have different names.
    pub(crate) fn enter_file(&mut self, scope: &str) {
        self.scope = SipHasher13::new().hash(scope.as_bytes());
        self.line = None;
    }

    /// The name of the next finding of the file.
    pub(crate) fn next(&mut self, file: &SourceFile<'_>, diagnostic: &Diagnostic) -> String {
        let mut hasher = SipHasher13::new();
        hasher.write(&self.scope.to_le_bytes());
        hasher.write(&self.line_hash(file, diagnostic).to_le_bytes());
        hasher.write(diagnostic.code.id.as_bytes());
        self.counted(hasher.finish())
    }

    /// The name of the file itself, which could not be checked.
    pub(crate) fn of_unchecked(&mut self) -> String {
        let mut hasher = SipHasher13::new();
        hasher.write(&self.scope.to_le_bytes());
        hasher.write(NOT_CHECKED.as_bytes());
        self.counted(hasher.finish())
    }

    fn counted(&mut self, hash: u64) -> String {
        let count = self.seen.entry(hash).or_default();
        *count += 1;
        format!("{hash:016x}:{count}")
    }

    fn line_hash(&mut self, file: &SourceFile<'_>, diagnostic: &Diagnostic) -> u64 {
        let line = file.position(diagnostic.span.start).line;
        if let Some((known, hash)) = self.line
            && known == line
        {
            return hash;
        }
        let text = file.index().line_span(line).map_or("", |span| file.slice(span));
        let hash = SipHasher13::new().hash(text.trim().as_bytes());
        self.line = Some((line, hash));
        hash
    }
}
