//! One line a finding: `file:line:column: severity[code] message`.

use std::io::{self, Write};

use crate::FileReport;
use crate::plain::plain_line;

/// Writes every finding of every file as one line, in the order of `reports`.
pub fn render(reports: &[FileReport<'_>], out: &mut dyn Write) -> io::Result<()> {
    for report in reports {
        let file = report.file();
        let name = plain_line(file.name);
        for diagnostic in report.diagnostics() {
            writeln!(
                out,
                "{name}:{}: {}[{}] {}",
                file.position(diagnostic.span.start),
                diagnostic.severity,
                diagnostic.code,
                plain_line(&diagnostic.message),
            )?;
        }
    }
    Ok(())
}
