//! The `TextMate` grammar: `textmate.json` beside this file, with the words of the catalogue in place of what stands in `{{}}`.

use std::collections::{BTreeMap, BTreeSet};

use acrc_catalog::{
    Command, Keyword, ObjectKind, OperandClass, Operator, Shape, UnaryOperator, all_functions, command,
};
use serde_json::{Value, json};

use super::words;

const TEMPLATE: &str = include_str!("textmate.json");

/// Blanks, those of documents included.
const BLANKS: &str = r"[ \t\f\x{A0}\x{2007}\x{202F}]*";

/// Where a word starts: behind no letter, but a `THEN` may be touched.
const WORD_START: &str = r"(?:(?<![A-Za-z])|(?<=\)THEN|\) THEN))";

/// The grammar.
pub(super) fn json() -> String {
    let lists = lists();
    let mut grammar: Value = serde_json::from_str(TEMPLATE).expect("the template is JSON");
    fill(&mut grammar, &lists);
    let mut text = serde_json::to_string_pretty(&grammar).expect("a value without odd keys");
    text.push('\n');
    text
}

fn fill(value: &mut Value, lists: &BTreeMap<&str, String>) {
    match value {
        Value::String(text) if text == "{{daughters}}" => *value = Value::Array(daughters()),
        Value::String(text) => {
            for (name, list) in lists {
                *text = text.replace(&format!("{{{{{name}}}}}"), list);
            }
            assert!(!text.contains("{{"), "the template names a list that is not there: {text}");
        }
        Value::Array(values) => values.iter_mut().for_each(|value| fill(value, lists)),
        Value::Object(fields) => fields.values_mut().for_each(|value| fill(value, lists)),
        _ => {}
    }
}

fn lists() -> BTreeMap<&'static str, String> {
    let commands = || words::commands().filter(|row| row.shape != Shape::Assignment);
    let control = commands()
        .filter(|row| words::is_control(row))
        .map(|row| row.name)
        .chain([Keyword::Then, Keyword::To, Keyword::Step].map(Keyword::name));
    let operators = || {
        let unary = UnaryOperator::ALL.iter().map(|operator| operator.name());
        Operator::ALL.iter().map(|operator| operator.name()).chain(unary).filter(|word| words::is_letters(word))
    };
    let is_operator = |word: &&str| operators().any(|operator| operator == *word);
    let takes_name = |row: &&Command| {
        matches!(
            row.shape,
            Shape::Bit
                | Shape::BitMove
                | Shape::ParameterTuple
                | Shape::Print
                | Shape::Input
                | Shape::Condition
                | Shape::If
        )
    };
    let others = commands().filter(|row| !words::is_control(row)).map(|row| row.name);
    let functions =
        |is_string: bool| all_functions().map(|row| row.name).filter(move |name| name.ends_with('$') == is_string);
    let variables = |is_string: bool| {
        let named = |class: &&OperandClass| !matches!(class, OperandClass::Parameter | OperandClass::Bit);
        let names = OperandClass::ALL.iter().filter(named).map(|class| class.name());
        names.filter(move |name| name.starts_with('$') == is_string)
    };
    BTreeMap::from([
        ("b", BLANKS.to_owned()),
        ("w", WORD_START.to_owned()),
        ("control", alternatives(control)),
        ("jumps", alternatives(commands().filter(|row| row.shape == Shape::Target).map(|row| row.name))),
        ("operator_words", alternatives(operators())),
        ("logic", alternatives(commands().map(|row| row.name).filter(is_operator).chain([command::LD.info().name]))),
        ("before_name", alternatives(commands().filter(takes_name).map(|row| row.name))),
        ("reserved", alternatives(words::reserved().into_iter())),
        ("objects", alternatives(ObjectKind::ALL.iter().map(|kind| kind.name()))),
        ("commands", alternatives(others.filter(|word| !is_operator(word)))),
        ("words", alternatives(Keyword::ALL.iter().map(|keyword| keyword.name()))),
        ("functions", alternatives(functions(false))),
        ("string_functions", alternatives(functions(true))),
        ("variables", alternatives(variables(false))),
        ("string_variables", alternatives(variables(true))),
    ])
}

/// The words, the longest first, as alternatives of a regular expression.
fn alternatives<'w>(words: impl Iterator<Item = &'w str>) -> String {
    let mut words: Vec<&str> = words.collect::<BTreeSet<_>>().into_iter().collect();
    words.sort_by_key(|word| (std::cmp::Reverse(word.len()), *word));
    words.join("|").replace('$', r"\$")
}

/// One pattern for each command with daughters: what is a daughter behind one word may be a name behind another.
fn daughters() -> Vec<Value> {
    // What is an operator elsewhere is found at the start of its line.
    let is_operator = |row: &&Command| Operator::from_symbol(row.name).is_some();
    let parents =
        words::commands().filter(|row| !row.daughters.is_empty() && row.id != command::ELSE && !is_operator(row));
    parents.map(daughter_pattern).collect()
}

fn daughter_pattern(row: &Command) -> Value {
    let words = |rows: &mut dyn Iterator<Item = &'static Command>| {
        alternatives(rows.map(|row| row.word.trim_end_matches(|last: char| last.is_ascii_digit())))
    };
    let below = || row.daughters.iter().map(|daughter| daughter.info());
    let further: Vec<&Command> =
        below().flat_map(|daughter| daughter.daughters.iter().map(|further| further.info())).collect();
    // Behind an object its number may stand.
    let number = if row.shape == Shape::Object { format!("{BLANKS}([0-9]*)") } else { "()".to_owned() };
    let third = if further.is_empty() {
        String::new()
    } else {
        format!("(?:{BLANKS}({})(?![A-Za-z]))?", words(&mut further.into_iter()))
    };
    let word = row.name;
    let second = words(&mut below());
    json!({
        "match": format!("(?i){WORD_START}({word}){number}{BLANKS}({second})(?![A-Za-z]){third}"),
        "captures": {
            "1": { "name": "keyword.other.command.acrobasic" },
            "2": { "name": "constant.numeric.acrobasic" },
            "3": { "name": "keyword.other.daughter.acrobasic" },
            "4": { "name": "keyword.other.daughter.acrobasic" },
        },
    })
}
