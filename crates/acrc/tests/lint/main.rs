//! `acrc lint`: which rules are heard, repairs, reports, projects.

#[path = "../common/mod.rs"]
mod common;
mod projects;
mod repairs;
mod reports;
mod selection;
mod watch;

use common::{Bench, Run};

/// An unused label, a jump to nowhere, a size without parentheses.
const THREE: &str = "PROG0\nPROGRAM\n_A\nGOTO Nowhere\nCLEAR : DIM LV10\nPRINT LV0\nENDP\n";

/// The codes of a concise report, each with its file and line.
fn codes(run: &Run) -> Vec<String> {
    let lines = run.stdout.lines().filter_map(|line| {
        let (place, rest) = line.split_once(": ")?;
        let (file_line, _) = place.rsplit_once(':')?;
        let code = rest.split_once('[')?.1.split_once(']')?.0;
        Some(format!("{file_line} {code}"))
    });
    lines.collect()
}

/// Lints with a concise report.
fn lint(bench: &Bench, arguments: &[&str]) -> Vec<String> {
    codes(&bench.acrc(["lint", "--format", "concise", "--quiet"].iter().chain(arguments)))
}
