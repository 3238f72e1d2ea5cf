//! `ACR605`: a variable of a program that is set and never read.

use acrc_analysis::SectionIndex;
use acrc_catalog::OperandClass;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Statement, StatementKind};
use acrc_syntax::units::Level;

use crate::locals::{How, Locals, Mention};
use crate::operands::{Reference, Variable};
use crate::rule::{Check, Group, Mark, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR605", name: "unused-variable" },
        group: Group::Style,
        severity: Severity::Advice,
        enabled: true,
        mark: Some(Mark::Unnecessary),
        what: "A program sets a variable of its own (LV, SV, DV, $V or an array) and never reads it. Parameters and bits, \
               which others may read, are left alone, and so are classes of which one is chosen by a computed number.",
        why: "Often the number is a slip, and the variable that was meant keeps its old value.",
        bad: "PROG0\nDIM LV(2)\nPROGRAM\nLV0 = 5\nPRINT LV1\nENDP",
        good: "PROG0\nDIM LV(2)\nPROGRAM\nLV1 = 5\nPRINT LV1\nENDP",
        guide: "System Configuration / Memory Allocations",
    },
    checks: &[Check::File(check)],
};

/// What the sections of a file do with the variables of each program.
#[derive(Default)]
struct Uses {
    /// The first assignment in each whole program, by place.
    set: Vec<(Level, Mention)>,
    /// What is read, at a prompt too; sorted before it is searched.
    read: Vec<(Level, Variable)>,
    /// Classes of which one variable is chosen by a computed number.
    computed: Vec<(Level, OperandClass)>,
}

fn check(context: &mut Context<'_>) {
    if !context.index().sections.iter().any(|section| sets_locals(context, section)) {
        return;
    }
    let mut uses = Uses::default();
    for section in &context.index().sections {
        uses.add(context, section);
    }
    uses.read.sort_unstable();
    for (level, mention) in &uses.set {
        let is_read = uses.read.binary_search(&(*level, mention.variable)).is_ok();
        if is_read || uses.computed.contains(&(*level, mention.variable.class)) {
            continue;
        }
        let (name, program) = (context.slice(mention.span), level_name(*level));
        let diagnostic = RULE.at(mention.span, format!("{program} sets {name} and never reads it"));
        context.report(diagnostic.with_help("delete the assignment, or correct the number where it should be read"));
    }
}

/// Whether a whole program sets a variable of its own: most do not, and need no closer look.
fn sets_locals(context: &Context<'_>, section: &SectionIndex) -> bool {
    let range = section.section.statements.start as usize..section.section.statements.end as usize;
    let statements = context.tree().statements().get(range).unwrap_or_default();
    let sets_local = |statement: &Statement| match &statement.kind {
        StatementKind::Assign(assign) => Reference::of(context, &assign.target).is_some_and(|to| to.class().is_local()),
        _ => false,
    };
    context.is_whole_program(section) && statements.iter().any(sets_local)
}

impl Uses {
    fn add(&mut self, context: &Context<'_>, section: &SectionIndex) {
        let level = section.section.level;
        let is_whole = context.is_whole_program(section);
        let locals = Locals::new(context, section);
        for mentions in locals.by_variable() {
            if let Some(mention) = mentions.iter().find(|mention| mention.how != How::Write) {
                self.read.push((level, mention.variable));
            } else if let Some(mention) = mentions.first().filter(|_| is_whole) {
                self.set.push((level, *mention));
            }
        }
        for class in locals.computed() {
            if !self.computed.contains(&(level, *class)) {
                self.computed.push((level, *class));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(body: &str) -> Vec<String> {
        let text = format!("#DEFINE Count LV0\nPROG0\nPROGRAM\n{body}\nENDP\n");
        spans_of("ACR605", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn the_first_assignment_is_marked() {
        assert_eq!(found("LV0 = 1\nLV0 = 2\nSV1 = LV1"), ["LV0", "SV1"]);
        assert_eq!(found("Count = 1"), ["Count"]);
        assert_eq!(found("LA0(LV1) = 1\nLA1(0) = 1\nX(LA1(1))"), ["LA0(LV1)"]);
    }

    #[test]
    fn any_use_is_one() {
        assert_eq!(found("LV0 = 1\nX(Count)"), [""; 0]);
        assert_eq!(found("FOR LV0 = 1 TO 3\nDWL 1\nNEXT"), [""; 0]);
        assert_eq!(found("INPUT \"go on\"; $V0"), [""; 0]);
        assert_eq!(found("LV0 = 1\nLV1 = 2\nX(LV(P0))"), [""; 0]);
        assert_eq!(found("P0 = 1\nBIT 32 = 1"), [""; 0]);
    }

    #[test]
    fn the_prompt_of_the_program_reads_too() {
        let program = "PROG0\nPROGRAM\nLV0 = 1\nENDP\n";
        assert_eq!(spans_of("ACR605", &format!("{program}PRINT LV0\n")), [""; 0]);
        assert_eq!(spans_of("ACR605", &format!("{program}PROG1\nPRINT LV0\n")), ["LV0"]);
        assert_eq!(spans_of("ACR605", "LV0 = 1\n"), [""; 0], "a piece of a program");
    }
}
