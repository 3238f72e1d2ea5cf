//! A person at a terminal of a controller.

use std::sync::Arc;

use acrc_compile::{SourceUnit, compile};
use acrc_controller::world::WorldEvent;
use acrc_controller::{ChannelId, Controller, FaultReport, Observer, Options, PromptState, Sent, View};
use acrc_syntax::units::Level;

/// Two axes of program 0 that need 1.1 seconds for 10 units.
pub(crate) const TWO_AXES: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\n\
                                   ACC 100 DEC 100 STP 100 VEL 10\n";

/// Ticks of a second.
const SECOND: u64 = 2000;

/// Keeps what the run tells besides the channels.
#[derive(Default)]
pub(crate) struct Log {
    pub(crate) faults: Vec<String>,
    pub(crate) output: Vec<String>,
}

impl Observer for Log {
    fn output(&mut self, sent: &Sent) {
        self.output.push(sent.text.to_owned());
    }

    fn fault(&mut self, fault: &FaultReport) {
        self.faults.push(fault.to_string());
    }

    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}

    fn tick(&mut self, _: &View) {}

    fn watches_every_tick(&self) -> bool {
        false
    }
}

/// A controller and a channel to it.
pub(crate) struct Desk {
    pub(crate) controller: Controller,
    pub(crate) channel: ChannelId,
    pub(crate) log: Log,
}

impl Desk {
    /// At the system prompt of a controller with factory settings.
    pub(crate) fn new() -> Self {
        Self::with("")
    }

    /// Behind setup code.
    pub(crate) fn with(setup: &str) -> Self {
        Self::of_model(setup, "ACR9000")
    }

    pub(crate) fn of_model(setup: &str, model: &str) -> Self {
        let tree = acrc_syntax::parse(setup);
        let unit =
            SourceUnit { name: "setup.8K", text: setup, tree: &tree, start: Level::System, implicit_program: false };
        let image = compile(&[unit], model).unwrap_or_else(|errors| panic!("{setup}\n{errors:#?}"));
        let mut controller = Controller::new(Arc::new(image), Options::default()).expect("setup code loads");
        let stream = controller.model().streams[0].parse().expect("a stream of the model");
        let channel = controller.open_channel(stream).expect("nobody uses it");
        let mut log = Log::default();
        controller.run_until(0, &mut log);
        Self { controller, channel, log }
    }

    /// At the prompt of program 0 with the axes X and Y.
    pub(crate) fn machine() -> Self {
        let mut desk = Self::with(TWO_AXES);
        desk.send("PROG0\r");
        desk
    }

    /// Types text and gives what comes back before the channel is ready again, a second later at the latest.
    pub(crate) fn send(&mut self, text: &str) -> String {
        self.controller.receive(self.channel, text.as_bytes());
        let end = self.ticks() + SECOND;
        while self.ticks() < end && self.controller.prompt_state(self.channel) == PromptState::Busy {
            self.controller.step(1, &mut self.log);
        }
        self.read()
    }

    /// Types lines and gives the answer to each: what comes back, without the echo and the prompt.
    #[track_caller]
    pub(crate) fn ask(&mut self, line: &str) -> String {
        let answer = self.send(&format!("{line}\r"));
        let rest = answer.strip_prefix(&format!("{line}\r\n")).unwrap_or_else(|| panic!("no echo in {answer:?}"));
        let state = self.controller.prompt_state(self.channel);
        let PromptState::Ready(prompt) = state else { panic!("not ready after {line:?}: {state:?}, {answer:?}") };
        rest.strip_suffix(&prompt).unwrap_or_else(|| panic!("no prompt {prompt:?} in {answer:?}")).to_owned()
    }

    /// Lets time pass and gives what comes meanwhile.
    pub(crate) fn wait(&mut self, seconds: f64) -> String {
        self.controller.step((seconds * SECOND as f64) as u64, &mut self.log);
        self.read()
    }

    pub(crate) fn read(&mut self) -> String {
        self.controller.take_output(self.channel).into_iter().map(char::from).collect()
    }

    pub(crate) fn bit(&self, number: i64) -> bool {
        self.controller.bit(number).expect("a flag")
    }

    fn ticks(&self) -> u64 {
        self.controller.view().ticks()
    }
}
