//! `ACR214`: an alias that no code of the project uses.

use acrc_analysis::{AliasFact, DefinedIn};
use acrc_diagnostics::{Code, Edit, Fix, Severity, Span};

use crate::Context;
use crate::rule::{Check, Group, Mark, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR214", name: "unused-alias" },
        group: Group::Names,
        severity: Severity::Advice,
        enabled: true,
        mark: Some(Mark::Unnecessary),
        what: "No file of the project uses an alias that it defines. A lone piece of code and a project without programs \
               are left alone. The fix is unsafe: a host may use the alias by its name.",
        why: "Each alias takes 48 bytes of the controller's memory. An alias for an input that nothing looks at may also \
              show that a check was forgotten.",
        bad: "#DEFINE Guard BIT2\n#DEFINE Lamp BIT32\nPROG0\nPROGRAM\nSET Lamp\nENDP",
        good: "#DEFINE Guard BIT2\n#DEFINE Lamp BIT32\nPROG0\nPROGRAM\nIF (Guard) THEN SET Lamp\nENDP",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let environment = context.environment();
    if environment.fragment || context.usage().programs.is_empty() {
        return;
    }
    for (place, site) in (0..).zip(&context.index().defines) {
        let name = context.slice(site.name);
        let is_first = matches!(
            environment.alias(name),
            Some(AliasFact::Defined { first: DefinedIn::This(first), .. }) if *first == place
        );
        // A word of the language is never read as an alias, which another rule says.
        let is_name = acrc_catalog::word(name).is_none();
        if is_first && is_name && environment.own_alias(name).is_some_and(|own| own.used_at.is_empty()) {
            let finding = RULE.at(site.name, format!("nothing in the project uses the alias `{name}`"));
            context.report(match whole_line(context, site.name) {
                Some(line) => finding.with_fix(Fix::unsafe_("remove the definition", vec![Edit::replace(line, "")])),
                None => finding,
            });
        }
    }
}

/// The line of a definition with its line break, when nothing else stands on it.
fn whole_line(context: &Context<'_>, name: Span) -> Option<Span> {
    let text = context.text();
    let lines = context.tree().lines();
    let line = lines.get(lines.partition_point(|line| line.span.end < name.start))?;
    let alone = line.statements.len() == 1 && line.comment.is_none() && line.number.is_none();
    let behind = text.get(line.span.end as usize..)?;
    let line_break = behind.len() - behind.strip_prefix('\r').unwrap_or(behind).trim_start_matches('\n').len();
    let line_break = line_break.min(if behind.starts_with("\r\n") { 2 } else { 1 });
    alone.then(|| Span::new(line.span.start, line.span.end + line_break as u32))
}

#[cfg(test)]
mod tests {
    use crate::testing::{found_by, lines_of, spans_of};

    const PROGRAM: &str = "PROG0\nPROGRAM\nSET Lamp\nENDP\n";

    #[test]
    fn an_alias_is_used_in_whatever_file() {
        let setup = "#DEFINE Lamp BIT32\n#DEFINE Guard BIT2\n#DEFINE Speed P1\n";
        let files =
            [("Setup.8K", setup), ("Prog0.8K", "PROGRAM\nSET Lamp\nENDP\n"), ("PLC0.8K", "PROGRAM\nLD Guard\nENDP\n")];
        assert_eq!(lines_of("ACR214", &files), [vec![3], vec![], vec![]]);
    }

    #[test]
    fn a_statement_that_could_not_be_read_may_use_it() {
        let text = format!("#DEFINE Guard BIT2\n{}", PROGRAM.replace("Lamp", "Lamp\nP0 = )Guard"));
        assert_eq!(spans_of("ACR214", &text), [""; 0]);
    }

    #[test]
    fn aliases_are_case_sensitive() {
        let text = format!("#DEFINE Lamp BIT32\n#DEFINE lamp BIT33\n{PROGRAM}");
        assert_eq!(spans_of("ACR214", &text), ["lamp"]);
    }

    #[test]
    fn a_second_definition_is_told_elsewhere() {
        let text = format!("#DEFINE Guard BIT2\n#DEFINE Guard BIT2\n{PROGRAM}");
        assert_eq!(spans_of("ACR214", &text), ["Guard"]);
    }

    #[test]
    fn setups_alone_and_pieces_of_code() {
        assert_eq!(spans_of("ACR214", "SYS\n#DEFINE Lamp BIT32\n"), [""; 0]);
        assert_eq!(spans_of("ACR214", "#DEFINE Lamp BIT32\nPROGRAM\nSET 32\nENDP\n"), [""; 0]);
    }

    #[test]
    fn the_fix_takes_the_line_away() {
        for line_break in ["\n", "\r\n"] {
            let text = format!("#DEFINE Guard BIT2\n\n#DEFINE Lamp BIT32\n{PROGRAM}").replace('\n', line_break);
            let found = found_by("ACR214", &text);
            let edit = &found[0].fixes[0].edits[0];
            assert_eq!(&text[edit.span.range()], format!("#DEFINE Guard BIT2{line_break}"));
        }
        assert_eq!(found_by("ACR214", &format!("#DEFINE Guard BIT2 : SET 4\n{PROGRAM}"))[0].fixes, []);
    }
}
