//! `ACR127`: a `WHILE` whose condition nothing in it changes.

use acrc_analysis::{SectionIndex, walk};
use acrc_catalog::{CommandId, command};
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Expr, ExprKind, StatementKind};
use acrc_syntax::blocks::BlockKind;

use crate::Context;
use crate::locals::Locals;
use crate::operands::{Variable, condition, is_repeatable};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR127", name: "loop-never-changes" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "The condition of a WHILE reads variables of the program only, and the loop neither changes one of them nor \
               has a BREAK, GOSUB or another way out.",
        why: "Variables of a program are its own: no other program and no input changes them. Once entered, the loop never \
              ends.",
        bad: "PROG0\nDIM LV(2)\nPROGRAM\nLV0 = 0\nWHILE (LV0 < 10)\nSET 32\nDWL 0.1\nCLR 32\nDWL 0.1\nLV1 = LV0 + 1\nWEND\nPRINT LV1\nENDP",
        good: "PROG0\nDIM LV(2)\nPROGRAM\nLV0 = 0\nWHILE (LV0 < 10)\nSET 32\nDWL 0.1\nCLR 32\nDWL 0.1\nLV0 = LV0 + 1\nWEND\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

/// What may leave a loop or change variables elsewhere.
const WAYS_OUT: [CommandId; 10] = [
    command::BREAK,
    command::GOTO,
    command::GOSUB,
    command::RETURN,
    command::END,
    command::HALT,
    command::NEW,
    command::RUN,
    command::REBOOT,
    command::CLEAR,
];

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let mut loops = Vec::new();
    for block in section.blocks.all().iter().filter(|block| block.kind == BlockKind::While) {
        let opener = context.tree().statements().get(block.opener as usize);
        let variables = opener
            .and_then(condition)
            .and_then(|condition| local_variables(context, condition).map(|variables| (condition, variables)));
        if let (Some((condition, variables)), Some(closer)) = (variables, block.closer) {
            loops.push((block.opener..closer, condition, variables));
        }
    }
    if loops.is_empty() {
        return;
    }
    let locals = Locals::new(context, section);
    let ways_out = ways_out(context, section);
    for (range, condition, variables) in loops {
        let next = ways_out.partition_point(|at| *at <= range.start);
        let is_left = ways_out.get(next).is_some_and(|at| range.contains(at));
        let changes = |variable: &Variable| {
            let writes = locals.writes(*variable);
            let next = writes.partition_point(|write| write.statement <= range.start);
            locals.is_computed(variable.class) || writes.get(next).is_some_and(|write| range.contains(&write.statement))
        };
        if !is_left && !variables.iter().any(changes) {
            report(context, condition);
        }
    }
}

fn report(context: &mut Context<'_>, condition: &Expr) {
    let span = condition.span;
    let message = "nothing in this loop changes what its condition reads: once entered, it never ends";
    let diagnostic = RULE.at(span, message);
    context.report(diagnostic.with_help("change a variable of the condition in the loop, or leave it with BREAK"));
}

fn ways_out(context: &Context<'_>, section: &SectionIndex) -> Vec<u32> {
    let statements = context.tree().statements();
    let leaves = |at: &u32| match statements.get(*at as usize).map(|statement| &statement.kind) {
        Some(StatementKind::Command(command)) => WAYS_OUT.contains(&command.id),
        Some(StatementKind::Error) => true,
        _ => false,
    };
    section.section.statements.clone().filter(leaves).collect()
}

/// The variables that a condition reads. `None` when it reads something else, or nothing.
fn local_variables(context: &Context<'_>, condition: &Expr) -> Option<Vec<Variable>> {
    let mut variables = Some(Vec::new());
    walk::each(condition, &mut |expr| {
        if let (ExprKind::Operand(_) | ExprKind::Alias, Some(list)) = (&expr.kind, &mut variables) {
            match Variable::of(context, expr).filter(|variable| variable.class.is_local()) {
                Some(variable) => list.push(variable),
                None => variables = None,
            }
        }
    });
    variables.filter(|variables| !variables.is_empty() && is_repeatable(condition))
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(body: &str) -> Vec<String> {
        let text = format!("#DEFINE Count LV0\nPROG0\nPROGRAM\n{body}\nENDP\n");
        spans_of("ACR127", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn a_condition_that_stays_as_it_is() {
        assert_eq!(found("WHILE (LV0 < 10)\nDWL 1\nWEND"), ["(LV0 < 10)"]);
        assert_eq!(found("WHILE (Count < LV1)\nX(LV0)\nLV2 = LV0\nWEND"), ["(Count < LV1)"]);
        assert_eq!(found("WHILE ($V0 = \"\")\nDWL 1\nWEND"), ["($V0 = \"\")"]);
        assert_eq!(found("LV0 = 1\nWHILE (LA0(LV0) < 10)\nX(LA0(1))\nWEND\nLV0 = 2"), ["(LA0(LV0) < 10)"]);
    }

    #[test]
    fn a_change_of_any_part_of_the_condition_is_enough() {
        assert_eq!(found("WHILE (LV0 < 10)\nCount = Count + 1\nWEND"), [""; 0]);
        assert_eq!(found("WHILE (LV0 < LV1)\nIF (BIT 1) THEN LV1 = 0\nWEND"), [""; 0]);
        assert_eq!(found("WHILE (LA0(0) < 10)\nLA0(LV1) = 1\nWEND"), [""; 0]);
        assert_eq!(found("WHILE (LV0 < 10)\nLV(P0) = 1\nWEND"), [""; 0]);
        assert_eq!(found("WHILE ($V0 = \"\")\nINPUT $V0\nWEND"), [""; 0]);
        assert_eq!(found("WHILE (LV0 < 10)\nFOR LV0 = 1 TO 20\nNEXT\nWEND"), [""; 0]);
    }

    #[test]
    fn what_others_change_or_a_way_out_ends_it() {
        assert_eq!(found("WHILE (P0 < LV0)\nWEND"), [""; 0]);
        assert_eq!(found("WHILE (LV0 < RND(10))\nWEND"), [""; 0]);
        assert_eq!(found("WHILE (LV0 < 10)\nIF (BIT 1) THEN BREAK\nWEND"), [""; 0]);
        assert_eq!(found("WHILE (LV0 < 10)\nGOSUB A\nWEND\nEND\n_A\nLV0 = LV0 + 1\nRETURN"), [""; 0]);
        assert_eq!(found("WHILE (1)\nDWL 1\nWEND"), [""; 0]);
    }
}
