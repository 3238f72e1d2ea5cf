//! The places whose values a dry run can show.

use acrc_analysis::index::AliasTarget;
use acrc_analysis::query::symbols;
use acrc_analysis::{Db, Project, SourceFile};
use acrc_catalog::OperandClass;
use acrc_diagnostics::Span;
use acrc_syntax::units::Level;

use crate::occurrence::in_span;
use crate::{Entity, level_of};

/// An operand whose value can be shown beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InlineValue {
    /// Where it stands.
    pub span: Span,
    /// Its class.
    pub class: OperandClass,
    /// Its number.
    pub number: u64,
    /// The program to which it belongs, when it is local.
    pub level: Option<Level>,
}

/// The operands in a part of a file that are written by number or as an alias, in the order of the text. Elements of
/// arrays are left out.
pub fn inline_values(db: &dyn Db, project: Project, file: SourceFile, part: Span) -> Vec<InlineValue> {
    let symbols = symbols(db, project);
    let value = |class: OperandClass, number: u64, span: Span, level: Option<Level>| {
        (!class.is_array()).then_some(InlineValue { span, class, number, level })
    };
    let found = in_span(db, project, file, part).into_iter();
    found
        .filter_map(|occurrence| match occurrence.entity {
            Entity::Operand { class, number: Some(number), level } => value(class, number, occurrence.span, level),
            Entity::Alias(name) => match symbols.alias(&name)?.operand.target {
                AliasTarget::Operand(class, Some(number)) => {
                    let level = class.is_local().then(|| level_of(db, file, occurrence.statement));
                    value(class, number, occurrence.span, level)
                }
                _ => None,
            },
            _ => None,
        })
        .collect()
}
