//! The checks of the rules that are on, by the place at which they are asked. A rule that is off costs nothing.

use acrc_analysis::SectionIndex;
use acrc_syntax::ast::{Expr, Statement};

use crate::Context;
use crate::references::Reference;
use crate::registry::RULES;
use crate::rule::{Check, On};
use crate::selector::RuleSet;

type CheckExpression = fn(&mut Context<'_>, &Expr);

/// The checks by the place at which they are asked.
#[derive(Default)]
pub(crate) struct Plan {
    pub(crate) file: Vec<fn(&mut Context<'_>)>,
    pub(crate) section: Vec<fn(&mut Context<'_>, &SectionIndex)>,
    pub(crate) statement: Vec<fn(&mut Context<'_>, &Statement)>,
    /// By [`On`].
    pub(crate) expression: [Vec<CheckExpression>; On::COUNT],
    pub(crate) reference: Vec<fn(&mut Context<'_>, &Reference)>,
}

impl Plan {
    /// The checks of these rules, in the order of the registry.
    pub(crate) fn new(on: RuleSet) -> Self {
        let mut plan = Self::default();
        let rules = RULES.iter().enumerate().filter(|(place, _)| on.contains(*place));
        for check in rules.flat_map(|(_, rule)| rule.checks) {
            match *check {
                Check::File(check) => plan.file.push(check),
                Check::Section(check) => plan.section.push(check),
                Check::Statement(check) => plan.statement.push(check),
                Check::Expression(on, check) => plan.expression[on as usize].push(check),
                Check::Reference(check) => plan.reference.push(check),
            }
        }
        plan
    }
}
