//! From a topic to the rows that it names.

use super::Entry;
use crate::{
    Keyword, ObjectKind, UnaryOperator, all_bits, all_commands, all_functions, all_messages, all_operands,
    all_operators, all_parameters, all_unary_operators, bit, model, parameter,
};

/// Everything that a topic names; nothing when it names nothing.
pub(super) fn entries(topic: &str) -> Vec<Entry> {
    let topic = topic.split_whitespace().collect::<Vec<_>>().join(" ");
    if let Some(digits) = digits_of(&topic, "P") {
        return digits.parse().map(|number| Entry::Parameter(Box::new(parameter(number)))).into_iter().collect();
    }
    if let Some(digits) = digits_of(&topic, "BIT") {
        return digits.parse().map(|number| Entry::Bit(Box::new(bit(number)))).into_iter().collect();
    }
    let mut found = named(&topic);
    if found.is_empty() {
        found = named(topic.trim_end_matches(|letter: char| letter.is_ascii_digit()).trim_end());
    }
    if found.is_empty() {
        found = all_commands().filter(|command| same(command.word, &topic)).map(Entry::Command).collect();
    }
    found
}

/// The digits of `P12290`, `p 12290`, `P(12290)`.
fn digits_of<'a>(topic: &'a str, prefix: &str) -> Option<&'a str> {
    let (head, rest) = topic.split_at_checked(prefix.len())?;
    let rest = rest.trim_start();
    let digits = rest.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).unwrap_or(rest).trim();
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    (same(head, prefix) && is_number).then_some(digits)
}

fn same(left: &str, right: &str) -> bool {
    left.eq_ignore_ascii_case(right)
}

fn named(topic: &str) -> Vec<Entry> {
    if topic.is_empty() {
        return Vec::new();
    }
    let mut found: Vec<Entry> =
        all_commands().filter(|command| same(command.name, topic)).map(Entry::Command).collect();
    found.extend(all_functions().filter(|function| same(function.name, topic)).map(Entry::Function));
    found.extend(operators(topic));
    found.extend(all_operands().filter(|operand| names_operand(operand, topic)).map(Entry::Operand));
    let described = found.iter().any(|entry| matches!(entry, Entry::Command(command) if command.clause));
    found.extend(Keyword::from_name(topic).filter(|_| !described).map(Entry::Keyword));
    if found.is_empty() {
        found.extend(ObjectKind::from_name(topic).map(Entry::Object));
    }
    found.extend(fields(topic));
    found.extend(model(topic).map(Entry::Model));
    found.extend(all_messages().filter(|message| same(message.text, topic)).map(Entry::Message));
    found
}

fn operators(topic: &str) -> impl Iterator<Item = Entry> {
    let infos = all_operators().map(crate::Operator::info).chain(all_unary_operators().map(UnaryOperator::info));
    infos.filter(move |info| same(info.symbol, topic) || info.alternative == topic).map(Entry::Operator)
}

fn names_operand(operand: &crate::Operand, topic: &str) -> bool {
    same(operand.name, topic) || operand.class.is_some_and(|class| same(class.name(), topic))
}

/// Fields by name, title or acronym; a field of two rows once.
fn fields(topic: &str) -> Vec<Entry> {
    let asked = |field: &str, title: &str, also: &[&str]| {
        same(field, topic)
            || same(&field.replace('_', " "), topic)
            || same(title, topic)
            || also.iter().any(|name| same(name, topic))
    };
    let parameters = all_parameters()
        .filter(|row| asked(row.field, row.title, row.also))
        .map(|row| (row.field, Entry::ParameterField(row)));
    let bits =
        all_bits().filter(|row| asked(row.field, row.title, row.also)).map(|row| (row.field, Entry::BitField(row)));
    let mut found: Vec<(&str, Entry)> = Vec::new();
    for (field, entry) in parameters.chain(bits) {
        if !found.iter().any(|(known, _)| *known == field) {
            found.push((field, entry));
        }
    }
    found.into_iter().map(|(_, entry)| entry).collect()
}
