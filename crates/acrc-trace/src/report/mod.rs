//! One page in which a person looks around a run: plots to zoom and pan, paths, what the programs sent, what went wrong, and the statement that each
//! program stood at.
//!
//! The page is one file without anything from elsewhere; a content security policy keeps it that way. Its script and style sheet are the files in
//! `page/`; what the run was is a JSON object in it (`data.rs`). Text of programs never becomes markup.

mod data;

use crate::plot::Event;
use crate::{Envelope, StatementLog, Trace};

/// The frame of the page, with marks where the other parts go.
const PAGE: &str = include_str!("page/page.html");
const STYLE: &str = include_str!("page/page.css");
/// The parts of the script, which share one scope.
const SCRIPTS: [&str; 9] = [
    include_str!("page/dom.js"),
    include_str!("page/data.js"),
    include_str!("page/scale.js"),
    include_str!("page/view.js"),
    include_str!("page/panels.js"),
    include_str!("page/paths.js"),
    include_str!("page/programs.js"),
    include_str!("page/controls.js"),
    include_str!("page/main.js"),
];

/// What a page shows.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    /// The heading.
    pub title: &'a str,
    /// What is to be known of the run at a glance: what it is, and its value.
    pub facts: Vec<(String, String)>,
    /// The signals over time.
    pub signals: &'a Envelope,
    /// The samples of the signals of `paths`.
    pub positions: &'a Trace,
    /// Pairs of signals by name that are the path of a tool.
    pub paths: Vec<[String; 2]>,
    /// Points in time to mark.
    pub events: &'a [Event],
    /// Where the programs stood.
    pub statements: &'a StatementLog,
    /// The texts that the places of [`Report::statements`] lie in: the files by index.
    pub files: Vec<SourceText>,
    /// The texts that the controller holds, by the name of the program.
    pub listings: Vec<SourceText>,
    /// What the programs sent, in order of time.
    pub output: Vec<OutputLine<'a>>,
    /// Run-time errors.
    pub faults: Vec<Event>,
    /// What the reader of the run has to know about its limits.
    pub notes: &'a [String],
}

/// A text of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceText {
    /// Its name.
    pub name: String,
    /// All of it.
    pub text: String,
}

/// A line that a program sent.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputLine<'a> {
    /// When it began, in seconds.
    pub time: f64,
    /// Who sent it where.
    pub source: String,
    /// What.
    pub text: &'a str,
}

/// Writes the page.
#[must_use]
pub fn html(report: &Report) -> String {
    let script = SCRIPTS.concat();
    let parts = [
        ("{{title}}", crate::plot::escaped(report.title)),
        ("{{style}}", STYLE.to_owned()),
        ("{{data}}", data::json(report)),
        ("{{script}}", script),
    ];
    let mut page = String::with_capacity(PAGE.len() + parts.iter().map(|(_, text)| text.len()).sum::<usize>());
    let mut rest = PAGE;
    // The marks stand in the page in this order; what is put in is not looked at again.
    for (mark, text) in &parts {
        let (before, behind) = rest.split_once(mark).unwrap_or((rest, ""));
        page.push_str(before);
        page.push_str(text);
        rest = behind;
    }
    page.push_str(rest);
    page
}
