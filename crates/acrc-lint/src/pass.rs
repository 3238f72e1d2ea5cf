//! The one pass over a file: each rule says where it wants to be asked, and each place is visited once.

use acrc_analysis::{FileContext, walk};
use acrc_diagnostics::Diagnostic;

use crate::Context;
use crate::consequences::Consequences;
use crate::references;
use crate::rule::On;
use crate::{settings, suppress};

/// What the rules that are on, and the parser, find in a file, but for what is suppressed there.
pub(crate) fn run(file: &FileContext<'_>) -> Vec<Diagnostic> {
    let Some(settings) = settings::of_file(file) else { return Vec::new() };
    let plan = &settings.plan;
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
        if plan.reference.is_empty() {
            continue;
        }
        references::collect(&context, statement, &mut references);
        for reference in &references {
            for check in &plan.reference {
                check(&mut context, reference);
            }
        }
    }
    let consequences = Consequences::new(file, &settings);
    let mut found = context.into_findings();
    found.retain(|finding| !consequences.hide(finding));
    let errors = file.tree.errors().iter().filter(|error| !consequences.hide_error(error, file.text));
    found.extend(errors.cloned());
    found.extend_from_slice(file.encoding);
    found.retain(|finding| settings.hear(finding));
    suppress::apply(file, &settings, &consequences, &mut found);
    for finding in &mut found {
        settings.set_severity(finding);
    }
    found
}
