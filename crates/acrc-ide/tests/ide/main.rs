//! Editor features through the public surface of the crate.

mod actions;
mod any_text;
mod completion;
mod fixture;
mod format;
mod hints;
mod hover;
mod navigation;
mod occurrences;
mod rename;
mod semantic_tokens;
mod signature_help;
