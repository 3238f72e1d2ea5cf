//! One pass over a file that fills its index.

use acrc_catalog::{ObjectKind, OperandClass, command};
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
use acrc_syntax::ast::{Argument, Command, Define, Expr, ExprKind, Separator, Statement, StatementKind};
use acrc_syntax::blocks::Blocks;
use acrc_syntax::units::{Level, Section, SectionKind};
use acrc_syntax::{blocks, units};
use rustc_hash::FxHashSet;

use super::{
    AliasOperand, Attachment, AttachmentKind, AttachmentSite, DefineSite, Effects, Exports, FileIndex, Jump, LabelSite,
    LineSite, Name, SectionIndex, Sequence, Swallowed, effects, section,
};
use crate::{FileRole, walk};

pub(super) fn build(text: &str, tree: &Tree, role: FileRole) -> (FileIndex, Exports, Effects) {
    let implicit_program = super::is_implicit_program(role, tree);
    let mut builder = Builder {
        text,
        tree,
        uses: FxHashSet::default(),
        numbers: FxHashSet::default(),
        exports: Exports::default(),
        effects: effects::Collector::new(text),
    };
    let mut index = FileIndex { implicit_program, ..FileIndex::default() };
    for mut section in units::split(tree, role.start()) {
        if implicit_program && section.level == role.start() {
            section.kind = SectionKind::Stored;
        }
        builder.section(section, &mut index);
    }
    index.numbers = builder.numbers.iter().copied().collect();
    index.numbers.sort_unstable();
    let (exports, effects) = builder.finish();
    (index, exports, effects)
}

struct Builder<'a> {
    text: &'a str,
    tree: &'a Tree,
    uses: FxHashSet<(&'a str, Level)>,
    numbers: FxHashSet<(OperandClass, u64)>,
    exports: Exports,
    effects: effects::Collector<'a>,
}

/// What the statements of a section share.
struct Place<'b> {
    level: Level,
    sequence: Sequence,
    blocks: &'b Blocks,
    /// Set behind a `THEN` for the rest of its line.
    behind_then: bool,
}

impl<'a> Builder<'a> {
    fn section(&mut self, section: Section, index: &mut FileIndex) {
        let sequence = match section.kind {
            SectionKind::Immediate => Sequence::Immediate,
            SectionKind::Stored => Sequence::Stored(index.sections.len() as u32),
        };
        self.exports.has_program |= section.opener.is_some();
        self.exports.levels.push(section.level);
        if section.kind == SectionKind::Stored && !section.statements.is_empty() {
            self.effects.program(section.level);
        }

        let blocks = blocks::match_blocks(self.tree, section.statements.clone());
        let mut place = Place { level: section.level, sequence, blocks: &blocks, behind_then: false };
        let (mut labels, mut jumps) = (Vec::new(), Vec::new());
        for at in section.statements.clone() {
            let Some(statement) = self.tree.statements().get(at as usize) else { break };
            place.behind_then =
                statement.separator != Separator::Line && (place.behind_then || statement.separator == Separator::Then);
            match &statement.kind {
                StatementKind::Label(label) => labels.push(LabelSite { name: label.name, statement: at }),
                StatementKind::Define(define) => self.define(define, index),
                StatementKind::Command(command) => {
                    jumps.extend(jump(at, command));
                    self.command(at, statement, command, &place, index);
                }
                _ => {}
            }
            self.effects.statement(section.level, section.kind == SectionKind::Stored, statement);
            self.collect_uses(section.level, statement);
        }
        if section.kind == SectionKind::Stored && does_something(self.tree, &section) {
            self.exports.stored.push(section.level);
        }
        labels.sort_by_key(|label: &LabelSite| (self.slice(label.name), label.statement));
        let lines = self.line_numbers(&section);
        let swallowed = Swallowed::find(self.tree, &section);
        let mut section = SectionIndex { section, labels, lines, jumps, blocks, swallowed };
        section.resolve_jumps(self.text);
        index.sections.push(section);
    }

    fn define(&mut self, define: &Define, index: &mut FileIndex) {
        index.defines.push(DefineSite { name: define.name, operand: define.operand.span });
        let operand = AliasOperand::new(self.text, &define.operand);
        self.exports.aliases.push((self.slice(define.name).into(), operand));
    }

    fn command(&mut self, at: u32, statement: &Statement, command: &Command, place: &Place<'_>, index: &mut FileIndex) {
        self.exports.switches_level |= section::SWITCHES.contains(&command.id);
        if let Some((kind, site)) = self.attachment(statement, command) {
            let &Place { level, sequence, blocks, behind_then } = place;
            let conditional = behind_then || blocks.enclosing(at).is_some();
            index.attachments.push(site);
            self.exports.attachments.push(Attachment { level, sequence, conditional, kind });
        }
    }

    fn collect_uses(&mut self, level: Level, statement: &Statement) {
        let text = self.text;
        let (uses, numbers) = (&mut self.uses, &mut self.numbers);
        walk::expressions(statement, &mut |expr: &Expr| match &expr.kind {
            ExprKind::Alias => {
                uses.insert((text.get(expr.span.range()).unwrap_or_default(), level));
            }
            ExprKind::Operand(operand) => {
                numbers.extend(walk::whole(&operand.index).map(|number| (operand.class, number)));
            }
            _ => {}
        });
        // What could not be read may use any alias whose name stands in it.
        if statement.kind == StatementKind::Error {
            let words = self.slice(statement.span).split(|c: char| !c.is_ascii_alphanumeric());
            self.uses.extend(words.filter(|word| !word.is_empty()).map(|word| (word, level)));
        }
        let bits = walk::bits(statement).filter_map(|bit| walk::whole(&bit.index));
        self.numbers.extend(bits.map(|number| (OperandClass::Bit, number)));
    }

    fn line_numbers(&self, section: &Section) -> Vec<LineSite> {
        let mut lines: Vec<_> = numbered_lines(self.tree, section).collect();
        lines.sort_unstable();
        lines
    }

    fn attachment(&self, statement: &Statement, command: &Command) -> Option<(AttachmentKind, AttachmentSite)> {
        let object = |wanted: ObjectKind| {
            command.arguments.iter().find_map(|argument| match argument {
                Argument::Object(object) if object.kind == wanted => object.index,
                _ => None,
            })
        };
        let (slot, axis) = (object(ObjectKind::Slave), object(ObjectKind::Axis));
        let mut site = AttachmentSite { statement: statement.span, name: None };
        let kind = match command.id {
            command::ATTACH_SLAVE => {
                let name = command.arguments.iter().find_map(string_argument);
                site.name = name.map(|(whole, _)| whole);
                let name = name.map(|(_, inner)| self.slice(inner).to_ascii_uppercase().into());
                AttachmentKind::Slave { slot, axis, name }
            }
            command::ATTACH_MASTER => AttachmentKind::Master { master: object(ObjectKind::Master) },
            command::ATTACH_AXIS => {
                let stepper = command.arguments.iter().any(is_stepper);
                AttachmentKind::Axis { axis, stepper }
            }
            command::DETACH => AttachmentKind::Detach { slot, axis },
            command::DETACH_ALL => AttachmentKind::DetachAll,
            _ => return None,
        };
        Some((kind, site))
    }

    fn slice(&self, span: Span) -> &'a str {
        self.text.get(span.range()).unwrap_or_default()
    }

    fn finish(mut self) -> (Exports, Effects) {
        let mut uses: Vec<_> = self.uses.into_iter().map(|(name, level)| (Name::from(name), level)).collect();
        uses.sort_unstable();
        self.exports.uses = uses;
        for levels in [&mut self.exports.levels, &mut self.exports.stored] {
            levels.sort_unstable();
            levels.dedup();
        }
        (self.exports, self.effects.finish())
    }
}

/// Whether a section holds more than remarks, labels and its end.
fn does_something(tree: &Tree, section: &Section) -> bool {
    let range = section.statements.start as usize..section.statements.end as usize;
    let idle = |kind: &StatementKind| match kind {
        StatementKind::Remark(_) | StatementKind::Label(_) => true,
        StatementKind::Command(command) => command.id == command::END,
        _ => false,
    };
    tree.statements().get(range).is_some_and(|statements| statements.iter().any(|statement| !idle(&statement.kind)))
}

fn jump(statement: u32, command: &Command) -> Option<Jump> {
    let call = match command.id {
        command::GOTO => false,
        command::GOSUB => true,
        _ => return None,
    };
    command.arguments.iter().find_map(|argument| match argument {
        Argument::Target(target) => Some(Jump { statement, target: *target, to: None, call }),
        _ => None,
    })
}

fn is_stepper(argument: &Argument) -> bool {
    matches!(argument, Argument::Object(object) if object.kind == ObjectKind::Stepper)
}

/// A string argument with its quotes, and without.
fn string_argument(argument: &Argument) -> Option<(Span, Span)> {
    match argument {
        Argument::Value(Expr { span, kind: ExprKind::String(inner) }) => Some((*span, *inner)),
        _ => None,
    }
}

fn numbered_lines<'a>(tree: &'a Tree, section: &'a Section) -> impl Iterator<Item = LineSite> + 'a {
    let range = section.statements.clone();
    let from = tree.lines().partition_point(|line| line.statements.end <= range.start);
    let lines = tree.lines().get(from..).unwrap_or_default();
    lines.iter().take_while(move |line| line.statements.start < section.statements.end).filter_map(|line| {
        let number = line.number?.value;
        (!line.statements.is_empty()).then_some(LineSite { number, statement: line.statements.start })
    })
}
