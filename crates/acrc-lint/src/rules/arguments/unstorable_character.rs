//! `ACR026`: a character that a text of the controller can't hold. The compiler reports it under the same code.

use acrc_analysis::compile_codes;
use acrc_diagnostics::{Severity, Span};
use acrc_syntax::ast::{Expr, ExprKind};

use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: compile_codes::UNSTORABLE_CHARACTER,
        group: Group::Compile,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A text has a character beyond one byte.",
        why: "Texts on the controller have one byte a character; the terminal would show something else.",
        bad: "PRINT \"\u{3a9}\"",
        good: "PRINT \"ohm\"",
        guide: "System Configuration / Memory Allocations",
    },
    checks: &[Check::Expression(On::Text, check)],
};

fn check(context: &mut Context<'_>, expr: &Expr) {
    let ExprKind::String(text) = expr.kind else { return };
    let Some((offset, character)) = context.slice(text).char_indices().find(|(_, character)| !is_stored(*character))
    else {
        return;
    };
    let start = text.start + offset as u32;
    let span = Span::new(start, start + character.len_utf8() as u32);
    let help = if matches!(character, '\u{201C}'..='\u{201F}' | '\u{2033}') {
        "it stands for a quote, which would end the text: use an apostrophe"
    } else {
        "texts on the controller have one byte a character"
    };
    context.report(RULE.at(span, format!("the character `{character}` can't be stored")).with_help(help));
}

/// A character of one byte, or a typographic one for which the compiler stores its plain form.
fn is_stored(character: char) -> bool {
    u8::try_from(character).is_ok()
        || matches!(
            character,
            '\u{2018}'..='\u{201B}'
                | '\u{2032}'
                | '\u{2010}'..='\u{2015}'
                | '\u{2212}'
                | '\u{2002}'..='\u{200A}'
                | '\u{202F}'
                | '\u{2026}'
        )
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn one_byte_a_character() {
        assert_eq!(codes("PRINT \"20 \u{b0}C \u{2013} caf\u{e9}\"\n"), []);
        assert_eq!(codes("PRINT \"5 k\u{3a9}, 6 k\u{3a9}\"\n$V0 = \"\u{201c}\"\n"), [(1, "ACR026"), (2, "ACR026")]);
        assert_eq!(codes("REM \u{3a9}\n' \u{3a9}\n"), []);
    }
}
