//! Questions about a project with places in the answers: the ground for navigation, references and reports.

use acrc_diagnostics::Span;
use acrc_syntax::units::Level;

use crate::index::{AttachmentKind, Name};
use crate::query::{exports, file_index, symbols};
use crate::symbols::{AliasSymbol, AxisTable};
use crate::{Db, Project, SourceFile};

/// Something that a project declares.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Definition {
    /// Its file.
    pub file: SourceFile,
    /// The place of its name.
    pub span: Span,
    /// Its name.
    pub name: Name,
    /// What it is.
    pub kind: DefinitionKind,
}

/// What can be declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DefinitionKind {
    /// A label, valid in the program of its level.
    Label(Level),
    /// An alias, valid everywhere.
    Alias,
    /// An axis name, valid in the program of its level.
    Axis(Level),
}

/// Everything that the project declares, in the order of its files and, within one, of aliases, labels, axis names.
pub fn definitions(db: &dyn Db, project: Project) -> Vec<Definition> {
    let files = project.files(db).iter();
    files
        .flat_map(|file| [alias_definitions(db, *file), label_definitions(db, *file), axis_definitions(db, *file)])
        .flatten()
        .collect()
}

/// The labels of the program of `level`, in the order of the files and by name.
pub fn labels(db: &dyn Db, project: Project, level: Level) -> Vec<Definition> {
    let all = project.files(db).iter().flat_map(|file| label_definitions(db, *file));
    all.filter(|definition| definition.kind == DefinitionKind::Label(level)).collect()
}

/// The aliases of the project, in the order of their first definition.
pub fn aliases(db: &dyn Db, project: Project) -> &[AliasSymbol] {
    &symbols(db, project).aliases
}

/// The axis names that are valid in the program of `level`. `None` when nothing attaches an axis there.
pub fn axis_names(db: &dyn Db, project: Project, level: Level) -> Option<&AxisTable> {
    symbols(db, project).axes_at(level)
}

fn alias_definitions(db: &dyn Db, file: SourceFile) -> Vec<Definition> {
    let names = exports(db, file).aliases.iter().map(|(name, _)| name.clone());
    let sites = &file_index(db, file).defines;
    let define = |(name, site): (Name, &crate::index::DefineSite)| Definition {
        file,
        span: site.name,
        name,
        kind: DefinitionKind::Alias,
    };
    names.zip(sites).map(define).collect()
}

fn label_definitions(db: &dyn Db, file: SourceFile) -> Vec<Definition> {
    let text = file.text(db);
    let mut found = Vec::new();
    for section in &file_index(db, file).sections {
        let kind = DefinitionKind::Label(section.section.level);
        found.extend(section.labels.iter().map(|label| {
            let name = text.get(label.name.range()).unwrap_or_default().into();
            Definition { file, span: label.name, name, kind }
        }));
    }
    found
}

fn axis_definitions(db: &dyn Db, file: SourceFile) -> Vec<Definition> {
    let attachments = exports(db, file).attachments.iter();
    let mut found = Vec::new();
    for (attachment, site) in attachments.zip(&file_index(db, file).attachments) {
        if let (AttachmentKind::Slave { name: Some(name), .. }, Some(span)) = (&attachment.kind, site.name) {
            found.push(Definition { file, span, name: name.clone(), kind: DefinitionKind::Axis(attachment.level) });
        }
    }
    found
}
