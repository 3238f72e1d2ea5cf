//! `ACR204`: an axis name that the program does not have.

use acrc_analysis::deed::acts;
use acrc_analysis::{AxisTable, walk};
use acrc_catalog::command::AXIS_MOVE;
use acrc_diagnostics::{Code, Diagnostic, Edit, Fix, Severity};
use acrc_syntax::ast::{Argument, Axis, Statement, StatementKind};
use acrc_syntax::units::Level;

use crate::near_command::{exchanged_letters, near_command};
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::rules::arguments::report_before_move;
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR204", name: "undeclared-axis" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A statement uses an axis name that no ATTACH SLAVE gives in this program. A misspelt command looks the \
               same: `VLE 5` reads as a move of an axis named VLE. In a project that attaches nothing at all it is one \
               advice a project, as attachments may have been made by hand and stay on the controller.",
        why: "An axis name is valid in its own program only. Without the attachment the move is refused when the \
              program gets there, in the middle of the cycle.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nX10 Y20\nENDP",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\nPROGRAM\nX10 Y20\nENDP",
        guide: "System Configuration / Attachments",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    if report_before_move::follows_report(context, statement) {
        return;
    }
    if let Some(axis) = walk::axes(statement).next().filter(|axis| is_label(context, axis, statement)) {
        let name = context.slice(axis.name);
        let finding = RULE.at(axis.name, format!("`{name}` is no command, and a label begins with an underscore"));
        let fix =
            Fix::unsafe_(format!("make it the label _{name}"), vec![Edit::replace(axis.name, format!("_{name}"))]);
        context.report(finding.with_fix(fix));
        return;
    }
    let level = context.level();
    for axis in walk::axes(statement) {
        match context.environment().axes_at(level) {
            Some(table) if table.open || table.has(context.slice(axis.name)) => {}
            Some(table) => context.report(not_among(context, axis, statement, table)),
            None if context.environment().fragment => {
                if let Some(diagnostic) = probably_misspelt(context, axis, statement) {
                    context.report(diagnostic);
                }
            }
            None => without_attachments(context, axis, statement),
        }
    }
}

/// Whether a lone word at the start of a line is what a GOTO or GOSUB of the program looks for in vain.
fn is_label(context: &Context<'_>, axis: &Axis, statement: &Statement) -> bool {
    let is_alone = axis.value.is_none() && may_be_command(axis, statement) && statement.span == axis.name;
    let jumps = context.section().filter(|_| is_alone).map_or(&[][..], |section| &section.jumps);
    jumps.iter().any(|jump| jump.to.is_none() && context.slice(jump.target.span()) == context.slice(axis.name))
}

fn not_among(context: &Context<'_>, axis: &Axis, statement: &Statement, table: &AxisTable) -> Diagnostic {
    let name = context.slice(axis.name);
    if may_be_command(axis, statement)
        && let Some(command) = near_command(name)
    {
        return misspelt(axis, name, command);
    }
    let program = level_name(context.level());
    let names: Vec<_> = table.names.iter().map(|(name, _)| &**name).collect();
    RULE.at(axis.name, format!("{program} has no axis `{name}`"))
        .with_help(format!("its axes are {}; ATTACH SLAVE gives a name to another one", names.join(", ")))
}

/// One error a program is enough: the first axis stands for all.
fn without_attachments(context: &mut Context<'_>, axis: &Axis, statement: &Statement) {
    let level = context.level();
    // Which names a PLC program may use is not documented.
    if matches!(level, Level::Plc(_)) || context.reported_levels.contains(&level) {
        return;
    }
    context.reported_levels.push(level);
    if let Some(first) = context.machine().unattached.filter(|_| level != Level::System) {
        attached_by_hand(context, axis, first);
        return;
    }
    let name = context.slice(axis.name);
    let program = level_name(level);
    let uses = if is_motion(statement) { "moves" } else { "uses the axis" };
    let diagnostic = match level {
        Level::System => RULE
            .at(axis.name, format!("the axis `{name}` is used at the SYS prompt, which has no axis names"))
            .with_help("switch to the program with PROGn, or address the axis by number (AXIS0)"),
        _ => RULE
            .at(axis.name, format!("{program} {uses} `{name}`, but no ATTACH SLAVE names an axis for it"))
            .with_help(format!(
                "attach a master and the axis in the setup of {program}: ATTACH MASTER0, ATTACH SLAVE0 AXIS0 \"{name}\""
            )),
    };
    context.report(diagnostic);
}

/// Once a project that attaches nothing, in the first file that names an axis.
fn attached_by_hand(context: &mut Context<'_>, axis: &Axis, first: u32) {
    let is_told = context.reported_levels.iter().filter(|level| matches!(level, Level::Program(_))).count() > 1;
    if is_told || context.environment().place != first {
        return;
    }
    let message =
        format!("the axis `{}` is used, but nothing in the project attaches an axis", context.slice(axis.name));
    let diagnostic = RULE.at(axis.name, message).with_help(
        "unless the controller keeps attachments that were made by hand, attach masters and axes in the setup: ATTACH \
         MASTER0, ATTACH SLAVE0 AXIS0",
    );
    context.report(Diagnostic { severity: Severity::Advice, ..diagnostic });
}

fn is_motion(statement: &Statement) -> bool {
    matches!(&statement.kind, StatementKind::Command(command) if acts(command).any(|act| act.deed.is_motion()))
}

/// In a piece of code without its surroundings any name may be an axis. Only a name that does not move, and a command
/// with two letters exchanged, are still conspicuous.
fn probably_misspelt(context: &Context<'_>, axis: &Axis, statement: &Statement) -> Option<Diagnostic> {
    let name = context.slice(axis.name);
    if name.len() < 3 || !may_be_command(axis, statement) {
        return None;
    }
    if axis.value.is_none() {
        return Some(near_command(name).map_or_else(
            || RULE.at(axis.name, format!("`{name}` is no command, and no axis with a target either")),
            |command| misspelt(axis, name, command),
        ));
    }
    let command = exchanged_letters(name)?;
    Some(Diagnostic { severity: Severity::Warning, ..misspelt(axis, name, command) })
}

fn misspelt(axis: &Axis, name: &str, command: &str) -> Diagnostic {
    RULE.at(axis.name, format!("unknown command or axis `{name}`: did you mean `{command}`?"))
        .with_fix(Fix::unsafe_(format!("write {command}"), vec![Edit::replace(axis.name, command)]))
}

/// The first axis of a move without a keyword, alone or without a target: a misspelt command reads like this.
fn may_be_command(axis: &Axis, statement: &Statement) -> bool {
    let StatementKind::Command(command) = &statement.kind else { return false };
    let is_first = matches!(command.arguments.first(), Some(Argument::Axis(first)) if first.name == axis.name);
    command.id == AXIS_MOVE && is_first && (command.arguments.len() == 1 || axis.value.is_none())
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, codes_in, lines_of, lint};

    const X: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n";

    fn in_program(statement: &str) -> Vec<(u32, &'static str)> {
        codes(&format!("{X}{statement}\n"))
    }

    #[test]
    fn a_label_without_its_underscore() {
        let text = format!("{X}PROGRAM\nLoop:\nDWL 1\nGOTO Loop\nENDP\n");
        let found = lint(&[("test.8K", &text)]).concat();
        assert_eq!(found[0].message, "`Loop` is no command, and a label begins with an underscore");
        let fixed = acrc_diagnostics::apply(&text, &[&found[0].fixes[0]]).expect("a fix of one edit");
        assert_eq!(codes(&fixed), []);
    }

    #[test]
    fn axis_names_have_no_case_and_numbers_need_no_name() {
        assert_eq!(in_program("x10 : JOG VEL X5 : RES AXIS1 : AXIS1 JOG INC 5"), []);
        assert_eq!(in_program("JOG VEL X5 Y5"), [(4, "ACR204")]);
    }

    #[test]
    fn names_belong_to_their_program() {
        assert_eq!(codes(&format!("{X}PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS1 \"Y\"\nX10\n")), [(7, "ACR204")]);
    }

    #[test]
    fn a_program_without_attachments_is_told_so_once() {
        let attached = "PROG2\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n";
        let text = format!("PROG0\nX10\nY20\nPROG1\nDRIVE ON Z\n{attached}");
        let found = lint(&[("test.8K", &text)]).concat();
        let messages: Vec<_> = found.iter().filter(|d| d.code.id == "ACR204").map(|d| &*d.message).collect();
        assert_eq!(
            messages,
            [
                "program 0 moves `X`, but no ATTACH SLAVE names an axis for it",
                "program 1 uses the axis `Z`, but no ATTACH SLAVE names an axis for it"
            ]
        );
    }

    #[test]
    fn a_project_without_attachments_is_advised_once() {
        let (first, second) = ("PROG0\nDETACH\nDWL 1\nDRIVE ON Z\nX10\nPROG2\nX0\n", "PROG1\nY10\n");
        assert_eq!(
            lines_of("ACR204", &[("a.8K", "PROG0\nDWL 1\n"), ("b.8K", first), ("c.8K", second)]),
            [vec![], vec![4], vec![]]
        );
        assert_eq!(codes(first), []);
        assert_eq!(codes("PROG0\nX10\nSYS\nY5\n"), [(4, "ACR204")], "SYS has no axes");
        assert_eq!(codes("ATTACH AXIS0 ENC0 DAC0 ENC0\nPROG0\nX10\n"), [(3, "ACR204")], "a setup that is incomplete");
    }

    #[test]
    fn a_setting_that_reads_as_a_report_and_a_move_is_told_of_once() {
        assert_eq!(in_program("VEL Z5"), [(4, "ACR208")]);
        assert_eq!(in_program("VEL : Z5"), [(4, "ACR204")]);
    }

    #[test]
    fn a_piece_of_code_may_name_any_axis() {
        assert_eq!(codes("X10 Y20\nJOG VEL ARM5\n"), []);
    }

    #[test]
    fn a_misspelt_command_is_told_apart() {
        let messages =
            |text: &str| lint(&[("test.8K", text)]).concat().iter().map(|d| d.message.clone()).collect::<Vec<_>>();
        let unknown = "unknown command or axis `VLE`: did you mean `VEL`?";
        assert_eq!(messages(&format!("{X}VLE 5\n")), [unknown]);
        assert_eq!(messages("VLE 5\n"), [unknown]);
        let unknown = "unknown command or axis `MOVE`: did you mean `MOV`?";
        assert_eq!(messages(&format!("{X}MOVE X5\n")), [unknown]);
        assert_eq!(messages("MOVE X5\n"), [unknown]);
        assert_eq!(messages("STRT\n"), ["`STRT` is no command, and no axis with a target either"]);
    }

    #[test]
    fn the_setup_of_a_project_names_the_axes_of_its_programs() {
        let files = [("Setup.8K", X), ("Prog0.8K", "PROGRAM\nX10\nY10\nENDP\n")];
        let found = lint(&files);
        assert_eq!(codes_in(files[0].1, &found[0]), []);
        assert_eq!(codes_in(files[1].1, &found[1]), [(3, "ACR204")]);
    }
}
