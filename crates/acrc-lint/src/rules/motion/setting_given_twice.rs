//! `ACR528`: a setting of an axis that replaces another one before anything used it.

use acrc_analysis::deed::acts;
use acrc_analysis::{SectionIndex, walk};
use acrc_catalog::{CommandId, ObjectKind, command};
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Argument, Command, Statement, StatementKind};
use acrc_syntax::units::{Level, SectionKind};

use super::{straight, values};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR528", name: "setting-given-twice" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "At a prompt, a setting of an axis (PPU, HLBIT, HLDEC, SLM, SLDEC, EXC, IPB, TLM, JOG VEL, JOG ACC, JOG \
               DEC, JOG HOMVF) is given a second time with another constant, only other settings stand between, and \
               the second one stands behind a setting or an attachment of another axis that never gets it.",
        why: "Setups are made by copying the block of one axis. A number that was not changed gives the setting to \
              the first axis again: that one works with a wrong value, and the other one with none.",
        bad: "ATTACH AXIS0 ENC0 DAC0 ENC0\nAXIS0 PPU 1000\nAXIS0 HLBIT 0\nATTACH AXIS1 ENC1 DAC1 ENC1\nAXIS1 PPU 1000\n\
              AXIS0 HLBIT 3",
        good: "ATTACH AXIS0 ENC0 DAC0 ENC0\nAXIS0 PPU 1000\nAXIS0 HLBIT 0\nATTACH AXIS1 ENC1 DAC1 ENC1\nAXIS1 PPU \
               1000\nAXIS1 HLBIT 3",
        guide: "System Configuration / Attachments",
    },
    checks: &[Check::File(check)],
};

/// Settings that an axis has once.
const SETTINGS: [CommandId; 12] = [
    command::PPU,
    command::HLBIT,
    command::HLDEC,
    command::SLM,
    command::SLDEC,
    command::EXC,
    command::IPB,
    command::TLM,
    command::JOG_VEL,
    command::JOG_ACC,
    command::JOG_DEC,
    command::JOG_HOMVF,
];

/// Groups of the catalogue whose commands set something up; those that move are told apart by what they do.
const SETUP: [&str; 6] =
    ["Axis Limits", "Servo Control", "Feedback Control", "Setpoint Control", "Velocity Profile", "Global Objects"];

/// A setting that an axis got.
struct Setting {
    id: CommandId,
    axis: u32,
    /// What was given; `None` when it is not constant.
    values: Option<Vec<f64>>,
    span: Span,
    /// The axis that the command before it is about.
    among: Option<u32>,
}

fn check(context: &mut Context<'_>) {
    let index = context.index();
    let given = given(context, index.sections.iter());
    for (at, setting) in given.all.iter().enumerate() {
        let stretch = given.stretches.iter().rfind(|start| **start <= at).copied().unwrap_or(0);
        let mut before = given.all.get(stretch..at).unwrap_or_default().iter();
        let earlier = before.rfind(|other| (other.id, other.axis) == (setting.id, setting.axis));
        let Some(earlier) = earlier else { continue };
        let differ = earlier.values.is_some() && setting.values.is_some() && earlier.values != setting.values;
        if let Some(other) = forgotten(setting, &given.all).filter(|_| differ) {
            let (name, axis) = (setting.id.info().name, setting.axis);
            let message = format!("{name} of AXIS{axis} is given a second time, and AXIS{other} gets none");
            let diagnostic = RULE.at(setting.span, message).with_related(earlier.span, "the first one is given here");
            context.report(diagnostic.with_help(format!("this one is probably meant for AXIS{other}")));
        }
    }
}

/// The other axis among whose settings one stands, when it does not get it anywhere in the file.
fn forgotten(setting: &Setting, all: &[Setting]) -> Option<u32> {
    let other = setting.among.filter(|other| *other != setting.axis)?;
    (!all.iter().any(|given| (given.id, given.axis) == (setting.id, other))).then_some(other)
}

/// The settings that a file gives at prompts.
struct Given {
    all: Vec<Setting>,
    /// Where stretches of nothing but settings begin in `all`.
    stretches: Vec<usize>,
}

fn given<'a>(context: &Context<'_>, sections: impl Iterator<Item = &'a SectionIndex>) -> Given {
    let mut given = Given { all: Vec::new(), stretches: Vec::new() };
    let mut among = None;
    for section in sections.filter(|section| section.section.kind == SectionKind::Immediate) {
        let level = section.section.level;
        let range = section.section.statements.start as usize..section.section.statements.end as usize;
        for statement in context.tree().statements().get(range).unwrap_or_default() {
            if may_use(context, statement) {
                given.stretches.push(given.all.len());
            }
            let StatementKind::Command(command) = &statement.kind else { continue };
            if SETTINGS.contains(&command.id) {
                given.all.extend(settings(context, level, command, statement.span, among));
            }
            among = axis_of(command).or(among);
        }
    }
    given
}

/// Whether a statement may make use of what was set before it, or may not be executed.
fn may_use(context: &Context<'_>, statement: &Statement) -> bool {
    match &statement.kind {
        StatementKind::Remark(_) | StatementKind::Define(_) | StatementKind::Dim(_) => false,
        StatementKind::Command(command) if matches!(command.id, command::SET | command::CLR) => {
            walk::bits(statement).any(|bit| straight::flag(context, bit).is_none_or(|flag| starts(flag.field)))
        }
        StatementKind::Command(command) if command.id == command::ATTACH_AXIS => false,
        StatementKind::Command(command) => {
            !SETUP.contains(&command.id.info().group) || acts(command).any(|act| act.deed.is_motion())
        }
        _ => true,
    }
}

/// Whether a flag starts a program or a jog.
fn starts(field: &str) -> bool {
    ["run", "jog", "home"].iter().any(|start| field.starts_with(start))
}

/// What a command gives to which axes, as far as they are known.
fn settings(context: &Context<'_>, level: Level, command: &Command, span: Span, among: Option<u32>) -> Vec<Setting> {
    let new = |axis: Option<u32>, argument: Option<&Argument>| {
        let values = values(argument?)?.iter().map(walk::literal).collect();
        Some(Setting { id: command.id, axis: axis?, values, span, among })
    };
    if let Some(prefix) = &command.prefix {
        let axis = prefix.index.filter(|_| prefix.kind == ObjectKind::Axis);
        return new(axis, command.arguments.first()).into_iter().collect();
    }
    let part = |argument: &Argument| match argument {
        Argument::Axis(axis) => {
            let number = context.environment().axes_at(level)?.find(context.slice(axis.name))?.1;
            new(number, axis.value.as_deref())
        }
        Argument::Object(object) if object.kind == ObjectKind::Axis => new(object.index, object.value.as_deref()),
        _ => None,
    };
    command.arguments.iter().filter_map(part).collect()
}

/// The one axis that a command names by its number.
fn axis_of(command: &Command) -> Option<u32> {
    let arguments = command.arguments.iter().filter_map(|argument| match argument {
        Argument::Object(object) => Some(object),
        _ => None,
    });
    let mut axes =
        command.prefix.as_deref().into_iter().chain(arguments).filter(|object| object.kind == ObjectKind::Axis);
    let only = axes.next()?.index;
    only.filter(|_| axes.next().is_none())
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    const TWO: &str = "ATTACH AXIS0 ENC0 DAC0 ENC0\nAXIS0 PPU 1000\nAXIS0 HLBIT 0\nAXIS0 ON\nATTACH AXIS1 ENC1 DAC1 \
                       ENC1\nAXIS1 PPU 1000\n";

    fn found(rest: &str) -> Vec<String> {
        let text = format!("{TWO}{rest}\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n");
        spans_of("ACR528", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn the_block_of_an_axis_is_copied() {
        assert_eq!(found("AXIS0 HLBIT 3\nAXIS1 HLDEC 10"), ["AXIS0 HLBIT 3"]);
        assert_eq!(found("SET BIT16144\nHLBIT AXIS0 (0,1,5)"), ["HLBIT AXIS0 (0,1,5)"]);
    }

    #[test]
    fn the_other_axis_has_its_own() {
        assert_eq!(found("AXIS1 HLBIT 6\nAXIS0 HLBIT 3"), [""; 0]);
        assert_eq!(found("AXIS0 PPU 500\nAXIS0 HLBIT 3"), [""; 0], "a change of mind");
    }

    #[test]
    fn settings_that_agree_are_used_or_are_not_known() {
        for rest in [
            "AXIS0 HLBIT 0",
            "AXIS1 HLBIT 3",
            "AXIS0 HLBIT (P0)",
            "AXIS0 HLBIT",
            "AXIS0 PGAIN 0\nAXIS0 PGAIN 0.01",
            "AXIS0 JOG VEL 5\nAXIS0 JOG INC 5\nAXIS0 JOG VEL 1",
            "RUN PROG0\nAXIS0 HLBIT 3",
            "SET 1032\nAXIS0 HLBIT 3",
            "INH 5\nAXIS0 HLBIT 3",
            "IF (BIT 1) THEN AXIS0 HLBIT 3",
            "PROG0\nPROGRAM\nAXIS0 HLBIT 3\nENDP",
        ] {
            assert_eq!(found(rest), [""; 0], "{rest}");
        }
    }
}
