//! Places in a text that lead to a page or to a file.

use acrc_analysis::query::parse;
use acrc_analysis::{Db, SourceFile};
use acrc_diagnostics::{Code, Span};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A place that leads somewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    /// The place.
    pub span: Span,
    /// Where it leads.
    pub to: LinkTarget,
}

/// Where a link leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LinkTarget {
    /// The page of a rule.
    Rule(Code),
    /// A file, relative to the one with the link.
    File(String),
}

/// The rules in `acrc: allow` comments of a file.
pub fn links(db: &dyn Db, file: SourceFile) -> Vec<Link> {
    let rules = acrc_lint::allowed_rules(parse(db, file), file.text(db));
    rules.into_iter().map(|(span, doc)| Link { span, to: LinkTarget::Rule(doc.code) }).collect()
}

/// The programs that an `acrc.toml` lists. A text that is no TOML has none.
pub fn project_links(text: &str) -> Vec<Link> {
    let Ok(table) = DeTable::parse(text) else { return Vec::new() };
    let project = table.get_ref().get("project").map(Spanned::get_ref);
    let Some(DeValue::Table(project)) = project else { return Vec::new() };
    let Some(DeValue::Array(files)) = project.get("files").map(Spanned::get_ref) else { return Vec::new() };
    let link = |file: &Spanned<DeValue<'_>>| match file.get_ref() {
        DeValue::String(name) => Some(Link { span: file.span().into(), to: LinkTarget::File(name.to_string()) }),
        _ => None,
    };
    files.iter().filter_map(link).collect()
}
