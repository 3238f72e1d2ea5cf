//! SARIF 2.1.0, the interchange format of static analysis: for code scanning services and viewers in editors.
//!
//! One run with the rules that occur and a result a finding. Paths are URI references below `%SRCROOT%`, the folder that
//! the names of the files are relative to; absolute names become `file` URIs. The name of a rule is the one that users
//! write, in kebab case. Columns count Unicode scalar values. Byte offsets are left out: offsets in a decoded text are
//! not those in the file.
//!
//! A result has a fingerprint of its own, `acrcLineHash/v1`. It does not bear the name `primaryLocationLineHash`: GitHub
//! computes that one itself when a report is uploaded, and warns of a value that is not its own.

mod invocation;
mod result;
mod rule;
mod uri;

use std::collections::BTreeMap;
use std::io::{self, Write};

use serde::Serialize;

use crate::{Code, FileReport, Severity, Unchecked};
use invocation::Invocation;
use result::Results;
pub use rule::RuleInfo;
use rule::{RuleJson, Rules};

const SCHEMA: &str = "https://json.schemastore.org/sarif-2.1.0.json";
/// What relative paths are relative to. A viewer asks for it or knows it; it is never a path of this machine.
const SOURCE_ROOT: &str = "%SRCROOT%";

/// Writes every finding of every file, in the order of `reports`, after the rules that occur. `info` tells what is known
/// of a rule and is asked once for each. What is `unchecked` are notifications of an invocation that failed.
pub fn render(
    reports: &[FileReport<'_>],
    unchecked: &[Unchecked],
    info: &dyn Fn(Code) -> Option<RuleInfo>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let rules = Rules::of(reports, info);
    let driver = Driver { name: "acrc", semantic_version: env!("CARGO_PKG_VERSION"), rules: &rules.list };
    let run = Run {
        tool: Tool { driver },
        invocations: [Invocation::new(unchecked)],
        original_uri_base_ids: BTreeMap::from([(SOURCE_ROOT, BaseLocation::SOURCE_ROOT)]),
        column_kind: "unicodeCodePoints",
        newline_sequences: ["\r\n", "\n", "\r"],
        results: Results { reports, rules: &rules },
    };
    serde_json::to_writer(&mut *out, &Log { schema: SCHEMA, version: "2.1.0", runs: [run] })?;
    out.write_all(b"\n")
}

/// The word of SARIF for a severity.
const fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Advice => "note",
    }
}

#[derive(Serialize)]
struct Log<'a> {
    #[serde(rename = "$schema")]
    schema: &'static str,
    version: &'static str,
    runs: [Run<'a>; 1],
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Run<'a> {
    tool: Tool<'a>,
    invocations: [Invocation; 1],
    original_uri_base_ids: BTreeMap<&'static str, BaseLocation>,
    column_kind: &'static str,
    newline_sequences: [&'static str; 3],
    results: Results<'a>,
}

#[derive(Serialize)]
struct Tool<'a> {
    driver: Driver<'a>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Driver<'a> {
    name: &'static str,
    semantic_version: &'static str,
    rules: &'a [RuleJson],
}

/// A folder that has a name in the report and a place only on the machine that reads it.
#[derive(Serialize)]
struct BaseLocation {
    description: Description,
}

#[derive(Serialize)]
struct Description {
    text: &'static str,
}

impl BaseLocation {
    const SOURCE_ROOT: Self = Self { description: Description { text: "The folder that acrc was run in." } };
}
