//! A controller that a host is connected to.

use std::sync::Arc;

use acrc_compile::{SourceUnit, compile};
use acrc_controller::world::WorldEvent;
use acrc_controller::{ChannelId, Controller, FaultReport, Observer, Options, Sent, View};
use acrc_syntax::units::Level;

/// X and Y of program 0, with 1000 pulses a unit. A move of 10 units takes 1.1 seconds.
pub(crate) const TWO_AXES: &str = "SYS\nDIM P(10)\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\n\
                                   PPU X1000 Y1000\nACC 100 DEC 100 STP 100 VEL 10\n";

/// Ticks of a second.
const SECOND: f64 = 2000.0;

/// Keeps what a run tells.
#[derive(Default)]
pub(crate) struct Log {
    pub(crate) faults: Vec<String>,
    pub(crate) output: String,
}

impl Observer for Log {
    fn output(&mut self, sent: &Sent) {
        self.output.push_str(sent.text);
    }

    fn fault(&mut self, fault: &FaultReport) {
        self.faults.push(fault.message.clone());
    }

    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}

    fn tick(&mut self, _: &View) {}

    fn watches_every_tick(&self) -> bool {
        false
    }
}

/// A controller, what it has told, and a terminal at its prompt.
pub(crate) struct Bench {
    pub(crate) controller: Controller,
    pub(crate) log: Log,
    terminal: ChannelId,
}

impl Bench {
    /// Behind setup code.
    pub(crate) fn new(setup: &str) -> Self {
        Self::with(setup, Options::default())
    }

    pub(crate) fn with(setup: &str, options: Options) -> Self {
        Self::of_model(setup, "ACR9000", options)
    }

    pub(crate) fn of_model(setup: &str, model: &str, options: Options) -> Self {
        let tree = acrc_syntax::parse(setup);
        let unit =
            SourceUnit { name: "test.8K", text: setup, tree: &tree, start: Level::System, implicit_program: false };
        let image = compile(&[unit], model).unwrap_or_else(|errors| panic!("{setup}\n{errors:#?}"));
        let mut controller = Controller::new(Arc::new(image), options).expect("compiled programs load");
        let mut log = Log::default();
        controller.step(10, &mut log);
        assert_eq!(log.faults, [""; 0], "{setup}");
        let open = |name: &str| controller.open_channel(name.parse().expect("a stream"));
        let terminal = ["STREAM2", "COM1"].into_iter().map(open).find_map(Result::ok).expect("a free stream");
        let mut bench = Self { controller, log, terminal };
        bench.ask("ECHO 0");
        bench
    }

    /// Lets time pass.
    pub(crate) fn pass(&mut self, seconds: f64) {
        self.controller.step((seconds * SECOND) as u64, &mut self.log);
    }

    /// What the terminal answers to a line, without prompts and spaces.
    pub(crate) fn ask(&mut self, line: &str) -> String {
        self.controller.receive(self.terminal, format!("{line}\r").as_bytes());
        self.controller.step(200, &mut self.log);
        let answer: String = self.controller.take_output(self.terminal).into_iter().map(char::from).collect();
        let lines = answer.split("\r\n").filter(|line| !line.ends_with('>'));
        lines.map(str::trim).filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ")
    }

    /// Position of an axis in units, to a millionth.
    pub(crate) fn position(&self, axis: u8) -> f64 {
        (self.controller.view().position(axis) * 1e6).round() / 1e6
    }

    pub(crate) fn flag(&self, number: u32) -> bool {
        self.controller.view().bit(number)
    }

    pub(crate) fn set_long(&mut self, parameter: u32, value: i32) -> Result<(), String> {
        self.controller.set_parameter_long(parameter, value, &mut self.log).map_err(|error| error.to_string())
    }

    pub(crate) fn set_single(&mut self, parameter: u32, value: f32) -> Result<(), String> {
        self.controller.set_parameter_single(parameter, value, &mut self.log).map_err(|error| error.to_string())
    }

    pub(crate) fn mask(&mut self, parameter: u32, clear: u32, set: u32) -> Result<(), String> {
        self.controller.mask_parameter(parameter, clear, set, &mut self.log).map_err(|error| error.to_string())
    }

    pub(crate) fn set_flag(&mut self, flag: u32, state: bool) -> Result<(), String> {
        self.controller.set_flag(flag, state, &mut self.log).map_err(|error| error.to_string())
    }
}
