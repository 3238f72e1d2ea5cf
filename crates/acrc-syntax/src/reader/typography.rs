//! Characters that came with text copied from a document.

use acrc_diagnostics::{Diagnostic, Edit, Fix, Span};

use super::Reader;
use crate::ast::StatementKind;
use crate::codes;

/// What stands in a program in place of a typographic character, and what both are called.
const ASCII: [(&[char], &str, &str); 4] = [
    (&['\u{201C}', '\u{201D}', '\u{201E}'], "\"", "curly quote"),
    (&['\u{2018}', '\u{2019}'], "'", "curly apostrophe"),
    (&['\u{2010}', '\u{2011}', '\u{2012}', '\u{2013}', '\u{2014}', '\u{2212}'], "-", "dash"),
    (&['\u{A0}', '\u{2007}', '\u{202F}'], " ", "no-break space"),
];

impl Reader<'_> {
    /// Reports the typographic characters of code; remarks may hold any text.
    pub(super) fn report_typography(&mut self, places: &[Span]) {
        for &place in places {
            let Some(found) = self.slice(place).chars().next() else { continue };
            let Some(&(_, ascii, name)) = ASCII.iter().find(|(characters, ..)| characters.contains(&found)) else {
                continue;
            };
            if self.is_in_remark(place) {
                continue;
            }
            let shown = if ascii == " " { "a blank".to_owned() } else { format!("`{ascii}`") };
            self.report(
                Diagnostic::warning(
                    codes::TYPOGRAPHIC_CHARACTER,
                    place,
                    format!("a {name} (U+{:04X}) stands for {shown}", u32::from(found)),
                )
                .with_help("the controller knows ASCII only")
                .with_fix(Fix::safe(format!("replace it with {shown}"), vec![Edit::replace(place, ascii)])),
            );
        }
    }

    fn is_in_remark(&self, place: Span) -> bool {
        let after = self.statements.partition_point(|statement| statement.span.start <= place.start);
        let before = after.checked_sub(1).and_then(|index| self.statements.get(index));
        before.is_some_and(|statement| {
            matches!(statement.kind, StatementKind::Remark(_)) && place.start < statement.span.end
        })
    }
}
