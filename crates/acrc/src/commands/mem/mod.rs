//! `acrc mem`: where the memory of a project goes, and whether it is enough (guide, "Memory Allocations").

mod bar;
mod json;
mod text;

use acrc_analysis::Database;
use acrc_analysis::memory::report;
use acrc_analysis::project::LoadedProject;
use acrc_diagnostics::LineIndex;
use anyhow::Context as _;

use super::project::{check, compile, errors_of, load, title};
use crate::cli::{ColorChoice, MemArguments, MemFormat};
use crate::exit::Exit;
use crate::output::{Terminal, print};

/// Columns of an account that does not go to a terminal.
const COLUMNS: usize = 80;
/// An account is not wider than this on any terminal, since nobody compares numbers a screen apart.
const WIDEST: usize = 120;
/// Nor narrower than this: lines are broken by the terminal then.
const NARROWEST: usize = 50;

pub(super) fn run(arguments: &MemArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let project = load(&arguments.project)?;
    let Some(image) = compile(&project, "has no account of its memory before these are mended", Terminal::error(color))
    else {
        return Ok(Exit::Findings);
    };
    let db = Database::new();
    let input = project.add_to(&db);
    let report = report(&db, input, &image).context("the compiled project can't be read")?;
    let files: Vec<&str> = project.files.iter().map(|file| file.path.as_str()).collect();
    let account = Account { title: title(&project), files: &files, report: &report, errors: errors(&project) };
    match arguments.format {
        MemFormat::Json => print(|out| json::write(&account, out))?,
        MemFormat::Text => {
            let page = text::Page { terminal: Terminal::output(color), columns: columns() };
            print(|out| out.write_all(page.render(&account).as_bytes()))?;
        }
    }
    Ok(if account.is_over() { Exit::Findings } else { Exit::Clean })
}

/// The columns of the terminal.
fn columns() -> usize {
    let terminal = terminal_size::terminal_size_of(std::io::stdout());
    terminal.map_or(COLUMNS, |(width, _)| usize::from(width.0)).clamp(NARROWEST, WIDEST)
}

/// What is shown.
struct Account<'a> {
    /// What a person calls the project.
    title: &'a str,
    /// The files, as they are shown.
    files: &'a [&'a str],
    report: &'a acrc_analysis::memory::Report,
    /// What programs use without memory.
    errors: Vec<Error>,
}

/// A use of what has no memory, as the linter finds it.
struct Error {
    file: usize,
    line: u32,
    /// The rule that explains it.
    rule: &'static str,
    message: String,
}

/// The rules that say which variables, parameters and elements have no memory. What the setup is refused is in the report.
const USES: [&str; 3] = ["ACR403", "ACR405", "ACR406"];

fn errors(project: &LoadedProject) -> Vec<Error> {
    let mut errors = Vec::new();
    for (file, found) in errors_of(check(project)).into_iter().enumerate() {
        let uses = found.into_iter().filter(|found| USES.contains(&found.code.id));
        let index = project.files.get(file).map(|file| LineIndex::new(&file.source.text));
        errors.extend(uses.map(|found| Error {
            file,
            line: index.as_ref().map_or(0, |index| index.position(found.span.start).line),
            rule: found.code.name,
            message: found.message,
        }));
    }
    errors
}

impl Account<'_> {
    /// Something does not fit.
    fn is_over(&self) -> bool {
        self.report.is_over() || !self.errors.is_empty()
    }

    /// `src/Prog0.8K:12`
    fn place(&self, (file, line): (usize, u32)) -> String {
        format!("{}:{line}", self.files.get(file).copied().unwrap_or("?"))
    }
}
