//! Checks of functions, operators and operands.

use super::Faults;
use crate::catalogue::rows::{Catalogue, FunctionRow, OperatorRow};
use crate::vocabulary::{OperandClass, Operator, TypeClass, UnaryOperator};

pub fn check(catalogue: &Catalogue, faults: &mut Faults) {
    functions(&catalogue.functions, faults);
    let symbols = Operator::ALL.iter().map(|operator| operator.name()).collect::<Vec<_>>();
    operators("operator", &catalogue.operators, &symbols, faults);
    let symbols = UnaryOperator::ALL.iter().map(|operator| operator.name()).collect::<Vec<_>>();
    operators("unary operator", &catalogue.unary_operators, &symbols, faults);
    faults.unique("name", catalogue.operands.iter().map(|row| (row.name.clone(), format!("operand {}", row.name))));
    for row in &catalogue.operands {
        let label = format!("operand {}", row.name);
        if let Some(class) = &row.class {
            faults.known(&label, "class", class, OperandClass::from_name(class).is_some());
        }
        faults.origin(&label, &row.source, &row.confidence);
    }
    for class in OperandClass::ALL {
        if !catalogue.operands.iter().any(|row| row.class.as_deref() == Some(class.name())) {
            faults.add(format_args!("operand class {class}"), "no row describes it");
        }
    }
}

fn functions(rows: &[FunctionRow], faults: &mut Faults) {
    let label = |row: &FunctionRow| format!("function {} (id {})", row.name, row.id);
    faults.unique("id", rows.iter().map(|row| (row.id, label(row))));
    faults.unique("name", rows.iter().map(|row| (row.name.to_uppercase(), label(row))));
    for row in rows {
        for class in row.arguments.iter().chain([&row.result]) {
            faults.known(label(row), "type", class, TypeClass::from_name(class).is_some());
        }
        if row.min_args.is_some_and(|least| usize::from(least) > row.arguments.len()) {
            faults.add(label(row), format_args!("min_args is more than its {} arguments", row.arguments.len()));
        }
        faults.origin(label(row), &row.source, &row.confidence);
    }
}

/// Each operator of the vocabulary has exactly one row.
fn operators(what: &str, rows: &[OperatorRow], symbols: &[&str], faults: &mut Faults) {
    let label = |row: &OperatorRow| format!("{what} {}", row.symbol);
    faults.unique("symbol", rows.iter().map(|row| (row.symbol.clone(), label(row))));
    for row in rows {
        faults.known(label(row), "symbol", &row.symbol, symbols.contains(&row.symbol.as_str()));
        faults.origin(label(row), &row.source, &row.confidence);
        if !(1..=8).contains(&row.precedence) {
            faults.add(label(row), format_args!("precedence {} is outside 1 to 8", row.precedence));
        }
    }
    for symbol in symbols {
        if !rows.iter().any(|row| row.symbol == *symbol) {
            faults.add(format_args!("{what} {symbol}"), "no row describes it");
        }
    }
}
