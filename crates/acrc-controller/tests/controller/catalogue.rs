//! Every parameter and flag of the catalogue: its first, middle and last number keep what is written, whichever way it is reached.

use std::fmt::Write as _;

use acrc_catalog::{
    Access, AddressLaw, BitKind, BitRow, Confidence, ObjectKind, ParameterRow, Space, ValueType, all_bits,
    all_parameters,
};
use acrc_vm::Value;

use crate::support::{Ran, Sim};

/// A model with every object that the catalogue numbers.
const LARGEST: &str = "ACR9030";

/// Setup code, and what it should print: the value behind what it is of.
#[derive(Default)]
struct Script {
    text: String,
    expected: Vec<String>,
}

impl Script {
    fn new() -> Self {
        Self { text: "SYS\nDIM P(4096)\n".to_owned(), expected: Vec::new() }
    }

    fn execute(&mut self, statement: &str) {
        let _ = writeln!(self.text, "{statement}");
    }

    /// A statement that prints one value.
    fn expect(&mut self, statement: &str, value: &str) {
        self.execute(&format!("PRINT \"{statement} \";\n{statement}"));
        self.expected.push(format!("{statement} "));
        self.expected.push(value.to_owned());
    }

    fn run(&self) -> Ran {
        Sim::new(&self.text).model(LARGEST).watched(false).run()
    }

    #[track_caller]
    fn check(&self) -> Ran {
        let ran = self.run().clean();
        let printed: Vec<&str> = ran.record.output.iter().map(|line| &*line.text).collect();
        for (printed, expected) in printed.chunks(2).zip(self.expected.chunks(2)) {
            assert_eq!(printed, expected);
        }
        assert_eq!(printed.len(), self.expected.len());
        ran
    }
}

/// The first, the middle and the last place of a row.
fn places(law: &AddressLaw) -> Vec<u32> {
    let mut places = vec![0, law.count / 2, law.count - 1];
    places.dedup();
    places
}

fn read_only(access: Access, confidence: Confidence) -> bool {
    access == Access::Read && confidence != Confidence::Low
}

fn writable_parameters() -> impl Iterator<Item = &'static ParameterRow> {
    let follows =
        |row: &ParameterRow| ["vector_velocity", "master_speed", "jog_acceleration_current"].contains(&row.field);
    all_parameters()
        .filter(move |row| row.object != Space::Flags && !read_only(row.access, row.confidence) && !follows(row))
}

/// A value that the row can keep, different for each part of a command.
fn value(row: &ParameterRow) -> &'static str {
    match (row.ty, row.set_by.map_or(0, |set_by| set_by.part)) {
        (Some(ValueType::Long), _) => "3",
        (_, 0) => "1.5",
        _ => "-2.5",
    }
}

#[test]
fn every_parameter_keeps_what_is_written() {
    let mut script = Script::new();
    for row in writable_parameters() {
        for number in places(&row.law).into_iter().filter_map(|place| row.law.number(place)) {
            script.execute(&format!("P{number} = {}", value(row)));
            script.expect(&format!("PRINT P{number}"), value(row));
        }
    }
    script.check();
}

#[test]
fn a_setting_and_its_parameter_are_one_value() {
    let mut script = Script::new();
    for row in writable_parameters() {
        let Some(command) = row.set_by.map(|set_by| set_by.command.info()) else { continue };
        for place in places(&row.law) {
            let (number, kind) = (row.law.number(place).expect("a place"), command.prefixes[0]);
            let word = if kind == ObjectKind::Axis { command.name } else { command.word };
            let setting = format!("{kind}{} {word}", row.law.object_index(place).expect("an object"));
            if command.tuple_max > 1 {
                script.execute(&format!("{setting} (1.5, -2.5)"));
            } else {
                script.execute(&format!("{setting} 1.5"));
                script.expect(&setting, "1.5");
                script.execute(&format!("P{number} = 2"));
                script.expect(&setting, "2");
                script.execute(&format!("{setting} 1.5"));
            }
            script.expect(&format!("PRINT P{number}"), value(row));
        }
    }
    assert!(script.expected.len() > 200);
    script.check();
}

#[test]
fn read_only_parameters_refuse_every_write() {
    let mut script = Script::new();
    let rows = all_parameters().filter(|row| read_only(row.access, row.confidence));
    let numbers: Vec<u32> =
        rows.flat_map(|row| places(&row.law).into_iter().filter_map(|place| row.law.number(place))).collect();
    for number in &numbers {
        script.execute(&format!("P{number} = 1"));
    }
    let ran = script.run();
    assert_eq!(ran.record.faults.len(), numbers.len());
    for (fault, number) in ran.record.faults.iter().zip(numbers) {
        assert!(fault.message.starts_with(&format!("P{number} (")), "{fault}");
    }
}

/// What a flag reads after it was set.
fn after_set(row: &BitRow) -> &'static str {
    // A program that does not run cannot be paused, and an axis that does not jog cannot stop.
    let clears = row.kind == BitKind::Request && row.confidence != Confidence::Low;
    let commands = ["program_pause", "plc_run_request", "plc_halt_request", "jog_stopping"].contains(&row.field);
    if clears || commands { "0" } else { "-1" }
}

#[test]
fn every_flag_keeps_its_state_or_clears_itself_or_refuses() {
    let mut script = Script::new();
    let mut refused = 0;
    let mut numbers = Vec::new();
    for row in all_bits() {
        for number in places(&row.law).into_iter().filter_map(|place| row.law.number(place)) {
            // A smaller row within a larger one decides.
            if acrc_catalog::bit(number).row != Some(row) {
                continue;
            }
            numbers.push(number);
            script.execute(&format!("SET {number}"));
            if read_only(row.access, row.confidence) {
                refused += 1;
            } else {
                script.expect(&format!("PRINT BIT({number})"), after_set(row));
            }
        }
    }
    let ran = script.run();
    assert_eq!(ran.record.faults.len(), refused);
    assert!(ran.record.faults.iter().all(|fault| fault.message.ends_with("is read-only")));
    let printed: Vec<&str> = ran.record.output.iter().map(|line| &*line.text).collect();
    assert_eq!(printed, script.expected);
    assert_words_agree(&ran);
}

#[test]
fn every_word_is_its_flags() {
    let mut script = Script::new();
    let words = acrc_catalog::all_flag_words().flat_map(|words| words.law.first..=words.law.last());
    // Programs and masters do things when their flags change; the other words keep any pattern in what is not read-only.
    for word in words
        .filter(|word| !(4112..4120).contains(word) && !(4128..4144).contains(word) && !(4328..4336).contains(word))
    {
        let pattern = word.wrapping_mul(0x9e37_79b9);
        for index in (0..32).filter(|index| pattern >> index & 1 == 1) {
            let bit = acrc_catalog::bit((word - 4096) * 32 + index);
            if !read_only(bit.access, bit.confidence) {
                script.execute(&format!("BIT({}) = 1", bit.number));
            }
        }
        script.execute(&format!("P{word} = P{word}"));
    }
    let ran = script.run();
    assert!(ran.record.faults.iter().all(|fault| fault.message.ends_with("is read-only")), "{:?}", ran.record.faults);
    assert_words_agree(&ran);
}

#[track_caller]
fn assert_words_agree(ran: &Ran) {
    for word in 4096..4648 {
        let flags = (0..32).fold(0_u32, |flags, index| flags | u32::from(ran.bit((word - 4096) * 32 + index)) << index);
        assert_eq!(ran.controller.parameter(word), Ok(Value::Long(flags as i32)), "P{word}");
    }
}
