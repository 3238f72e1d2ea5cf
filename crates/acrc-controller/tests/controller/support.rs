//! Runs program text on a controller and keeps what it produced.

use std::sync::Arc;

use acrc_compile::{SourceUnit, compile};
use acrc_controller::world::{World, WorldEvent};
use acrc_controller::{BacklashRule, Controller, FaultReport, Observer, Options, Port, Sent, Stopped, View};
use acrc_image::{Image, UnitName};
use acrc_syntax::units::Level;

/// Attaches X and Y to program 0 and gives its master round numbers: a move of 10 units takes 1.1 seconds.
pub(crate) const TWO_AXES: &str = "SYS\nDIM P(10)\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\n\
                                   ACC 100 DEC 100 STP 100 VEL 10\n";

/// The same with Z as a third axis.
pub(crate) const THREE_AXES: &str = "SYS\nDIM P(10)\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\n\
                                     ATTACH SLAVE2 AXIS2 \"Z\"\nACC 100 DEC 100 STP 100 VEL 10\n";

/// Round numbers for the jog profilers of X and Y, too: a jog of 10 units takes 1.1 seconds. Registers count thousandths of a unit.
pub(crate) const JOGS: &str = "PPU X1000 Y1000\nJOG ACC X100 Y100\nJOG DEC X100 Y100\nJOG VEL X10 Y10\n";

/// A run to be made.
pub(crate) struct Sim {
    text: String,
    start: Vec<u8>,
    until: f64,
    world: String,
    typed: Vec<(&'static str, &'static str)>,
    seed: u64,
    model: &'static str,
    watched: bool,
    plc_scan: Option<f64>,
    backlash: BacklashRule,
}

impl Sim {
    /// A project of one file, entered at the system prompt. Nothing is started but by the text itself.
    pub(crate) fn new(text: &str) -> Self {
        Self {
            text: text.to_owned(),
            start: Vec::new(),
            until: 60.0,
            world: String::new(),
            typed: Vec::new(),
            seed: 0,
            model: "ACR9000",
            watched: true,
            plc_scan: None,
            backlash: BacklashRule::default(),
        }
    }

    /// Program 0 with the axes X and Y, started.
    pub(crate) fn program(body: &str) -> Self {
        Self::new(&format!("{TWO_AXES}PROGRAM\n{body}\nENDP\n")).start(&[0])
    }

    /// Program 0 with the axes X, Y and Z, started.
    pub(crate) fn in_space(body: &str) -> Self {
        Self::new(&format!("{THREE_AXES}PROGRAM\n{body}\nENDP\n")).start(&[0])
    }

    /// The same with [`JOGS`] and more setup code.
    pub(crate) fn jogging(setup: &str, body: &str) -> Self {
        Self::new(&format!("{TWO_AXES}{JOGS}{setup}\nPROGRAM\n{body}\nENDP\n")).start(&[0])
    }

    pub(crate) fn start(mut self, programs: &[u8]) -> Self {
        self.start = programs.to_vec();
        self
    }

    pub(crate) fn until(mut self, seconds: f64) -> Self {
        self.until = seconds;
        self
    }

    pub(crate) fn world(mut self, world: &str) -> Self {
        world.clone_into(&mut self.world);
        self
    }

    /// Offers text at a port.
    pub(crate) fn offer(mut self, port: &'static str, text: &'static str) -> Self {
        self.typed.push((port, text));
        self
    }

    pub(crate) fn seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }

    pub(crate) fn model(mut self, model: &'static str) -> Self {
        self.model = model;
        self
    }

    /// Seconds from one scan of the PLC programs to the next.
    pub(crate) fn plc_scan(mut self, seconds: f64) -> Self {
        self.plc_scan = Some(seconds);
        self
    }

    /// Backlash compensation goes by the direction of travel.
    pub(crate) fn travel_backlash(mut self) -> Self {
        self.backlash = BacklashRule::PositiveTravel;
        self
    }

    /// Whether the observer is shown every tick.
    pub(crate) fn watched(mut self, watched: bool) -> Self {
        self.watched = watched;
        self
    }

    pub(crate) fn image(&self) -> Image {
        let tree = acrc_syntax::parse(&self.text);
        let unit = SourceUnit {
            name: "test.8K",
            text: &self.text,
            tree: &tree,
            start: Level::System,
            implicit_program: false,
        };
        compile(&[unit], self.model).unwrap_or_else(|errors| panic!("{}\n{errors:#?}", self.text))
    }

    /// The controller at power-up, for a test that lets time pass itself.
    pub(crate) fn controller(&self) -> Controller {
        let world = World::parse(&self.world).expect("the world of a test is valid");
        let options =
            Options { world, seed: self.seed, plc_scan: self.plc_scan, backlash: self.backlash, ..Options::default() };
        Controller::new(Arc::new(self.image()), options).expect("compiled programs load")
    }

    pub(crate) fn run(&self) -> Ran {
        let mut controller = self.controller();
        for (port, text) in &self.typed {
            controller.offer(port.parse::<Port>().expect("a port"), text.as_bytes());
        }
        let mut record = Record { watched: self.watched, ..Record::default() };
        let stopped = controller.run(&self.start, self.until, &mut record);
        Ran { controller, stopped, record }
    }

    /// The lines printed, without time and source.
    pub(crate) fn prints(&self) -> Vec<String> {
        self.run().clean().record.output.into_iter().map(|line| line.text).collect()
    }

    /// The lines printed, behind their time in milliseconds.
    pub(crate) fn timed(&self) -> Vec<String> {
        let ran = self.run().clean();
        ran.record.output.into_iter().map(|line| format!("{} {}", line.milliseconds, line.text)).collect()
    }

    /// The messages of all faults.
    pub(crate) fn faults(&self) -> Vec<String> {
        self.run().record.faults.into_iter().map(|fault| fault.message).collect()
    }
}

/// A line of output.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Line {
    pub(crate) milliseconds: f64,
    pub(crate) program: Option<u8>,
    pub(crate) device: i32,
    pub(crate) stream: Option<String>,
    pub(crate) text: String,
}

/// What a run produced.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Record {
    pub(crate) output: Vec<Line>,
    pub(crate) faults: Vec<FaultReport>,
    /// Milliseconds and note of each event of the world.
    pub(crate) events: Vec<(f64, String)>,
    pub(crate) ticks: u64,
    watched: bool,
}

impl Observer for Record {
    fn output(&mut self, sent: &Sent) {
        let program = match sent.unit {
            UnitName::Program(number) => Some(number),
            UnitName::Boot | UnitName::Plc(_) => None,
        };
        let text = sent.text.strip_suffix("\r\n").unwrap_or(sent.text).to_owned();
        let stream = sent.stream.map(|stream| stream.to_string());
        let milliseconds = milliseconds(sent.seconds);
        self.output.push(Line { milliseconds, program, device: sent.device, stream, text });
    }

    fn fault(&mut self, fault: &FaultReport) {
        self.faults.push(fault.clone());
    }

    fn event(&mut self, seconds: f64, event: &WorldEvent, _: &View) {
        self.events.push((milliseconds(seconds), event.note.clone().unwrap_or_default()));
    }

    fn tick(&mut self, _: &View) {
        self.ticks += 1;
    }

    fn watches_every_tick(&self) -> bool {
        self.watched
    }
}

/// Rounded to a tenth of a microsecond, so that a test can write the number down.
fn milliseconds(seconds: f64) -> f64 {
    (seconds * 1e7).round() / 1e4
}

/// A run that is over.
pub(crate) struct Ran {
    pub(crate) controller: Controller,
    pub(crate) stopped: Stopped,
    pub(crate) record: Record,
}

impl Ran {
    /// The same run, which had no fault.
    #[track_caller]
    pub(crate) fn clean(self) -> Self {
        assert!(self.record.faults.is_empty(), "{:#?}", self.record.faults);
        self
    }

    /// Position of an axis in units, to a millionth.
    pub(crate) fn position(&self, axis: u8) -> f64 {
        (self.controller.view().position(axis) * 1e6).round() / 1e6
    }

    /// Velocity of an axis in units/s, to a millionth.
    pub(crate) fn velocity(&self, axis: u8) -> f64 {
        (self.controller.view().motion(axis).0 * 1e6).round() / 1e6
    }

    /// State of a flag.
    pub(crate) fn bit(&self, number: i64) -> bool {
        self.controller.bit(number).expect("a flag that exists")
    }

    /// The end of the run in milliseconds.
    pub(crate) fn milliseconds(&self) -> f64 {
        milliseconds(self.controller.seconds())
    }

    pub(crate) fn notes(&self) -> Vec<String> {
        self.controller.notes().map(str::to_owned).collect()
    }
}
