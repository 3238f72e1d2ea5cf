//! The parameters and bits that a statement names, by number: as a literal (`P12290`), as a constant (`P(12288+256)`),
//! as the argument of `SET` or `INH`, or through an alias. Who asks about numbers sees all of them alike.

use acrc_catalog::{CommandId, OperandClass, command};
use acrc_diagnostics::{Diagnostic, Span};
use acrc_syntax::ast::{BitArgument, Expr, ExprKind, Statement, StatementKind};

use crate::index::AliasTarget;
use crate::walk;

/// Tells what the alias at a place stands for.
pub type AliasAt<'a> = &'a dyn Fn(Span) -> Option<AliasTarget>;

/// A parameter, bit or variable with a number that is known before the program runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reference {
    /// Where it stands.
    pub span: Span,
    /// What it is.
    pub class: OperandClass,
    /// Its number.
    pub number: u64,
    /// It is written as an alias.
    pub alias: bool,
    /// What the statement does with it.
    pub usage: Usage,
}

/// What a statement does with a parameter or bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Usage {
    /// Gives it an alias.
    Define,
    /// Takes its value.
    Read,
    /// Shows its value to a person.
    Print,
    /// Changes it.
    Write,
    /// Waits until the bit is set, or clear.
    Wait {
        /// Until it is set.
        set: bool,
    },
}

impl Reference {
    /// Its number, unless it is beyond all numbers.
    pub fn small(&self) -> Option<u32> {
        u32::try_from(self.number).ok()
    }

    /// What a person calls it: `P12290`, `bit 516`.
    pub fn name(&self) -> String {
        match self.class {
            OperandClass::Bit => format!("bit {}", self.number),
            class => format!("{class}{}", self.number),
        }
    }

    /// Says at the place of an alias which number it stands for.
    #[must_use]
    pub fn labelled(&self, finding: Diagnostic) -> Diagnostic {
        if self.alias { finding.with_label(format!("this is {}", self.name())) } else { finding }
    }
}

/// Puts the references of a statement into `found`, in the order of the text.
pub fn collect(alias_at: AliasAt<'_>, statement: &Statement, found: &mut Vec<Reference>) {
    found.clear();
    for bit in walk::bits(statement) {
        found.extend(bit_reference(alias_at, statement, bit));
    }
    let bits = found.len();
    walk::expressions(statement, &mut |expr| {
        if let Some((class, number)) = meaning(alias_at, expr)
            && !walk::bits(statement).any(|bit| bit.index.span == expr.span)
        {
            let alias = matches!(expr.kind, ExprKind::Alias);
            found.push(Reference { span: expr.span, class, number, alias, usage: usage(statement, expr) });
        }
    });
    if bits > 0 && found.len() > bits {
        found.sort_by_key(|reference| reference.span.start);
    }
}

/// The operand that an expression is, when its number is known.
pub fn meaning(alias_at: AliasAt<'_>, expr: &Expr) -> Option<(OperandClass, u64)> {
    match &expr.kind {
        ExprKind::Operand(operand) => Some((operand.class, walk::whole(&operand.index)?)),
        ExprKind::Alias => match alias_at(expr.span)? {
            AliasTarget::Operand(class, number) => Some((class, number?)),
            _ => None,
        },
        _ => None,
    }
}

/// The bit that an argument names. An alias of something else is not one.
fn bit_reference(alias_at: AliasAt<'_>, statement: &Statement, bit: &BitArgument) -> Option<Reference> {
    let StatementKind::Command(command) = &statement.kind else { return None };
    let alias = matches!(bit.index.kind, ExprKind::Alias);
    let number = if alias {
        match meaning(alias_at, &bit.index)? {
            (OperandClass::Bit, number) => number,
            _ => return None,
        }
    } else {
        walk::whole(&bit.index)?
    };
    let usage = bit_usage(command.id, bit.negative);
    Some(Reference { span: bit.span, class: OperandClass::Bit, number, alias, usage })
}

/// What a command does with the bit that is its argument.
pub fn bit_usage(id: CommandId, negative: bool) -> Usage {
    match id {
        command::SET | command::CLR | command::OUT | command::OUT_NOT => Usage::Write,
        command::INH => Usage::Wait { set: !negative },
        _ => Usage::Read,
    }
}

fn usage(statement: &Statement, expr: &Expr) -> Usage {
    let is = |target: &Expr| std::ptr::eq(target, expr);
    match &statement.kind {
        StatementKind::Assign(assign) if is(&assign.target) => Usage::Write,
        StatementKind::For(counted) if is(&counted.variable) => Usage::Write,
        StatementKind::Input(input) if input.variables.iter().any(is) => Usage::Write,
        StatementKind::Define(_) => Usage::Define,
        StatementKind::Print(_) => Usage::Print,
        _ => Usage::Read,
    }
}
