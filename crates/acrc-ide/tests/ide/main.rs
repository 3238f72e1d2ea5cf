//! Editor features through the public surface of the crate.

mod fixture;
mod occurrences;
mod semantic_tokens;
