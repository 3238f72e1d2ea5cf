//! Operators, functions and operands.

use std::fmt::Write as _;

use acrc_catalog::{Operator, UnaryOperator, all_functions, all_operands, all_operators, all_unary_operators};

use super::{cell, heading};

pub(super) fn page() -> String {
    let mut page = heading("Expressions", "`crates/acrc-catalog/data`");
    page.push_str("A lower rank binds tighter; equal ranks are evaluated from left to right.\n");
    page.push_str("\n## Operators\n\n| Operator | Rank | Notes | Confidence |\n|---|---|---|---|\n");
    for operator in all_unary_operators().map(UnaryOperator::info).chain(all_operators().map(Operator::info)) {
        let _ = writeln!(
            page,
            "| `{}` | {} | {} | {} |",
            cell(operator.symbol),
            operator.precedence,
            cell(operator.summary),
            operator.confidence.label()
        );
    }
    page.push_str("\n## Functions\n\n| Function | Arguments | Meaning | Confidence |\n|---|---|---|---|\n");
    for function in all_functions() {
        let arguments = if function.min_args == function.max_args {
            function.min_args.to_string()
        } else {
            format!("{} to {}", function.min_args, function.max_args)
        };
        let _ = writeln!(
            page,
            "| `{}` | {arguments} | {} | {} |",
            cell(function.name),
            cell(function.summary),
            function.confidence.label()
        );
    }
    page.push_str("\n## Operands\n\n| Operand | Meaning | Confidence |\n|---|---|---|\n");
    for operand in all_operands() {
        let _ =
            writeln!(page, "| `{}` | {} | {} |", cell(operand.name), cell(operand.summary), operand.confidence.label());
    }
    page
}
