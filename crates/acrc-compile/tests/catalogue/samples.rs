//! Something to write for each placeholder of a signature.

use acrc_catalog::{Command, Shape};

/// How many rounds it takes until each placeholder had each of its values.
pub(crate) const ROUNDS: usize = 8;

const NUMBERS: [&str; ROUNDS] = ["3", "2.5", "-4", "123456.789", "P0", "(LV0 + 1)", "Speed", "(-SQRT(P1) * 2)"];
const VARIABLES: [&str; ROUNDS] = ["LV0", "P0", "SV(LV1)", "LA0(1)", "DV2", "DA1(LV0 + 1)", "Speed", "$V0"];
const COUNTERS: [&str; ROUNDS] = ["LV0", "P0", "SV(LV1)", "LA0(1)", "DV2", "DA1(LV0)", "Speed", "SA0(P1)"];
const SOURCES: [&str; ROUNDS] = ["ENC1", "CLOCK", "P12290", "NONE", "LA0", "3", "Speed", "ADC0"];
const CONDITIONS: [&str; ROUNDS] =
    ["P0 > 5", "1", "BIT 24", "NOT Flag", "(P0 = 1) AND (P1 = 2)", "LV0 MOD 2", "Speed", "-P0 <> 0.5"];

/// Writes a form of a row with the values of a round.
pub(crate) fn write(row: &Command, form: &[String], round: usize) -> String {
    let mut out = String::new();
    let (mut axes, mut values) = (["X", "Y", "Z", "ARM"].into_iter().cycle(), 0);
    for token in form {
        let written = match token.as_str() {
            "axis" => axes.next().unwrap_or_default().to_owned(),
            placeholder if is_placeholder(placeholder) => {
                values += 1;
                value(row, placeholder, round + values).to_owned()
            }
            word => numbered(word),
        };
        if !(out.is_empty() || out.ends_with('#')) {
            out.push(' ');
        }
        out.push_str(&written);
    }
    out
}

fn is_placeholder(token: &str) -> bool {
    token.starts_with(|first: char| first.is_ascii_lowercase())
}

/// `AXISn` with a number for its letter, `_name` with a name.
fn numbered(word: &str) -> String {
    match word {
        "Px" => "P4097".to_owned(),
        "_name" => "_There".to_owned(),
        _ => match word.strip_suffix(|last: char| "nmab".contains(last)) {
            Some(object) if !object.is_empty() && !word.starts_with('"') => format!("{object}2"),
            _ => word.to_owned(),
        },
    }
}

fn value(row: &Command, placeholder: &str, round: usize) -> &'static str {
    let of = |values: [&'static str; ROUNDS]| values[round % ROUNDS];
    match (row.shape, placeholder) {
        (Shape::Attach, "position" | "velocity") => "ENC1",
        (Shape::Attach, "signal") => "DAC1",
        (Shape::Config, "encoders") => "ENC8",
        (Shape::Config, _) => ["NONE", "DAC4", "ADC8", "STEPPER4"][round % 4],
        (Shape::Free, "command") => "ALL",
        (Shape::Define, "name") => "Fresh",
        (Shape::Define, _) => ["P5", "BIT 24", "-3.5", "LA0(1)"][round % 4],
        (_, "name" | "alias") => "Flag",
        (_, "variable" | "operand") => of(if row.shape == Shape::For { COUNTERS } else { VARIABLES }),
        (_, "condition") => of(CONDITIONS),
        (_, "label") => "Here",
        (Shape::Target | Shape::LineNumber, "number") => "100",
        (_, "statement") => "SET 32",
        (_, "text") => "one, two: three",
        (_, "source" | "parameter") => of(SOURCES),
        (_, "array") => ["LA0", "SA1", "DA2", "LA(P0)"][round % 4],
        (_, "encoder") => "ENC2",
        (Shape::Index, _) => ["2", "0"][round % 2],
        (Shape::Bit | Shape::BitMove | Shape::Assignment, "index") => ["24", "8467"][round % 2],
        _ => of(NUMBERS),
    }
}
