//! `ACR307`: a number stands where the project has an alias for it.

use acrc_diagnostics::{Code, Edit, Fix, Severity, Span};

use crate::Context;
use crate::references::{Reference, Usage};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR307", name: "alias-exists" },
        group: Group::Parameters,
        severity: Severity::Advice,
        enabled: false,
        mark: None,
        what: "A parameter or bit is written by its number, and the project has an alias for it. The fix is unsafe: an \
               alias has a meaning only where its #DEFINE was sent before.",
        why: "Whoever changes the wiring changes the alias, and the number stays behind: one program then switches the \
              old output.",
        bad: "#DEFINE Clamp BIT32\nPROG0\nPROGRAM\nSET 32\nENDP",
        good: "#DEFINE Clamp BIT32\nPROG0\nPROGRAM\nSET Clamp\nENDP",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::Reference(check)],
};

fn check(context: &mut Context<'_>, reference: &Reference) {
    let is_global = !reference.class.is_local();
    if reference.alias || reference.usage == Usage::Define || !is_global {
        return;
    }
    let environment = context.environment();
    let Some(alias) = environment.alias_for(reference.class, reference.number) else { return };
    // Within a program that has an axis of this name the word is the axis.
    if environment.axes_at(context.level()).is_some_and(|axes| axes.open || axes.has(alias)) {
        return;
    }
    let span = without_sign(context, reference.span);
    let fix = Fix::unsafe_(format!("write {alias}"), vec![Edit::replace(span, spaced(context, span, alias))]);
    let message = format!("{} has the alias `{alias}`", reference.name());
    context.report(RULE.at(span, message).with_fix(fix));
}

/// The sign of an INH belongs to the statement.
fn without_sign(context: &Context<'_>, span: Span) -> Span {
    let unsigned = context.slice(span).trim_start_matches(|c: char| c == '-' || c == '+' || c.is_whitespace());
    Span::new(span.end - unsigned.len() as u32, span.end)
}

/// A number may touch the words around it, a name may not: `SET32`.
fn spaced(context: &Context<'_>, span: Span, alias: &str) -> String {
    let text = context.text();
    let touches = |c: Option<char>| c.is_some_and(|c| c.is_ascii_alphanumeric() || c == '_');
    let before = touches(text.get(..span.start as usize).and_then(|text| text.chars().next_back()));
    let behind = touches(text.get(span.end as usize..).and_then(|text| text.chars().next()));
    format!("{}{alias}{}", if before { " " } else { "" }, if behind { " " } else { "" })
}

#[cfg(test)]
mod tests {
    use crate::testing::{found_by, lines_of, spans_of};

    #[test]
    fn numbers_with_an_alias() {
        let text = "#DEFINE Clamp BIT32\n#DEFINE Speed P1\nSET32\nINH -32\nVEL (P(1)+1)\nIF (BIT 32) THEN CLR Clamp\n";
        assert_eq!(spans_of("ACR307", text), ["32", "32", "P(1)", "BIT 32"]);
    }

    #[test]
    fn across_files() {
        let files = [("Setup.8K", "#DEFINE Clamp BIT32\n"), ("Prog0.8K", "PROGRAM\nSET 32\nSET 33\nENDP\n")];
        assert_eq!(lines_of("ACR307", &files), [vec![], vec![2]]);
    }

    #[test]
    fn an_axis_of_the_name_is_in_the_way() {
        let text = "#DEFINE X BIT32\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nSET 32\n";
        assert_eq!(spans_of("ACR307", text), [""; 0]);
    }

    #[test]
    fn a_name_is_set_off_from_what_the_number_touched() {
        let found = found_by("ACR307", "#DEFINE Clamp BIT32\nSET32\nCLR 32CLR33\n");
        let texts: Vec<_> = found.iter().map(|found| found.fixes[0].edits[0].text.clone()).collect();
        assert_eq!(texts, [" Clamp", "Clamp "]);
    }
}
