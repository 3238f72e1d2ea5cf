//! The machine-readable form: one compact JSON object and a line end.
//!
//! ```json
//! {"diagnostics":[{"code":"ACR101","name":"undefined-label","severity":"error","message":"...","file":"Prog0.8K",
//!   "range":{"start":{"line":3,"column":6},"end":{"line":3,"column":11}},"help":null,
//!   "related":[{"message":"...","range":{...}}],
//!   "fixes":[{"title":"...","applicability":"safe","edits":[{"range":{...},"text":"..."}]}]}],
//!  "errors":[{"file":"other/acrc.toml","message":"..."}],
//!  "summary":{"files":1,"errors":1,"warnings":0,"advice":0}}
//! ```
//!
//! `errors` has what could not be checked; its `file` may be null. Lines and columns count from 1, columns in Unicode scalar values; an end is one past the last character. Members are
//! added when there is need, never renamed or removed.

pub(crate) mod finding;

use std::io::{self, Write};

use serde::{Serialize, Serializer};

use crate::{FileReport, Summary, Unchecked};
use finding::FindingJson;

/// Writes every finding of every file, in the order of `reports`, what is `unchecked`, and the summary.
pub fn render(reports: &[FileReport<'_>], unchecked: &[Unchecked], out: &mut dyn Write) -> io::Result<()> {
    let document = Document {
        diagnostics: Diagnostics(reports),
        errors: unchecked.iter().map(ErrorJson::new).collect(),
        summary: SummaryJson::from(Summary::of(reports)),
    };
    serde_json::to_writer(&mut *out, &document)?;
    out.write_all(b"\n")
}

#[derive(Serialize)]
struct Document<'a> {
    diagnostics: Diagnostics<'a>,
    errors: Vec<ErrorJson<'a>>,
    summary: SummaryJson,
}

#[derive(Serialize)]
struct ErrorJson<'a> {
    file: Option<&'a str>,
    message: &'a str,
}

impl<'a> ErrorJson<'a> {
    fn new(Unchecked { name, reason }: &'a Unchecked) -> Self {
        Self { file: name.as_deref(), message: reason }
    }
}

/// The findings of all files as one array, converted one at a time as they are written.
struct Diagnostics<'a>(&'a [FileReport<'a>]);

impl Serialize for Diagnostics<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().flat_map(|report| {
            let file = report.file();
            report.diagnostics().iter().map(|diagnostic| FindingJson::new(file, diagnostic))
        }))
    }
}

#[derive(Serialize)]
struct SummaryJson {
    files: usize,
    errors: usize,
    warnings: usize,
    advice: usize,
}

impl From<Summary> for SummaryJson {
    fn from(Summary { files, errors, warnings, advice }: Summary) -> Self {
        Self { files, errors, warnings, advice }
    }
}
