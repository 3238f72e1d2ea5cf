//! What a program names: aliases, axes, labels, lines, objects.

use acrc_analysis::index::{AliasTarget, AttachmentKind};
use acrc_analysis::query::{exports, file_index, parse, symbols};
use acrc_analysis::{Db, SourceFile};
use acrc_catalog::{Entry, ObjectKind};
use acrc_diagnostics::Span;
use acrc_syntax::units::Level;

use super::operands::{described, operand};
use crate::{Entity, FilePosition, Role, everywhere};

/// An alias, and the page of what it stands for.
pub(super) fn alias(db: &dyn Db, position: FilePosition, name: &str) -> String {
    let FilePosition { project, .. } = position;
    let Some(alias) = symbols(db, project).alias(name) else {
        return format!("**{name}** — nothing in the project defines this name\n");
    };
    let file = project.files(db).get(alias.file as usize).map_or("", |file| file.name(db));
    match alias.operand.target {
        AliasTarget::Operand(class, Some(number)) => {
            let level = crate::level_of(
                db,
                position.file,
                crate::statement_at(db, position.file, position.offset).unwrap_or(0),
            );
            let local = class.is_local().then_some(level);
            let page = operand(db, project, class, Some(number), local);
            format!("**{name}** — alias of {}, defined in {file}\n\n---\n\n{page}", described(class, number))
        }
        _ => format!("**{name}** — alias of `{}`, defined in {file}\n", alias.operand.text),
    }
}

/// An axis by its name in a program.
pub(super) fn axis(db: &dyn Db, position: FilePosition, level: Level, name: &str) -> String {
    let table = symbols(db, position.project).axes_at(level);
    match table.and_then(|table| table.find(name)) {
        Some((_, Some(number))) => {
            let head = format!("**{name}** — axis {number} in {level}\n\n");
            head + &attachment(db, position, level, name)
        }
        Some((_, None)) => format!("**{name}** — axis of a computed number in {level}\n"),
        None => format!("**{name}** — no axis that {level} is known to attach\n"),
    }
}

/// How an axis comes to its program.
fn attachment(db: &dyn Db, position: FilePosition, level: Level, wanted: &str) -> String {
    let mut page = Vec::new();
    let mut master = None;
    for file in position.project.files(db) {
        for attachment in exports(db, *file).attachments.iter().filter(|attachment| attachment.level == level) {
            match &attachment.kind {
                AttachmentKind::Master { master: number } => master = *number,
                AttachmentKind::Slave { slot, name: Some(name), .. } if &**name == wanted => {
                    let number =
                        |number: Option<u32>| number.map_or_else(|| "?".to_owned(), |number| number.to_string());
                    page.push(format!(
                        "- slave {} of master {}, attached in {}\n",
                        number(*slot),
                        number(master),
                        file.name(db)
                    ));
                }
                _ => {}
            }
        }
    }
    page.concat()
}

/// An object by number. An axis has the names that programs give it.
pub(super) fn object(db: &dyn Db, position: FilePosition, kind: ObjectKind, number: Option<u32>) -> String {
    let mut page = vec![Entry::Object(kind).markdown()];
    if let (ObjectKind::Axis, Some(number)) = (kind, number) {
        for (level, table) in &symbols(db, position.project).axes {
            for (name, _) in table.names.iter().filter(|(_, axis)| *axis == Some(number)) {
                page.push(format!("- `{name}` in {level}\n"));
            }
        }
    }
    page.concat()
}

/// A label: the remark above it, and who goes there.
pub(super) fn label(db: &dyn Db, position: FilePosition, level: Level, name: &str) -> String {
    let found = everywhere(db, position.project, &Entity::Label(level, name.into()));
    let Some((file, definition)) = found.iter().find(|(_, occurrence)| occurrence.role == Role::Define) else {
        return format!("**{name}** — {level} has no such label\n");
    };
    let mut page = vec![format!("**{name}** — label of {level}, in {}\n", file.name(db))];
    if let Some(remark) = remark_above(db, *file, definition.span) {
        page.push(format!("\n{remark}\n"));
    }
    page.push("\n".to_owned());
    for (role, words) in [(Role::Call, "called"), (Role::Jump, "jumped to")] {
        match found.iter().filter(|(_, occurrence)| occurrence.role == role).count() {
            0 => {}
            1 => page.push(format!("- {words} at one place\n")),
            count => page.push(format!("- {words} at {count} places\n")),
        }
    }
    page.concat()
}

/// A line by its number.
pub(super) fn line(db: &dyn Db, position: FilePosition, level: Level, number: u32) -> String {
    for file in position.project.files(db) {
        let sections = file_index(db, *file).sections.iter().filter(|section| section.section.level == level);
        for section in sections {
            if let Some(line) = section.lines.iter().find(|line| line.number == number) {
                let tree = parse(db, *file);
                let span =
                    tree.lines().get(tree.line_of(line.statement) as usize).map_or(Span::empty(0), |line| line.span);
                let text = file.text(db).get(span.range()).unwrap_or_default().trim();
                return format!("**line {number}** of {level}, in {}\n\n```acrobasic\n{text}\n```\n", file.name(db));
            }
        }
    }
    format!("**line {number}** — {level} has no such line\n")
}

/// The text of the remarks on the lines directly above a place.
fn remark_above(db: &dyn Db, file: SourceFile, place: Span) -> Option<String> {
    let (text, tree) = (file.text(db), parse(db, file));
    let line = tree.lines().partition_point(|line| line.span.end < place.start);
    let above = tree.lines().get(..line)?.iter().rev();
    let mut remarks: Vec<&str> = above.map_while(|line| crate::remark::whole_line(text, tree, line)).collect();
    remarks.reverse();
    (!remarks.is_empty()).then(|| remarks.join("  \n"))
}
