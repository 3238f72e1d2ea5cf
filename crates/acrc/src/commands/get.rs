//! `acrc get`: parameters and flags of a controller.

use acrc_link::Protocol;
use acrc_link::values::{Named, Value, read};
use serde_json::{Value as Json, json};

use super::link::{connect, failed, names, watch_interrupt};
use crate::cli::{ColorChoice, GetArguments};
use crate::exit::Exit;
use crate::output::{Terminal, print};

pub(super) fn run(arguments: &GetArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let terminal = Terminal::error(color);
    let Some(names) = names(&arguments.naming, terminal)? else { return Ok(Exit::Failure) };
    let mut named = Vec::new();
    for name in &arguments.names {
        named.extend(names.find(name)?);
    }
    watch_interrupt()?;
    let registers: Vec<_> = named.iter().map(|named| named.register).collect();
    let values = connect(&arguments.to, Protocol::Text).and_then(|mut connection| read(&mut connection, &registers));
    let values = match values {
        Ok(values) => values,
        Err(error) => return Ok(failed(error, terminal)),
    };
    let both: Vec<(&Named, Value)> = named.iter().zip(values).collect();
    show(arguments, &both, Terminal::output(color))?;
    Ok(Exit::Clean)
}

fn show(arguments: &GetArguments, values: &[(&Named, Value)], terminal: Terminal) -> anyhow::Result<()> {
    if arguments.json {
        let list: Vec<Json> = values.iter().map(|(named, value)| as_json(named, *value)).collect();
        return print(|out| writeln!(out, "{}", Json::Array(list)));
    }
    if arguments.bare {
        return print(|out| values.iter().try_for_each(|(_, value)| writeln!(out, "{value}")));
    }
    let width = values.iter().map(|(named, _)| named.name.len()).max().unwrap_or_default();
    let texts: Vec<String> = values.iter().map(|(_, value)| value.to_string()).collect();
    let wide = texts.iter().map(String::len).max().unwrap_or_default();
    print(|out| {
        values.iter().zip(&texts).try_for_each(|((named, _), text)| {
            let (number, title) = (named.register.to_string(), named.register.title());
            let number = if number == named.name { String::new() } else { number };
            let about = [number, title].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(": ");
            let line = format!("{:width$}  {text:>wide$}  {}", named.name, terminal.faint(&about));
            writeln!(out, "{}", line.trim_end())
        })
    })
}

/// A value with what it is.
pub(super) fn as_json(named: &Named, value: Value) -> Json {
    let number = match value {
        Value::Flag(set) => json!(set),
        Value::Long(number) => json!(number),
        // As it is printed: the digits of the other form of the same number are none of the controller's.
        Value::Single(number) => number.to_string().parse::<f64>().map_or(Json::Null, |number| json!(number)),
        Value::Number(number) => json!(number),
    };
    json!({
        "name": named.name,
        "register": named.register.to_string(),
        "value": number,
        "title": named.register.title(),
    })
}
