//! Findings that are left out because they only repeat, in other words, a mistake that is already reported.
//!
//! A statement that could not be read costs one finding, that of the parser: what a rule says about the readable part of
//! it rests on a guess. What stands behind a forgotten `ENDP` belongs to another program than it seems to. A name that
//! ATTACH SLAVE gives to an axis although no axis can have it is refused there, and not again at each of its uses; nor is
//! an alias that is a word of the language.

use acrc_analysis::FileContext;
use acrc_analysis::index::Name;
use acrc_catalog::{AxisNameError, check_axis_name};
use acrc_diagnostics::{Diagnostic, Severity, Span};
use acrc_syntax::Tree;
use acrc_syntax::ast::{Separator, Statement, StatementKind};

use crate::rules::names::{alias_name, axis_name};
use crate::settings::Settings;
use crate::suppress;

/// The stretches of a file in which rules are not heard.
pub(crate) struct Consequences {
    /// In order and disjoint.
    spans: Vec<Span>,
    /// Names of axes that are too long to be read as such.
    long_names: Vec<Name>,
    /// The statements that use an alias which is a word of the language, in order.
    misread: Vec<Span>,
}

impl Consequences {
    pub(crate) fn new(file: &FileContext<'_>, settings: &Settings) -> Self {
        let errors = file.tree.errors().iter().filter(|error| error.severity == Severity::Error);
        let mut spans: Vec<Span> = errors.filter_map(|error| broken_at(file.tree, error.span)).collect();
        spans.extend(file.index.sections.iter().filter_map(|section| {
            let statements = file.tree.statements();
            let first = statements.get(section.swallowed?.first as usize)?;
            let last = section.section.closer.unwrap_or(section.section.statements.end.checked_sub(1)?);
            Some(Span::cover(first.span, statements.get(last as usize)?.span))
        }));
        spans.sort_unstable_by_key(|span| (span.start, span.end));
        spans.dedup_by(|next, before| {
            let joins = next.start < before.end;
            if joins {
                *before = Span::cover(*before, *next);
            }
            joins
        });
        // A name is only reported where it is given if that is heard as loud as what is left out.
        let long_names = if settings.is_error(&axis_name::RULE.doc) { long_names(file) } else { Vec::new() };
        let misread = if settings.is_error(&alias_name::RULE.doc) { misread(file) } else { Vec::new() };
        Self { spans, long_names, misread }
    }

    /// Whether a finding lies in such a stretch.
    pub(crate) fn hide(&self, finding: &Diagnostic) -> bool {
        holds(&self.spans, finding.span) || holds(&self.misread, finding.span)
    }

    /// Whether an error of the parser is only that it does not know a name that an ATTACH SLAVE of the program gives, and
    /// that is too long for an axis; or that it does not know an alias for one.
    pub(crate) fn hide_error(&self, error: &Diagnostic, text: &str) -> bool {
        let written = text.get(error.span.range()).unwrap_or_default();
        let is_misread = holds(&self.misread, error.span);
        is_misread || self.long_names.iter().any(|name| name.eq_ignore_ascii_case(written))
    }

    /// Whether rules may have been silenced in a part of the text.
    pub(crate) fn touch(&self, part: Span) -> bool {
        let after = self.spans.partition_point(|span| span.start < part.end);
        let before = after.checked_sub(1).and_then(|index| self.spans.get(index));
        before.is_some_and(|span| part.start < span.end)
    }
}

/// Whether one of `spans`, which are in order and disjoint, holds `inner`.
fn holds(spans: &[Span], inner: Span) -> bool {
    let after = spans.partition_point(|span| span.start <= inner.start);
    let before = after.checked_sub(1).and_then(|index| spans.get(index));
    before.is_some_and(|span| inner.end <= span.end)
}

/// The statements that use an alias which is a word of the language.
fn misread(file: &FileContext<'_>) -> Vec<Span> {
    // What a comment keeps from being reported where it is defined is reported where it is used: the text can't be compiled.
    let is_reported = |word: &&Name| {
        let definitions = file.questions.definitions(word);
        !definitions.iter().all(|(tree, text, name)| suppress::is_allowed(tree, text, *name, &alias_name::RULE.doc))
    };
    let words: Vec<&Name> = file.environment.words.iter().filter(is_reported).collect();
    if words.is_empty() {
        return Vec::new();
    }
    let can_use = |statement: &&Statement| {
        !matches!(statement.kind, StatementKind::Define(_) | StatementKind::Remark(_) | StatementKind::Label(_))
    };
    let is_used = |span: Span| {
        let text = file.text.get(span.range()).unwrap_or_default();
        text.split(|c: char| !c.is_ascii_alphanumeric())
            .any(|written| words.iter().any(|word| word.as_ref() == written))
    };
    file.tree
        .statements()
        .iter()
        .filter(can_use)
        .map(|statement| statement.span)
        .filter(|span| is_used(*span))
        .collect()
}

/// The names that are too long, among those that the programs of the file give to their axes.
fn long_names(file: &FileContext<'_>) -> Vec<Name> {
    if file.tree.errors().is_empty() {
        return Vec::new();
    }
    let tables = file.index.sections.iter().filter_map(|section| file.environment.axes_at(section.section.level));
    let mut names: Vec<Name> = tables
        .flat_map(|table| table.names.iter().map(|(name, _)| name))
        .filter(|name| matches!(check_axis_name(name), Err(AxisNameError::Letters(_))))
        .cloned()
        .collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// The statement that an error of the parser is about, with the one before it when what follows that is the error.
fn broken_at(tree: &Tree, error: Span) -> Option<Span> {
    let statements = tree.statements();
    let mut at = statements.partition_point(|statement| statement.span.start <= error.start).checked_sub(1)?;
    let span = statements.get(at).filter(|statement| error.start <= statement.span.end)?.span;
    let is_rest =
        |statement: &Statement| statement.kind == StatementKind::Error && statement.separator == Separator::Blank;
    while at > 0 && statements.get(at).is_some_and(is_rest) {
        at -= 1;
    }
    Some(Span::cover(statements.get(at)?.span, span))
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, codes_in, lint};

    #[test]
    fn a_broken_statement_costs_one_finding() {
        for statement in [
            "P0=FOO(1)",
            "P3=INT(2.7)",
            "GOSUB 5+",
            "P0=\"a",
            "X/ Y5",
            "P0 := 1",
            "P0=0x1F",
            "SET -",
            "IF (BIT 1) THEN",
            "FOR P0=1 TO 3\nDWL 1\nNEXT P0",
            "IF (BIT 1)\nEND IF",
        ] {
            let text = format!("PROG0\nPROGRAM\n{statement}\nENDP\n");
            let found = lint(&[("test.8K", &text)]).concat();
            assert_eq!(found.len(), 1, "{statement}: {found:#?}");
        }
    }

    #[test]
    fn a_name_that_is_too_long_for_an_axis_costs_one_finding() {
        let setup = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"BRIDGE\"\nATTACH SLAVE1 AXIS1 \"H\"\n";
        let program = "PROGRAM\nDRIVE ON BRIDGE H\nH10\nBRIDGE4000\nBridge 0\nENDP\nPROG1\nPROGRAM\nENDP\n";
        let found = lint(&[("Setup.8K", setup), ("Prog0.8K", program)]);
        assert_eq!(codes_in(setup, &found[0]), [(3, "ACR205")]);
        assert_eq!(codes_in(program, &found[1]), []);
        let unknown = "PROGRAM\nBRIDGES4000\nENDP\n";
        let found = lint(&[("Setup.8K", setup), ("Prog0.8K", unknown)]);
        assert_eq!(codes_in(unknown, &found[1]), [(2, "ACR001")]);
        let elsewhere = "PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"Z\"\nPROGRAM\nBRIDGE4000\nENDP\n";
        let found = lint(&[("Setup.8K", setup), ("Prog1.8K", elsewhere)]);
        assert_eq!(codes_in(elsewhere, &found[1]), [(5, "ACR001")]);
    }

    #[test]
    fn an_alias_that_is_a_word_costs_one_finding() {
        let defines = "#DEFINE Mode P5\n#DEFINE Cnt P6\n";
        let program = "PROG0\nPROGRAM\nMode = 1\nP6 = Mode + 1\nIF (Mode = 2) THEN Cnt = 1\nWHILE (Cnt < 3)\nCnt = Cnt + \
                       1\nWEND\nGOTO Nowhere\nENDP\n";
        let found = lint(&[("Defines.8K", defines), ("Prog0.8K", program)]);
        assert_eq!(codes_in(defines, &found[0]), [(1, "ACR212"), (2, "ACR212")]);
        assert_eq!(codes_in(program, &found[1]), [(9, "ACR101")]);
        let commands = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nMODE = 1\nENDP\n";
        let found = lint(&[("Defines.8K", defines), ("Prog0.8K", commands)]);
        assert_eq!(codes_in(commands, &found[1]), [(5, "ACR010")], "an alias is written in one case only");
    }

    #[test]
    fn an_alias_that_is_a_word_and_allowed_to_be_is_reported_where_it_is_used() {
        let program = "PROG0\nPROGRAM\nMode = 1\nENDP\n";
        for defines in ["' acrc: allow(ACR212)\n#DEFINE Mode P5\n", "' acrc: allow-file(alias-name)\n#DEFINE Mode P5\n"]
        {
            let found = lint(&[("Defines.8K", defines), ("Prog0.8K", program)]);
            assert_eq!(codes_in(defines, &found[0]), []);
            assert_eq!(codes_in(program, &found[1]), [(3, "ACR010")]);
        }
        let once = "' acrc: allow(ACR212)\n#DEFINE Mode P5\n#DEFINE Mode P5\n";
        let found = lint(&[("Defines.8K", once), ("Prog0.8K", program)]);
        assert_eq!((codes_in(once, &found[0]), codes_in(program, &found[1])), (vec![(3, "ACR212")], vec![]));
    }

    #[test]
    fn the_statements_around_a_broken_one_are_still_judged() {
        assert_eq!(codes("DWL \"a\" : P0 = : DWL \"b\"\n"), [(1, "ACR202"), (1, "ACR001"), (1, "ACR202")]);
    }
}
