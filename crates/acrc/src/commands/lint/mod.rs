//! `acrc lint`: checks projects, shows what was found, and repairs it.

mod baseline;
mod checked;
mod repair;
mod rules;
mod show;
mod statistics;
mod watch;

use std::io::IsTerminal as _;
use std::mem::ManuallyDrop;
use std::path::PathBuf;

use acrc_analysis::project::{FailOn as ConfigFailOn, LintConfig, LoadError, Selection};
use acrc_diagnostics::{Applicability, FileReport, Unchecked, unified_diff};
use anyhow::bail;

use self::baseline::{Baseline, Hidden};
use self::checked::Checked;
use self::repair::Change;
use self::show::{Notes, counted};
use super::project::{inputs, load};
use super::stdin;
use super::targets::{self, display};
use crate::cli::{ColorChoice, FailOn, LintArguments};
use crate::exit::{Exit, note, say, warn};
use crate::output::{Terminal, print, refuse_clashes, tell};

pub(super) fn run(arguments: &LintArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let selection = Selection::from(&arguments.selection);
    let on_command_line = LintConfig { command_line: selection.clone(), ..LintConfig::default() };
    let problems = acrc_lint::problems(&on_command_line);
    if !problems.is_empty() {
        bail!("{}", problems.join("\n"));
    }
    show::check(&arguments.output)?;
    let from_stdin = stdin::is_meant(&arguments.paths, arguments.stdin_filename.as_deref())?;
    match (arguments.selection.rules, arguments.watch, from_stdin) {
        (_, true, true) => bail!("standard input can't be watched"),
        (true, ..) => rules::run(arguments, &selection),
        (_, true, _) => watch::run(arguments, &selection, color),
        (.., from_stdin) => {
            // The process ends behind this: taking the trees of a large project apart first is noticeable.
            let mut run = ManuallyDrop::new(Run::load(arguments, &selection, from_stdin));
            run.finish(color)
        }
    }
}

/// One look at projects.
struct Run<'a> {
    arguments: &'a LintArguments,
    /// The program comes from standard input.
    from_stdin: bool,
    projects: Vec<Checked>,
    /// Why some could not be looked at, or not be written.
    errors: Vec<anyhow::Error>,
}

impl<'a> Run<'a> {
    /// Loads and checks what the paths stand for.
    fn load(arguments: &'a LintArguments, selection: &Selection, from_stdin: bool) -> Self {
        if from_stdin {
            let mut run = Self { arguments, from_stdin, projects: Vec::new(), errors: Vec::new() };
            match stdin::load(arguments.stdin_filename.as_deref()) {
                Ok((target, project)) => run.projects.push(Checked::new(&target, project, selection)),
                Err(error) => run.errors.push(error),
            }
            return run;
        }
        let (targets, mut errors) = targets::find(&arguments.paths);
        let mut projects = Vec::with_capacity(targets.len());
        let progress = Progress::new(targets.len(), arguments.output.quiet);
        for (number, target) in targets.iter().enumerate() {
            progress.at(number, target.path.as_str());
            match load(target.path.as_std_path()) {
                Ok(project) => projects.push(Checked::new(target, project, selection)),
                Err(error) => errors.push(error),
            }
        }
        progress.end();
        Self { arguments, from_stdin, projects, errors }
    }

    /// Repairs or shows, as it was asked for.
    fn finish(&mut self, color: ColorChoice) -> anyhow::Result<Exit> {
        let options = &self.arguments.output;
        let repair = &self.arguments.repair;
        let mut notes = Notes::default();
        if repair.fix || repair.diff {
            let changes = self.repair(if repair.bold { Applicability::Unsafe } else { Applicability::Safe });
            if repair.diff {
                self.show_diff(&changes, color)?;
                return Ok(self.exit(changes.iter().any(|changes| !changes.is_empty()), color));
            }
            notes.fixed = Some(self.write(&changes)?);
        }
        if options.write_baseline {
            self.write_baseline()?;
            return Ok(self.exit(false, color));
        }
        notes.hidden = self.hide()?;
        if self.reports_something() {
            let unchecked = self.unchecked();
            let reports: Vec<FileReport<'_>> = self.projects.iter().flat_map(Checked::reports).collect();
            if self.from_stdin && repair.fix {
                // Standard output has the repaired text.
                show::on_stderr(&reports, &unchecked, notes, options, color);
            } else {
                show::show(&reports, &unchecked, notes, options, color, &self.inputs())?;
            }
        }
        let failed = self.failed();
        Ok(self.exit(failed, color))
    }

    fn repair(&mut self, boldest: Applicability) -> Vec<Vec<Change>> {
        let mut all = Vec::with_capacity(self.projects.len());
        for checked in &mut self.projects {
            let (changes, errors) = repair::repair(checked, boldest);
            self.errors.extend(errors);
            all.push(changes);
        }
        all
    }

    /// Writes what was repaired; the number of fixes.
    fn write(&mut self, changes: &[Vec<Change>]) -> anyhow::Result<usize> {
        if self.from_stdin {
            let shown = self.projects.iter().flat_map(|checked| {
                let files = checked.project.files.iter().zip(&checked.shown);
                files.filter(|(_, shown)| **shown).map(|(file, _)| file.source.encode())
            });
            for bytes in shown {
                print(|out| out.write_all(&bytes))?;
            }
            return Ok(changes.iter().flatten().map(|change| change.fixes).sum());
        }
        let mut fixed = 0;
        for (checked, changes) in self.projects.iter().zip(changes) {
            let (written, errors) = repair::write(checked, changes);
            fixed += written;
            self.errors.extend(errors);
        }
        Ok(fixed)
    }

    fn show_diff(&self, changes: &[Vec<Change>], color: ColorChoice) -> anyhow::Result<()> {
        let terminal = Terminal::output(color);
        print(|out| {
            for (checked, changes) in self.projects.iter().zip(changes) {
                for change in changes {
                    let name = checked.names.get(change.place).map_or("", String::as_str);
                    unified_diff(name, &change.before.text, &change.after.text, terminal.color, out)?;
                }
            }
            Ok(())
        })?;
        if !self.arguments.output.quiet {
            let fixes = changes.iter().flatten().map(|change| change.fixes).sum();
            let files = changes.iter().flatten().count();
            // Standard output is for `patch`.
            let line = format!("{} in {} would be repaired", counted(fixes, "finding"), counted(files, "file"));
            tell(|err| writeln!(err, "{line}"));
        }
        Ok(())
    }

    fn write_baseline(&self) -> anyhow::Result<()> {
        let Some(path) = &self.arguments.output.baseline else { return Ok(()) };
        refuse_clashes(&[path], &self.inputs())?;
        let mut baseline = Baseline::empty(path);
        self.projects.iter().for_each(|checked| baseline.add(checked));
        baseline.write(path)?;
        if self.arguments.output.quiet {
            return Ok(());
        }
        print(|out| writeln!(out, "{}: {}", path.display(), counted(baseline.len(), "finding")))
    }

    /// Leaves out what the baseline lists.
    fn hide(&mut self) -> anyhow::Result<Option<Hidden>> {
        let Some(path) = &self.arguments.output.baseline else { return Ok(None) };
        let mut baseline = Baseline::read(path)?;
        let mut total = Hidden::default();
        for checked in &mut self.projects {
            let hidden = baseline.hide(checked);
            total.known += hidden.known;
            total.repaired += hidden.repaired;
        }
        total.repaired += baseline.gone();
        Ok(Some(total))
    }

    /// Whether there is a report: not for people when nothing could be checked, who read the errors.
    fn reports_something(&self) -> bool {
        let for_programs = self.arguments.output.format.is_for_programs() && !self.arguments.output.statistics;
        !self.projects.is_empty() || self.errors.is_empty() || for_programs
    }

    /// What went wrong, for reports.
    fn unchecked(&self) -> Vec<Unchecked> {
        let name = |error: &anyhow::Error| error.downcast_ref::<LoadError>().map(|error| display(error.path()));
        let unchecked = |error| Unchecked { name: name(error), reason: format!("{error:#}") };
        self.errors.iter().map(unchecked).collect()
    }

    /// The files that must not be written over.
    fn inputs(&self) -> Vec<PathBuf> {
        self.projects.iter().flat_map(|checked| inputs(&checked.project)).collect()
    }

    /// Whether something was found that counts.
    fn failed(&self) -> bool {
        self.projects.iter().any(|checked| {
            let configured = checked.project.config.lint.fail_on.unwrap_or(ConfigFailOn::Warning);
            let fail_on = self.arguments.output.fail_on.map_or(configured, ConfigFailOn::from);
            checked.found_in_shown().any(|found| fail_on.fails(found.severity))
        })
    }

    fn exit(&self, failed: bool, color: ColorChoice) -> Exit {
        self.say_troubles(color);
        self.status(failed)
    }

    /// Says what is odd and what went wrong.
    fn say_troubles(&self, color: ColorChoice) {
        let terminal = Terminal::error(color);
        if !self.arguments.output.quiet {
            for checked in &self.projects {
                checked.warnings().iter().for_each(|line| warn(line, terminal));
                if let Some(line) = checked.note() {
                    note(&line, terminal);
                }
            }
        }
        self.errors.iter().for_each(|error| say(error, terminal));
    }

    fn status(&self, failed: bool) -> Exit {
        match (self.errors.is_empty(), failed) {
            (false, _) => Exit::Failure,
            (true, true) => Exit::Findings,
            (true, false) => Exit::Clean,
        }
    }
}

impl From<FailOn> for ConfigFailOn {
    fn from(choice: FailOn) -> Self {
        match choice {
            FailOn::Never => Self::Never,
            FailOn::Advice => Self::Advice,
            FailOn::Warning => Self::Warning,
            FailOn::Error => Self::Error,
        }
    }
}

/// Says on a terminal which of several projects is being looked at.
struct Progress {
    total: usize,
    shown: bool,
}

impl Progress {
    /// Fewer are done before anybody reads it.
    const WORTH_IT: usize = 8;

    fn new(total: usize, quiet: bool) -> Self {
        Self { total, shown: total >= Self::WORTH_IT && !quiet && std::io::stderr().is_terminal() }
    }

    fn at(&self, number: usize, name: &str) {
        if self.shown {
            tell(|err| write!(err, "\r\u{1b}[2Kchecking {} of {}: {name}", number + 1, self.total));
        }
    }

    fn end(&self) {
        if self.shown {
            tell(|err| write!(err, "\r\u{1b}[2K"));
        }
    }
}
