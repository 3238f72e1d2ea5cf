//! Projects written as one text: `=== name` begins a file, `$0` is the cursor.

use acrc_analysis::project::Config;
use acrc_analysis::{Database, FileRole, Project, SourceFile};
use acrc_diagnostics::{LineIndex, Span};
use acrc_ide::FilePosition;

/// A project in a database.
pub(crate) struct Fixture {
    pub(crate) db: Database,
    pub(crate) project: Project,
    pub(crate) files: Vec<SourceFile>,
    cursor: Option<(SourceFile, u32)>,
}

impl Fixture {
    /// Reads a fixture. Text before the first `===` is a file `program.8K`.
    pub(crate) fn new(text: &str) -> Self {
        let db = Database::new();
        let mut files = Vec::new();
        let mut cursor = None;
        for (name, text) in split(text) {
            let offset = text.find("$0");
            let file =
                SourceFile::new(&db, name.to_owned(), text.replacen("$0", "", 1), FileRole::of(name), Vec::new());
            cursor = cursor.or(offset.map(|offset| (file, offset as u32)));
            files.push(file);
        }
        let project = Project::new(&db, files.clone(), acrc_catalog::default_model(), Config::default());
        Self { db, project, files, cursor }
    }

    /// The place of the cursor.
    pub(crate) fn cursor(&self) -> FilePosition {
        let (file, offset) = self.cursor.expect("the fixture has a $0");
        FilePosition { project: self.project, file, offset }
    }

    /// A place as a person writes it, with its text: `Setup.8K:2:9 Clamp`.
    pub(crate) fn show(&self, file: SourceFile, span: Span) -> String {
        let text = file.text(&self.db);
        let position = LineIndex::new(text).position(span.start);
        format!("{}:{position} {}", file.name(&self.db), text.get(span.range()).expect("the span is in the text"))
    }
}

fn split(text: &str) -> Vec<(&str, &str)> {
    if !text.starts_with("=== ") {
        return vec![("program.8K", text)];
    }
    let parts = text.split("=== ").skip(1);
    parts.map(|part| part.split_once('\n').expect("a file name ends its line")).collect()
}
