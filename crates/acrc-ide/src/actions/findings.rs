//! The repairs of findings.

use acrc_analysis::{Database, Db, Project, SourceFile};
use acrc_diagnostics::{Applicability, Diagnostic};
use acrc_syntax::{Encoding, SourceText};

use super::{ActionKind, CodeAction, Request};
use crate::edits::line_edits;

/// Every repair of a finding that has no parts to fill in; of each the first safe one is preferred.
pub(super) fn add(request: &Request<'_>, found: &[&Diagnostic], actions: &mut Vec<CodeAction>) {
    for finding in found {
        for (place, fix) in finding.fixes.iter().enumerate() {
            if fix.applicability == Applicability::DisplayOnly {
                continue;
            }
            actions.push(CodeAction {
                preferred: place == 0 && fix.applicability == Applicability::Safe,
                applicability: fix.applicability,
                finding: Some((finding.code, finding.span)),
                ..request.here(ActionKind::QuickFix, sentence(&fix.title), fix.edits.clone())
            });
        }
    }
}

/// An order as the title of an action.
fn sentence(title: &str) -> String {
    let mut characters = title.chars();
    let first = characters.next().map(|first| first.to_ascii_uppercase());
    first.into_iter().chain(characters).collect()
}

/// Repairs everything in a file that can be repaired safely, again and again until nothing is left. `None` when there is
/// nothing to repair. This looks at the whole project anew: it is for a person who asks for it, or for saving.
pub fn fix_all(db: &dyn Db, project: Project, file: SourceFile) -> Option<CodeAction> {
    let found = acrc_analysis::diagnostics(db, project, file, acrc_lint::CHECKER);
    let is_safe = |finding: &Diagnostic| finding.fixes.iter().any(|fix| fix.applicability == Applicability::Safe);
    if !found.iter().any(is_safe) {
        return None;
    }
    let mut scratch = Database::new();
    let copy = |file: &SourceFile| {
        let (name, text) = (file.name(db).to_owned(), file.text(db).to_owned());
        SourceFile::new(&scratch, name, text, file.role(db), file.encoding(db).to_vec())
    };
    let files: Vec<SourceFile> = project.files(db).iter().map(copy).collect();
    let source =
        |file: &SourceFile| SourceText { text: file.text(db).to_owned(), encoding: Encoding::Utf8, end_mark: false };
    let mut sources: Vec<SourceText> = project.files(db).iter().map(source).collect();
    let place = project.files(db).iter().position(|other| *other == file)?;
    let copied = Project::new(&scratch, files, project.model(db), project.config(db).clone());
    acrc_lint::fix::fix(&mut scratch, copied, &mut sources, Applicability::Safe, |other| other == place);
    let edits = line_edits(file.text(db), &sources.get(place)?.text);
    (!edits.is_empty()).then(|| CodeAction {
        title: "Apply all safe fixes".to_owned(),
        kind: ActionKind::FixAll,
        edits: vec![(file, edits)],
        preferred: false,
        applicability: Applicability::Safe,
        finding: None,
    })
}
