//! The motion in the stored programs of a file: each kind once an axis and program, where it stands first.

use acrc_analysis::deed::{Deed, On, acts};
use acrc_analysis::{FileContext, SectionIndex};
use acrc_catalog::ObjectKind;
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Statement, StatementKind};
use acrc_syntax::units::{Level, SectionKind};

/// Motion of an axis.
#[derive(Clone, Copy)]
pub(crate) struct Motion {
    /// Its kind.
    pub(crate) deed: Deed,
    /// The axis.
    pub(crate) axis: u32,
    /// The program that has it.
    pub(crate) level: Level,
    /// The axis as it is written there.
    pub(crate) span: Span,
    /// It is written by its name, not as `AXISn`.
    pub(crate) named: bool,
}

/// All motion of a file, in the order of the text. Axes that are not known are left out.
pub(crate) fn collect(file: &FileContext<'_>) -> Vec<Motion> {
    let mut motions = Vec::new();
    for section in file.index.sections.iter().filter(|section| section.section.kind == SectionKind::Stored) {
        let range = section.section.statements.start as usize..section.section.statements.end as usize;
        for statement in file.tree.statements().get(range).unwrap_or_default() {
            add(file, section, statement, &mut motions);
        }
    }
    motions
}

fn add(file: &FileContext<'_>, section: &SectionIndex, statement: &Statement, motions: &mut Vec<Motion>) {
    let StatementKind::Command(command) = &statement.kind else { return };
    let level = section.section.level;
    for act in acts(command).filter(|act| act.deed.is_motion()) {
        let (axis, named) = match act.on {
            On::Object(ObjectKind::Axis, axis) => (axis, false),
            On::Axis(name) => (axis_named(file, level, name), true),
            On::Level | On::Object(..) | On::Word(_) => continue,
        };
        let Some(axis) = axis else { continue };
        let is_same = |other: &Motion| (other.deed, other.axis, other.level) == (act.deed, axis, level);
        if !motions.iter().any(is_same) {
            motions.push(Motion { deed: act.deed, axis, level, span: act.span, named });
        }
    }
}

/// The axis that a name stands for in the program of a level.
fn axis_named(file: &FileContext<'_>, level: Level, name: Span) -> Option<u32> {
    let name = file.text.get(name.range()).unwrap_or_default();
    file.environment.axes_at(level)?.find(name)?.1
}
