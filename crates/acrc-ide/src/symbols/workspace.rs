//! Finding what a project declares by its name.

use acrc_analysis::{Db, Project};

use super::{Symbol, SymbolKind, document_symbols, fuzzy};
use crate::Target;

/// Something that a project declares.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WorkspaceSymbol {
    /// Its name.
    pub name: String,
    /// What else is to say.
    pub detail: String,
    /// What it is.
    pub kind: SymbolKind,
    /// The program or prompt in which it is declared; empty for a program.
    pub container: String,
    /// Where it is declared.
    pub target: Target,
}

/// What the project declares under names that hold the characters of `pattern` in their order; the best fits first, and
/// at most `limit` of them. An empty pattern fits everything.
pub fn workspace_symbols(db: &dyn Db, project: Project, pattern: &str, limit: usize) -> Vec<WorkspaceSymbol> {
    let mut found: Vec<(u32, WorkspaceSymbol)> = Vec::new();
    for &file in project.files(db) {
        let mut add = |symbol: Symbol, container: &str| {
            let Symbol { name, detail, kind, whole, place, .. } = symbol;
            let is_named = !matches!(kind, SymbolKind::Prompt | SymbolKind::Variable);
            if let Some(rank) = fuzzy::rank(pattern, &name).filter(|_| is_named) {
                let target = Target { file, whole, name: place };
                found.push((rank, WorkspaceSymbol { name, detail, kind, container: container.to_owned(), target }));
            }
        };
        for mut section in document_symbols(db, file) {
            let children = std::mem::take(&mut section.children);
            let container = section.name.clone();
            add(section, "");
            for child in children {
                add(child, &container);
            }
        }
    }
    // Equal ranks stay in the order of the project.
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().take(limit).map(|(_, symbol)| symbol).collect()
}
