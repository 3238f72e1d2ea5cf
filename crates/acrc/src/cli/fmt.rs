//! The arguments of `acrc fmt`.

use std::num::NonZeroU32;
use std::path::PathBuf;

use clap::Args;

/// `acrc fmt`
#[derive(Args, Debug)]
#[command(after_help = "A PATH is a project, a folder with projects below it (what git ignores is passed over),\n\
                  a file of a project, or `-` for standard input, which goes to standard output.\n\n\
                  Only blanks, blank lines and the case of keywords change. Lines that can't be read are left\n\
                  as they are, and so is what stands between ' acrc: fmt off and ' acrc: fmt on.\n\n\
                  Examples:\n  \
                  acrc fmt                       format the projects in and below this folder\n  \
                  acrc fmt --check               for CI: name the files that are not formatted\n  \
                  acrc fmt --diff src/Prog0.8K   show what would change\n  \
                  acrc fmt --renumber 100,10     also give numbered lines the numbers 100, 110, 120, ...\n\n\
                  Exit status: 0 done, 1 with --check or --diff: something would change, 2 could not run.")]
pub(crate) struct FmtArguments {
    /// What to format
    #[arg(default_value = ".", value_name = "PATH")]
    pub(crate) paths: Vec<PathBuf>,
    /// Name the files that are not formatted, and write nothing
    #[arg(long)]
    pub(crate) check: bool,
    /// Show what would change, and write nothing
    #[arg(long, conflicts_with = "check")]
    pub(crate) diff: bool,
    /// The name of what is read from standard input; the project that it lies in is read from disk
    #[arg(long, value_name = "FILE")]
    pub(crate) stdin_filename: Option<PathBuf>,
    /// Give numbered lines, and the jumps to them, new numbers
    #[arg(long, value_name = "START,STEP", value_parser = parse_numbering)]
    pub(crate) renumber: Option<Numbering>,
    /// Say nothing but what went wrong
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

/// The numbers of lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Numbering {
    /// Of the first line of each program.
    pub(crate) start: NonZeroU32,
    /// From line to line.
    pub(crate) step: NonZeroU32,
}

fn parse_numbering(text: &str) -> Result<Numbering, String> {
    let number = |text: &str| text.trim().parse::<NonZeroU32>().ok();
    let parts = text.split_once(',').and_then(|(start, step)| Some((number(start)?, number(step)?)));
    let (start, step) = parts.ok_or("write the first number and the step, for example 100,10")?;
    Ok(Numbering { start, step })
}
