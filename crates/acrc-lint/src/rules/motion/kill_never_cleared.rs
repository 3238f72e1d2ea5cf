//! `ACR511`: an axis that can be killed, and that nothing sets free again.

use acrc_analysis::{Deed, SectionIndex, walk};
use acrc_catalog::{OperandClass, command};
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::{Statement, StatementKind};

use super::{axis_name, first_motions_of_attached, straight};
use crate::Context;
use crate::operands::condition;
use crate::references::meaning;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR511", name: "kill-never-cleared" },
        group: Group::Motion,
        severity: Severity::Advice,
        enabled: true,
        mark: None,
        what: "An axis that programs move has hardware limits, or the response to an excess of following error, \
               switched on; and nothing in the project clears its kill request (8467 + 32 * axis), in words or by a \
               DRIVE ON in a program. Where a condition of a program looks whether the axis was killed, a DRIVE ON \
               before the first label and loop of that program does not count: it is not executed again. It is a warning where \
               that condition calls a subroutine which returns: the program goes on as if the axis could move again.",
        why: "A limit sets the kill request of the axis and of all axes of its master. Every motion is refused until \
              somebody clears it, and then Kill All Moves of the master: without a program that does so the machine \
              stands until a person at a terminal sends Ctrl-Y.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLIM X3\nVEL 5\nPROGRAM\nX10\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLIM X3\nVEL 5\nPROGRAM\nX10\nEND\n\
               _Recover\nCLR 8467 : CLR 522\nRETURN\nENDP",
        guide: "Programming Basics / Kill All Motion Request vs. Kill All Moves",
    },
    checks: &[Check::File(check), Check::Section(check_recovery)],
};

/// The flag of a killed axis.
const KILLED: &str = "kill_all_motion_request";

fn check(context: &mut Context<'_>) {
    let machine = context.machine();
    let [limits, response] = [Deed::HardLimitsOn, Deed::ErrorResponse].map(|deed| machine.axes_with(deed));
    for motion in first_motions_of_attached(context, &Deed::MOTION) {
        let by = match (limits.has(motion.axis), response.has(motion.axis)) {
            (true, _) => "a limit switch",
            (false, true) => "an excess of following error",
            (false, false) => continue,
        };
        if machine.never(Deed::KillCleared, motion.axis) && machine.programs_enabling(motion.axis).next().is_none() {
            let axis = axis_name(context, &motion);
            let message = format!("{by} kills the motion of {axis}, and nothing in the project sets it free again");
            context.report(RULE.at(motion.span, message).with_help(help(motion.axis)));
        }
    }
}

fn help(axis: u32) -> String {
    let flag = acrc_catalog::bit_number(KILLED, axis).map(|flag| format!(" (CLR {flag})")).unwrap_or_default();
    format!(
        "where the program recovers from a stop, clear the kill request of the axis{flag}, then Kill All Moves of its \
         master"
    )
}

/// A program that looks whether an axis was killed, and enables its drive at the start only.
fn check_recovery(context: &mut Context<'_>, section: &SectionIndex) {
    let (machine, level) = (context.machine(), section.section.level);
    // Who starts the program again executes its start again.
    let starts_once = machine.never_at(Deed::Run, level) && section.lines.is_empty();
    if !machine.complete || !starts_once || !context.is_whole_program(section) {
        return;
    }
    let range = section.section.statements.start as usize..section.section.statements.end as usize;
    let statements = context.tree().statements().get(range).unwrap_or_default();
    let start = statements.iter().position(comes_again).unwrap_or(statements.len());
    let again = statements.get(start..).unwrap_or_default();
    let enabled: Vec<_> = again
        .iter()
        .flat_map(|statement| straight::deeds(context, statement))
        .filter(|(deed, _)| *deed == Deed::DriveOn)
        .map(|(_, axis)| axis)
        .collect();
    let mut told = Vec::new();
    let first = section.section.statements.start + start as u32;
    let looks: Vec<_> = (first..)
        .zip(again)
        .flat_map(|(at, statement)| looks_at(context, statement).into_iter().map(move |look| (at, look)))
        .collect();
    for (at, (axis, span)) in looks {
        let mut enabling = machine.programs_enabling(axis);
        let only_here = enabling.next().is_some_and(|first| first == level) && enabling.all(|other| other == level);
        let moves = context.motions().iter().any(|motion| motion.axis == axis && motion.level == level);
        let is_cleared =
            !machine.never(Deed::KillCleared, axis) || enabled.iter().any(|on| on.is_none_or(|on| on == axis));
        if moves && only_here && !is_cleared && !told.contains(&axis) {
            told.push(axis);
            let goes_on = calls_and_goes_on(context, section, at);
            let message = format!("the program looks whether AXIS{axis} was killed, and nothing sets it free again");
            let severity = if goes_on { Severity::Warning } else { Severity::Advice };
            context.report(Diagnostic { severity, ..RULE.at(span, message).with_help(help(axis)) });
        }
    }
}

/// Whether an IF calls a subroutine that can return: the program goes on as if the axis could move again.
fn calls_and_goes_on(context: &mut Context<'_>, section: &SectionIndex, at: u32) -> bool {
    let call = section.jumps.iter().find(|jump| jump.call && jump.statement == at + 1);
    call.is_some_and(|call| context.flow(section).is_some_and(|flow| flow.returns_from(call.statement)))
}

/// Whether what stands behind a statement may be executed again.
fn comes_again(statement: &Statement) -> bool {
    match &statement.kind {
        StatementKind::Label(_) | StatementKind::For(_) | StatementKind::Error => true,
        StatementKind::Command(command) => command.id == command::WHILE,
        _ => false,
    }
}

/// The axes whose kill requests a condition looks at, with the places.
fn looks_at(context: &Context<'_>, statement: &Statement) -> Vec<(u32, Span)> {
    let mut found = Vec::new();
    let Some(condition) = condition(statement) else { return found };
    walk::each(condition, &mut |expr| {
        if let Some((OperandClass::Bit, number)) = meaning(context, expr)
            && let Some(axis) = u32::try_from(number).ok().map(acrc_catalog::bit).filter(|flag| flag.field == KILLED)
        {
            found.extend(axis.object_index.map(|axis| (axis, expr.span)));
        }
    });
    found
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{found_by, spans_of};

    fn found(setup: &str, program: &str) -> Vec<String> {
        let text = format!(
            "#DEFINE KillX BIT8467\nAXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH \
             SLAVE1 AXIS1 \"Y\"\n{setup}\nPROGRAM\nX10 Y10\n{program}\nENDP\n"
        );
        spans_of("ACR511", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn limits_and_error_response_kill() {
        assert_eq!(found("HLIM X3", ""), ["X"]);
        assert_eq!(found("SET 8501", ""), ["Y"]);
        assert_eq!(found("HLIM X3\nDRIVE ON X", ""), ["X"], "the setup is not executed again");
        assert_eq!(found("", ""), [""; 0]);
    }

    #[test]
    fn a_program_that_looks_and_does_not_clear() {
        let look = |first: &str, then: &str, end: &str| {
            let text = format!(
                "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLIM X3\nPROGRAM\n{first}\nDRIVE ON \
                 X\n_A\nX10\nIF (BIT 8467) THEN GOSUB B\nGOTO A\n_B\n{then}\nRETURN\nENDP\n{end}"
            );
            spans_of("ACR511", &text).into_iter().map(str::to_owned).collect::<Vec<_>>()
        };
        assert_eq!(look("PBOOT", "CLR 16132", ""), ["BIT 8467"]);
        assert_eq!(look("PBOOT", "GOTO A", ""), ["BIT 8467"]);
        assert_eq!(look("PBOOT", "CLR 8467", ""), [""; 0]);
        assert_eq!(look("PBOOT", "DRIVE ON X", ""), [""; 0]);
        assert_eq!(look("_Start", "CLR 16132", ""), [""; 0], "it may be executed again");
        assert_eq!(look("PBOOT", "CLR 16132", "PROG1\nPROGRAM\nDRIVE ON AXIS0\nENDP\n"), [""; 0], "another program");
        assert_eq!(look("PBOOT", "CLR 16132", "PROG1\nPROGRAM\nRUN PROG0\nENDP\n"), [""; 0], "it is started again");
    }

    #[test]
    fn a_program_that_goes_on_is_warned() {
        let text = |then: &str| {
            format!(
                "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLIM X3\nPROGRAM\nPBOOT\nDRIVE ON \
                 X\n_A\nX10\nIF (BIT 8467) THEN {then}\nGOTO A\n_B\nPRINT \"killed\"\nRETURN\n_C\nPRINT \"killed\"\nEND\nENDP\n"
            )
        };
        for (then, severity) in
            [("GOSUB B", Severity::Warning), ("GOSUB C", Severity::Advice), ("GOTO C", Severity::Advice)]
        {
            assert_eq!(found_by("ACR511", &text(then))[0].severity, severity, "{then}");
        }
    }

    #[test]
    fn every_way_of_recovering() {
        for recover in ["CLR 8467", "CLR KillX", "BIT8467 = 0", "DRIVE ON X", "DRIVE ON AXIS0", "CLR (8467 + 32 * LV0)"]
        {
            assert_eq!(found("HLIM X3", recover), [""; 0], "{recover}");
        }
        assert_eq!(found("HLIM X3", "SET 8467"), ["X"]);
    }
}
