//! A Code Quality report of GitLab: a JSON array with an object a finding, which GitLab shows in merge requests.
//!
//! GitLab does not show the name of a check, so the description begins with the code. Errors are `critical`, warnings
//! `major`, warnings that are unconfirmed `minor`, advice is `info`. What could not be checked is a `blocker`
//! at the beginning of the file that is in the way.

use std::io::{self, Write};

use serde::ser::SerializeSeq as _;
use serde::{Serialize, Serializer};

use crate::fingerprint::Fingerprints;
use crate::json::finding::PositionJson;
use crate::path::repository_path;
use crate::plain::plain_line;
use crate::unchecked::NOT_CHECKED;
use crate::{Diagnostic, FileReport, Severity, Unchecked};

/// Writes every finding of every file, in the order of `reports`, then what is `unchecked`.
pub fn render(reports: &[FileReport<'_>], unchecked: &[Unchecked], out: &mut dyn Write) -> io::Result<()> {
    serde_json::to_writer(&mut *out, &Issues(reports, unchecked))?;
    out.write_all(b"\n")
}

/// The findings of all files, converted one at a time as they are written.
struct Issues<'a>(&'a [FileReport<'a>], &'a [Unchecked]);

impl Serialize for Issues<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut issues = serializer.serialize_seq(None)?;
        let mut fingerprints = Fingerprints::default();
        for report in self.0 {
            let path = repository_path(report.file().name);
            fingerprints.enter_file(&path);
            for diagnostic in report.diagnostics() {
                issues.serialize_element(&Issue {
                    description: format!("{}: {}", diagnostic.code, plain_line(&diagnostic.message)),
                    check_name: diagnostic.code.id,
                    fingerprint: fingerprints.next(report.file(), diagnostic),
                    severity: severity(diagnostic),
                    location: Location { path: &path, positions: Positions::new(report, diagnostic) },
                })?;
            }
        }
        for unchecked in self.1 {
            let path = repository_path(unchecked.name_or_tool());
            fingerprints.enter_file(&path);
            issues.serialize_element(&Issue {
                description: plain_line(&unchecked.reason).into_owned(),
                check_name: NOT_CHECKED,
                fingerprint: fingerprints.of_unchecked(),
                severity: "blocker",
                location: Location { path: &path, positions: Positions::START },
            })?;
        }
        issues.end()
    }
}

const fn severity(diagnostic: &Diagnostic) -> &'static str {
    match diagnostic.severity {
        Severity::Error => "critical",
        Severity::Warning if diagnostic.unconfirmed => "minor",
        Severity::Warning => "major",
        Severity::Advice => "info",
    }
}

#[derive(Serialize)]
struct Issue<'a> {
    description: String,
    check_name: &'static str,
    fingerprint: String,
    severity: &'static str,
    location: Location<'a>,
}

#[derive(Serialize)]
struct Location<'a> {
    path: &'a str,
    positions: Positions,
}

#[derive(Serialize)]
struct Positions {
    begin: PositionJson,
    end: PositionJson,
}

impl Positions {
    /// The beginning of a file.
    const START: Self = Self { begin: PositionJson::START, end: PositionJson::START };

    fn new(report: &FileReport<'_>, diagnostic: &Diagnostic) -> Self {
        let at = |offset| PositionJson::new(report.file(), offset);
        Self { begin: at(diagnostic.span.start), end: at(diagnostic.span.end) }
    }
}
