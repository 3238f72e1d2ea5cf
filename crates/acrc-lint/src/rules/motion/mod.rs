//! Attachments of masters and slaves, settings without which motion goes wrong, limits, waits for the end of motion
//! (guide, "System Configuration" and "Making Motion").
//!
//! Rules that say "nothing in the project does it" speak only in projects that show how their controller is set up, and
//! at one place: the first motion of the axis, or of the program, in the first file that has some.

pub(crate) mod abrupt_stop;
pub(crate) mod axis_commanded_by_two_programs;
pub(crate) mod cam_without_table;
pub(crate) mod coordinated_wait_for_jog;
pub(crate) mod drive_never_enabled;
pub(crate) mod error_without_response;
pub(crate) mod gear_without_source;
pub(crate) mod homing_velocity_never_set;
pub(crate) mod homing_without_limits;
pub(crate) mod jog_stopped_at_once;
pub(crate) mod jog_velocity_never_set;
pub(crate) mod kill_never_cleared;
pub(crate) mod limit_inputs_cross_block;
pub(crate) mod master_in_two_programs;
pub(crate) mod motion_without_attachments;
pub(crate) mod program_never_started;
pub(crate) mod pulses_per_unit_never_set;
pub(crate) mod ramp_never_set;
pub(crate) mod reversed_limits;
pub(crate) mod runs_empty_program;
pub(crate) mod second_master;
pub(crate) mod setting_given_twice;
pub(crate) mod slash_outside_linear_move;
pub(crate) mod slave_before_master;
pub(crate) mod software_limits_not_set;
mod straight;
pub(crate) mod velocity_never_set;
pub(crate) mod wait_for_other_axis;
pub(crate) mod wait_for_other_master;

use acrc_analysis::{Contradiction, Deed};
use acrc_catalog::ObjectKind;
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, Command, Expr};
use acrc_syntax::units::Level;

use crate::Context;
use crate::motions::Motion;

/// The first motion of each axis by one of `deeds`, where this file is the one to report it.
fn first_motions(context: &Context<'_>, deeds: &[Deed]) -> Vec<Motion> {
    let machine = context.machine();
    if !machine.complete {
        return Vec::new();
    }
    let place = Some(context.environment().place);
    let mut first: Vec<Motion> = Vec::new();
    for motion in context.motions().iter().filter(|motion| deeds.contains(&motion.deed)) {
        let seen = first.iter().any(|other| other.axis == motion.axis);
        if !seen && machine.first_file_with(deeds, motion.axis) == place {
            first.push(*motion);
        }
    }
    first
}

/// The same, but for axes that no program attaches: that is one finding, and what they lack besides is not worth another.
fn first_motions_of_attached(context: &Context<'_>, deeds: &[Deed]) -> Vec<Motion> {
    let machine = context.machine();
    let mut motions = first_motions(context, deeds);
    motions.retain(|motion| machine.open || machine.has_axis(motion.axis));
    motions
}

/// The first coordinated move of each program, where this file is the one to report it.
fn first_moves(context: &Context<'_>) -> Vec<Motion> {
    let machine = context.machine();
    if !machine.complete {
        return Vec::new();
    }
    let place = Some(context.environment().place);
    let mut first: Vec<Motion> = Vec::new();
    for motion in context.motions().iter().filter(|motion| motion.deed == Deed::Move) {
        let seen = first.iter().any(|other| other.level == motion.level);
        if !seen && matches!(motion.level, Level::Program(_)) && machine.first_file_moving(motion.level) == place {
            first.push(*motion);
        }
    }
    first
}

/// An axis as a message names it: "`X` (AXIS0)".
fn axis_name(context: &Context<'_>, motion: &Motion) -> String {
    let Motion { axis, span, named, .. } = *motion;
    if named { format!("`{}` (AXIS{axis})", context.slice(span)) } else { format!("AXIS{axis}") }
}

/// What an axis does in a motion.
fn verb(motion: &Motion) -> &'static str {
    match motion.deed {
        Deed::Jog => "is jogged",
        Deed::Home => "is homed",
        Deed::Gear => "is geared",
        Deed::Cam => "follows a cam",
        _ => "is moved",
    }
}

/// The contradictions of this file's attachments, with the places of the attachments and the levels concerned.
fn contradictions(context: &Context<'_>) -> Vec<(Contradiction, Span, Level)> {
    let conflicts = context.environment().conflicts.iter();
    let site = |attachment: u32| context.index().attachments.get(attachment as usize).map(|site| site.statement);
    conflicts.filter_map(|conflict| Some((conflict.what, site(conflict.attachment)?, conflict.level))).collect()
}

/// The values that a command gives to its axes: `X5 Y(1,2)`, and `AXIS0` in front.
fn axis_values(command: &Command) -> impl Iterator<Item = &[Expr]> {
    let prefixed = command.prefix.as_ref().is_some_and(|prefix| prefix.kind == ObjectKind::Axis);
    command.arguments.iter().filter_map(move |argument| match argument {
        Argument::Axis(axis) => values(axis.value.as_deref()?),
        Argument::Object(object) if object.kind == ObjectKind::Axis => values(object.value.as_deref()?),
        _ if prefixed => values(argument),
        _ => None,
    })
}

fn values(argument: &Argument) -> Option<&[Expr]> {
    match argument {
        Argument::Value(expr) => Some(std::slice::from_ref(expr)),
        Argument::Tuple(tuple) => Some(&tuple.values),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{lines_of, spans_of};

    /// A setup of two axes without any of the settings that rules ask for.
    const SETUP: &str =
        "ATTACH AXIS0 ENC0 DAC0 ENC0\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\n";

    /// The rules that say what a project does nowhere, with a program that they complain about.
    const NOWHERE: [(&str, &str); 9] = [
        ("ACR504", "JOG FWD AXIS5"),
        ("ACR506", "X10"),
        ("ACR507", "JOG FWD X"),
        ("ACR508", "X10"),
        ("ACR509", "JOG HOME X1"),
        ("ACR513", "SLIM X3 : X10"),
        ("ACR518", "SET 16152 : JOG HOME X1"),
        ("ACR520", "GEAR ON X"),
        ("ACR521", "X10"),
    ];

    fn project(program: &str) -> [(&'static str, String); 2] {
        [("Setup.8K", SETUP.to_owned()), ("Prog0.8K", format!("PROGRAM\n{program}\nENDP\n"))]
    }

    fn lines(code: &str, files: &[(&str, String)]) -> Vec<Vec<u32>> {
        let files: Vec<_> = files.iter().map(|(name, text)| (*name, text.as_str())).collect();
        lines_of(code, &files)
    }

    #[test]
    fn what_is_done_nowhere_is_found() {
        for (code, program) in NOWHERE {
            assert_eq!(lines(code, &project(program)), [vec![], vec![2]], "{code}");
        }
    }

    #[test]
    fn a_mistake_is_one_finding() {
        for (code, program) in NOWHERE {
            let twice = format!("{program}\n{program}");
            let [setup, first] = project(&twice);
            let second = ("more.8K", format!("PROG0\nPROGRAM\n{program}\nENDP\n"));
            assert_eq!(lines(code, &[setup, first, second]), [vec![], vec![2], vec![]], "{code}");
        }
    }

    #[test]
    fn what_does_not_show_its_setup_is_not_judged() {
        for (code, program) in NOWHERE {
            let stored = format!("PROGRAM\n{program}\nENDP\n");
            assert_eq!(spans_of(code, &stored), [""; 0], "{code}: a piece of code");
            let attached = format!("PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n{stored}");
            assert_eq!(spans_of(code, &attached), [""; 0], "{code}: attachments only");
        }
    }

    #[test]
    fn what_is_typed_at_a_prompt_is_not_judged() {
        for (code, program) in NOWHERE {
            let typed = format!("{SETUP}{program}\n");
            assert_eq!(spans_of(code, &typed), [""; 0], "{code}");
        }
    }
}
