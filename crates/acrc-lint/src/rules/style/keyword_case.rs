//! `ACR601`: words of the language that are not written in capital letters.

use acrc_analysis::walk;
use acrc_diagnostics::{Code, Edit, Fix, Severity, Span};
use acrc_syntax::ast::{Argument, Axis, ExprKind, Statement, StatementKind};
use acrc_syntax::lexer::TokenKind;

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR601", name: "keyword-case" },
        group: Group::Style,
        severity: Severity::Advice,
        enabled: false,
        mark: None,
        what: "A word of the language is not written in capital letters. Axis names, aliases and labels are left alone.",
        why: "LIST shows the program in capitals, so that a text in capitals is easier to compare with what the controller \
              holds; and capitals set the words of the language off from aliases, whose case matters.",
        bad: "PROG0\nPROGRAM\nif (Bit 24) then set 32\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 24) THEN SET 32\nENDP",
        guide: "none: the controller takes words of the language in any case",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let mut names = Vec::new();
    for statement in context.tree().statements() {
        let words = match &statement.kind {
            StatementKind::Remark(text) => Span::new(statement.span.start, text.start),
            StatementKind::Error => continue,
            _ => statement.span,
        };
        if !has_small_letters(context.slice(words)) {
            continue;
        }
        names.clear();
        collect_names(statement, &mut names);
        names.sort_unstable_by_key(|span| span.start);
        check_words(context, words, &names);
    }
}

fn has_small_letters(text: &str) -> bool {
    text.bytes().any(|byte| byte.is_ascii_lowercase())
}

fn check_words(context: &mut Context<'_>, span: Span, names: &[Span]) {
    for token in context.tree().tokens_in(span) {
        let text = context.slice(token.span);
        let is_word = matches!(token.kind, TokenKind::Word | TokenKind::Dollar);
        let after = names.partition_point(|name| name.start <= token.span.start);
        let in_name = after.checked_sub(1).and_then(|at| names.get(at)).is_some_and(|name| token.span.start < name.end);
        if is_word && !in_name && has_small_letters(text) {
            let capitals = text.to_ascii_uppercase();
            let fix = Fix::safe(format!("write {capitals}"), vec![Edit::replace(token.span, capitals.as_str())]);
            let diagnostic = RULE.at(token.span, format!("the keyword `{text}` is not in capitals"));
            context.report(diagnostic.with_fix(fix));
        }
    }
}

/// The places of the names in a statement: words that are not of the language.
fn collect_names(statement: &Statement, names: &mut Vec<Span>) {
    match &statement.kind {
        StatementKind::Label(label) => names.push(label.name),
        StatementKind::Define(define) => names.push(define.name),
        StatementKind::Command(command) => {
            for argument in &command.arguments {
                match argument {
                    Argument::Target(target) => names.push(target.span()),
                    Argument::Axis(Axis { name, .. }) => names.push(*name),
                    _ => {}
                }
            }
        }
        _ => {}
    }
    walk::expressions(statement, &mut |expr| {
        if matches!(expr.kind, ExprKind::Alias) {
            names.push(expr.span);
        }
    });
}

#[cfg(test)]
mod tests {
    use crate::testing::{fixed, spans_of};

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR601", text)
    }

    #[test]
    fn every_word_of_the_language_counts() {
        assert_eq!(found("Set 32 : Clr BIT 33\n"), ["Set", "Clr"]);
        assert_eq!(
            found("if (bit24 and not BIT 5) then goto Done\n_Done\n"),
            ["if", "bit", "and", "not", "then", "goto"]
        );
        assert_eq!(found("For LV0 = 1 to 3 step 1\nnext\n"), ["For", "to", "step", "next"]);
        assert_eq!(
            found("P0 = sqrt(p1) : $v0 = chr$(65)\n"),
            ["sqrt", "p", "$v", "chr", "$"].get(..4).unwrap_or_default()
        );
        assert_eq!(found("rem all lower case\nJOG Vel X10\naxis0 PPU 4000\n"), ["rem", "Vel", "axis"]);
    }

    #[test]
    fn names_are_written_as_their_owner_likes() {
        let text = "#DEFINE lamp BIT32\nPROG0\nATTACH SLAVE0 AXIS0 \"x\"\nPROGRAM\n_start\nx10 SET lamp\nJOG VEL x5\n\
                    PRINT \"set to\"; lamp\nGOTO start\nENDP\n";
        assert_eq!(found(text), [""; 0]);
    }

    #[test]
    fn the_words_are_written_in_capitals() {
        assert_eq!(fixed("ACR601", "if (Lamp) then jog vel X5 'lamp\n"), "IF (Lamp) THEN JOG VEL X5 'lamp\n");
    }
}
