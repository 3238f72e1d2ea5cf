//! `ACR515`: an axis that two programs set in motion.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::units::Level;

use super::axis_name;
use crate::motions::Motion;
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR515", name: "axis-commanded-by-two-programs" },
        group: Group::Motion,
        severity: Severity::Advice,
        enabled: true,
        mark: None,
        what: "The stored text of two programs sets one axis in motion: by a move, a jog, a homing, a gear or a cam. It \
               is told once an axis, at the first such statement of the later program. A program that homes the axis \
               and ends before the main program begins is common practice, hence advice only. A program is left out \
               when something in the project looks whether it runs (flags 1024 and 1032 + 32 * program).",
        why: "Programs run side by side. A jog of one program replaces the target of the other one, or adds to its \
              move: the axis goes where neither wants it, and both wait for the same flag.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG ABS X10\n\
              ENDP\nPROG1\nPROGRAM\nIF (BIT 3) THEN AXIS0 JOG FWD\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG ABS X10\n\
               ENDP\nPROG1\nPROGRAM\nINH -1024\nIF (BIT 3) THEN AXIS0 JOG FWD\nENDP",
        guide: "Making Motion / Jog Profiler",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    if !context.machine().complete {
        return;
    }
    let mut first: Vec<Motion> = Vec::new();
    for motion in context.motions() {
        if !first.iter().any(|other| (other.axis, other.level) == (motion.axis, motion.level)) {
            first.push(*motion);
        }
    }
    for motion in first {
        if let Some((level, file)) = other_program(context, &motion) {
            let (axis, other) = (axis_name(context, &motion), level_name(level));
            let there = context.questions().file_name(file);
            let place = if file == context.environment().place { String::new() } else { format!(" ({there})") };
            let message = format!("{axis} is commanded by {} and by {other}{place}", level_name(motion.level));
            context.report(RULE.at(motion.span, message).with_help(
                "let one program command the axis; where the programs take turns, let each look whether the other runs",
            ));
        }
    }
}

/// The first program that moves the axis of a motion, when the program of the motion is the second one that does.
fn other_program(context: &Context<'_>, motion: &Motion) -> Option<(Level, u32)> {
    let machine = context.machine();
    let mut programs = machine.programs_moving(motion.axis);
    programs.retain(|(level, _)| machine.never_at(Deed::Watch, *level));
    match programs.as_slice() {
        [first, (second, file), ..] if *second == motion.level && *file == context.environment().place => Some(*first),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{found_by, lines_of, spans_of};

    const SETUP: &str = "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \
                         \"Y\"\nPROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"Z\"\n";

    fn text(first: &str, second: &str) -> String {
        format!("{SETUP}PROG0\nPROGRAM\n{first}\nENDP\nPROG1\nPROGRAM\n{second}\nENDP\n")
    }

    fn found(first: &str, second: &str) -> Vec<String> {
        spans_of("ACR515", &text(first, second)).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn each_kind_of_motion() {
        for command in ["AXIS0 JOG FWD", "JOG HOME AXIS0", "AXIS0 GEAR ON", "AXIS0 CAM ON"] {
            assert_eq!(found("X10 Y10", &format!("Z5\n{command}")), ["AXIS0"], "{command}");
            assert_eq!(found(command, "JOG INC Z5"), [""; 0], "{command}");
        }
        assert_eq!(found("JOG INC X5", "AXIS0 JOG OFF : AXIS0 JOG VEL 5 : AXIS0 RES"), [""; 0]);
    }

    #[test]
    fn one_finding_an_axis_in_the_later_program() {
        assert_eq!(found("X10 : JOG INC Y5", "AXIS1 JOG FWD\nAXIS1 JOG REV\nAXIS0 JOG FWD"), ["AXIS1", "AXIS0"]);
        let files = [
            ("Setup.8K", SETUP),
            ("Prog0.8K", "PROGRAM\nX10\nENDP\n"),
            ("Prog1.8K", "PROGRAM\nZ1\nAXIS0 JOG FWD\nENDP\n"),
            ("Prog2.8K", "PROGRAM\nAXIS0 JOG REV\nENDP\n"),
        ];
        assert_eq!(lines_of("ACR515", &files), [vec![], vec![], vec![3], vec![]]);
    }

    #[test]
    fn programs_that_take_turns() {
        assert_eq!(found("X10", "INH -1024\nAXIS0 JOG FWD"), [""; 0]);
        assert_eq!(found("RUN PROG1\nWHILE (BIT 1056)\nWEND\nX10", "AXIS0 JOG FWD"), [""; 0]);
        assert_eq!(found("IF (BIT 1064 = 0) THEN X10", "AXIS0 JOG FWD"), [""; 0]);
        assert_eq!(found("RUN PROG1\nX10", "INH -1088\nAXIS0 JOG FWD"), ["AXIS0"], "another program");
    }

    #[test]
    fn both_programs_are_named() {
        let text = text("X10", "AXIS0 JOG FWD");
        let messages: Vec<_> = found_by("ACR515", &text).into_iter().map(|found| found.message).collect();
        assert_eq!(messages, ["AXIS0 is commanded by program 1 and by program 0"]);
    }
}
