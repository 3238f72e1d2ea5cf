//! `acrc set`: writes parameters and flags of a controller, and reads them back.

use acrc_link::values::{Named, Names, Risk, Value, WriteError, parse_value, read, risk, write};
use acrc_link::{Connection, Protocol, Tcp};
use anyhow::{Context as _, bail};
use serde_json::{Value as Json, json};

use super::get::as_json;
use super::link::{Consent, confirm, connect, failed, names, watch_interrupt};
use crate::cli::{ColorChoice, SetArguments};
use crate::exit::Exit;
use crate::output::{Terminal, print};

/// What is to be written.
struct Order {
    named: Named,
    value: f64,
    risk: Risk,
}

pub(super) fn run(arguments: &SetArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let terminal = Terminal::error(color);
    let Some(names) = names(&arguments.naming, terminal)? else { return Ok(Exit::Failure) };
    let orders = arguments.values.iter().map(|text| order(text, &names)).collect::<anyhow::Result<Vec<_>>>()?;
    watch_interrupt()?;
    let risky: Vec<String> = orders.iter().filter(|order| order.risk != Risk::None).map(describe).collect();
    if !risky.is_empty() && !arguments.yes {
        let (list, what) = (risky.join("\n  "), if risky.len() == 1 { "this" } else { "these" });
        let question =
            format!("{} can act on the machine:\n  {list}\nWrite {what} to {}?", capital(what), arguments.to.to);
        match confirm(&question, &format!("{} can act on the machine", risky.join(", ")))? {
            Consent::Given => {}
            Consent::Denied => bail!("nothing was written"),
            Consent::Interrupted => return Ok(Exit::Interrupted),
        }
    }
    let mut connection = match connect(&arguments.to, Protocol::Text) {
        Ok(connection) => connection,
        Err(error) => return Ok(failed(error, terminal)),
    };
    let mut done = Vec::new();
    let result = orders.iter().try_for_each(|order| {
        let written = change(&mut connection, order)?;
        done.push((order, written));
        Ok(())
    });
    show(arguments.json, &done)?;
    let Err(error) = result else { return Ok(Exit::Clean) };
    if done.len() + 1 < orders.len() {
        let left: Vec<&str> = orders.iter().skip(done.len() + 1).map(|order| order.named.name.as_str()).collect();
        crate::exit::note(&format!("not written: {}", left.join(", ")), terminal);
    }
    Ok(match error {
        WriteError::Link(error) => failed(error, terminal),
        error @ WriteError::Differs { .. } => {
            crate::exit::say(&error.into(), terminal);
            Exit::Findings
        }
    })
}

fn order(text: &str, names: &Names) -> anyhow::Result<Order> {
    let (name, value) = text.split_once('=').with_context(|| format!("{text}: write NAME=VALUE"))?;
    let named = names.one(name)?;
    let value = parse_value(named.register, value).map_err(anyhow::Error::msg)?;
    let risk = risk(named.register, value);
    if risk == Risk::ReadOnly {
        bail!("{} ({}) is read-only", named.register, named.register.title());
    }
    Ok(Order { named, value, risk })
}

fn describe(order: &Order) -> String {
    let Named { name, register } = &order.named;
    let register = if *name == register.to_string() { String::new() } else { format!("{register}, ") };
    let title = order.named.register.title();
    let title = if title.is_empty() { "unknown to the catalogue".to_owned() } else { title };
    format!("{name}={} ({register}{title})", order.value)
}

fn capital(word: &str) -> String {
    word.split_at_checked(1).map_or_else(String::new, |(first, rest)| first.to_uppercase() + rest)
}

/// The value before and after.
fn change(connection: &mut Connection<Tcp>, order: &Order) -> Result<(Value, Value), WriteError> {
    let register = order.named.register;
    let before = read(connection, &[register])?.into_iter().next();
    let after = write(connection, register, order.value)?;
    Ok((before.unwrap_or(after), after))
}

fn show(json: bool, done: &[(&Order, (Value, Value))]) -> anyhow::Result<()> {
    if json {
        let list: Vec<Json> = done
            .iter()
            .map(|(order, (before, after))| {
                let mut row = as_json(&order.named, *after);
                if let Some(row) = row.as_object_mut() {
                    let before = as_json(&order.named, *before).get("value").cloned();
                    row.insert("before".to_owned(), json!(before));
                }
                row
            })
            .collect();
        return print(|out| writeln!(out, "{}", Json::Array(list)));
    }
    print(|out| {
        done.iter()
            .try_for_each(|(order, (before, after))| writeln!(out, "{} = {after} (was {before})", order.named.name))
    })
}
