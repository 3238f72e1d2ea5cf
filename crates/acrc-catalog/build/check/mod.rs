//! The checks that a data file must pass. Each message names the row.

mod commands;
mod expressions;
mod links;
mod numbers;
mod others;

use std::collections::BTreeMap;
use std::fmt::Display;

use super::rows::Catalogue;
use crate::vocabulary::Confidence;

/// Every fault of the data; none means that tables can be generated.
pub fn check(catalogue: &Catalogue) -> Vec<String> {
    let mut faults = Faults::default();
    commands::check(&catalogue.commands, &mut faults);
    expressions::check(catalogue, &mut faults);
    numbers::check(catalogue, &mut faults);
    links::check(catalogue, &mut faults);
    others::check(catalogue, &mut faults);
    faults.0
}

/// Collected faults.
#[derive(Default)]
struct Faults(Vec<String>);

impl Faults {
    fn add(&mut self, row: impl Display, fault: impl Display) {
        self.0.push(format!("{row}: {fault}"));
    }

    /// A word that must be one of a vocabulary.
    fn known(&mut self, row: impl Display, what: &str, word: &str, found: bool) {
        if !found {
            self.add(row, format_args!("unknown {what} `{word}`"));
        }
    }

    /// What every row must say about where it comes from.
    fn origin(&mut self, row: impl Display, source: &str, confidence: &str) {
        if source.trim().is_empty() {
            self.add(&row, "the source is empty");
        }
        self.known(row, "confidence", confidence, Confidence::from_name(confidence).is_some());
    }

    /// A key that no two rows may share.
    fn unique<K: Ord + Display + Clone>(&mut self, what: &str, rows: impl Iterator<Item = (K, String)>) {
        let mut seen = BTreeMap::new();
        for (key, row) in rows {
            if let Some(other) = seen.insert(key.clone(), row.clone()) {
                self.add(row, format_args!("{what} {key} is taken by {other}"));
            }
        }
    }
}
