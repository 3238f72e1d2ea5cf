//! What could not be checked. It must not look like what has no findings.

/// The rule that reports name where they have no other place for what could not be checked.
pub(crate) const NOT_CHECKED: &str = "not-checked";

/// A project or file that could not be checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unchecked {
    /// The file that is in the way, as it is shown; `None` when it is none in particular.
    pub name: Option<String>,
    /// Why, perhaps on several lines.
    pub reason: String,
}

impl Unchecked {
    /// A name for forms in which everything lies in a file.
    pub(crate) fn name_or_tool(&self) -> &str {
        self.name.as_deref().unwrap_or("acrc")
    }
}
