//! `ACR408`: more system memory than the controller has.

use acrc_analysis::memory::{IssueKind, SystemBlock};
use acrc_catalog::Confidence;
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::Dim;

use super::sites;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR408", name: "system-memory-exceeded" },
        group: Group::Memory,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "The DIM statements of the setup want more memory than the controller has. It is a warning, and an error \
               when the project names a model whose memory is documented.",
        why: "The controller refuses the DIM, and what it was for has no memory at all.",
        bad: "SYS\nCLEAR\nDIM PROG0(1000000)\nDIM PROG1(100000)",
        good: "SYS\nCLEAR\nDIM PROG0(800000)\nDIM PROG1(100000)",
        guide: "System Configuration / Memory Allocations",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for (site, kind) in sites::issues(context) {
        let IssueKind::SystemExceeded { block, needed, free } = kind else { continue };
        let model = context.model();
        let total = sites::number(model.system_memory().into());
        let span = sites::dim(context, site)
            .and_then(|dim| dim.sizes.first())
            .map_or_else(|| sites::span(context, site), |size| size.span);
        let message = format!(
            "{block} wants {} but {} of the {total} of an {} are free",
            sites::counted(needed, "byte"),
            sites::number(free),
            model.name
        );
        let counted = matches!(block, SystemBlock::Parameters | SystemBlock::Aliases);
        let diagnostic = RULE.at(span, message);
        let diagnostic = match sites::dim(context, site).filter(|_| !counted && free > 0) {
            Some(dim) => diagnostic.with_help(format!("{}({free}) takes all that is left", words(context, dim))),
            None => diagnostic.with_help("give less to something else"),
        };
        let proven = context.given_model().is_some_and(|model| model.confidence == Confidence::High);
        let severity = if proven { Severity::Error } else { Severity::Warning };
        context.report(Diagnostic { severity, ..diagnostic });
    }
}

/// `DIM PROG1`, as it is written.
fn words<'t>(context: &Context<'t>, dim: &Dim) -> &'t str {
    let end = dim.index.as_ref().map_or(dim.name.end, |index| index.span.end);
    context.slice(Span::new(dim.name.start, end))
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{codes, lint_as};

    #[test]
    fn the_last_byte_can_be_given_away() {
        // 1,048,576 in all: 48,576 are left behind a million, 800 of them for 100 parameters of 8.
        assert_eq!(codes("SYS\nCLEAR\nDIM PROG0(1000000)\nDIM P(100)\nDIM PROG1(47776)\n"), []);
        assert_eq!(codes("SYS\nCLEAR\nDIM PROG0(1000000)\nDIM P(100)\nDIM PROG1(47777)\n"), [(5, "ACR408")]);
    }

    #[test]
    fn the_factory_settings_take_half_a_megabyte() {
        assert_eq!(codes("SYS\nDIM PROG8(524288)\n"), []);
        assert_eq!(codes("SYS\nDIM PROG8(524289)\n"), [(2, "ACR408")]);
    }

    #[test]
    fn a_model_that_is_named_proves_it() {
        let text = "SYS\nCLEAR\nDIM PROG0(1048577)\n";
        assert_eq!(lint_as("ACR9000", text)[0].severity, Severity::Error);
        assert_eq!(lint_as("ACR8000", text)[0].severity, Severity::Warning);
        let message = &lint_as("ACR9000", text)[0].message;
        assert_eq!(message, "PROG0 wants 1,048,577 bytes but 1,048,576 of the 1,048,576 of an ACR9000 are free");
    }
}
