//! The one pass over a file: each rule says where it wants to be asked, and each place is visited once.

use std::sync::LazyLock;

use acrc_analysis::{FileContext, SectionIndex, walk};
use acrc_diagnostics::Diagnostic;
use acrc_syntax::ast::{Expr, Statement};

use crate::Context;
use crate::consequences::Consequences;
use crate::references::{self, Reference};
use crate::registry::RULES;
use crate::rule::{Check, On};
use crate::settings::Settings;

type CheckExpression = fn(&mut Context<'_>, &Expr);

/// The checks of all rules by the place at which they are asked.
#[derive(Default)]
struct Plan {
    file: Vec<fn(&mut Context<'_>)>,
    section: Vec<fn(&mut Context<'_>, &SectionIndex)>,
    statement: Vec<fn(&mut Context<'_>, &Statement)>,
    /// By [`On`].
    expression: [Vec<CheckExpression>; On::COUNT],
    reference: Vec<fn(&mut Context<'_>, &Reference)>,
}

static PLAN: LazyLock<Plan> = LazyLock::new(|| {
    let mut plan = Plan::default();
    for check in RULES.iter().flat_map(|rule| rule.checks) {
        match *check {
            Check::File(check) => plan.file.push(check),
            Check::Section(check) => plan.section.push(check),
            Check::Statement(check) => plan.statement.push(check),
            Check::Expression(on, check) => plan.expression[on as usize].push(check),
            Check::Reference(check) => plan.reference.push(check),
        }
    }
    plan
});

/// What all rules, and the parser, find in a file.
pub(crate) fn run(file: &FileContext<'_>) -> Vec<Diagnostic> {
    let plan = &*PLAN;
    let mut context = Context::new(file);
    for check in &plan.file {
        check(&mut context);
    }
    for section in &file.index.sections {
        context.enter(Some(section), section.section.statements.start);
        for check in &plan.section {
            check(&mut context, section);
        }
    }
    let mut references = Vec::new();
    let mut sections = file.index.sections.iter().peekable();
    for (at, statement) in (0..).zip(file.tree.statements()) {
        while sections.next_if(|section| section.section.statements.end <= at).is_some() {}
        let section = sections.peek().copied().filter(|section| section.section.statements.start <= at);
        context.enter(section, at);
        for check in &plan.statement {
            check(&mut context, statement);
        }
        walk::expressions(statement, &mut |expr| {
            let Some(on) = On::of(expr) else { return };
            for check in &plan.expression[on as usize] {
                check(&mut context, expr);
            }
        });
        references::collect(&context, statement, &mut references);
        for reference in &references {
            for check in &plan.reference {
                check(&mut context, reference);
            }
        }
    }
    let consequences = Consequences::new(file);
    let mut found = context.into_findings();
    found.retain(|finding| !consequences.hide(finding));
    found.extend_from_slice(file.tree.errors());
    let settings = Settings::new(file.lint);
    found.retain(|finding| settings.hear(finding));
    found
}
