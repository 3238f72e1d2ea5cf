//! `ACR514`: a path that ends without a ramp.

use acrc_analysis::deed::acts;
use acrc_analysis::{Deed, SectionIndex, walk};
use acrc_catalog::command;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Argument, BitArgument, Command, ExprKind, Separator, Statement, StatementKind};
use acrc_syntax::units::{Level, SectionKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR514", name: "abrupt-stop" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "The last move before the program ends, or before it waits for the master to stand still, is made with \
               STP 0. Only stretches without labels, jumps and conditions from the STP 0 to the end of the motion are \
               judged; the moves of a loop count as if they stood there once.",
        why: "With a stop ramp of zero a move ends at full speed, for the next one to go on. When nothing follows, the \
              velocity drops to zero at once: the load takes a blow, and the axis may be killed by its following \
              error.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nACC 100 VEL 25\nSTP 0\nX10\nX20\nINH -516\n\
              ENDP",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nACC 100 VEL 25\nSTP 0\nX10\nSTP 100\nX20\n\
               INH -516\nENDP",
        guide: "Making Motion / What are Motion Profiles?",
    },
    checks: &[Check::Section(check)],
};

/// A stretch with STP 0 in force.
#[derive(Clone, Copy, Default)]
struct Stretch {
    /// The STP 0.
    stop: Option<Span>,
    /// The last move behind it.
    last: Option<Span>,
}

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    if section.section.kind != SectionKind::Stored {
        return;
    }
    let standstill = standstill_flag(context, section.section.level);
    let mut stretch = Stretch::default();
    let range = section.section.statements.start as usize..section.section.statements.end as usize;
    let mut behind_then = false;
    for statement in context.tree().statements().get(range).unwrap_or_default() {
        behind_then = statement.separator != Separator::Line && (behind_then || statement.separator == Separator::Then);
        let effect = if behind_then { Effect::Unclear } else { effect(statement, standstill) };
        match effect {
            Effect::NoRamp => stretch.stop = Some(statement.span),
            Effect::Move if stretch.stop.is_some() => stretch.last = Some(statement.span),
            Effect::Nothing | Effect::Move => {}
            Effect::End => {
                report(context, stretch);
                stretch.last = None;
            }
            Effect::Unclear => stretch = Stretch::default(),
        }
    }
    if section.section.closer.is_some() {
        report(context, stretch);
    }
}

fn report(context: &mut Context<'_>, stretch: Stretch) {
    if let Stretch { stop: Some(stop), last: Some(last) } = stretch {
        let message = "the last move of the path ends at full speed: no stop ramp is set";
        context.report(
            RULE.at(last, message)
                .with_related(stop, "the stop ramp is switched off here")
                .with_help("set STP again before the last move"),
        );
    }
}

/// What a statement means for the end of a path.
enum Effect {
    Nothing,
    /// `STP 0`
    NoRamp,
    Move,
    /// The motion is over behind it.
    End,
    /// What holds behind it depends on more than the statements before it.
    Unclear,
}

fn effect(statement: &Statement, standstill: Option<u64>) -> Effect {
    match &statement.kind {
        StatementKind::Command(command) => effect_of(command, standstill),
        // A loop only repeats what its body does: whatever ramp the first round finds, the others find too unless the
        // body changes it, and then that is read on the way.
        StatementKind::Remark(_)
        | StatementKind::Print(_)
        | StatementKind::Assign(_)
        | StatementKind::Dim(_)
        | StatementKind::Define(_)
        | StatementKind::For(_) => Effect::Nothing,
        StatementKind::Label(_) | StatementKind::If(_) | StatementKind::Input(_) | StatementKind::Error => {
            Effect::Unclear
        }
    }
}

fn effect_of(command: &Command, standstill: Option<u64>) -> Effect {
    match command.id {
        command::STP if command.prefix.is_none() => match command.arguments.as_slice() {
            [Argument::Value(value)] if walk::literal(value) == Some(0.0) => Effect::NoRamp,
            [] => Effect::Nothing,
            _ => Effect::Unclear,
        },
        command::INH if waits_for_standstill(command, standstill) => Effect::End,
        command::END => Effect::End,
        command::NEXT
        | command::WHILE
        | command::WEND
        | command::ACC
        | command::DEC
        | command::VEL
        | command::F
        | command::JRK
        | command::SET
        | command::CLR
        | command::DWL => Effect::Nothing,
        _ if acts(command).any(|act| act.deed == Deed::Move) => Effect::Move,
        _ => Effect::Unclear,
    }
}

/// `INH -516` for master 0.
fn waits_for_standstill(command: &Command, standstill: Option<u64>) -> bool {
    let [Argument::Bit(BitArgument { negative: true, index, .. })] = command.arguments.as_slice() else { return false };
    standstill.is_some_and(|flag| matches!(index.kind, ExprKind::Integer(number) if number == flag))
}

/// The flag that says whether the one master of a program is in motion.
fn standstill_flag(context: &Context<'_>, level: Level) -> Option<u64> {
    let mut masters = context.machine().masters.iter().filter(|(_, of)| *of == level);
    let (master, _) = masters.next()?;
    let only = masters.next().is_none() && !context.machine().open;
    acrc_catalog::bit_number("in_motion", *master).filter(|_| only).map(u64::from)
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(program: &str) -> Vec<String> {
        let text = format!("PROG0\nATTACH MASTER1\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\n{program}\nENDP\n");
        spans_of("ACR514", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn the_last_move_before_the_end_of_the_motion() {
        assert_eq!(found("STP 0\nX10\nX20"), ["X20"]);
        assert_eq!(found("STP0 VEL 5\nX10 : SET 32\nX/5\nINH -548\nDWL 1\nX0"), ["X/5", "X0"]);
        assert_eq!(found("STP 0\nMOV X10\nEND"), ["MOV X10"]);
    }

    #[test]
    fn the_last_move_of_a_loop() {
        assert_eq!(found("STP 0\nFOR LV0 = 0 TO 9 STEP 1\nX(LV0)\nNEXT\nINH -548\nSTP 50"), ["X(LV0)"]);
        assert_eq!(found("STP 0\nX5\nWHILE (BIT 7)\nX/1\nX/2\nWEND"), ["X/2"]);
    }

    #[test]
    fn a_ramp_before_the_last_move() {
        assert_eq!(found("STP 0\nX10\nSTP 50\nX20"), [""; 0]);
        assert_eq!(found("STP 0\nX10\nSTP (P0)\nX20"), [""; 0]);
        assert_eq!(found("STP 50\nX10"), [""; 0]);
    }

    #[test]
    fn what_depends_on_more_is_not_judged() {
        for program in [
            "STP 0\n_A\nX10\nGOTO A",
            "STP 0\nX10\nGOSUB A\nEND\n_A\nRETURN",
            "STP 0\nFOR LV0 = 1 TO 3\nX/1\nSTP 50\nNEXT\nX0",
            "STP 0\nFOR LV0 = 1 TO 3\nX/1\nIF (BIT 1) THEN BREAK\nNEXT",
            "FOR LV0 = 1 TO 3\nX/1\nSTP 0\nNEXT",
            "IF (BIT 1) THEN STP 0\nX10",
            "STP 0\nX10\nINH -516\nSTP 50\nX0",
            "STP 0\nX10\nIF (BIT 1)\nX20\nENDIF",
        ] {
            assert_eq!(found(program), [""; 0], "{program}");
        }
    }
}
