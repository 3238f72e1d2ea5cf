//! The controller models.

use std::fmt::Write as _;

use acrc_catalog::models;

use super::{cell, heading};

pub(super) fn page() -> String {
    let mut page = heading("Controller models", "`crates/acrc-catalog/data/models.toml`");
    page.push_str("| Model | Programs | PLCs | Masters | Axes | Slaves | User memory | Notes | Confidence |\n");
    page.push_str("|---|---|---|---|---|---|---|---|---|\n");
    for model in models() {
        let _ = writeln!(
            page,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            model.name,
            model.programs,
            model.plcs,
            model.masters,
            model.axes,
            model.slaves,
            model.user_memory,
            cell(model.note),
            model.confidence.label()
        );
    }
    page
}
