//! Parameters and flags by what they are called: `kamr axis 1` is `BIT8499`.

use acrc_analysis::Db;
use acrc_analysis::query::symbols;
use acrc_catalog::{AddressLaw, Model, OperandClass, Space, all_bits, all_parameters};

use super::context::Context;
use super::items::item;
use super::{Completion, CompletionKind, Completions};
use crate::Entity;

/// The most that are shown at once.
const LIMIT: usize = 60;
/// Letters that are typed before anything is looked up.
const LEAST: usize = 2;

/// The flags whose names fit what is typed.
pub(super) fn bits(db: &dyn Db, context: &Context<'_>, found: &mut Completions) {
    let rows = all_bits().map(|row| Row {
        law: row.law,
        object: row.object,
        title: row.title,
        field: row.field,
        also: row.also,
    });
    look_up(db, context, OperandClass::Bit, rows, found);
}

/// The parameters whose names fit what is typed.
pub(super) fn parameters(db: &dyn Db, context: &Context<'_>, found: &mut Completions) {
    let rows = all_parameters().map(|row| Row {
        law: row.law,
        object: row.object,
        title: row.title,
        field: row.field,
        also: row.also,
    });
    look_up(db, context, OperandClass::Parameter, rows, found);
}

/// What a row of flags and one of parameters have in common.
struct Row {
    law: AddressLaw,
    object: Space,
    title: &'static str,
    field: &'static str,
    also: &'static [&'static str],
}

/// What is asked for: words of the name, and the number of the object.
struct Query {
    words: Vec<String>,
    number: Option<u32>,
}

fn look_up(
    db: &dyn Db,
    context: &Context<'_>,
    class: OperandClass,
    rows: impl Iterator<Item = Row>,
    found: &mut Completions,
) {
    let (span, phrase) = context.phrase();
    if phrase.trim().len() < LEAST {
        found.incomplete = true;
        return;
    }
    let query = Query::new(db, context, phrase);
    let model = context.project.model(db);
    let mut count = 0;
    for row in rows {
        let Some(rank) = query.rank(&row) else { continue };
        for (number, owner) in row.numbers(model, query.number) {
            if count == LIMIT {
                found.incomplete = true;
                return;
            }
            count += 1;
            let label = format!("{class}{number}");
            found.items.push(Completion {
                detail: format!("{}{owner}", row.title),
                span,
                filter: phrase.to_owned(),
                entity: Some(Entity::Operand { class, number: Some(number.into()), level: None }),
                ..item(context, &label, kind(class), rank)
            });
        }
    }
    // What fits depends on all that is typed.
    found.incomplete = true;
}

const fn kind(class: OperandClass) -> CompletionKind {
    match class {
        OperandClass::Bit => CompletionKind::Bit,
        _ => CompletionKind::Parameter,
    }
}

impl Query {
    fn new(db: &dyn Db, context: &Context<'_>, phrase: &str) -> Self {
        let axes = symbols(db, context.project).axes_at(context.level);
        let mut query = Self { words: Vec::new(), number: None };
        for word in phrase.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()) {
            let digits = word.trim_start_matches(|c: char| c.is_ascii_alphabetic());
            let letters = word.strip_suffix(digits).unwrap_or(word);
            // `kamr x` means the axis of that name.
            let axis = (!query.words.is_empty()).then(|| axes?.find(word)?.1).flatten();
            match (axis, digits.parse()) {
                (Some(axis), _) => {
                    query.words.push("axis".to_owned());
                    query.number = Some(axis);
                }
                (None, Ok(number)) => {
                    query.number = Some(number);
                    query.words.extend(Some(letters.to_ascii_lowercase()).filter(|letters| !letters.is_empty()));
                }
                (None, Err(_)) => query.words.push(word.to_ascii_lowercase()),
            }
        }
        query
    }

    /// The rank of a row, if every word is found in its names.
    fn rank(&self, row: &Row) -> Option<u8> {
        let names = || {
            let words = |text: &'static str| text.split(|c: char| !c.is_ascii_alphanumeric());
            words(row.title).chain(words(row.field)).chain(words(row.object.name())).chain(row.also.iter().copied())
        };
        let fits = |word: &String| names().any(|name| super::items::begins(name, word));
        if self.words.is_empty() || !self.words.iter().all(fits) {
            return None;
        }
        let acronym = row.also.iter().any(|also| self.words.iter().any(|word| also.eq_ignore_ascii_case(word)));
        // Several words are no beginning of a command.
        let phrase = self.words.len() + usize::from(self.number.is_some()) > 1;
        Some(if phrase { 1 } else { 6 } - u8::from(acronym))
    }
}

impl Row {
    /// Its numbers for the objects of a model, or for one of them, with what they belong to.
    fn numbers(&self, model: &Model, wanted: Option<u32>) -> Vec<(u32, String)> {
        let most = match self.object {
            Space::Axis => u32::from(model.axes),
            Space::Master => u32::from(model.masters),
            Space::Program => u32::from(model.programs),
            Space::Plc => u32::from(model.plcs),
            _ => u32::MAX,
        };
        let places = 0..self.law.count;
        let of = |place: u32| {
            let index = self.law.object_index(place).or_else(|| self.law.element(place));
            let fits = match (index, wanted) {
                (Some(index), Some(wanted)) => index == wanted,
                (None, Some(_)) => false,
                (_, None) => true,
            };
            let exists = self.law.object_index(place).is_none_or(|index| index < most);
            let owner = index.map_or_else(String::new, |index| format!(", {} {index}", self.object));
            Some((self.law.number(place).filter(|_| fits && exists)?, owner))
        };
        // Of long lists of elements the first ones stand for all.
        places.filter_map(of).take(if wanted.is_some() { LIMIT } else { 8 }).collect()
    }
}
