//! Adds the `DIM` that variables lack, as large as the numbers that the program writes ask for.

use acrc_analysis::index::AliasTarget;
use acrc_analysis::memory::{LocalBlock, local_class, memory_view};
use acrc_analysis::query::{file_index, parse, symbols};
use acrc_analysis::{SourceFile, walk};
use acrc_catalog::{FIRST_FLAG_WORD, OperandClass, command};
use acrc_diagnostics::{Diagnostic, Edit};
use acrc_syntax::ast::{ExprKind, Statement, StatementKind};
use acrc_syntax::units::{Level, SectionKind};

use super::{ActionKind, CodeAction, Request};
use crate::edits::{FileEdits, indent_at, line_break};
use crate::place::{line_at, section_of};
use crate::{Entity, FilePosition};

/// Characters of each string where nothing says how many there are.
const STRING_LENGTH: u64 = 80;

pub(super) fn add(request: &Request<'_>, found: &[&Diagnostic], actions: &mut Vec<CodeAction>) {
    for finding in found {
        let lines = match finding.code.name {
            "undimensioned-variable" => local(request, finding),
            "undimensioned-parameters" => {
                let needed = request.needed(Level::System, OperandClass::Parameter);
                Some((Level::System, vec![format!("DIM P({})", needed.variables)]))
            }
            _ => None,
        };
        let Some((level, lines)) = lines else { continue };
        let Some(edits) = request.insert(level, &lines) else { continue };
        actions.push(CodeAction {
            title: format!("Add {}", lines.join(" and ")),
            edits: vec![edits],
            finding: Some((finding.code, finding.span)),
            ..request.here(ActionKind::QuickFix, "", Vec::new())
        });
    }
}

/// The level and the `DIM`s that a local variable lacks.
fn local(request: &Request<'_>, finding: &Diagnostic) -> Option<(Level, Vec<String>)> {
    let Request { db, project, file, .. } = *request;
    let occurrence = crate::at(db, FilePosition { project, file, offset: finding.span.start })?;
    let level = crate::level_of(db, file, occurrence.statement);
    let (class, number) = match &occurrence.entity {
        Entity::Operand { class, number, .. } => (*class, *number),
        Entity::Alias(name) => match symbols(db, project).alias(name)?.operand.target {
            AliasTarget::Operand(class, number) => (class, number),
            _ => return None,
        },
        _ => return None,
    };
    let needed = request.needed(level, class);
    let length = if matches!(class, OperandClass::StringV | OperandClass::StringA) {
        format!(", {STRING_LENGTH}")
    } else {
        String::new()
    };
    if !class.is_array() {
        return Some((level, vec![format!("DIM {class}({}{length})", needed.variables)]));
    }
    let dims = memory_view(db, project, file).locals(level);
    let extent =
        |block| dims.and_then(|dims| dims.extent(block, number.and_then(|n| u32::try_from(n).ok()).unwrap_or(0)));
    let mut lines = Vec::new();
    if dims.and_then(|dims| dims.extent(LocalBlock::References(class), 0)).is_none() {
        lines.push(format!("DIM {class}({})", needed.variables));
    }
    if let Some(array) = number.filter(|_| extent(LocalBlock::Array(class)).is_none()) {
        let elements = needed.elements.iter().filter(|(own, _)| *own == array).map(|(_, element)| element + 1).max();
        lines.push(format!("DIM {class}{array}({}{length})", elements.unwrap_or(1)));
    }
    Some((level, lines))
}

/// What the numbers that are written ask for.
struct Needed {
    /// How many variables, or arrays; at least one.
    variables: u64,
    /// Arrays with the elements of theirs that are named.
    elements: Vec<(u64, u64)>,
}

impl Request<'_> {
    /// What the texts of a level need of a class; of parameters what the whole project does.
    fn needed(&self, level: Level, class: OperandClass) -> Needed {
        let mut needed = Needed { variables: 1, elements: Vec::new() };
        let is_global = class == OperandClass::Parameter;
        let mut note = |number: u64| {
            if !is_global || number < u64::from(FIRST_FLAG_WORD) {
                needed.variables = needed.variables.max(number.saturating_add(1));
            }
        };
        for alias in &symbols(self.db, self.project).aliases {
            let is_used = is_global || alias.used_at.contains(&level);
            if let AliasTarget::Operand(own, Some(number)) = alias.operand.target
                && own == class
                && is_used
            {
                note(number);
            }
        }
        for &file in self.project.files(self.db) {
            for section in &file_index(self.db, file).sections {
                if !is_global && section.section.level != level {
                    continue;
                }
                for statement in statements(parse(self.db, file).statements(), section.section.statements.clone()) {
                    walk::expressions(statement, &mut |expr| {
                        let ExprKind::Operand(operand) = &expr.kind else { return };
                        let Some(number) = walk::whole(&operand.index).filter(|_| operand.class == class) else {
                            return;
                        };
                        note(number);
                        if let Some(element) = operand.element.as_ref().and_then(walk::whole) {
                            needed.elements.push((number, element));
                        }
                    });
                }
            }
        }
        needed
    }

    /// New lines at a level: behind its last `DIM` of the same kind, else at the start of its stored text, behind a
    /// `CLEAR`, which a second run needs.
    fn insert(&self, level: Level, lines: &[String]) -> Option<FileEdits> {
        if let Some((file, statement)) = self.last_dim(level) {
            return Some((file, vec![self.below(file, statement, lines)]));
        }
        let statement = crate::statement_at(self.db, self.file, self.part.start)?;
        let section = &section_of(self.db, self.file, statement)?.section;
        let first = section.statements.start;
        let is_clear = |statement: &Statement| matches!(&statement.kind, StatementKind::Command(own) if own.id == command::CLEAR && own.arguments.is_empty());
        let cleared = statements(self.tree.statements(), section.statements.clone()).iter().position(is_clear);
        let mut new = lines.to_vec();
        let edit = match (cleared, section.opener) {
            _ if level == Level::System || section.kind != SectionKind::Stored || section.level != level => {
                return None;
            }
            (Some(clear), _) => self.below(self.file, first + clear as u32, &new),
            (None, Some(opener)) => {
                new.insert(0, "CLEAR".to_owned());
                self.below(self.file, opener, &new)
            }
            (None, None) => {
                let line = self.tree.lines().get(self.tree.line_of(first) as usize)?;
                let end = line_break(self.text, self.tree, line.span.start);
                if line.number.is_some() {
                    return None;
                }
                Edit::insert(line.span.start, format!("CLEAR{end}{}{end}", new.join(end)))
            }
        };
        Some((self.file, vec![edit]))
    }

    /// The last statement that dimensions memory of this level.
    fn last_dim(&self, level: Level) -> Option<(SourceFile, u32)> {
        let mut found = None;
        for &file in self.project.files(self.db) {
            let tree = parse(self.db, file);
            for section in file_index(self.db, file).sections.iter().filter(|section| section.section.level == level) {
                for at in section.section.statements.clone() {
                    let kind = tree.statements().get(at as usize).map(|statement| &statement.kind);
                    let Some(StatementKind::Dim(dim)) = kind else { continue };
                    let is_local = local_class(dim.id).is_some() || dim.id == command::DIM_MBUF;
                    let numbered = tree.lines().get(tree.line_of(at) as usize).is_none_or(|line| line.number.is_some());
                    if is_local == (level != Level::System) && !numbered {
                        found = Some((file, at));
                    }
                }
            }
        }
        found
    }

    /// Lines below the one on which a statement stands.
    fn below(&self, file: SourceFile, statement: u32, lines: &[String]) -> Edit {
        let (text, tree) = (file.text(self.db), parse(self.db, file));
        let start = tree.statements().get(statement as usize).map_or(0, |statement| statement.span.start);
        let (end, indent) = (line_break(text, tree, start), indent_at(text, tree, start));
        let place = tree.lines().get(line_at(tree, start)).map_or(0, |line| line.span.end);
        Edit::insert(place, lines.iter().flat_map(|line| [end, indent, line]).collect::<String>())
    }
}

fn statements(all: &[Statement], range: std::ops::Range<u32>) -> &[Statement] {
    all.get(range.start as usize..range.end as usize).unwrap_or_default()
}
