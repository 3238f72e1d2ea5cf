//! Tables of functions, operators and operands.

use super::{confidence, constant, index, line, table};
use crate::catalogue::rows::{Catalogue, FunctionRow, OperatorRow};
use crate::vocabulary::{OperandClass, Operator, TypeClass, UnaryOperator};

pub fn tables(catalogue: &Catalogue, out: &mut String) {
    table(out, "FUNCTIONS", "Function", catalogue.functions.iter().map(function));
    index(out, "FUNCTION_BY_ID", catalogue.functions.iter().map(|row| u16::from(row.id)));
    let symbols = Operator::ALL.iter().map(|operator| operator.name());
    table(out, "OPERATORS", "OperatorInfo", symbols.map(|symbol| operator(&catalogue.operators, symbol)));
    let symbols = UnaryOperator::ALL.iter().map(|operator| operator.name());
    table(out, "UNARY_OPERATORS", "OperatorInfo", symbols.map(|symbol| operator(&catalogue.unary_operators, symbol)));
    let operands = catalogue.operands.iter().map(|row| {
        let class = row.class.as_deref().and_then(OperandClass::from_name);
        let class = class.map_or("None".to_owned(), |class| format!("Some(OperandClass::{class:?})"));
        format!(
            "Operand {{ name: {:?}, class: {class}, summary: {:?}, index: {:?}, storage: {:?}, note: {:?}, source: {:?}, confidence: {} }}",
            row.name,
            row.summary,
            row.index,
            row.storage,
            row.note,
            row.source,
            confidence(&row.confidence)
        )
    });
    table(out, "OPERANDS", "Operand", operands);
}

pub fn constants(rows: &[FunctionRow]) -> String {
    let mut out = String::new();
    for row in rows {
        line(&mut out, format_args!("/// `{}`: {}.", row.name, row.summary));
        line(&mut out, format_args!("pub const {}: FunctionId = FunctionId({});", constant(&row.name), row.id));
    }
    out
}

fn class(name: &str) -> String {
    format!("TypeClass::{:?}", TypeClass::from_name(name).expect("checked"))
}

fn function(row: &FunctionRow) -> String {
    format!(
        "Function {{ id: FunctionId({}), name: {:?}, min_args: {}, max_args: {}, argument_types: &[{}], result: {}, domain: {:?}, \
         summary: {:?}, note: {:?}, source: {:?}, confidence: {} }}",
        row.id,
        row.name,
        row.min_args.map_or(row.arguments.len(), usize::from),
        row.arguments.len(),
        row.arguments.iter().map(|name| class(name)).collect::<Vec<_>>().join(", "),
        class(&row.result),
        row.domain,
        row.summary,
        row.note,
        row.source,
        confidence(&row.confidence)
    )
}

fn operator(rows: &[OperatorRow], symbol: &str) -> String {
    let row = rows.iter().find(|row| row.symbol == symbol).expect("checked");
    format!(
        "OperatorInfo {{ symbol: {:?}, alternative: {:?}, precedence: {}, summary: {:?}, operands: {:?}, result: {:?}, note: {:?}, \
         source: {:?}, confidence: {} }}",
        row.symbol,
        row.alternative,
        row.precedence,
        row.summary,
        row.operands,
        row.result,
        row.note,
        row.source,
        confidence(&row.confidence)
    )
}
