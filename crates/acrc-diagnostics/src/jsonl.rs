//! JSON Lines: an object a finding, one on each line, for tools that read findings as they come.
//!
//! An object has the members of a finding in [`json`](crate::json). What could not be checked
//! comes last, as an error with the name `not-checked`, without code and range. There is no summary; without findings
//! nothing is written. A line holds no other line separator of any kind, so it may be split by any reader of lines.

use std::io::{self, Write};

use serde::Serialize as _;
use serde_json::Serializer;
use serde_json::ser::Formatter;

use crate::json::finding::FindingJson;
use crate::{FileReport, Unchecked};

/// Writes every finding of every file on a line of its own, in the order of `reports`, then what is `unchecked`.
pub fn render(reports: &[FileReport<'_>], unchecked: &[Unchecked], out: &mut dyn Write) -> io::Result<()> {
    let found = reports.iter().flat_map(|report| {
        let file = report.file();
        report.diagnostics().iter().map(|diagnostic| FindingJson::new(file, diagnostic))
    });
    for finding in found.chain(unchecked.iter().map(FindingJson::unchecked)) {
        finding.serialize(&mut Serializer::with_formatter(&mut *out, OneLine))?;
        out.write_all(b"\n")?;
    }
    Ok(())
}

/// Compact, and with the characters escaped that JSON allows in a string and some readers take for the end of a line.
struct OneLine;

impl Formatter for OneLine {
    fn write_string_fragment<W: ?Sized + Write>(&mut self, out: &mut W, fragment: &str) -> io::Result<()> {
        let separators = ['\u{85}', '\u{2028}', '\u{2029}'];
        for part in fragment.split_inclusive(separators) {
            match part.char_indices().next_back() {
                Some((start, last)) if separators.contains(&last) => {
                    out.write_all(part.get(..start).unwrap_or_default().as_bytes())?;
                    write!(out, "\\u{:04x}", last as u32)?;
                }
                _ => out.write_all(part.as_bytes())?,
            }
        }
        Ok(())
    }
}
