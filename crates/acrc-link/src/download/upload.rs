//! What a controller has as the files of a project, with the comments of a local project where the text is the same.
//!
//! A controller keeps no setup code: memory, aliases and attachments are written as the statements that make them, as far as
//! their reports can be read, and what else it has been told is not there.

use std::collections::BTreeMap;

use acrc_image::UnitName;
use acrc_syntax::ast::StatementKind;
use similar::{Algorithm, DiffOp, capture_diff_slices};

use super::listing::{Listing, Names, places_of_lines, unit_lines};
use super::script::{Kind, Place, Script};
use super::survey::Survey;

/// A file that was read back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UploadedFile {
    /// Its name, by which a project knows it: `Prog0.8K`.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Lines of the text that come from the local project, with their comments.
    pub recovered: usize,
    /// Lines of the program.
    pub lines: usize,
}

/// What was read back.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Upload {
    /// The files.
    pub files: Vec<UploadedFile>,
    /// What could not be read.
    pub notes: Vec<String>,
}

/// The files of what a controller has.
pub fn upload(survey: &Survey, local: Option<&Script>) -> Upload {
    let mut upload = Upload::default();
    if let Some(text) = &survey.protected {
        upload.notes.push(format!("programs are missing: the controller does not list them ({text})"));
    }
    let setup = setup(survey, &mut upload.notes);
    let lines = setup.lines().count();
    upload.files.push(UploadedFile { name: "Setup.8K".to_owned(), text: setup, recovered: 0, lines });
    for (unit, listing) in &survey.programs {
        upload.files.push(program(*unit, listing, survey, local));
    }
    upload
}

/// Setup code that makes memory, aliases and attachments.
fn setup(survey: &Survey, notes: &mut Vec<String>) -> String {
    let mut text = String::from("SYS\nHALT ALL\nNEW ALL\nCLEAR\nDETACH ALL\n\n");
    match &survey.memory {
        Some(memory) => text.extend(memory.iter().map(|(block, size)| format!("DIM {block}({size})\n"))),
        None => notes.push("memory is missing: what DIM reports is not understood".to_owned()),
    }
    match &survey.aliases {
        Some(_) => statements(&mut text, &survey.alias_lines, notes),
        None => notes.push("aliases are missing: what DEF reports is not understood".to_owned()),
    }
    statements(&mut text, &survey.hardware, notes);
    for (unit, lines) in &survey.attachments {
        text.extend(["\n", &unit.to_string(), "\n"]);
        statements(&mut text, lines, notes);
    }
    text.push_str("SYS\n");
    text
}

/// Adds what was reported in the form of statements.
fn statements(text: &mut String, lines: &[String], notes: &mut Vec<String>) {
    for line in lines.iter().map(|line| line.trim()).filter(|line| !line.is_empty()) {
        let tree = acrc_syntax::parse(line);
        let readable = tree.errors().is_empty()
            && tree.statements().iter().all(|statement| statement.kind != StatementKind::Error)
            && !tree.statements().is_empty();
        if readable {
            text.extend([line, "\n"]);
        } else {
            // As a comment nothing is lost, and nothing is sent.
            text.extend(["' ", line, "\n"]);
            notes.push(format!("`{line}` is not understood and stands in Setup.8K as a comment"));
        }
    }
}

fn program(unit: UnitName, listing: &Listing, survey: &Survey, local: Option<&Script>) -> UploadedFile {
    let name = match unit {
        UnitName::Boot => "Setup.8K".to_owned(),
        UnitName::Program(number) => format!("Prog{number}.8K"),
        UnitName::Plc(number) => format!("PLC{number}.8K"),
    };
    let known = survey.aliases.as_deref().unwrap_or_default();
    let source = local.and_then(|script| Some((script, script.unit(unit)?)));
    let Some((script, own)) = source else {
        let lines = listing.lines.len();
        return UploadedFile { name, text: format!("PROGRAM\n{}ENDP\n", listing.text()), recovered: 0, lines };
    };
    let names = Names::new(&script.image.aliases, known);
    let own_lines = unit_lines(own, &names.entries).unwrap_or_default();
    let found = listing.canonical(unit, &names);
    let mut writer = Writer::new(script);
    let places = places_of_lines(own);
    writer.above_kind(unit, &Kind::Open);
    writer.text.push_str("PROGRAM\n");
    for operation in capture_diff_slices(Algorithm::Myers, &own_lines, &found) {
        if let DiffOp::Equal { old_index, new_index, len } = operation {
            for (old, new) in (old_index..old_index + len).zip(new_index..) {
                writer.recover(places.get(old).copied().flatten(), found.get(new).map_or("", String::as_str));
            }
        } else {
            for line in found.get(operation.new_range()).unwrap_or_default() {
                writer.text.extend([line, "\n"]);
            }
        }
    }
    writer.above_kind(unit, &Kind::Close);
    writer.text.push_str("ENDP\n");
    UploadedFile { name, text: writer.text, recovered: writer.recovered, lines: found.len() }
}

struct Writer<'a> {
    script: &'a Script,
    /// The lines of each file.
    sources: Vec<Vec<&'a str>>,
    /// How many lines to be typed a line of a file makes, by file and number.
    owners: BTreeMap<(usize, u32), usize>,
    text: String,
    recovered: usize,
}

impl<'a> Writer<'a> {
    fn new(script: &'a Script) -> Self {
        let mut owners = BTreeMap::new();
        for line in &script.lines {
            *owners.entry((line.place.file, line.place.line)).or_default() += 1;
        }
        let sources = script.files.iter().map(|file| file.text.lines().collect()).collect();
        Self { script, sources, owners, text: String::new(), recovered: 0 }
    }

    /// A line that is the same in the project: as it stands there, with the comments above it.
    fn recover(&mut self, place: Option<Place>, listed: &str) {
        let Some(Place { file, line, .. }) = place else { return self.text.extend([listed, "\n"]) };
        self.above(file, line);
        self.recovered += 1;
        // A line of the source that does something else as well is not the text of the program alone.
        let alone = self.owners.get(&(file, line)) == Some(&1);
        let source = self.source(file, line).filter(|_| alone).unwrap_or(listed);
        self.text.extend([source.trim_end(), "\n"]);
    }

    /// The comments above where a text begins or ends.
    fn above_kind(&mut self, unit: UnitName, kind: &Kind) {
        let line = self.script.lines.iter().rfind(|line| line.unit() == Some(unit) && line.kind == *kind);
        if let Some(place) = line.map(|line| line.place) {
            self.above(place.file, place.line);
        }
    }

    /// The comments and empty lines directly above a line.
    fn above(&mut self, file: usize, line: u32) {
        let first = (1..line).rev().take_while(|line| !self.owners.contains_key(&(file, *line))).last();
        let Some(first) = first else { return };
        let comments: Vec<&str> = (first..line).filter_map(|line| self.source(file, line)).map(str::trim_end).collect();
        // No text begins with empty lines.
        let begins = self.text.is_empty();
        let comments = comments.into_iter().skip_while(|line| begins && line.is_empty());
        self.text.extend(comments.flat_map(|line| [line, "\n"]));
    }

    fn source(&self, file: usize, line: u32) -> Option<&'a str> {
        self.sources.get(file)?.get(line.checked_sub(1)? as usize).copied()
    }
}
