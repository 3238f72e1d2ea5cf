//! Every word of the language with all that it can be, and the daughters by parent.

use std::collections::BTreeMap;

use super::{line, perfect, table};
use crate::catalogue::rows::{Catalogue, CommandRow};
use crate::vocabulary::{Keyword, ObjectKind, OperandClass, Operator, UnaryOperator};

/// Fields of a `Word` by name, as Rust expressions.
type Fields = BTreeMap<&'static str, String>;

pub fn tables(catalogue: &Catalogue, out: &mut String) {
    let words = collect(catalogue);
    let rows = words.iter().map(|(word, fields)| {
        let fields: Vec<String> = fields.iter().map(|(name, value)| format!("{name}: {value}, ")).collect();
        format!("({word:?}, Word {{ {}..Word::NOTHING }})", fields.concat())
    });
    table(out, "WORDS", "(&str, Word)", rows);
    let keys: Vec<_> = words.keys().map(|word| (0, word.clone())).collect();
    perfect::emit(out, "WORD_HASH", &keys);
    let longest = words.keys().map(String::len).max().unwrap_or(0);
    line(out, format_args!("pub(crate) const LONGEST_WORD: usize = {longest};"));
    daughters(&catalogue.commands, out);
}

fn collect(catalogue: &Catalogue) -> BTreeMap<String, Fields> {
    let mut words: BTreeMap<String, Fields> = BTreeMap::new();
    let mut set = |word: &str, field: &'static str, value: String| {
        words.entry(word.to_uppercase()).or_default().insert(field, value);
    };
    for row in catalogue.commands.iter().filter(|row| row.word && !row.clause) {
        match row.parent {
            None => set(&row.name, "command", format!("Some(CommandId({}))", row.opcode)),
            Some(_) => set(row.last_word(), "daughter", "true".to_owned()),
        }
    }
    for row in &catalogue.functions {
        set(&row.name, "function", format!("Some(FunctionId({}))", row.id));
    }
    for kind in ObjectKind::ALL {
        set(kind.name(), "object", format!("Some(ObjectKind::{kind:?})"));
    }
    for class in OperandClass::ALL {
        set(class.name(), "operand", format!("Some(OperandClass::{class:?})"));
    }
    for keyword in Keyword::ALL {
        set(keyword.name(), "keyword", format!("Some(Keyword::{keyword:?})"));
    }
    let is_word = |symbol: &str| symbol.chars().all(char::is_alphabetic);
    for operator in Operator::ALL.iter().filter(|operator| is_word(operator.name())) {
        set(operator.name(), "operator", format!("Some(Operator::{operator:?})"));
    }
    for operator in UnaryOperator::ALL.iter().filter(|operator| is_word(operator.name())) {
        set(operator.name(), "unary", format!("Some(UnaryOperator::{operator:?})"));
    }
    words
}

fn daughters(rows: &[CommandRow], out: &mut String) {
    let opcodes: BTreeMap<&str, u16> = rows.iter().map(|row| (row.name.as_str(), row.opcode)).collect();
    let daughters: Vec<(u16, &CommandRow)> =
        rows.iter().filter_map(|row| Some((*opcodes.get(row.parent.as_deref()?)?, row))).collect();
    let entries = daughters
        .iter()
        .map(|(parent, row)| format!("(CommandId({parent}), {:?}, CommandId({}))", row.last_word(), row.opcode));
    table(out, "DAUGHTERS", "(CommandId, &str, CommandId)", entries);
    let keys: Vec<_> = daughters.iter().map(|(parent, row)| (*parent, row.last_word().to_owned())).collect();
    perfect::emit(out, "DAUGHTER_HASH", &keys);
}
