//! `ACR308`: waiting for, or asking for, a request that clears itself.

use acrc_analysis::walk;
use acrc_catalog::{BitInfo, BitKind, Confidence, OperandClass, UnaryOperator, bit_number, command};
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::{Argument, Expr, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::references::meaning;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR308", name: "request-bit-awaited" },
        group: Group::Parameters,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program waits until a request bit is set, or tests whether one is that the controller clears at once. \
               Waiting until a request is clear, that is, done, is fine. Kill All Moves and the Kill All Motion Request \
               stay set and are no requests in this sense.",
        why: "The controller clears a request as soon as it has processed it, mostly before a program gets to look. The \
              wait never ends, the test is never true.",
        bad: "PROG0\nPROGRAM\nSET 1064\nINH 1064\nENDP",
        good: "PROG0\nPROGRAM\nSET 1064\nINH -1064\nENDP",
        guide: "Programming Basics / Parameters and Bits",
    },
    checks: &[Check::Statement(check)],
};

/// The requests that are processed at once, with the flag that shows what they bring about. The others last as long as
/// what they ask for: the ramp of a stop, the start of a network.
const INSTANT: [(&str, &str); 4] = [
    ("feedhold_request", "in_feedhold"),
    ("cycle_start_request", "in_motion"),
    ("run_request", "program_running"),
    ("halt_request", "program_running"),
];

fn check(context: &mut Context<'_>, statement: &Statement) {
    match &statement.kind {
        StatementKind::If(branch) if goes_back(context) => awaited(context, &branch.condition),
        StatementKind::If(branch) => tested(context, &branch.condition),
        StatementKind::Command(inhibit) if inhibit.id == command::INH => {
            for bit in walk::bits(statement).filter(|bit| !bit.negative) {
                let number = match &bit.index.kind {
                    ExprKind::Alias => meaning(context, &bit.index).filter(|(class, _)| *class == OperandClass::Bit),
                    _ => walk::whole(&bit.index).map(|number| (OperandClass::Bit, number)),
                };
                if let Some(info) = number.and_then(|(_, number)| request(number)) {
                    context.report(finding(bit.span, &info, "this wait may never end"));
                }
            }
        }
        StatementKind::Command(head) if head.id == command::WHILE => {
            if let Some(Argument::Value(condition)) = head.arguments.first() {
                awaited(context, condition);
            }
        }
        StatementKind::Command(head) if head.id == command::ELSEIF || head.id == command::ELSE_IF => {
            if let Some(Argument::Value(condition)) = head.arguments.first() {
                tested(context, condition);
            }
        }
        _ => {}
    }
}

/// Whether the present statement, an IF, jumps back in the text: a loop that waits, by another name.
fn goes_back(context: &Context<'_>) -> bool {
    let at = context.statement();
    let jumps = context.section().map_or(&[][..], |section| &section.jumps);
    jumps.iter().any(|jump| !jump.call && jump.statement == at + 1 && jump.to.is_some_and(|to| to < at))
}

/// The condition under which a loop goes on.
fn awaited(context: &mut Context<'_>, condition: &Expr) {
    let condition = bare(condition);
    if let ExprKind::Unary(UnaryOperator::Not, inner) = &condition.kind
        && let Some(info) = request_of(context, bare(inner))
    {
        context.report(finding(condition.span, &info, "this wait may never end"));
    }
}

fn tested(context: &mut Context<'_>, condition: &Expr) {
    let condition = bare(condition);
    if let Some(info) = request_of(context, condition)
        && INSTANT.iter().any(|(request, _)| *request == info.field)
    {
        context.report(finding(condition.span, &info, "this is hardly ever true"));
    }
}

fn bare(expr: &Expr) -> &Expr {
    match &expr.kind {
        ExprKind::Paren(inner) => bare(inner),
        _ => expr,
    }
}

fn request_of(context: &Context<'_>, expr: &Expr) -> Option<BitInfo> {
    match meaning(context, expr)? {
        (OperandClass::Bit, number) => request(number),
        _ => None,
    }
}

/// The bit, if it is attested as a request.
fn request(number: u64) -> Option<BitInfo> {
    let info = acrc_catalog::bit(u32::try_from(number).ok()?);
    (info.kind == Some(BitKind::Request) && info.confidence != Confidence::Low).then_some(info)
}

fn finding(span: Span, info: &BitInfo, label: &str) -> Diagnostic {
    let BitInfo { number, title, .. } = *info;
    let finding =
        RULE.at(span, format!("bit {number} ({title}) clears itself when it has been processed")).with_label(label);
    let finding = if info.confidence == Confidence::High { finding } else { finding.unconfirmed() };
    match state(info) {
        Some((state, title)) => finding.with_help(format!("look at what it brings about: bit {state} ({title})")),
        None => finding.with_help(format!("wait until it is clear again, that is, done: INH -{number}")),
    }
}

/// The flag that shows what a request brings about, where its number is attested.
fn state(info: &BitInfo) -> Option<(u32, &'static str)> {
    let (_, field) = INSTANT.iter().find(|(request, _)| *request == info.field)?;
    let state = acrc_catalog::bit(bit_number(field, info.object_index?)?);
    (state.confidence != Confidence::Low).then_some((state.number, state.title))
}

#[cfg(test)]
mod tests {
    use crate::testing::{lint, spans_of};

    #[test]
    fn waiting_for_a_request() {
        assert_eq!(spans_of("ACR308", "INH 520\nINH BIT5647\nINH (11265)\n"), ["520", "BIT5647", "(11265)"]);
        assert_eq!(spans_of("ACR308", "WHILE (NOT BIT 1032)\nWEND\n"), ["NOT BIT 1032"]);
        assert_eq!(
            spans_of("ACR308", "PROGRAM\n_A\nDWL 1\nIF (NOT BIT 520) THEN GOTO A\nIF (BIT 520) THEN GOTO A\nENDP\n"),
            ["NOT BIT 520"]
        );
        assert_eq!(spans_of("ACR308", "#DEFINE Start BIT521\nINH Start\nIF (Start) THEN SET 32\n"), ["Start", "Start"]);
    }

    #[test]
    fn waiting_for_its_end_and_for_states() {
        let text = "INH -520\nINH -5647\nINH 516\nINH 8467\nINH 522\nWHILE (BIT 523)\nWEND\nIF (BIT 11265) THEN SET 32\nIF (NOT BIT 1032) THEN SET 32\n";
        assert_eq!(spans_of("ACR308", text), [""; 0]);
    }

    #[test]
    fn the_state_is_named() {
        let found = lint(&[("test.8K", "IF (BIT 1064) THEN SET 32\n")]).concat();
        assert_eq!(found[0].help.as_deref(), Some("look at what it brings about: bit 1056 (Program Running)"));
    }
}
