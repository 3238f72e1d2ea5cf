//! Parameters and bits.

use std::fmt::Write as _;

use acrc_catalog::{all_bits, all_parameters};

use super::{cell, heading};

pub(super) fn parameters() -> String {
    let mut page = heading("System parameters", "`crates/acrc-catalog/data/parameters`");
    page.push_str("The row gives the number of object 0; each further object adds the step.\n\n");
    page.push_str("| First | Step | Count | Field | Meaning | Unit | Confidence |\n|---|---|---|---|---|---|---|\n");
    for row in all_parameters() {
        let _ = writeln!(
            page,
            "| P{} | {} | {} | `{}` | {} | {} | {} |",
            row.law.first,
            row.law.stride,
            row.law.count,
            row.field,
            cell(row.title),
            cell(row.unit),
            row.confidence.label()
        );
    }
    page
}

pub(super) fn bits() -> String {
    let mut page = heading("Bits", "`crates/acrc-catalog/data/bits`");
    page.push_str("The row gives the number of object 0; each further object adds the step.\n\n");
    page.push_str("| First | Step | Count | Field | Meaning | Confidence |\n|---|---|---|---|---|---|\n");
    for row in all_bits() {
        let _ = writeln!(
            page,
            "| BIT{} | {} | {} | `{}` | {} | {} |",
            row.law.first,
            row.law.stride,
            row.law.count,
            row.field,
            cell(row.title),
            row.confidence.label()
        );
    }
    page
}
