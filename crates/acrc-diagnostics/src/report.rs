//! Files with their findings, ready to be shown, and the count of them.

use std::fmt;
use std::sync::OnceLock;

use crate::{Diagnostic, LineIndex, Position, Severity, Span};

/// A named text whose lines are indexed at the first question for one.
#[derive(Clone, Debug)]
pub struct SourceFile<'a> {
    /// The name as it is printed, usually a path relative to where the user works.
    pub name: &'a str,
    /// The decoded text.
    pub text: &'a str,
    index: OnceLock<LineIndex>,
}

impl<'a> SourceFile<'a> {
    /// A file of this name and text. Costs nothing yet.
    #[must_use]
    pub const fn new(name: &'a str, text: &'a str) -> Self {
        Self { name, text, index: OnceLock::new() }
    }

    /// The lines of the text.
    pub fn index(&self) -> &LineIndex {
        self.index.get_or_init(|| LineIndex::new(self.text))
    }

    /// Line and column of `offset`; see [`LineIndex::position`].
    pub fn position(&self, offset: u32) -> Position {
        self.index().position(offset)
    }

    /// The text in `span`; empty when the span does not fit the text.
    pub fn slice(&self, span: Span) -> &'a str {
        self.text.get(span.range()).unwrap_or_default()
    }
}

/// One file and what was found in it. Every renderer takes a list of these and keeps its order.
#[derive(Clone, Debug)]
pub struct FileReport<'a> {
    file: SourceFile<'a>,
    diagnostics: Vec<&'a Diagnostic>,
}

impl<'a> FileReport<'a> {
    /// Puts the findings in the order in which they are shown: by place, at one place the worst first, then by code.
    pub fn new(file: SourceFile<'a>, diagnostics: impl IntoIterator<Item = &'a Diagnostic>) -> Self {
        let mut diagnostics: Vec<_> = diagnostics.into_iter().collect();
        diagnostics.sort_by(|a, b| {
            let place = (a.span.start, a.span.end).cmp(&(b.span.start, b.span.end));
            place.then(b.severity.cmp(&a.severity)).then(a.code.cmp(&b.code))
        });
        Self { file, diagnostics }
    }

    /// The file.
    pub const fn file(&self) -> &SourceFile<'a> {
        &self.file
    }

    /// The findings, in the order in which they are shown.
    pub fn diagnostics(&self) -> &[&'a Diagnostic] {
        &self.diagnostics
    }
}

/// How many findings there are. Displays as "2 errors, 1 warning in 3 files".
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// Files looked at, with and without findings.
    pub files: usize,
    /// Findings of severity error.
    pub errors: usize,
    /// Findings of severity warning.
    pub warnings: usize,
    /// Findings of severity advice.
    pub advice: usize,
}

impl Summary {
    /// Counts the findings of all files.
    #[must_use]
    pub fn of(reports: &[FileReport<'_>]) -> Self {
        let mut summary = Self::default();
        for report in reports {
            summary.add_file(report.diagnostics.iter().map(|diagnostic| diagnostic.severity));
        }
        summary
    }

    /// Counts one more file with findings of these severities.
    pub fn add_file(&mut self, severities: impl IntoIterator<Item = Severity>) {
        self.files += 1;
        for severity in severities {
            match severity {
                Severity::Error => self.errors += 1,
                Severity::Warning => self.warnings += 1,
                Severity::Advice => self.advice += 1,
            }
        }
    }

    /// Whether nothing was found.
    #[must_use]
    pub const fn is_clean(&self) -> bool {
        self.errors == 0 && self.warnings == 0 && self.advice == 0
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (self.errors, "error", "errors"),
            (self.warnings, "warning", "warnings"),
            (self.advice, "piece of advice", "pieces of advice"),
        ];
        let mut separator = "";
        for (count, one, many) in counts.into_iter().filter(|(count, ..)| *count > 0) {
            write!(f, "{separator}{}", Counted(count, one, many))?;
            separator = ", ";
        }
        if self.is_clean() {
            f.write_str("no problems")?;
        }
        write!(f, " in {}", Counted(self.files, "file", "files"))
    }
}

/// A number with its noun.
struct Counted(usize, &'static str, &'static str);

impl fmt::Display for Counted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.0, if self.0 == 1 { self.1 } else { self.2 })
    }
}
