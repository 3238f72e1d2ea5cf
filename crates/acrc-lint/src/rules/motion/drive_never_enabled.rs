//! `ACR505`: motion of an axis whose drive nothing enables.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Diagnostic, Severity};

use super::{axis_name, first_motions_of_attached, verb};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR505", name: "drive-never-enabled" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program moves an axis, and nothing in the project enables its drive: neither DRIVE ON nor its enable \
               flag (8465 + 32 * axis). Where the project enables no drive at all it is advice, as a host or an operator may \
               do it, or the drives may be wired to be always on: for each axis whose drive hands its signals to the \
               controller (a warning again where PBOOT starts the program, and nobody is asked), otherwise once a project, at its first motion of an axis with an ATTACH AXIS. Axes with \
               step outputs are left out.",
        why: "The profile runs while the motor has no power: the following error grows until the axis is killed, and \
              the program waits for a motion that never happens.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\nVEL 5\n\
              PROGRAM\nDRIVE ON X\nX10 Y10\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\nVEL 5\n\
               PROGRAM\nDRIVE ON X Y\nX10 Y10\nENDP",
        guide: "Application Examples / Enable Drive",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let machine = context.machine();
    let others = !machine.axes_with(Deed::DriveOn).is_empty();
    if !others && machine.axes_with(Deed::DriveSignals).is_empty() {
        check_whole_project(context);
        return;
    }
    for motion in first_motions_of_attached(context, &Deed::MOTION) {
        let judged = others || machine.axes_with(Deed::DriveSignals).has(motion.axis);
        if judged && machine.never(Deed::DriveOn, motion.axis) && !machine.steppers.may_have(motion.axis) {
            let (axis, verb) = (axis_name(context, &motion), verb(&motion));
            let message = format!("{axis} {verb}, but nothing in the project enables its drive");
            let help = format!("enable it before it moves: DRIVE ON {}", context.slice(motion.span));
            // What starts by itself at power-up waits for nobody who could enable the drive.
            let is_certain = others || machine.does_at(Deed::Boot, motion.level);
            let severity = if is_certain { Severity::Warning } else { Severity::Advice };
            context.report(Diagnostic { severity, ..RULE.at(motion.span, message).with_help(help) });
        }
    }
}

/// Once a project that enables nothing, at its first motion.
fn check_whole_project(context: &mut Context<'_>) {
    let machine = context.machine();
    let has_servo = |axis: u32| machine.servos.has(axis) && !machine.steppers.may_have(axis);
    let first = machine.moved().filter(|(axis, _)| has_servo(*axis)).map(|(_, file)| file).min();
    if first != Some(context.environment().place) {
        return;
    }
    let motion = context.motions().iter().find(|motion| has_servo(motion.axis)).copied();
    if let Some(motion) = motion.filter(|_| machine.complete) {
        let (axis, verb) = (axis_name(context, &motion), verb(&motion));
        let message = format!("{axis} {verb}, but nothing in the project enables a drive");
        let help = format!(
            "unless a host enables the drives, or their wiring does, enable each before it moves: DRIVE ON {}",
            context.slice(motion.span)
        );
        context.report(Diagnostic { severity: Severity::Advice, ..RULE.at(motion.span, message).with_help(help) });
    }
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{lines_of, lint, spans_of};

    const SETUP: &str = "#DEFINE EnableY BIT8497\nATTACH AXIS0 ENC0 DAC0 ENC0\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 \
                         AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\n";

    fn found(setup: &str, program: &str) -> Vec<String> {
        let text = format!("{SETUP}SYS\n{setup}\nPROG0\nPROGRAM\n{program}\nENDP\n");
        spans_of("ACR505", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn one_of_two_drives_is_forgotten() {
        assert_eq!(found("", "DRIVE ON X\nX10 Y10\nY20"), ["Y"]);
        assert_eq!(found("", "SET 8465\nJOG FWD Y"), ["Y"]);
    }

    #[test]
    fn every_way_of_enabling() {
        for enable in [
            "DRIVE ON X Y",
            "DRIVE ON AXIS1",
            "AXIS1 DRIVE ON",
            "SET 8497",
            "SET BIT8497",
            "SET EnableY",
            "BIT8497 = 1",
            "SET (8465 + 32 * P0)",
            "SET 1985",
            "P4361 = 131072",
        ] {
            assert_eq!(found("", &format!("{enable}\nY10")), [""; 0], "{enable}");
        }
        assert_eq!(found("", "SET (100 + P0) : DRIVE ON X\nY10"), ["Y"], "a user flag");
    }

    #[test]
    fn a_project_that_enables_no_drive_leaves_it_to_others() {
        let text = format!("{SETUP}SYS\nSET BIT8468\nPROG0\nPROGRAM\nX10 Y10\nENDP\n");
        let found = lint(&[("test.8K", &text)]).concat();
        let own: Vec<_> = found.iter().filter(|found| found.code.id == "ACR505").collect();
        assert_eq!(own.iter().map(|found| found.severity).collect::<Vec<_>>(), [Severity::Advice]);
        let found = lint(&[("test.8K", &text.replace("PROGRAM\n", "PROGRAM\nPBOOT\n"))]).concat();
        let own = found.iter().find(|found| found.code.id == "ACR505");
        assert_eq!(own.map(|found| found.severity), Some(Severity::Warning));
    }

    #[test]
    fn a_project_that_enables_nothing_is_advised_once() {
        let setup = |axes: &str| format!("{axes}{SETUP}");
        let program = "PROGRAM\nJOG FWD Y\nX10 Y10\nENDP\n";
        let second = "PROG0\nPROGRAM\nX10\nENDP\n";
        let lines =
            |axes: &str| lines_of("ACR505", &[("Setup.8K", &setup(axes)), ("Prog0.8K", program), ("b.8K", second)]);
        assert_eq!(lines(""), [vec![], vec![3], vec![]], "the first axis that has a servo output");
        assert_eq!(lines("ATTACH AXIS1 ENC1 DAC1 ENC1\n"), [vec![], vec![2], vec![]]);
        assert_eq!(lines("SET 8465\nSET 8497\n"), [[0; 0]; 3]);
        let text = format!("{SETUP}{program}");
        let found = lint(&[("test.8K", &text)]).concat();
        let own: Vec<_> = found.iter().filter(|found| found.code.id == "ACR505").collect();
        assert_eq!(own.iter().map(|found| found.severity).collect::<Vec<_>>(), [Severity::Advice]);
        let steps = text.replace("DAC0", "STEPPER0");
        assert_eq!(spans_of("ACR505", &steps), [""; 0]);
    }

    #[test]
    fn steps_need_no_enable() {
        assert_eq!(found("ATTACH AXIS1 STEPPER1 STEPPER1", "DRIVE ON X\nX10 Y10"), [""; 0]);
    }
}
