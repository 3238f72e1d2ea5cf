//! `acrc lint`: checks projects and shows what was found.

use std::collections::BTreeSet;

use acrc_analysis::project::{FailOn as ConfigFailOn, LoadedProject};
use acrc_diagnostics::{FileReport, Severity, Summary, concise, json, text};

use super::project::{check, load, reports};
use crate::cli::{ColorChoice, FailOn, LintArguments, LintFormat};
use crate::exit::Exit;
use crate::output::{Terminal, print};

pub(super) fn run(arguments: &LintArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let mut checked = Vec::new();
    let mut failed = false;
    let mut seen = BTreeSet::new();
    for path in &arguments.paths {
        // The same project given twice is checked once.
        if !seen.insert(path.canonicalize().unwrap_or_else(|_| path.clone())) {
            continue;
        }
        let project = load(path)?;
        let fail_on = arguments.fail_on.map_or_else(|| configured(&project), ConfigFailOn::from);
        let found = check(&project);
        failed |= found.iter().flatten().any(|finding| fail_on.fails(finding.severity));
        checked.push((project, found));
    }
    let reports: Vec<FileReport> = checked.iter().flat_map(|(project, found)| reports(project, found)).collect();
    show(&reports, arguments.format, color)?;
    Ok(if failed { Exit::Findings } else { Exit::Clean })
}

fn configured(project: &LoadedProject) -> ConfigFailOn {
    project.config.lint.fail_on.unwrap_or(ConfigFailOn::Warning)
}

impl From<FailOn> for ConfigFailOn {
    fn from(choice: FailOn) -> Self {
        match choice {
            FailOn::Never => Self::Never,
            FailOn::Warning => Self::Warning,
            FailOn::Error => Self::Error,
        }
    }
}

fn show(reports: &[FileReport], format: LintFormat, color: ColorChoice) -> anyhow::Result<()> {
    let terminal = Terminal::output(color);
    print(|out| match format {
        LintFormat::Json => json::render(reports, out),
        LintFormat::Concise => concise::render(reports, out),
        LintFormat::Text => {
            text::render(reports, text::Options { color: terminal.color, ..text::Options::default() }, out)?;
            writeln!(out, "{}", Summary::of(reports))?;
            explain_hint(reports, terminal, out)
        }
    })
}

/// Where to read more about what was found.
fn explain_hint(reports: &[FileReport], terminal: Terminal, out: &mut dyn std::io::Write) -> std::io::Result<()> {
    let found = reports.iter().flat_map(FileReport::diagnostics);
    let codes: BTreeSet<&str> =
        found.filter(|found| found.severity >= Severity::Warning).map(|found| found.code.id).collect();
    match codes.into_iter().next() {
        Some(code) => writeln!(out, "{}", terminal.faint(&format!("acrc explain {code} says more about a finding"))),
        None => Ok(()),
    }
}
