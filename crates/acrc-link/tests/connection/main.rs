//! Lines and answers: over a controller in the same process, and over lines that misbehave.

#[path = "../support/mod.rs"]
mod support;

mod answers;
mod misbehaviour;
