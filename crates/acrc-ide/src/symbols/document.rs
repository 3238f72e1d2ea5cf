//! The outline of a file: its programs, and in them labels, aliases, axes and dimensioned variables.

use acrc_analysis::index::{AttachmentKind, Exports};
use acrc_analysis::query::{exports, file_index, parse};
use acrc_analysis::{Db, FileIndex, SectionIndex, SourceFile};
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
use acrc_syntax::ast::{Dim, StatementKind};
use acrc_syntax::units::SectionKind;

use super::SymbolKind;
use crate::place::slice;
use crate::routine::{span_of, subroutines};

/// An entry of the outline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// Its name: `PROG0`, `Home`, `LA0`.
    pub name: String,
    /// What else is to say: what an alias stands for, the axis of a name, the size of a `DIM`. May be empty.
    pub detail: String,
    /// What it is.
    pub kind: SymbolKind,
    /// All of it.
    pub whole: Span,
    /// Its name, within the whole.
    pub place: Span,
    /// What stands in it, in the order of the text.
    pub children: Vec<Self>,
}

/// The outline of a file, in the order of the text. A prompt at which nothing is declared is left out.
pub fn document_symbols(db: &dyn Db, file: SourceFile) -> Vec<Symbol> {
    let outline =
        Outline { text: file.text(db), tree: parse(db, file), index: file_index(db, file), exports: exports(db, file) };
    let sections = outline.index.sections.iter().map(|section| outline.section(section));
    sections.filter(|symbol| symbol.kind == SymbolKind::Program || !symbol.children.is_empty()).collect()
}

struct Outline<'a> {
    text: &'a str,
    tree: &'a Tree,
    index: &'a FileIndex,
    exports: &'a Exports,
}

impl Outline<'_> {
    fn section(&self, index: &SectionIndex) -> Symbol {
        let section = &index.section;
        let first = section.opener.unwrap_or(section.statements.start);
        let end = section.closer.map_or(section.statements.end, |closer| closer + 1);
        let whole = span_of(self.tree, first..end.max(first + 1));
        let stored = section.kind == SectionKind::Stored;
        let mut children = self.labels(index);
        children.extend(self.aliases(whole));
        children.extend(self.axes(whole));
        children.extend(self.variables(index));
        children.sort_by_key(|child| child.place.start);
        Symbol {
            name: section.level.to_string(),
            detail: if stored { String::new() } else { "prompt".to_owned() },
            kind: if stored { SymbolKind::Program } else { SymbolKind::Prompt },
            whole,
            place: self.tree.statements().get(first as usize).map_or(whole, |statement| statement.span),
            children,
        }
    }

    fn labels(&self, index: &SectionIndex) -> Vec<Symbol> {
        let called = subroutines(self.tree, index);
        let mut starts: Vec<u32> = index.labels.iter().map(|label| label.statement).collect();
        starts.sort_unstable();
        let end_of = |label: u32| match called.iter().find(|routine| routine.statements.start == label) {
            Some(routine) => (SymbolKind::Subroutine, routine.statements.end),
            None => {
                let next = starts.get(starts.partition_point(|start| *start <= label)).copied();
                (SymbolKind::Label, next.unwrap_or(index.section.statements.end))
            }
        };
        let symbol = |label: &acrc_analysis::index::LabelSite| {
            let (kind, end) = end_of(label.statement);
            let whole = span_of(self.tree, label.statement..end);
            leaf(slice(self.text, label.name), String::new(), kind, whole, label.name)
        };
        index.labels.iter().map(symbol).collect()
    }

    fn aliases(&self, part: Span) -> impl Iterator<Item = Symbol> + use<'_> {
        let own = self.index.defines.iter().filter(move |site| part.contains(site.name.start));
        own.map(|site| {
            let whole = Span::cover(site.name, site.operand);
            let name = slice(self.text, site.name);
            leaf(name, slice(self.text, site.operand).to_owned(), SymbolKind::Alias, whole, site.name)
        })
    }

    fn axes(&self, part: Span) -> impl Iterator<Item = Symbol> + use<'_> {
        let all = self.exports.attachments.iter().zip(&self.index.attachments);
        all.filter(move |(_, site)| part.contains(site.statement.start)).filter_map(|(attachment, site)| {
            let AttachmentKind::Slave { axis, name: Some(name), .. } = &attachment.kind else { return None };
            let detail = axis.map_or_else(String::new, |axis| format!("AXIS{axis}"));
            Some(leaf(name, detail, SymbolKind::Axis, site.statement, site.name?))
        })
    }

    fn variables(&self, index: &SectionIndex) -> Vec<Symbol> {
        let range = index.section.statements.start as usize..index.section.statements.end as usize;
        let statements = self.tree.statements().get(range).unwrap_or_default().iter();
        let dims = statements.filter_map(|statement| match &statement.kind {
            StatementKind::Dim(dim) => Some((statement.span, dim)),
            _ => None,
        });
        dims.filter(|(_, dim)| !dim.sizes.is_empty()).map(|(whole, dim)| self.variable(whole, dim)).collect()
    }

    fn variable(&self, whole: Span, dim: &Dim) -> Symbol {
        let word = slice(self.text, dim.name).split_ascii_whitespace().next_back().unwrap_or_default();
        let number = dim.index.as_ref().map_or("", |index| slice(self.text, index.span));
        let place = dim.index.as_ref().map_or(dim.name, |index| Span::cover(dim.name, index.span));
        let sizes: Vec<&str> = dim.sizes.iter().map(|size| slice(self.text, size.span)).collect();
        let name = format!("{}{number}", word.to_ascii_uppercase());
        leaf(&name, format!("({})", sizes.join(", ")), SymbolKind::Variable, whole, place)
    }
}

fn leaf(name: &str, detail: String, kind: SymbolKind, whole: Span, place: Span) -> Symbol {
    // A list of symbols shows no empty names.
    let name = if name.is_empty() { "\"\"" } else { name };
    let whole = Span::cover(whole, place);
    Symbol { name: name.to_owned(), detail, kind, whole, place, children: Vec::new() }
}
