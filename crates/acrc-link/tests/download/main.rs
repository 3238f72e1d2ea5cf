//! Downloads to a controller in the same process, also those that are cut off at any place.

mod back;
mod bench;
mod cut;
mod liars;
mod refused;
mod whole;

#[path = "../support/mod.rs"]
mod support;
