//! What names stand for.

use rustc_hash::FxHashMap;

/// Resolves the names that a program text uses. Both kinds are case-sensitive.
pub trait Scope {
    /// The place of an alias in the table of the image.
    fn alias(&self, name: &str) -> Option<u16>;
    /// The number of a label in its unit, counted from 0 in the order of definition.
    fn label(&self, name: &str) -> Option<u16>;
}

/// A scope without any name.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoNames;

impl Scope for NoNames {
    fn alias(&self, _name: &str) -> Option<u16> {
        None
    }

    fn label(&self, _name: &str) -> Option<u16> {
        None
    }
}

/// A scope in which every name means something, for who asks only what a statement costs.
pub(crate) struct AnyNames;

impl Scope for AnyNames {
    fn alias(&self, _name: &str) -> Option<u16> {
        Some(0)
    }

    fn label(&self, _name: &str) -> Option<u16> {
        Some(0)
    }
}

/// A scope of two tables.
#[derive(Clone, Debug, Default)]
pub struct Tables {
    /// Aliases by name.
    pub aliases: FxHashMap<String, u16>,
    /// Labels by name.
    pub labels: FxHashMap<String, u16>,
}

impl Scope for Tables {
    fn alias(&self, name: &str) -> Option<u16> {
        self.aliases.get(name).copied()
    }

    fn label(&self, name: &str) -> Option<u16> {
        self.labels.get(name).copied()
    }
}
