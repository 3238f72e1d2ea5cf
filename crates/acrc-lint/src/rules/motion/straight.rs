//! The statements of a stored program that are certainly executed directly before another one: no label, jump or block
//! lies between.

use acrc_analysis::AliasFact;
use acrc_analysis::deed::{Deed, On, acts};
use acrc_analysis::index::AliasTarget;
use acrc_catalog::{BitInfo, ObjectKind, OperandClass, command};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, BitArgument, Command, ExprKind, Separator, Statement, StatementKind};
use acrc_syntax::units::SectionKind;

use crate::Context;

/// The group of the catalogue with the statements that lead elsewhere.
const FLOW: &str = "Program Flow";
/// Longer stretches are not looked at.
const LONGEST: usize = 100;

/// What is executed before the present statement, the nearest first. Nothing for what is typed at a prompt: time passes
/// between the lines.
pub(super) fn before<'a>(context: &Context<'a>) -> Vec<&'a Statement> {
    let stored = context.section().filter(|section| section.section.kind == SectionKind::Stored);
    let (Some(section), statements) = (stored, context.tree().statements()) else { return Vec::new() };
    let first = section.section.statements.start;
    let mut found = Vec::new();
    let mut at = context.statement();
    let mut same_line = true;
    while let Some(present) = statements.get(at as usize) {
        same_line &= present.separator != Separator::Line;
        if present.separator == Separator::Then || at <= first || found.len() == LONGEST {
            break;
        }
        at -= 1;
        let Some(earlier) = statements.get(at as usize) else { break };
        if leads_elsewhere(earlier) || (!same_line && is_conditional(statements, at)) {
            break;
        }
        found.push(earlier);
    }
    found
}

fn leads_elsewhere(statement: &Statement) -> bool {
    match &statement.kind {
        StatementKind::Command(command) => command.id.info().group == FLOW,
        StatementKind::Label(_)
        | StatementKind::If(_)
        | StatementKind::For(_)
        | StatementKind::Input(_)
        | StatementKind::Error => true,
        _ => false,
    }
}

/// Whether a statement stands behind a `THEN`.
fn is_conditional(statements: &[Statement], mut at: u32) -> bool {
    while let Some(statement) = statements.get(at as usize) {
        match statement.separator {
            Separator::Then => return true,
            Separator::Line => return false,
            Separator::Colon | Separator::Blank => {}
        }
        let Some(earlier) = at.checked_sub(1) else { return false };
        at = earlier;
    }
    false
}

/// What a command does, with the axis when it is known.
pub(super) fn deeds(context: &Context<'_>, statement: &Statement) -> Vec<(Deed, Option<u32>)> {
    let StatementKind::Command(command) = &statement.kind else { return Vec::new() };
    acts(command).map(|act| (act.deed, axis_of(context, act.on))).collect()
}

/// The axis that something is done to, when its number is known.
pub(super) fn axis_of(context: &Context<'_>, on: On<Span>) -> Option<u32> {
    match on {
        On::Object(ObjectKind::Axis, axis) => axis,
        On::Axis(name) => context.environment().axes_at(context.level())?.find(context.slice(name))?.1,
        On::Level | On::Object(..) | On::Word(_) => None,
    }
}

/// The flag that an INH waits for, when its number is known.
pub(super) fn awaited<'t>(context: &Context<'_>, command: &'t Command) -> Option<(&'t BitArgument, BitInfo)> {
    if command.id != command::INH {
        return None;
    }
    let [Argument::Bit(bit)] = command.arguments.as_slice() else { return None };
    let number = match bit.index.kind {
        ExprKind::Integer(number) => number,
        ExprKind::Alias => match context.alias(bit.index.span)? {
            AliasFact::Defined { operand, .. } => match operand.target {
                AliasTarget::Operand(OperandClass::Bit, Some(number)) => number,
                _ => return None,
            },
            AliasFact::Undefined { .. } => return None,
        },
        _ => return None,
    };
    Some((bit, acrc_catalog::bit(u32::try_from(number).ok()?)))
}

/// The flag that an earlier INH of a stretch waits for.
pub(super) fn awaited_by(context: &Context<'_>, statement: &Statement) -> Option<BitInfo> {
    let StatementKind::Command(command) = &statement.kind else { return None };
    awaited(context, command).map(|(_, flag)| flag)
}

/// The number of the one master of the present program.
pub(super) fn only_master(context: &Context<'_>) -> Option<u32> {
    let machine = context.machine();
    let mut masters = machine.masters.iter().filter(|(_, level)| *level == context.level());
    let (master, _) = masters.next()?;
    (masters.next().is_none() && !machine.open).then_some(*master)
}
