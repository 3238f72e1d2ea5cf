//! Sections of a file with their labels, line numbers, jumps and blocks.

use acrc_catalog::{CommandId, command};
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
use acrc_syntax::ast::{StatementKind, Target};
use acrc_syntax::blocks::Blocks;
use acrc_syntax::units::Section;

/// A section with what can be jumped to in it and from where.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionIndex {
    /// Level, kind and extent.
    pub section: Section,
    /// Its labels, sorted by name, then by place.
    pub labels: Vec<LabelSite>,
    /// Its line numbers, sorted by number, then by place.
    pub lines: Vec<LineSite>,
    /// Its `GOTO` and `GOSUB`, in the order of the text.
    pub jumps: Vec<Jump>,
    /// Its blocks.
    pub blocks: Blocks,
    /// Another program in it, when its own `ENDP` was forgotten.
    pub swallowed: Option<Swallowed>,
}

/// A program that is stored as a part of the one before it, which was not closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Swallowed {
    /// The first statement that was meant to stand outside: the switch of the prompt before the inner `PROGRAM`, or that
    /// `PROGRAM` itself.
    pub first: u32,
    /// The inner `PROGRAM`.
    pub program: u32,
}

impl Swallowed {
    /// Looks for a `PROGRAM` between the `PROGRAM` and the `ENDP` of a section.
    pub(super) fn find(tree: &Tree, section: &Section) -> Option<Self> {
        section.opener?;
        let mut switch = None;
        for at in section.statements.clone() {
            let StatementKind::Command(command) = &tree.statements().get(at as usize)?.kind else { continue };
            if command.id == command::PROGRAM {
                return Some(Self { first: switch.unwrap_or(at), program: at });
            }
            if SWITCHES.contains(&command.id) {
                switch.get_or_insert(at);
            }
        }
        None
    }
}

/// The commands that switch the prompt.
pub(super) const SWITCHES: [CommandId; 3] = [command::PROG, command::PLC, command::SYS];

/// The definition of a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LabelSite {
    /// The name without the underscore.
    pub name: Span,
    /// Index of the statement.
    pub statement: u32,
}

/// A line number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LineSite {
    /// The number.
    pub number: u32,
    /// Index of the first statement of the line.
    pub statement: u32,
}

/// A `GOTO` or `GOSUB`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Jump {
    /// Index of the statement.
    pub statement: u32,
    /// Where it goes, as written.
    pub target: Target,
    /// The statement of this section that it goes to, when there is one.
    pub to: Option<u32>,
    /// It is a `GOSUB`.
    pub call: bool,
}

impl SectionIndex {
    /// The labels of this name; more than one when it is defined twice. Labels are case-sensitive.
    pub fn labels_named<'a>(&'a self, text: &'a str, name: &str) -> &'a [LabelSite] {
        let from = self.labels.partition_point(|label| slice(text, label.name) < name);
        let rest = self.labels.get(from..).unwrap_or_default();
        let count = rest.partition_point(|label| slice(text, label.name) == name);
        rest.get(..count).unwrap_or_default()
    }

    pub(super) fn resolve_jumps(&mut self, text: &str) {
        let mut jumps = std::mem::take(&mut self.jumps);
        for jump in &mut jumps {
            jump.to = self.resolve(text, jump.target);
        }
        self.jumps = jumps;
    }

    /// The statement that a jump of this section leads to: a label, or a line number. A bare number is a line number
    /// unless only a label of that name exists.
    pub fn resolve(&self, text: &str, target: Target) -> Option<u32> {
        match target {
            Target::Label(name) => self.labels_named(text, slice(text, name)).first().map(|label| label.statement),
            Target::Line(number, span) => {
                let at = self.lines.partition_point(|line| line.number < number);
                let line = self.lines.get(at).filter(|line| line.number == number);
                line.map(|line| line.statement).or_else(|| self.resolve(text, Target::Label(span)))
            }
        }
    }
}

fn slice(text: &str, span: Span) -> &str {
    text.get(span.range()).unwrap_or_default()
}
