//! The build refuses faulty rows, and says which.

#![allow(unreachable_pub, dead_code, reason = "the modules are those of the build script")]

#[macro_use]
#[path = "../src/named.rs"]
mod named;
#[path = "../src/address.rs"]
mod address;
#[path = "../build/mod.rs"]
mod catalogue;
#[path = "../src/hash.rs"]
mod hash;
#[path = "../src/vocabulary/mod.rs"]
mod vocabulary;

use std::path::Path;

use catalogue::check::check;
use catalogue::read::read;
use catalogue::rows::{Catalogue, CommandRow, DefaultRow, NumberRow};

fn data() -> Catalogue {
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("data")).expect("the data files can be read")
}

fn command<'a>(catalogue: &'a mut Catalogue, name: &str) -> &'a mut CommandRow {
    catalogue.commands.iter_mut().find(|row| row.name == name).expect("a command")
}

fn number<'a>(rows: &'a mut [NumberRow], field: &str) -> &'a mut NumberRow {
    rows.iter_mut().find(|row| row.field == field).expect("a field")
}

/// Spoils the data and returns what the checks say.
fn faults(spoil: impl FnOnce(&mut Catalogue)) -> String {
    let mut catalogue = data();
    spoil(&mut catalogue);
    check(&catalogue).join("\n")
}

#[test]
fn the_data_has_no_faults() {
    assert_eq!(check(&data()), Vec::<String>::new());
}

/// A fault: what is wrong, and the edit that makes the data so.
type Case = (&'static str, fn(&mut Catalogue));

const COMMAND_FAULTS: &[Case] = &[
    ("an opcode taken twice", |all| command(all, "VEL").opcode = 345),
    ("an opcode beyond ten bits", |all| command(all, "VEL").opcode = 1024),
    ("a name taken twice", |all| command(all, "VEL").name = "acc".into()),
    ("a missing parent", |all| command(all, "JOG HOME").parent = Some("JIG".to_owned())),
    ("a loop of daughters", |all| {
        command(all, "JOG").parent = Some("JOG HOME".to_owned());
    }),
    ("a missing whole", |all| command(all, "ENDIF").belongs_to = Some("WHEN".to_owned())),
    ("an unknown shape", |all| command(all, "VEL").shape = "Number".into()),
    ("an unknown confidence", |all| command(all, "VEL").confidence = "sure".into()),
    ("an unknown level", |all| command(all, "VEL").levels.push("root".to_owned())),
    ("an unknown prefix", |all| command(all, "VEL").prefixes.push("SPINDLE".to_owned())),
    ("fewer arguments at most than at least", |all| command(all, "VEL").min_args = 2),
    ("a tuple upside down", |all| command(all, "SLM").tuple = [2, 1]),
    ("a missing tuple", |all| command(all, "SLM").tuple = [0, 0]),
    ("an empty source", |all| command(all, "VEL").source = " ".into()),
    ("an empty summary", |all| command(all, "VEL").summary.clear()),
];

const EXPRESSION_FAULTS: &[Case] = &[
    ("an unknown type", |all| all.functions[0].result = "angle".into()),
    ("an id taken twice", |all| all.functions[1].id = 1),
    ("an operator without a row", |all| all.operators.retain(|row| row.symbol != "MOD")),
    ("an unknown operator", |all| all.operators[0].symbol = "%".into()),
];

const NUMBER_FAULTS: &[Case] = &[
    ("a law that meets another", |all| {
        number(&mut all.parameters, "target_position").first = 12288;
    }),
    ("a flag without a word", |all| number(&mut all.bits, "jog_home_request").first = 17664),
    ("a parameter outside its block", |all| number(&mut all.parameters, "clock_ms").first = 7200),
    ("a count without a stride", |all| number(&mut all.parameters, "clock_ms").count = 2),
    ("a field of two laws", |all| {
        number(&mut all.bits, "not_in_position").field = "jog_active".into();
    }),
    ("an unknown object", |all| number(&mut all.bits, "mei_open").object = "spindle".into()),
    ("an unknown access", |all| number(&mut all.bits, "mei_open").access = Some("write".to_owned())),
    ("an unknown kind", |all| number(&mut all.bits, "mei_open").kind = Some("alarm".to_owned())),
    ("overlapping blocks", |all| all.blocks[1].first = 4000),
    ("overlapping words", |all| all.words[0].count = 2),
];

const LINK_FAULTS: &[Case] = &[
    ("an unknown command", |all| number(&mut all.parameters, "pgain").command = Some("PGIAN".to_owned())),
    ("a command that is no setting", |all| command(all, "PGAIN").setting = false),
    ("a command of another object", |all| number(&mut all.parameters, "dac_gain").command = Some("PGAIN".to_owned())),
    ("a part too many", |all| number(&mut all.parameters, "exc_minus").part = Some(2)),
    ("a part that is missing", |all| number(&mut all.parameters, "exc_minus").part = None),
    ("a part of nothing", |all| number(&mut all.parameters, "velocity").part = Some(0)),
    ("a part taken twice", |all| number(&mut all.parameters, "exc_minus").part = Some(0)),
    ("a default beside a command", |all| number(&mut all.parameters, "pgain").default = DefaultRow::All(1.0)),
    ("too few defaults", |all| number(&mut all.parameters, "node_id").default = DefaultRow::Each(vec![1.0, 0.0])),
];

const OTHER_FAULTS: &[Case] = &[
    ("a second default model", |all| all.models[1].default = true),
    ("an impossible model", |all| all.models[1].axes = 0),
    ("an empty message", |all| all.messages[0].text.clear()),
];

/// The build script's words for each fault, one paragraph a fault.
fn refusals(cases: &[Case]) -> String {
    let refusal = |(name, spoil): &Case| {
        let faults = faults(spoil);
        assert!(!faults.is_empty(), "nothing is said about {name}");
        format!("{name}\n  {}\n", faults.replace('\n', "\n  "))
    };
    cases.iter().map(refusal).collect::<Vec<_>>().join("\n")
}

#[test]
fn faulty_commands_are_refused() {
    insta::assert_snapshot!(refusals(COMMAND_FAULTS));
}

#[test]
fn faulty_expressions_are_refused() {
    insta::assert_snapshot!(refusals(EXPRESSION_FAULTS));
}

#[test]
fn faulty_numbers_are_refused() {
    insta::assert_snapshot!(refusals(NUMBER_FAULTS));
}

#[test]
fn faulty_links_are_refused() {
    insta::assert_snapshot!(refusals(LINK_FAULTS));
}

#[test]
fn faulty_models_and_messages_are_refused() {
    insta::assert_snapshot!(refusals(OTHER_FAULTS));
}

#[test]
fn an_unknown_key_names_its_file() {
    let directory = std::env::temp_dir().join("acrc-catalog-unknown-key");
    let commands = directory.join("commands");
    std::fs::create_dir_all(&commands).expect("a directory");
    std::fs::write(commands.join("bad.toml"), "group = \"Bad\"\ncolour = 1\ncommand = []\n").expect("a file");
    let errors = read(&directory).expect_err("an unknown key").join("\n");
    std::fs::remove_dir_all(&directory).expect("removed");
    assert!(errors.contains("bad.toml") && errors.contains("colour"), "{errors}");
}
