//! `acrc fmt`: formats programs.

use acrc_analysis::project::{FileGlobs, LoadedProject};
use acrc_diagnostics::{Fix, LineIndex, apply, unified_diff};
use acrc_fmt::renumber::Source;
use acrc_syntax::SourceText;
use anyhow::{anyhow, bail};

use super::project::load;
use super::targets::{Target, display, note_of_strangers};
use super::{source_file, stdin, targets};
use crate::cli::{ColorChoice, FmtArguments, Numbering};
use crate::exit::{Exit, note, say, warn};
use crate::output::{Terminal, print, tell};

pub(super) fn run(arguments: &FmtArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let mut run = Run { arguments, color, changed: 0, same: 0, errors: Vec::new() };
    if stdin::is_meant(&arguments.paths, arguments.stdin_filename.as_deref())? {
        let (target, project) = stdin::load(arguments.stdin_filename.as_deref())?;
        return run.stdin(&target, &project);
    }
    let (targets, errors) = targets::find(&arguments.paths);
    run.errors = errors;
    for target in &targets {
        let done = load(target.path.as_std_path()).and_then(|project| run.project(target, &project));
        run.errors.extend(done.err());
    }
    run.finish()
}

struct Run<'a> {
    arguments: &'a FmtArguments,
    color: ColorChoice,
    /// Files that are another now, or would be.
    changed: usize,
    same: usize,
    errors: Vec<anyhow::Error>,
}

impl Run<'_> {
    /// Formats a program from standard input to standard output.
    fn stdin(&mut self, target: &Target, project: &LoadedProject) -> anyhow::Result<Exit> {
        let formatted = self.format(target, project)?;
        let meant = formatted.iter().zip(&project.files).find_map(|(after, file)| Some((after.as_ref()?, file)));
        let Some((after, file)) = meant else { bail!("{} is excluded by [fmt]", target.path) };
        if self.arguments.check || self.arguments.diff {
            self.judge(&display(&file.path), &file.source, after)?;
            return self.finish();
        }
        print(|out| out.write_all(&after.encode()))?;
        Ok(Exit::Clean)
    }

    fn project(&mut self, target: &Target, project: &LoadedProject) -> anyhow::Result<()> {
        let formatted = self.format(target, project)?;
        for (file, after) in project.files.iter().zip(formatted) {
            let Some(after) = after else { continue };
            if self.arguments.check || self.arguments.diff {
                self.judge(&display(&file.path), &file.source, &after)?;
            } else if file.source.text == after.text {
                self.same += 1;
            } else {
                let path = file.path.as_std_path();
                match source_file::replace(path, &file.source.encode(), &after.encode()) {
                    Ok(()) => self.changed += 1,
                    Err(error) => self.errors.push(error),
                }
            }
        }
        Ok(())
    }

    /// The formatted texts of a project; `None` for files that are left alone.
    fn format(&self, target: &Target, project: &LoadedProject) -> anyhow::Result<Vec<Option<SourceText>>> {
        let config = &project.config.fmt;
        let options = acrc_ide::format_options(config);
        let texts = match self.arguments.renumber {
            Some(numbering) => renumber(project, numbering)?,
            None => project.files.iter().map(|file| file.source.text.clone()).collect(),
        };
        let exclude = FileGlobs::new(&config.exclude).map_err(anyhow::Error::msg)?;
        if !self.arguments.quiet {
            let terminal = Terminal::error(self.color);
            let strangers = target.strangers(project);
            project.idle_fmt_patterns(&strangers).iter().for_each(|line| warn(line, terminal));
            if let Some(line) = note_of_strangers(&strangers, &exclude, project) {
                note(&line, terminal);
            }
        }
        let mut formatted = Vec::with_capacity(texts.len());
        for ((file, text), meant) in project.files.iter().zip(texts).zip(target.meant(project)) {
            let excluded = !exclude.matching(project.config.lint.relative(file.path.as_str())).is_empty();
            if !meant || excluded {
                if text != file.source.text {
                    bail!("{} has numbered lines of the same programs: name the whole project", display(&file.path));
                }
                formatted.push(None);
                continue;
            }
            let result = acrc_fmt::format(&text, &options);
            self.say_unreadable(&display(&file.path), &result.unreadable);
            formatted.push(Some(SourceText { text: result.text, ..file.source.clone() }));
        }
        Ok(formatted)
    }

    /// Says or shows what would change in a file.
    fn judge(&mut self, name: &str, before: &SourceText, after: &SourceText) -> anyhow::Result<()> {
        if before.text == after.text {
            self.same += 1;
            return Ok(());
        }
        self.changed += 1;
        let terminal = Terminal::output(self.color);
        print(|out| match (self.arguments.diff, self.arguments.quiet) {
            (true, _) => unified_diff(name, &before.text, &after.text, terminal.color, out),
            (false, false) => writeln!(out, "{name} is not formatted"),
            (false, true) => Ok(()),
        })
    }

    fn say_unreadable(&self, name: &str, lines: &[u32]) {
        const SHOWN: usize = 5;
        let (Some(first), false) = (lines.first(), self.arguments.quiet) else { return };
        let text = if lines.len() == 1 {
            format!("line {first} can't be read and is left as it is")
        } else {
            let list: Vec<String> = lines.iter().take(SHOWN).map(u32::to_string).collect();
            let more = if lines.len() > SHOWN { ", ..." } else { "" };
            format!("{} lines can't be read and are left as they are: {}{more}", lines.len(), list.join(", "))
        };
        warn(&format!("{name}: {text}"), Terminal::error(self.color));
    }

    fn finish(&self) -> anyhow::Result<Exit> {
        let only_asked = self.arguments.check || self.arguments.diff;
        for error in &self.errors {
            say(error, Terminal::error(self.color));
        }
        if !self.arguments.quiet && (self.changed + self.same > 0 || self.errors.is_empty()) {
            let files = if self.changed == 1 { "1 file".to_owned() } else { format!("{} files", self.changed) };
            let done = if only_asked { "would be reformatted" } else { "reformatted" };
            let line = format!("{files} {done}, {} left alone", self.same);
            if self.arguments.diff {
                // Standard output is for `patch`.
                tell(|err| writeln!(err, "{line}"));
            } else {
                print(|out| writeln!(out, "{line}"))?;
            }
        }
        Ok(match (self.errors.is_empty(), only_asked && self.changed > 0) {
            (false, _) => Exit::Failure,
            (true, true) => Exit::Findings,
            (true, false) => Exit::Clean,
        })
    }
}

/// The texts of all files with new line numbers.
fn renumber(project: &LoadedProject, Numbering { start, step }: Numbering) -> anyhow::Result<Vec<String>> {
    let trees: Vec<_> = project.files.iter().map(|file| acrc_syntax::parse(&file.source.text)).collect();
    let sources = project.files.iter().zip(&trees).map(|(file, tree)| Source {
        text: &file.source.text,
        tree,
        start: file.role.start(),
        implicit_program: file.is_implicit_program(tree),
    });
    let sources: Vec<_> = sources.collect();
    let edits = acrc_fmt::renumber(&sources, start, step).map_err(|errors| {
        let lines = errors.iter().map(|error| {
            let file = project.files.get(error.file);
            let name = file.map(|file| display(&file.path)).unwrap_or_default();
            let place = file.map(|file| LineIndex::new(&file.source.text).position(error.span.start));
            place.map_or_else(|| error.to_string(), |place| format!("{name}:{place}: {error}"))
        });
        let lines: Vec<String> = lines.collect();
        anyhow!("the lines keep their numbers:\n{}", lines.join("\n"))
    })?;
    let texts = project.files.iter().zip(edits);
    texts.map(|(file, edits)| Ok(apply(&file.source.text, &[&Fix::safe("renumber", edits)])?)).collect()
}
