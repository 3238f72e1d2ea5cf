//! Editor features through the public surface of the crate.

mod completion;
mod actions;
mod fixture;
mod hints;
mod hover;
mod navigation;
mod occurrences;
mod rename;
mod semantic_tokens;
mod signature_help;
