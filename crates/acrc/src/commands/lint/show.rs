//! The report in the format that was asked for, and what is said around it.

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use acrc_diagnostics::sarif::RuleInfo;
use acrc_diagnostics::{
    Applicability, Code, FileReport, Severity, Summary, Unchecked, checkstyle, concise, github, gitlab, json, jsonl,
    junit, sarif, text,
};
use anyhow::{Context as _, bail};

use super::baseline::Hidden;
use super::statistics::{self, is_fixable};
use crate::cli::{ColorChoice, LintFormat, OutputArguments};
use crate::output::{OutputFile, Terminal, print, refuse_clashes, tell};

impl LintFormat {
    /// Whether it has a place for what could not be checked, so that a report is due also when nothing was.
    pub(super) fn is_for_programs(self) -> bool {
        !matches!(self, Self::Text | Self::Concise)
    }
}

/// What a report says besides the findings.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Notes {
    /// Fixes that were applied.
    pub(super) fixed: Option<usize>,
    /// What a baseline leaves out.
    pub(super) hidden: Option<Hidden>,
}

/// Refuses options that do not go together.
pub(super) fn check(options: &OutputArguments) -> anyhow::Result<()> {
    if options.statistics && !matches!(options.format, LintFormat::Text | LintFormat::Json) {
        bail!("statistics have the formats text and json");
    }
    Ok(())
}

/// Shows findings on standard output, or writes them to the file of `--output-file`, which must not be one of `inputs`.
/// What is said around a format for other programs goes to standard error.
pub(super) fn show(
    reports: &[FileReport<'_>],
    unchecked: &[Unchecked],
    notes: Notes,
    options: &OutputArguments,
    color: ColorChoice,
    inputs: &[PathBuf],
) -> anyhow::Result<()> {
    let terminal = Terminal::output(color);
    if let Some(path) = &options.output_file {
        write(reports, unchecked, options, path, inputs)?;
        return print(|out| say(reports, notes, options, terminal, out));
    }
    print(|out| {
        report(reports, unchecked, options, terminal, out)?;
        if options.format == LintFormat::Text { say(reports, notes, options, terminal, out) } else { Ok(()) }
    })?;
    if options.format != LintFormat::Text {
        tell(|err| say(reports, notes, options, Terminal::error(color), err));
    }
    Ok(())
}

/// Shows findings on standard error, when standard output has something else.
pub(super) fn on_stderr(
    reports: &[FileReport<'_>],
    unchecked: &[Unchecked],
    notes: Notes,
    options: &OutputArguments,
    color: ColorChoice,
) {
    let terminal = Terminal::error(color);
    tell(|err| {
        report(reports, unchecked, options, terminal, err)?;
        say(reports, notes, options, terminal, err)
    });
}

fn write(
    reports: &[FileReport<'_>],
    unchecked: &[Unchecked],
    options: &OutputArguments,
    path: &Path,
    inputs: &[PathBuf],
) -> anyhow::Result<()> {
    refuse_clashes(&[path], inputs)?;
    let mut file = OutputFile::create(path)?;
    let written = report(reports, unchecked, options, Terminal { color: false }, &mut file);
    written.with_context(|| format!("cannot write {}", path.display()))?;
    file.finish()
}

fn report(
    reports: &[FileReport<'_>],
    unchecked: &[Unchecked],
    options: &OutputArguments,
    terminal: Terminal,
    out: &mut dyn Write,
) -> io::Result<()> {
    match (options.format, options.statistics) {
        (LintFormat::Json, true) => statistics::json(reports, out),
        (_, true) => statistics::text(reports, out),
        (LintFormat::Text, _) => {
            text::render(reports, text::Options { color: terminal.color, ..text::Options::default() }, out)
        }
        (LintFormat::Concise, _) => concise::render(reports, out),
        (LintFormat::Json, _) => json::render(reports, unchecked, out),
        (LintFormat::Jsonl, _) => jsonl::render(reports, unchecked, out),
        (LintFormat::Sarif, _) => sarif::render(reports, unchecked, &rule_info, out),
        (LintFormat::Github, _) => github::render(reports, unchecked, out),
        (LintFormat::Gitlab, _) => gitlab::render(reports, unchecked, out),
        (LintFormat::Junit, _) => junit::render(reports, unchecked, out),
        (LintFormat::Checkstyle, _) => checkstyle::render(reports, unchecked, out),
    }
}

/// The page of a rule for code scanning.
fn rule_info(code: Code) -> Option<RuleInfo> {
    let doc = acrc_lint::explain(code.id)?;
    let tags = ["acrobasic", doc.group.as_str()];
    Some(RuleInfo {
        severity: doc.severity,
        summary: format!("{}.", doc.summary()).into(),
        description: format!("{} {}", doc.what, doc.why).into(),
        help: doc.render().into(),
        help_markdown: Some(doc.markdown().into()),
        tags: tags.map(Into::into).to_vec(),
    })
}

/// The sentences around a report. Beside a format for other programs only what that format can't say.
fn say(
    reports: &[FileReport<'_>],
    notes: Notes,
    options: &OutputArguments,
    terminal: Terminal,
    out: &mut dyn Write,
) -> io::Result<()> {
    if options.quiet {
        return Ok(());
    }
    let for_people = options.format == LintFormat::Text || options.output_file.is_some();
    let fixed = notes.fixed.filter(|fixed| *fixed > 0 || for_people);
    match (for_people, fixed) {
        (true, Some(fixed)) => writeln!(out, "{}; {} fixed", Summary::of(reports), fixed)?,
        (true, None) => writeln!(out, "{}", Summary::of(reports))?,
        (false, Some(fixed)) => writeln!(out, "{fixed} fixed")?,
        (false, None) => {}
    }
    if let Some(hidden) = notes.hidden {
        say_hidden(hidden, options, out)?;
    }
    if for_people {
        say_fixable(reports, out)?;
        if !options.statistics {
            explain_hint(reports, terminal, out)?;
        }
    }
    Ok(())
}

fn say_hidden(hidden: Hidden, options: &OutputArguments, out: &mut dyn Write) -> io::Result<()> {
    let name = options.baseline.as_deref().map(|path| path.display().to_string()).unwrap_or_default();
    if hidden.known > 0 {
        writeln!(out, "{} of {name} not shown", counted(hidden.known, "finding"))?;
    }
    if hidden.repaired > 0 {
        let verb = if hidden.repaired == 1 { "is" } else { "are" };
        writeln!(
            out,
            "{} of {name} {verb} repaired: write it anew with --write-baseline",
            counted(hidden.repaired, "finding")
        )?;
    }
    Ok(())
}

/// What could be repaired.
fn say_fixable(reports: &[FileReport<'_>], out: &mut dyn Write) -> io::Result<()> {
    let count = |boldest| {
        let found = reports.iter().flat_map(FileReport::diagnostics);
        found.filter(|finding| is_fixable(finding, boldest)).count()
    };
    let safe = count(Applicability::Safe);
    match (safe, count(Applicability::Unsafe) - safe) {
        (0, 0) => Ok(()),
        (safe, 0) => writeln!(out, "{} can be repaired with --fix", counted(safe, "finding")),
        (0, bold) => writeln!(out, "{} can be repaired with --fix --unsafe", counted(bold, "finding")),
        (safe, bold) => {
            writeln!(out, "{} can be repaired with --fix, {bold} more with --fix --unsafe", counted(safe, "finding"))
        }
    }
}

/// Where to read more about what was found.
fn explain_hint(reports: &[FileReport<'_>], terminal: Terminal, out: &mut dyn Write) -> io::Result<()> {
    let found = reports.iter().flat_map(FileReport::diagnostics);
    let codes: BTreeSet<&str> =
        found.filter(|found| found.severity >= Severity::Warning).map(|found| found.code.id).collect();
    match codes.into_iter().next() {
        Some(code) => writeln!(out, "{}", terminal.faint(&format!("acrc explain {code} says more about a finding"))),
        None => Ok(()),
    }
}

/// A number with its noun.
pub(super) fn counted(count: usize, noun: &str) -> String {
    if count == 1 { format!("1 {noun}") } else { format!("{count} {noun}s") }
}
