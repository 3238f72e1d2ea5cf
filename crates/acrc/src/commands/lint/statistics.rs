//! How often each rule finds something: `--statistics`.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::io::{self, Write};

use acrc_diagnostics::{Applicability, Code, Diagnostic, FileReport, Severity};
use serde::Serialize;

/// The findings of one rule.
#[derive(Serialize)]
struct Row {
    code: &'static str,
    name: &'static str,
    /// Of the worst of them.
    severity: &'static str,
    count: usize,
    /// How many of them `--fix` repairs.
    fixable: usize,
}

/// Whether a finding can be repaired by fixes that are at most this bold.
pub(super) fn is_fixable(finding: &Diagnostic, boldest: Applicability) -> bool {
    finding.fixes.iter().any(|fix| fix.applicability <= boldest)
}

/// The rules by their findings, the most frequent first.
fn rows(reports: &[FileReport<'_>]) -> Vec<Row> {
    let mut rules: BTreeMap<Code, (Severity, usize, usize)> = BTreeMap::new();
    for finding in reports.iter().flat_map(FileReport::diagnostics) {
        let (severity, count, fixable) = rules.entry(finding.code).or_insert((finding.severity, 0, 0));
        *severity = finding.severity.max(*severity);
        *count += 1;
        *fixable += usize::from(is_fixable(finding, Applicability::Safe));
    }
    let row = |(code, (severity, count, fixable)): (Code, (Severity, usize, usize))| Row {
        code: code.id,
        name: code.name,
        severity: severity.as_str(),
        count,
        fixable,
    };
    let mut rows: Vec<Row> = rules.into_iter().map(row).collect();
    rows.sort_by_key(|row| Reverse(row.count));
    rows
}

/// A table for people.
pub(super) fn text(reports: &[FileReport<'_>], out: &mut dyn Write) -> io::Result<()> {
    let rows = rows(reports);
    let width = rows.first().map_or(0, |row| row.count.to_string().len());
    for Row { code, name, severity, count, fixable } in rows {
        let mark = match fixable {
            0 => "[ ]",
            some if some == count => "[*]",
            _ => "[-]",
        };
        writeln!(out, "{count:>width$}  {code}  {severity:<7}  {mark}  {name}")?;
    }
    Ok(())
}

/// One JSON array.
pub(super) fn json(reports: &[FileReport<'_>], out: &mut dyn Write) -> io::Result<()> {
    serde_json::to_writer(&mut *out, &rows(reports))?;
    out.write_all(b"\n")
}
