//! Where a section reads and writes the variables of its program (`LV`, `SV`, `DV`, `$V` and the arrays).

use acrc_analysis::{SectionIndex, walk};
use acrc_catalog::{OperandClass, command};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, Command, Expr, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::operands::{Reference, Variable};

/// One place at which a variable is used.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mention {
    pub(crate) variable: Variable,
    /// Index of the statement.
    pub(crate) statement: u32,
    pub(crate) span: Span,
    pub(crate) how: How,
}

/// How a variable is used.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum How {
    Read,
    Write,
    /// Both, or no telling which.
    Both,
}

/// The uses of local variables in a section.
#[derive(Default)]
pub(crate) struct Locals {
    /// By variable; of each the places that may write it first, both in the order of the text.
    mentions: Vec<Mention>,
    /// Classes of which some variable is chosen by a computed number.
    computed: Vec<OperandClass>,
}

impl Locals {
    /// The uses in a section.
    pub(crate) fn new(context: &Context<'_>, section: &SectionIndex) -> Self {
        let mut locals = Self::default();
        for at in section.section.statements.clone() {
            let Some(statement) = context.tree().statements().get(at as usize) else { break };
            locals.statement(context, at, statement);
        }
        locals.mentions.sort_by_key(|mention| (mention.variable, mention.how == How::Read, mention.statement));
        locals
    }

    /// Whether variables of a class are chosen by computed numbers, so that each of them may be meant.
    pub(crate) fn is_computed(&self, class: OperandClass) -> bool {
        self.computed.contains(&class)
    }

    /// The classes of which some variable is chosen by a computed number.
    pub(crate) fn computed(&self) -> &[OperandClass] {
        &self.computed
    }

    /// The statements that may write a variable, in the order of the text.
    pub(crate) fn writes(&self, variable: Variable) -> &[Mention] {
        let from = self.mentions.partition_point(|mention| mention.variable < variable);
        let rest = self.mentions.get(from..).unwrap_or_default();
        let count = rest.partition_point(|mention| mention.variable == variable && mention.how != How::Read);
        rest.get(..count).unwrap_or_default()
    }

    /// The uses of each variable, those that may write it first.
    pub(crate) fn by_variable(&self) -> impl Iterator<Item = &[Mention]> {
        self.mentions.chunk_by(|a, b| a.variable == b.variable)
    }

    fn statement(&mut self, context: &Context<'_>, at: u32, statement: &Statement) {
        match &statement.kind {
            StatementKind::Assign(assign) => self.first(context, at, statement, &assign.target, How::Write),
            StatementKind::For(counted) => self.first(context, at, statement, &counted.variable, How::Both),
            StatementKind::Command(command) if !may_write(command) => {
                self.read(context, at, statement, None, How::Read);
            }
            // INPUT, and commands that may be given a variable to fill.
            StatementKind::Command(_) | StatementKind::Input(_) => {
                self.read(context, at, statement, None, How::Both);
            }
            _ => self.read(context, at, statement, None, How::Read),
        }
    }

    /// A statement that writes `target` and reads the rest.
    fn first(&mut self, context: &Context<'_>, at: u32, statement: &Statement, target: &Expr, how: How) {
        self.mention(context, at, target, how);
        self.read(context, at, statement, Some(target), How::Read);
    }

    fn read(&mut self, context: &Context<'_>, at: u32, statement: &Statement, except: Option<&Expr>, how: How) {
        walk::expressions(statement, &mut |expr| {
            if except.is_none_or(|except| !std::ptr::eq(except, expr)) {
                self.mention(context, at, expr, how);
            }
        });
    }

    fn mention(&mut self, context: &Context<'_>, statement: u32, expr: &Expr, how: How) {
        if !matches!(expr.kind, ExprKind::Operand(_) | ExprKind::Alias) {
            return;
        }
        match Reference::of(context, expr) {
            Some(Reference::Known(variable)) if variable.class.is_local() => {
                self.mentions.push(Mention { variable, statement, span: expr.span, how });
            }
            Some(Reference::Computed(class)) if class.is_local() && !self.is_computed(class) => {
                self.computed.push(class);
            }
            _ => {}
        }
    }
}

/// Whether a command is given a bare variable, which it might fill. Conditions are read.
fn may_write(command: &Command) -> bool {
    let is_bare = |argument: &Argument| match argument {
        Argument::Value(expr) => matches!(expr.kind, ExprKind::Operand(_) | ExprKind::Alias),
        _ => false,
    };
    !matches!(command.id, command::WHILE | command::ELSEIF | command::ELSE_IF) && command.arguments.iter().any(is_bare)
}
