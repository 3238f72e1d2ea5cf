//! The statements of a stored program that are certainly executed directly before another one: no label, jump or block
//! lies between.

use acrc_analysis::deed::{Deed, On, acts};
use acrc_analysis::walk;
use acrc_catalog::{BitInfo, CommandId, ObjectKind, OperandClass, UnaryOperator, command};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, BitArgument, Expr, ExprKind, Separator, Statement, StatementKind};
use acrc_syntax::units::SectionKind;

use crate::Context;
use crate::operands::condition;
use crate::references::meaning;

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
        // A loop that only waits is a wait like others.
        if let Some(head) = waiting_loop_ending(statements, at).filter(|head| *head >= first) {
            let range = head as usize + 1..=at as usize;
            let inside = statements.get(range).unwrap_or_default();
            same_line &= inside.iter().all(|statement| statement.separator != Separator::Line);
            at = head;
        }
        let Some(earlier) = statements.get(at as usize) else { break };
        let is_wait = waiting_loop(statements, at).is_some();
        if !is_wait && leads_elsewhere(earlier) || (!same_line && is_conditional(statements, at)) {
            break;
        }
        found.push(earlier);
    }
    found
}

/// What is certainly executed behind the present statement, in its order.
pub(super) fn after<'a>(context: &Context<'a>) -> Vec<&'a Statement> {
    let stored = context.section().filter(|section| section.section.kind == SectionKind::Stored);
    let Some(section) = stored else { return Vec::new() };
    let statements = context.tree().statements();
    let own = waiting_loop(statements, context.statement()).unwrap_or(context.statement());
    let range = own as usize + 1..section.section.statements.end as usize;
    let behind = statements.get(range).unwrap_or_default().iter();
    behind.take(LONGEST).take_while(|s| s.separator != Separator::Then && !leads_elsewhere(s)).collect()
}

/// The WEND of the loop that the statement at `at` begins, if the loop only waits: `WHILE (BIT 516) : WEND`.
fn waiting_loop(statements: &[Statement], at: u32) -> Option<u32> {
    if !is_command(statements.get(at as usize)?, command::WHILE) {
        return None;
    }
    let behind = statements.get(at as usize + 1..)?;
    let inside = behind.iter().take_while(|statement| passes_time(statement)).count();
    behind.get(inside).filter(|statement| is_command(statement, command::WEND)).map(|_| at + 1 + inside as u32)
}

/// The WHILE of the loop that the statement at `at` ends, if the loop only waits.
fn waiting_loop_ending(statements: &[Statement], at: u32) -> Option<u32> {
    if !is_command(statements.get(at as usize)?, command::WEND) {
        return None;
    }
    let head = (0..at).rev().find(|at| statements.get(*at as usize).is_none_or(|s| !passes_time(s)))?;
    statements.get(head as usize).filter(|statement| is_command(statement, command::WHILE)).map(|_| head)
}

fn passes_time(statement: &Statement) -> bool {
    matches!(statement.kind, StatementKind::Remark(_)) || is_command(statement, command::DWL)
}

fn is_command(statement: &Statement, id: CommandId) -> bool {
    matches!(&statement.kind, StatementKind::Command(command) if command.id == id)
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

/// A flag that a statement waits for.
pub(super) struct Wait {
    /// The flag as it is written.
    pub(super) span: Span,
    /// What it is.
    pub(super) flag: BitInfo,
    /// Until it is on.
    pub(super) on: bool,
}

/// The flags that a statement waits for, as far as their numbers are known: an INH, or a loop of the program that does
/// nothing but wait.
pub(super) fn waits(context: &Context<'_>, statement: &Statement) -> Vec<Wait> {
    let mut found = Vec::new();
    match &statement.kind {
        StatementKind::Command(command) if command.id == command::INH => {
            if let [Argument::Bit(bit)] = command.arguments.as_slice() {
                found.extend(flag(context, bit).map(|flag| Wait { span: bit.span, flag, on: !bit.negative }));
            }
        }
        StatementKind::Command(command) if command.id == command::WHILE => {
            let statements = context.tree().statements();
            let at = statements.partition_point(|other| other.span.start < statement.span.start);
            if waiting_loop(statements, at as u32).is_some()
                && let Some(condition) = condition(statement)
            {
                add_waits(context, condition, false, &mut found);
            }
        }
        _ => {}
    }
    found
}

/// The flags of the condition of a loop: it goes on while a flag is on, and waits until it is off.
fn add_waits(context: &Context<'_>, expr: &Expr, on: bool, found: &mut Vec<Wait>) {
    match &expr.kind {
        ExprKind::Paren(inner) => add_waits(context, inner, on, found),
        ExprKind::Unary(UnaryOperator::Not, inner) => add_waits(context, inner, !on, found),
        ExprKind::Binary(_, _, sides) => sides.iter().for_each(|side| add_waits(context, side, on, found)),
        _ => {
            if let Some((OperandClass::Bit, number)) = meaning(context, expr)
                && let Ok(number) = u32::try_from(number)
            {
                found.push(Wait { span: expr.span, flag: acrc_catalog::bit(number), on });
            }
        }
    }
}

/// What the flag of an argument is, when its number is known.
pub(super) fn flag(context: &Context<'_>, bit: &BitArgument) -> Option<BitInfo> {
    let number = match (&bit.index.kind, meaning(context, &bit.index)) {
        (ExprKind::Integer(number), _) => *number,
        (ExprKind::Alias, Some((OperandClass::Bit, number))) => number,
        _ => return None,
    };
    Some(acrc_catalog::bit(u32::try_from(number).ok()?))
}

/// Whether a statement waits for a flag.
pub(super) fn is_wait(statement: &Statement) -> bool {
    is_command(statement, command::INH) || is_command(statement, command::WHILE)
}

/// Whether a statement may write a flag of an axis: of this one, or by a number that is not known.
pub(super) fn writes(context: &Context<'_>, statement: &Statement, axis: u32) -> bool {
    let StatementKind::Command(command) = &statement.kind else { return false };
    matches!(command.id, command::SET | command::CLR)
        && walk::bits(statement).any(|bit| flag(context, bit).is_none_or(|flag| flag.object_index == Some(axis)))
}

/// The number of the one master of the present program.
pub(super) fn only_master(context: &Context<'_>) -> Option<u32> {
    let machine = context.machine();
    let mut masters = machine.masters.iter().filter(|(_, level)| *level == context.level());
    let (master, _) = masters.next()?;
    (masters.next().is_none() && !machine.open).then_some(*master)
}
