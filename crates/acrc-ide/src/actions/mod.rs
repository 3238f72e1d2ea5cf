//! What an editor offers to do at a place: repair a finding or allow it, give a number a name, write a block another way.

mod alias;
mod allow;
mod block;
mod dim;
mod findings;
mod label;
mod remark;

use acrc_analysis::query::{diagnostics, parse};
use acrc_analysis::{Db, Project, SourceFile};
use acrc_diagnostics::{Applicability, Code, Diagnostic, Edit, Span};
use acrc_syntax::Tree;

use crate::edits::FileEdits;

pub use findings::fix_all;

/// Kinds of actions, as editors group them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ActionKind {
    /// It repairs a finding or allows it.
    QuickFix,
    /// It gives something a name.
    Extract,
    /// It writes the same another way.
    Rewrite,
    /// It repairs all of a file that can be repaired safely.
    FixAll,
}

/// Something that an editor offers to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeAction {
    /// What it does, as an order: "Remove the blanks".
    pub title: String,
    /// How editors group it.
    pub kind: ActionKind,
    /// The edits; those of one file do not overlap.
    pub edits: Vec<FileEdits>,
    /// It is what one would choose unseen.
    pub preferred: bool,
    /// Whether the program means the same afterwards.
    pub applicability: Applicability,
    /// The finding that it is about.
    pub finding: Option<(Code, Span)>,
}

/// What can be done in a part of a file, repairs first.
pub fn code_actions(db: &dyn Db, project: Project, file: SourceFile, part: Span) -> Vec<CodeAction> {
    let end = file.text(db).len() as u32;
    let part = Span::new(part.start.min(end), part.end.min(end));
    let request = Request { db, project, file, text: file.text(db), tree: parse(db, file), part };
    let found: Vec<&Diagnostic> = request.findings().collect();
    let mut actions = Vec::new();
    findings::add(&request, &found, &mut actions);
    label::add(&request, &found, &mut actions);
    dim::add(&request, &found, &mut actions);
    alias::add(&request, &mut actions);
    block::add(&request, &mut actions);
    remark::add(&request, &mut actions);
    allow::add(&request, &found, &mut actions);
    actions.retain(|action| action.edits.iter().any(|(_, edits)| !edits.is_empty()));
    let mut offered: Vec<CodeAction> = Vec::new();
    for action in actions {
        // A rule that is on may repair what is offered anyhow.
        if !offered.iter().any(|other| other.edits == action.edits) {
            offered.push(action);
        }
    }
    offered
}

/// A part of a file for which actions are wanted.
struct Request<'a> {
    db: &'a dyn Db,
    project: Project,
    file: SourceFile,
    text: &'a str,
    tree: &'a Tree,
    part: Span,
}

impl<'a> Request<'a> {
    /// What is found there.
    fn findings(&self) -> impl Iterator<Item = &'a Diagnostic> + use<'a> {
        let part = self.part;
        let all = diagnostics(self.db, self.project, self.file, acrc_lint::CHECKER).iter();
        all.filter(move |finding| touch(finding.span, part))
    }

    /// The statements there, by their index.
    fn statements(&self) -> impl Iterator<Item = u32> + use<> {
        let statements = self.tree.statements();
        let first = statements.partition_point(|statement| statement.span.end < self.part.start);
        let end = statements.partition_point(|statement| statement.span.start <= self.part.end);
        first as u32..end.max(first) as u32
    }

    fn slice(&self, span: Span) -> &'a str {
        crate::place::slice(self.text, span)
    }

    /// An action that edits this file only.
    fn here(&self, kind: ActionKind, title: impl Into<String>, edits: Vec<Edit>) -> CodeAction {
        CodeAction {
            title: title.into(),
            kind,
            edits: vec![(self.file, edits)],
            preferred: false,
            applicability: Applicability::Unsafe,
            finding: None,
        }
    }
}

fn touch(a: Span, b: Span) -> bool {
    a.start <= b.end && b.start <= a.end
}
