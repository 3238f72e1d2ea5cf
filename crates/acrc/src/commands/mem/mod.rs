//! `acrc mem`: where the memory of a project goes, and whether it is enough (guide, "Memory Allocations").

mod bar;
mod json;
mod text;

use acrc_analysis::Database;
use acrc_analysis::memory::report;
use anyhow::Context as _;

use super::project::{compile, load, title};
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
    let Some(image) = compile(&project, Terminal::error(color))? else { return Ok(Exit::Findings) };
    let db = Database::new();
    let input = project.add_to(&db);
    let report = report(&db, input, &image).context("the compiled project can't be read")?;
    let files: Vec<&str> = project.files.iter().map(|file| file.path.as_str()).collect();
    let account = Account { title: title(&project), files: &files, report: &report };
    match arguments.format {
        MemFormat::Json => print(|out| json::write(&account, out))?,
        MemFormat::Text => {
            let page = text::Page { terminal: Terminal::output(color), columns: columns() };
            print(|out| out.write_all(page.render(&account).as_bytes()))?;
        }
    }
    Ok(if report.is_over() { Exit::Findings } else { Exit::Clean })
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
}

impl Account<'_> {
    /// `src/Prog0.8K:12`
    fn place(&self, (file, line): (usize, u32)) -> String {
        format!("{}:{line}", self.files.get(file).copied().unwrap_or("?"))
    }
}
