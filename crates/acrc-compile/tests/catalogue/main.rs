//! Every row of the catalogue has an encoding: statements written from the signatures, in all their forms, are stored, listed and stored again.

#[path = "../common/mod.rs"]
mod common;
mod notation;
mod samples;

use acrc_catalog::{
    Command, CommandId, Levels, ObjectKind, OperandClass, Shape, all_commands, all_functions, all_operators,
    all_unary_operators, command,
};
use acrc_image::{Node, Unit, encode};
use acrc_syntax::units::Level;
use common::{compile_file, listing};

/// What the written statements refer to.
const BEFORE: &str = "#DEFINE Flag BIT128\n#DEFINE Speed P7\n_Here\n";

/// Statements that follow others only.
fn context(row: &Command) -> &'static str {
    match row.id {
        command::ELSE | command::ELSEIF | command::ELSE_IF | command::ENDIF => "IF (P0)\n",
        _ => "",
    }
}

/// Where a row is entered: the program, the PLC program or, for what only the system prompt takes, a program as well, since a stored text
/// holds anything.
fn level(levels: Levels) -> Level {
    if levels.plc() && !levels.prog() { Level::Plc(3) } else { Level::Program(3) }
}

/// Stores `text`, and proves that its words, its statements and its listing lead to each other.
fn fixed_point(text: &str, level: Level) -> Result<Unit, String> {
    let compiled = |text: &str| {
        let image = compile_file(text, level, true).map_err(|errors| format!("{text}: {errors:?}"))?;
        image.verify().map_err(|error| format!("{text}: {error}"))?;
        let unit = image.programs.last().ok_or("nothing is stored")?.clone();
        Ok::<_, String>((listing(&unit, &image), unit))
    };
    let (listed, unit) = compiled(text)?;
    let statements = unit.decode().map_err(|error| format!("{text}: {error}"))?;
    let encoded = encode(unit.name, &statements).map_err(|error| format!("{text}: {error}"))?;
    let (listed_again, again) = compiled(&listed)?;
    let same = |other: &Unit| (&other.words, &other.strings) == (&unit.words, &unit.strings);
    if !(same(&encoded) && same(&again)) || listed_again != listed {
        return Err(format!("{text}\n--- listed\n{listed}--- listed again\n{listed_again}"));
    }
    Ok(unit)
}

/// The forms of a row: those of its signature, and each with an object that may stand before it in the place of the axis.
fn forms(row: &Command) -> Vec<Vec<String>> {
    if row.daughter_required {
        return Vec::new();
    }
    let forms = notation::forms(row.signature);
    let mut own: Vec<Vec<String>> = forms.into_iter().filter(|form| is_of(row, form)).collect();
    if own.is_empty() {
        own.push(vec![row.name.to_owned()]);
    }
    let prefixed = row.prefixes.iter().flat_map(|&kind| own.iter().filter_map(move |form| behind(kind, form)));
    let prefixed: Vec<Vec<String>> = prefixed.collect();
    [own, prefixed].concat()
}

/// A form with the word of a daughter is one of the daughter, except where words that are not known are taken as well. A line number alone
/// is no statement: it deletes the line.
fn is_of(row: &Command, form: &[String]) -> bool {
    if row.shape == Shape::LineNumber && form.len() == 1 {
        return false;
    }
    let names_daughter = |token: &String| token == "command" && row.shape != Shape::Free || token == "type";
    !form.iter().any(names_daughter)
}

/// The form with an object before it: `AXIS2 PPU 4000` for `PPU X 4000`. None when it begins with the object or has more than one axis.
fn behind(kind: ObjectKind, form: &[String]) -> Option<Vec<String>> {
    let axes = form.iter().filter(|token| *token == "axis").count();
    if form.first()?.starts_with(kind.name()) || axes > 1 || (kind != ObjectKind::Axis && axes > 0) {
        return None;
    }
    let rest = form.iter().filter(|token| *token != "axis").cloned();
    Some(std::iter::once(format!("{kind}n")).chain(rest).collect())
}

/// Is `found` the statement that a row describes: its own, one of its daughters, or the one that it is a part of?
fn describes(row: &Command, found: CommandId) -> bool {
    let lineage = std::iter::successors(Some(found), |id| id.info().parent);
    lineage.into_iter().any(|id| id == row.id) || row.belongs_to == Some(found)
}

#[test]
fn every_command_is_stored_in_all_its_forms() {
    let (mut failures, mut written) = (Vec::new(), 0);
    for row in all_commands() {
        let forms = forms(row);
        assert_eq!(forms.is_empty(), row.daughter_required, "{}: the forms are {forms:?}", row.name);
        for form in forms {
            for round in 0..samples::ROUNDS {
                let statement = samples::write(row, &form, round);
                let text = format!("{BEFORE}{}{statement}\n", context(row));
                written += 1;
                match fixed_point(&text, level(row.levels)) {
                    Ok(unit) if row.shape == Shape::Text && row.belongs_to.is_some() => {
                        assert!(unit.decode().is_ok_and(|all| all.len() == 3), "{statement} is not stored");
                    }
                    Ok(unit) => {
                        let statements = unit.decode().expect("decoded before");
                        let own = statements.iter().skip(3).any(|statement| describes(row, statement.command));
                        if !own {
                            failures.push(format!("{} is stored as another command: {statement}", row.name));
                        }
                    }
                    Err(error) => failures.push(error),
                }
            }
        }
    }
    assert!(failures.is_empty(), "{} of {written}\n{}", failures.len(), failures.join("\n"));
    assert!(written > 5000, "only {written} statements were written");
}

/// Stores an expression as the value of an assignment and tells whether a node of its kind is in it.
fn stored(expression: &str, is_kind: impl Fn(&Node) -> bool) {
    let unit = fixed_point(&format!("{BEFORE}DV0 = {expression}\n"), Level::Program(3))
        .unwrap_or_else(|error| panic!("{error}"));
    let statements = unit.decode().expect("decoded before");
    let value = statements.last().and_then(|statement| statement.items.last()).map(|item| &item.node);
    assert!(value.is_some_and(|node| contains(node, &is_kind)), "{expression} is stored as {value:?}");
}

fn contains(node: &Node, is_kind: &impl Fn(&Node) -> bool) -> bool {
    is_kind(node) || node.children().into_iter().any(|child| contains(child, is_kind))
}

#[test]
fn every_operator_is_stored() {
    for operator in all_operators() {
        let is_kind = |node: &Node| matches!(node, Node::Binary { op, .. } if *op == operator);
        for spelling in [operator.symbol(), operator.info().alternative].into_iter().filter(|symbol| !symbol.is_empty())
        {
            for [left, right] in
                [["P0", "3"], ["(LV0)", "-2.5"], ["$V0", "\"text\""], ["(1 + 2)", "(P1 * (3 - Speed))"]]
            {
                stored(&format!("{left} {spelling} {right}"), is_kind);
                stored(&format!("({left} {spelling} {right})"), is_kind);
            }
        }
        for other in all_operators() {
            stored(&format!("P0 {} P1 {} P2", operator.symbol(), other.symbol()), is_kind);
            stored(&format!("(P0 {} P1) {} (P2 {0} P3)", operator.symbol(), other.symbol()), is_kind);
        }
    }
    for operator in all_unary_operators() {
        for operand in ["P0", "(LV0)", "Flag", "BIT 24", "(P0 + 1)", "SIN(P0)", "(NOT BIT 5)"] {
            let is_kind = |node: &Node| matches!(node, Node::Unary { op, .. } if *op == operator);
            stored(&format!("{} {operand}", operator.symbol()), is_kind);
            stored(&format!("2 * ({} {operand})", operator.symbol()), is_kind);
        }
    }
}

#[test]
fn every_function_is_stored_with_each_number_of_arguments() {
    for function in all_functions() {
        let is_kind = |node: &Node| matches!(node, Node::Call { function: called, .. } if *called == function.id);
        for count in function.min_args..=function.max_args {
            for values in [
                ["1", "2", "3", "4"],
                ["P0", "(LV0)", "-2.5", "Speed"],
                ["$V0", "1", "LV2", "7"],
                ["\"a\"", "(P0 + 1)", "SQRT(2)", "3"],
            ] {
                let arguments = values[..usize::from(count)].join(", ");
                stored(&format!("{}({arguments})", function.name), is_kind);
                stored(&format!("2 - ({}({arguments})) + 1", function.name.to_lowercase()), is_kind);
            }
        }
    }
}

#[test]
fn every_operand_is_stored_with_numbers_and_expressions() {
    for &class in OperandClass::ALL {
        for index in ["0", "8191", "(LV0)", "(P0 + 1)", "(Speed)"] {
            if class.is_array() {
                let is_kind = |node: &Node| matches!(node, Node::Array { class: stored, .. } if *stored == class);
                for element in ["0", "499", "LV1", "-P0 + 1"] {
                    stored(&format!("{class}{index}({element})"), is_kind);
                }
            } else {
                let is_kind = |node: &Node| matches!(node, Node::Scalar { class: stored, .. } if *stored == class);
                stored(&format!("{class}{index}"), is_kind);
                stored(&format!("-({class} {index}) * 2"), is_kind);
            }
        }
    }
}
