//! Checks again whenever a file changes: `--watch`.
//!
//! The database stays: of a changed file only the text is replaced, and only what depends on it is computed anew. What
//! changes the make-up of a project (a new file, one that is gone, `acrc.toml`) loads everything again.

use std::collections::{BTreeMap, BTreeSet};
use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;

use acrc_analysis::project::{CONFIG_NAME, Selection, holds_programs};
use acrc_diagnostics::FileReport;
use acrc_syntax::SourceText;
use anyhow::Context as _;
use camino::Utf8Path;
use notify::{RecommendedWatcher, RecursiveMode, Watcher as _};

use super::Run;
use super::checked::Checked;
use super::show::{Notes, counted, show};
use crate::cli::{ColorChoice, LintArguments};
use crate::commands::targets::real;
use crate::exit::Exit;
use crate::output::{Terminal, nobody_reads, print, tell};

/// How long nothing must change before the files are looked at: an editor saves in several steps.
const QUIET: Duration = Duration::from_millis(60);
/// Puts the cursor into the corner of an empty screen.
const CLEAR: &str = "\u{1b}[2J\u{1b}[3J\u{1b}[H";

enum Message {
    Changed(Vec<PathBuf>),
    Stop,
}

pub(super) fn run(arguments: &LintArguments, selection: &Selection, color: ColorChoice) -> anyhow::Result<Exit> {
    let (sender, messages) = mpsc::channel();
    let stop = sender.clone();
    ctrlc::set_handler(move || drop(stop.send(Message::Stop))).context("cannot watch for Ctrl-C")?;
    let watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
        // Reading files is an event too.
        if let Ok(event) = event
            && !event.kind.is_access()
        {
            drop(sender.send(Message::Changed(event.paths)));
        }
    })
    .context("cannot watch for changes")?;
    let mut watched = Watched { watcher, folders: folders(&arguments.paths) };
    // Watching begins first, so that no change is missed.
    watched.attach()?;
    let mut session = Session { run: Run::load(arguments, selection, false), watched, selection, color };
    loop {
        session.show()?;
        if nobody_reads() {
            return Ok(session.run.status(session.run.failed()));
        }
        loop {
            match next(&messages) {
                None => return Ok(Exit::Interrupted),
                Some(changed) if session.update(&changed) => break,
                Some(_) => {}
            }
        }
    }
}

/// The folders that are watched, and what they lie in, so that one that was removed is seen when it comes back.
struct Watched {
    watcher: RecommendedWatcher,
    /// None inside another.
    folders: BTreeSet<PathBuf>,
}

impl Watched {
    /// Begins, or begins anew: the watch of a folder that was removed is not that of the one that has its name now.
    fn attach(&mut self) -> anyhow::Result<()> {
        for folder in &self.folders {
            if let Some(above) = folder.ancestors().skip(1).find(|above| above.is_dir()) {
                // A folder that may be passed through need not be one that may be watched.
                let _ = self.watcher.watch(above, RecursiveMode::NonRecursive);
            }
            if folder.is_dir() {
                let _ = self.watcher.unwatch(folder);
                let refuse = || format!("cannot watch {}", folder.display());
                self.watcher.watch(folder, RecursiveMode::Recursive).with_context(refuse)?;
            }
        }
        Ok(())
    }

    /// A folder that is watched lies at this path or below it.
    fn lie_in(&self, path: &Path) -> bool {
        self.folders.iter().any(|folder| folder.starts_with(path))
    }

    /// The path lies in a folder that is watched.
    fn hold(&self, path: &Path) -> bool {
        self.folders.iter().any(|folder| path.starts_with(folder))
    }
}

/// The folders that hold the paths, none inside another.
fn folders(paths: &[PathBuf]) -> BTreeSet<PathBuf> {
    let folders = paths.iter().map(|path| real(path));
    let folders = folders.map(|path| if path.is_dir() { path } else { path.parent().unwrap_or(&path).to_owned() });
    let folders: BTreeSet<PathBuf> = folders.collect();
    let outer = |folder: &PathBuf| !folders.iter().any(|other| other != folder && folder.starts_with(other));
    folders.iter().filter(|folder| outer(folder)).cloned().collect()
}

/// What changed until nothing changes for a moment; `None` at the end.
fn next(messages: &Receiver<Message>) -> Option<BTreeSet<PathBuf>> {
    let mut changed = BTreeSet::new();
    let mut message = messages.recv().ok()?;
    loop {
        match message {
            Message::Changed(paths) => changed.extend(paths),
            Message::Stop => return None,
        }
        match messages.recv_timeout(QUIET) {
            Ok(more) => message = more,
            Err(_) => return Some(changed),
        }
    }
}

struct Session<'a> {
    run: Run<'a>,
    watched: Watched,
    selection: &'a Selection,
    color: ColorChoice,
}

/// What a change of some paths asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Need {
    /// Nothing.
    Nothing,
    /// Files of known projects were changed.
    Check,
    /// Everything may be another.
    Load,
}

impl Session<'_> {
    /// Takes over what changed; whether there is something new to show.
    fn update(&mut self, changed: &BTreeSet<PathBuf>) -> bool {
        let mut need = Need::Nothing;
        let known = self.known();
        for path in changed {
            let step = match known.get(path) {
                Some(&(project, file)) => self.read(path, project, file),
                None if self.watched.lie_in(path) => Need::Load,
                None if self.watched.hold(path) => need_of_other(path, &known),
                None => Need::Nothing,
            };
            need = match (need, step) {
                (Need::Load, _) | (_, Need::Load) => Need::Load,
                (Need::Check, _) | (_, Need::Check) => Need::Check,
                _ => Need::Nothing,
            };
        }
        match need {
            Need::Nothing => return false,
            Need::Check => self.run.projects.iter_mut().for_each(Checked::check),
            Need::Load => {
                let attached = self.watched.attach();
                self.run = Run::load(self.run.arguments, self.selection, false);
                self.run.errors.extend(attached.err());
            }
        }
        true
    }

    /// The files of all projects by their paths: places of project and file.
    fn known(&self) -> BTreeMap<PathBuf, (usize, usize)> {
        let mut known = BTreeMap::new();
        for (project, checked) in self.run.projects.iter().enumerate() {
            for (file, loaded) in checked.project.files.iter().enumerate() {
                known.insert(real(loaded.path.as_std_path()), (project, file));
            }
        }
        known
    }

    /// Reads a file again.
    fn read(&mut self, path: &Path, project: usize, file: usize) -> Need {
        let source = std::fs::read(path).ok().and_then(|bytes| SourceText::decode(&bytes).ok());
        // A file that is gone, or can't be read, is told by loading its project.
        let (Some(source), Some(checked)) = (source, self.run.projects.get_mut(project)) else { return Need::Load };
        let input = checked.input.files(&checked.db).get(file).copied();
        let (Some(input), Some(loaded)) = (input, checked.project.files.get_mut(file)) else { return Need::Load };
        if loaded.source == source {
            return Need::Nothing;
        }
        checked.db.replace(input, &source);
        loaded.source = source;
        Need::Check
    }

    fn show(&mut self) -> anyhow::Result<()> {
        let options = &self.run.arguments.output;
        let is_screen = std::io::stdout().is_terminal();
        if is_screen {
            print(|out| write!(out, "{CLEAR}"))?;
        }
        let found: Vec<_> = self.run.projects.iter().map(|checked| checked.found.clone()).collect();
        let notes = Notes { fixed: None, hidden: self.run.hide()? };
        let reports: Vec<FileReport<'_>> = self.run.projects.iter().flat_map(Checked::reports).collect();
        if self.run.reports_something() {
            show(&reports, &self.run.unchecked(), notes, options, self.color, &[])?;
        }
        drop(reports);
        // What a baseline hides now may be looked for again.
        for (checked, found) in self.run.projects.iter_mut().zip(found) {
            checked.found = found;
        }
        self.run.say_troubles(self.color);
        if !options.quiet {
            let terminal = Terminal::error(self.color);
            let files: usize = self.run.projects.iter().map(|checked| checked.project.files.len()).sum();
            let line = format!("watching {}; Ctrl-C ends this", counted(files, "file"));
            tell(|err| writeln!(err, "{}", terminal.faint(&line)));
        }
        Ok(())
    }
}

/// What the change of a path that is no file of a project asks for.
fn need_of_other(path: &Path, known: &BTreeMap<PathBuf, (usize, usize)>) -> Need {
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let is_program = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("8k"));
    if name == CONFIG_NAME || name == ".gitignore" || is_program {
        return Need::Load;
    }
    // A folder that is moved takes its files along.
    let held_files = known.range(path.to_owned()..).next().is_some_and(|(file, _)| file.starts_with(path));
    let holds_files = path.is_dir() && (held_files || Utf8Path::from_path(path).is_some_and(holds_programs));
    if held_files == holds_files { Need::Nothing } else { Need::Load }
}
