//! `ACR230`: a command at a prompt that does not take it.

use acrc_catalog::{CommandId, Confidence, Shape, command};
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Argument, Command, Statement, StatementKind};
use acrc_syntax::units::{Level, SectionKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR230", name: "wrong-prompt" },
        group: Group::Names,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A command of a program or of its master is sent at the SYS prompt, or a PLC program moves axes or waits. \
               Files that do not show at which prompt they are sent are left alone.",
        why: "The controller refuses the command while the setup is sent, and what it should have set keeps its old \
              value: the first move runs with another velocity. A PLC program is scanned again and again beside the \
              programs and has no master: coordinated moves and waits belong to a program.",
        bad: "SYS\nVEL 20\nPROG0\nATTACH MASTER0",
        good: "SYS\nPROG0\nATTACH MASTER0\nVEL 20",
        guide: "Programs and Commands / Communication Levels",
    },
    checks: &[Check::Statement(check)],
};

/// Left to the rules about programs.
const LEFT_ALONE: [CommandId; 2] = [command::PROGRAM, command::ENDP];

/// What PLC programs do not take, beside moves.
const NOT_IN_PLC: [CommandId; 6] =
    [command::DWL, command::INH, command::IHPOS, command::MSEEK, command::MBUF, command::MBUF_ON];

fn check(context: &mut Context<'_>, statement: &Statement) {
    match context.level() {
        Level::System => check_system(context, statement),
        Level::Plc(_) => check_plc(context, statement),
        Level::Program(_) => {}
    }
}

fn check_plc(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(command) = &statement.kind else { return };
    let row = command.id.info();
    let is_move = row.shape == Shape::Move;
    if row.confidence != Confidence::High || row.levels.plc() || !(is_move || NOT_IN_PLC.contains(&command.id)) {
        return;
    }
    let (span, what) = if is_move { (statement.span, "coordinated moves") } else { (command.name, row.name) };
    let finding = RULE.at(span, format!("PLC programs do not take {what}"));
    context
        .report(finding.with_help("put it into a program, which the PLC program starts with RUN or tells by a flag"));
}

fn check_system(context: &mut Context<'_>, statement: &Statement) {
    let is_immediate = context.section().is_some_and(|section| section.section.kind == SectionKind::Immediate);
    if !is_immediate || context.environment().fragment {
        return;
    }
    let Some((id, span)) = judged(statement) else { return };
    let row = id.info();
    let is_attested = row.confidence == Confidence::High && !LEFT_ALONE.contains(&id);
    if is_attested && row.levels.prog() && !row.levels.sys() {
        let finding = RULE.at(span, format!("the SYS prompt does not take {}", row.name));
        context.report(finding.with_help("switch to the program first, for example with PROG0"));
    }
}

/// The command of a statement with its name. An object before it or behind it says what it acts on at any prompt, and
/// axis names have a rule of their own.
fn judged(statement: &Statement) -> Option<(CommandId, Span)> {
    match &statement.kind {
        StatementKind::Command(command) if is_bare(command) => Some((command.id, command.name)),
        StatementKind::For(_) => Some((command::FOR, statement.span)),
        _ => None,
    }
}

fn is_bare(command: &Command) -> bool {
    let names = |argument: &Argument| matches!(argument, Argument::Axis(_) | Argument::Object(_));
    command.prefix.is_none() && !command.arguments.iter().any(names)
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, lines_of, spans_of};

    #[test]
    fn commands_of_a_program_at_the_system_prompt() {
        let text = "SYS\nVEL 20 ACC 100\nGOSUB 100\nDWL 1\nPROG0\nVEL 20 ACC 100\nDWL 1\n";
        assert_eq!(spans_of("ACR230", text), ["VEL", "ACC", "GOSUB", "DWL"]);
    }

    #[test]
    fn commands_of_the_system_are_sent_at_program_prompts_too() {
        assert_eq!(codes("PROG0\nESAVE\nFLASH IMAGE\nPROGRAM\nESAVE\nENDP\n"), []);
    }

    #[test]
    fn objects_say_what_is_meant_at_any_prompt() {
        let text = "SYS\nAXIS0 PPU 2000\nAXIS0 JOG VEL 5\nRES AXIS0\nDRIVE ON AXIS0\nRUN PROG0\nHALT ALL\nP0 = 1 : SET 32\nPROG0\n";
        assert_eq!(codes(text), []);
    }

    #[test]
    fn the_name_of_a_file_tells_its_prompt() {
        let files = [("Setup.8K", "VEL 20\n"), ("Prog0.8K", "VEL 20\nENDP\n"), ("PLC0.8K", "LD 5\nOUT 32\n")];
        assert_eq!(lines_of("ACR230", &files), [vec![1], vec![], vec![]]);
    }

    #[test]
    fn plc_programs_neither_move_nor_wait() {
        let text = "PLC0\nPROGRAM\nLD 5\nOUT 32\nX0\nMOV X1\nDWL 1\nINH 24\nVEL 20\nP0 = 1 : SET 33\nENDP\n";
        assert_eq!(spans_of("ACR230", text), ["X0", "MOV X1", "DWL", "INH"]);
        assert_eq!(lines_of("ACR230", &[("PLC3.8K", "PROGRAM\nCIRCW X(1,1) Y(0,1)\nEND\nENDP\n")]), [[2]]);
    }

    #[test]
    fn a_piece_of_code_may_be_sent_anywhere() {
        assert_eq!(codes("VEL 20\nDWL 1\nFOR LV0 = 1 TO 3\nNEXT\n"), []);
        assert_eq!(codes("PROGRAM\nDWL 1\nENDP\n"), []);
    }
}
