//! A small controller for tests, and programs from text.
#![allow(dead_code, reason = "every test file uses its own part")]

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fmt::Write as _;

use acrc_catalog::command;
use acrc_compile::{SourceUnit, compile};
use acrc_image::{Image, Unit};
use acrc_syntax::units::Level;
use acrc_vm::{
    Arg, Budget, Call, Code, FaultKind, Frame, Host, LoadError, Locals, Outcome, Run, Stop, Text, Value, format, run,
};

/// Memory of the test program.
pub(crate) const MEMORY: u64 = 100_000;

/// Compiles a text that is typed at the prompt of program 0, or its stored program.
pub(crate) fn image(text: &str, stored: bool) -> Image {
    let tree = acrc_syntax::parse(text);
    assert!(tree.errors().is_empty(), "{text}\n{:#?}", tree.errors());
    let file = SourceUnit { name: "test", text, tree: &tree, start: Level::Program(0), implicit_program: stored };
    compile(&[file], "ACR9000").unwrap_or_else(|errors| panic!("{text}\n{errors:#?}"))
}

/// The stored program of an image.
pub(crate) fn program(image: &Image) -> &Unit {
    image.programs.first().unwrap_or(&image.boot)
}

/// Loads a stored program.
pub(crate) fn try_load(text: &str) -> Result<Code, LoadError> {
    let image = image(text, true);
    Code::load(program(&image), &image.aliases)
}

/// Loads a stored program.
pub(crate) fn load(text: &str) -> Code {
    try_load(text).unwrap_or_else(|error| panic!("{text}\n{error} at {:?}", error.location))
}

/// A controller of parameters, flags and a log.
#[derive(Default)]
pub(crate) struct Bench {
    /// Parameters that were written; others read as 0.
    pub(crate) parameters: BTreeMap<i64, Value>,
    /// Flags that are set.
    pub(crate) bits: BTreeSet<i64>,
    /// What `PRINT` sent to any device.
    pub(crate) output: String,
    /// Other commands, one a line.
    pub(crate) log: String,
    /// Characters that wait.
    pub(crate) keys: VecDeque<u8>,
    /// Lines for `INPUT`.
    pub(crate) lines: VecDeque<&'static str>,
    /// How often `DWL` has to be offered before it is done.
    pub(crate) patience: u32,
    pub(crate) waited: u32,
    pub(crate) seed: u32,
    /// Statements that were reported.
    pub(crate) trace: Vec<u32>,
}

/// Parameters and flags from here on do not exist.
const END: i64 = 100_000;

impl Host for Bench {
    fn parameter(&mut self, number: i64) -> Result<Value, FaultKind> {
        match number {
            0..END => Ok(self.parameters.get(&number).cloned().unwrap_or_default()),
            _ => Err(FaultKind::UnknownParameter(number)),
        }
    }

    fn set_parameter(&mut self, number: i64, value: &Value) -> Result<(), FaultKind> {
        match number {
            0..4096 => self.parameters.insert(number, Value::Double(value.to_f64()?)),
            12288 => return Err(FaultKind::ReadOnlyParameter(number)),
            38912..39168 => self.parameters.insert(number, Value::Long(value.to_long()?)),
            39168..39424 => self.parameters.insert(number, Value::Single(value.to_f64()? as f32)),
            _ => return Err(FaultKind::UnknownParameter(number)),
        };
        Ok(())
    }

    fn bit(&mut self, number: i64) -> Result<bool, FaultKind> {
        if (0..END).contains(&number) { Ok(self.bits.contains(&number)) } else { Err(FaultKind::UnknownBit(number)) }
    }

    fn set_bit(&mut self, number: i64, state: bool) -> Result<(), FaultKind> {
        match number {
            0..24 => return Err(FaultKind::ReadOnlyBit(number)),
            24..END if state => self.bits.insert(number),
            24..END => self.bits.remove(&number),
            _ => return Err(FaultKind::UnknownBit(number)),
        };
        Ok(())
    }

    fn command(&mut self, call: &Call) -> Result<Outcome, FaultKind> {
        match call.command {
            command::PRINT | command::QUESTION => {
                let printed = format::print_line(call.arguments)?;
                self.output.extend(printed.bytes.into_iter().map(char::from));
            }
            command::DWL if self.waited < self.patience => {
                assert_eq!(call.first, self.waited == 0);
                self.waited += 1;
                return Ok(Outcome::Again);
            }
            command::HALT => return Ok(Outcome::End),
            command::INPUT => match self.lines.pop_front() {
                Some(line) => return Ok(Outcome::Input(Text::from(line))),
                None => return Ok(Outcome::Again),
            },
            command::FLASH_IMAGE => return Err(FaultKind::Unsupported(call.command)),
            _ => self.log(call),
        }
        Ok(Outcome::Done)
    }

    fn random(&mut self, below: u32) -> u32 {
        self.seed = self.seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        ((u64::from(self.seed) * u64::from(below)) >> 32) as u32
    }

    fn take_character(&mut self, _device: i32) -> Result<Option<u8>, FaultKind> {
        Ok(self.keys.pop_front())
    }

    fn character_waits(&mut self, _device: i32) -> Result<bool, FaultKind> {
        Ok(!self.keys.is_empty())
    }
}

/// The same controller with somebody who watches the statements.
struct Watched<'a>(&'a mut Bench);

impl Host for Watched<'_> {
    const WATCHES_STATEMENTS: bool = true;

    fn statement(&mut self, pc: u32) {
        self.0.trace.push(pc);
    }

    fn parameter(&mut self, number: i64) -> Result<Value, FaultKind> {
        self.0.parameter(number)
    }

    fn set_parameter(&mut self, number: i64, value: &Value) -> Result<(), FaultKind> {
        self.0.set_parameter(number, value)
    }

    fn bit(&mut self, number: i64) -> Result<bool, FaultKind> {
        self.0.bit(number)
    }

    fn set_bit(&mut self, number: i64, state: bool) -> Result<(), FaultKind> {
        self.0.set_bit(number, state)
    }

    fn command(&mut self, call: &Call) -> Result<Outcome, FaultKind> {
        self.0.command(call)
    }

    fn random(&mut self, below: u32) -> u32 {
        self.0.random(below)
    }

    fn take_character(&mut self, device: i32) -> Result<Option<u8>, FaultKind> {
        self.0.take_character(device)
    }

    fn character_waits(&mut self, device: i32) -> Result<bool, FaultKind> {
        self.0.character_waits(device)
    }
}

impl Bench {
    fn log(&mut self, call: &Call) {
        self.waited = 0;
        let name = call.command.info().name;
        let prefix =
            call.prefix.map(|(kind, index)| format!("{kind}{} ", index.unwrap_or_default())).unwrap_or_default();
        let arguments: Vec<String> = call.arguments.iter().map(show).collect();
        let _ = writeln!(self.log, "{prefix}{name}: {}", arguments.join(", "));
    }
}

/// An argument, short.
fn show(argument: &Arg) -> String {
    format!("{argument:?}")
}

/// A machine with one program.
pub(crate) struct Machine {
    pub(crate) code: Code,
    pub(crate) frame: Frame,
    pub(crate) locals: Locals,
    pub(crate) bench: Bench,
}

impl Machine {
    /// With a stored program.
    pub(crate) fn new(text: &str) -> Self {
        Self::with(load(text))
    }

    /// With loaded code.
    pub(crate) fn with(code: Code) -> Self {
        Self { code, frame: Frame::new(), locals: Locals::new(MEMORY), bench: Bench::default() }
    }

    /// Runs with a budget.
    pub(crate) fn run(&mut self, budget: Budget) -> Run {
        run(&self.code, &mut self.frame, &mut self.locals, &mut self.bench, budget)
    }

    /// Runs with a budget, and takes note of every statement.
    pub(crate) fn run_watched(&mut self, budget: Budget) -> Run {
        run(&self.code, &mut self.frame, &mut self.locals, &mut Watched(&mut self.bench), budget)
    }

    /// Runs to the end, or for 100,000 lines.
    pub(crate) fn finish(&mut self) -> Stop {
        self.run(Budget::lines(100_000)).stop
    }
}

/// What a program prints; a fault is shown behind it with its place.
pub(crate) fn output(text: &str) -> String {
    let mut machine = Machine::new(text);
    let stop = machine.finish();
    let mut shown = machine.bench.output;
    match stop {
        Stop::Ended => {}
        Stop::Fault(fault) => {
            let place = fault.location(&machine.code);
            let _ = write!(shown, "{fault} [line {}, statement {}]", place.line, place.statement);
        }
        other => {
            let _ = write!(shown, "{other:?}");
        }
    }
    shown
}

/// What an expression prints, with some variables around.
pub(crate) fn value(expression: &str) -> String {
    let text = format!(
        "DIM LV(4)\nDIM SV(4)\nDIM DV(4)\nDIM $V(4,20)\n\
         LV0=7 : LV1=-3 : SV0=2.5 : SV1=0.1 : DV0=0.25 : DV1=-1.5 : $V0=\"Axis\" : P38912=5 : P39168=1.5 : P0=0.5\n\
         PRINT {expression}"
    );
    output(&text).trim_end_matches("\r\n").to_owned()
}
