//! A file of the guide on a controller, with a terminal and a record of what happens.

use std::sync::Arc;

use acrc_compile::{SourceUnit, compile};
use acrc_controller::world::{World, WorldEvent};
use acrc_controller::{ChannelId, Controller, FaultReport, Observer, Options, PromptState, Sent, State, View};
use acrc_image::{Image, UnitName};
use acrc_syntax::units::Level;

use crate::guide::Listing;

/// Ticks of a second.
const SECOND: f64 = 2000.0;
/// Axes whose positions are recorded.
const AXES: usize = 3;

/// The machine at one tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    pub(crate) seconds: f64,
    pub(crate) position: [f64; AXES],
    pub(crate) velocity: [f64; AXES],
    moving: bool,
}

impl Sample {
    /// Speed along the path.
    pub(crate) fn speed(&self) -> f64 {
        self.velocity.iter().map(|velocity| velocity * velocity).sum::<f64>().sqrt()
    }
}

/// A line that was printed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Line {
    pub(crate) seconds: f64,
    pub(crate) device: i32,
    pub(crate) text: String,
}

/// What a run tells.
#[derive(Default)]
pub(crate) struct Record {
    pub(crate) samples: Vec<Sample>,
    pub(crate) lines: Vec<Line>,
    pub(crate) faults: Vec<String>,
    /// Time and state of each change of the flag that is watched.
    pub(crate) changes: Vec<(f64, bool)>,
    flag: Option<u32>,
    master: u32,
    watched: bool,
}

impl Observer for Record {
    fn output(&mut self, sent: &Sent) {
        self.lines.push(Line { seconds: sent.seconds, device: sent.device, text: sent.text.to_owned() });
    }

    fn fault(&mut self, fault: &FaultReport) {
        self.faults.push(fault.message.clone());
    }

    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}

    fn tick(&mut self, view: &View) {
        let seconds = view.seconds();
        if let Some(state) = self.flag.map(|flag| view.bit(flag))
            && self.changes.last().map_or(state, |(_, last)| *last != state)
        {
            self.changes.push((seconds, state));
        }
        let axes: [u8; AXES] = [0, 1, 2];
        self.samples.push(Sample {
            seconds,
            position: axes.map(|axis| view.position(axis)),
            velocity: axes.map(|axis| view.motion(axis).0),
            moving: view.bit(516 + 32 * self.master),
        });
    }

    fn watches_every_tick(&self) -> bool {
        self.watched
    }
}

/// How a run is prepared.
#[derive(Clone, Copy, Default)]
pub(crate) struct Plan<'a> {
    /// Statements behind those of the context.
    pub(crate) before: &'a str,
    /// Lines at the end of the program.
    pub(crate) behind: &'a str,
    /// Replaced in the text.
    pub(crate) replaced: &'a [(&'a str, &'a str)],
    /// Seconds, a flag that comes from outside, and its new state.
    pub(crate) inputs: &'a [(f64, u32, bool)],
    /// Seconds, parameter, and the value that it gets from outside.
    pub(crate) parameters: &'a [(f64, &'a str, f64)],
    /// The mechanics of the axes.
    pub(crate) axes: &'a str,
    /// Seconds, port, and what is typed there.
    pub(crate) typed: &'a [(f64, &'a str, &'a str)],
    /// A flag whose changes are recorded.
    pub(crate) flag: Option<u32>,
    /// Only what is printed and what the watched flag does is of interest, not the way of the axes.
    pub(crate) unwatched: bool,
    pub(crate) seed: u64,
    pub(crate) no_battery: bool,
    pub(crate) idle: bool,
}

/// A controller that a file of the guide runs on.
pub(crate) struct Bench {
    pub(crate) controller: Controller,
    pub(crate) record: Record,
    channel: ChannelId,
}

impl Bench {
    /// The file as it is, started at power-up.
    pub(crate) fn of(listing: &Listing) -> Self {
        Self::planned(listing, &Plan::default())
    }

    /// The file in the circumstances of a plan, started at power-up unless the plan is idle.
    pub(crate) fn planned(listing: &Listing, plan: &Plan) -> Self {
        let mut text = listing.project_with(plan.before, plan.behind);
        for (from, to) in plan.replaced {
            assert!(text.contains(from), "{} has no {from:?}", listing.name);
            text = text.replace(from, to);
        }
        let programs = [listing.program()];
        let mut bench = Self::powered(&text, &listing.model, plan, if plan.idle { &[] } else { &programs });
        bench.record.master = u32::from(listing.program());
        bench
    }

    /// The context of a file only, at the prompt of its program.
    pub(crate) fn terminal(listing: &Listing) -> Self {
        Self::terminal_with(listing, "")
    }

    /// The same behind more statements.
    pub(crate) fn terminal_with(listing: &Listing, before: &str) -> Self {
        Self::terminal_planned(listing, &Plan { before, ..Plan::default() })
    }

    /// The same in the circumstances of a plan.
    pub(crate) fn terminal_planned(listing: &Listing, plan: &Plan) -> Self {
        let text = format!("SYS\n{}{}\n", listing.context, plan.before);
        let mut bench = Self::powered(&text, &listing.model, &Plan { unwatched: true, ..*plan }, &[]);
        if listing.context.contains("PROG") {
            let prompt = format!("PROG{}", listing.program());
            bench.ask(&prompt);
        }
        bench
    }

    /// The file typed line by line behind its context, and the answers.
    pub(crate) fn typed(listing: &Listing) -> (Self, Vec<String>) {
        let mut bench = Self::terminal(listing);
        let answers = listing.text.lines().filter(|line| !line.is_empty()).map(|line| bench.ask(line)).collect();
        (bench, answers)
    }

    /// Setup code of a test.
    pub(crate) fn setup(text: &str) -> Self {
        Self::powered(text, "ACR9000", &Plan { unwatched: true, ..Plan::default() }, &[])
    }

    /// The same on another model, without setup code.
    pub(crate) fn of_model(model: &str) -> Self {
        Self::powered("", model, &Plan { unwatched: true, ..Plan::default() }, &[])
    }

    /// The same with program 0 started and the world of a plan.
    pub(crate) fn powered_with(text: &str, plan: &Plan) -> Self {
        Self::powered(text, "ACR9000", plan, &[0])
    }

    fn powered(text: &str, model: &str, plan: &Plan, start: &[u8]) -> Self {
        let image = image(text, model).unwrap_or_else(|error| panic!("{error}\n{text}"));
        let options = Options { world: world(plan), seed: plan.seed, ..Options::default() };
        let mut controller =
            Controller::with_memory(Arc::new(image), options, !plan.no_battery, None).expect("compiled programs load");
        let stream = controller.model().streams[0].parse().expect("a stream of the model");
        let channel = controller.open_channel(stream).expect("nobody uses it");
        let mut record = Record { flag: plan.flag, watched: !plan.unwatched, ..Record::default() };
        controller.start_after_setup(start);
        controller.run_until(0, &mut record);
        Self { controller, record, channel }
    }

    pub(crate) fn switch_off_and_on(&mut self) {
        self.controller.power_cycle(&mut self.record);
    }

    /// Lets time pass.
    pub(crate) fn pass(&mut self, seconds: f64) -> &mut Self {
        self.controller.step((seconds * SECOND).round() as u64, &mut self.record);
        self
    }

    /// Types a line and gives the answer without echo and prompt.
    #[track_caller]
    pub(crate) fn ask(&mut self, line: &str) -> String {
        self.controller.receive(self.channel, format!("{line}\r").as_bytes());
        for _ in 0..100 {
            if self.controller.prompt_state(self.channel) != PromptState::Busy {
                break;
            }
            self.controller.step(1, &mut self.record);
        }
        let bytes = self.controller.take_output(self.channel);
        let answer: String = bytes.into_iter().map(char::from).collect();
        let PromptState::Ready(prompt) = self.controller.prompt_state(self.channel) else {
            return answer;
        };
        let answer = answer.strip_prefix(&format!("{line}\r\n")).unwrap_or_else(|| panic!("no echo in {answer:?}"));
        answer.strip_suffix(&prompt).unwrap_or_else(|| panic!("no prompt in {answer:?}")).replace("\r\n", "\n")
    }

    /// The number that a line is answered with.
    #[track_caller]
    pub(crate) fn number(&mut self, line: &str) -> f64 {
        let answer = self.ask(line);
        answer.trim().parse().unwrap_or_else(|_| panic!("{line}: {answer:?} is no number"))
    }

    pub(crate) fn bit(&self, number: i64) -> bool {
        self.controller.bit(number).expect("a flag")
    }

    /// Position of an axis, to a millionth.
    pub(crate) fn position(&self, axis: u8) -> f64 {
        (self.controller.view().position(axis) * 1e6).round() / 1e6
    }

    /// The level of the terminal.
    pub(crate) fn level(&self) -> String {
        self.controller.level(self.channel).to_string()
    }

    pub(crate) fn state(&self, program: u8) -> State {
        let programs = self.controller.programs();
        programs
            .iter()
            .find(|report| report.unit == UnitName::Program(program))
            .map_or(State::Idle, |report| report.state)
    }

    /// What was printed at a device, as lines; one that is still open too.
    pub(crate) fn printed(&self, device: i32) -> Vec<String> {
        let sent = self.record.lines.iter().filter(|line| line.device == device);
        let text: String = sent.map(|line| line.text.as_str()).collect();
        text.lines().map(str::to_owned).collect()
    }

    /// Nothing has gone wrong.
    #[track_caller]
    pub(crate) fn clean(&self) -> &Self {
        assert!(self.record.faults.is_empty(), "{:?}", self.record.faults);
        self
    }

    /// Times at which motion began and ended, for each stretch of motion that is over; moves of no length are left out.
    pub(crate) fn motions(&self) -> Vec<(f64, f64)> {
        let mut motions = Vec::new();
        let mut begin = None;
        for sample in &self.record.samples {
            match (begin, sample.moving) {
                (None, true) => begin = Some(sample.seconds),
                (Some(from), false) => {
                    if sample.seconds - from > 1.5 / SECOND {
                        motions.push((from, sample.seconds));
                    }
                    begin = None;
                }
                _ => {}
            }
        }
        motions
    }

    /// How long each stretch of motion took.
    pub(crate) fn durations(&self) -> Vec<f64> {
        self.motions().iter().map(|(begin, end)| end - begin).collect()
    }

    /// When the axes came closest to each point, one behind the other.
    #[track_caller]
    pub(crate) fn visits(&self, points: &[Vec<f64>]) -> Vec<f64> {
        let mut at = 0;
        let mut times = Vec::new();
        for point in points {
            let distance = |sample: &Sample| {
                point.iter().zip(sample.position).map(|(wanted, found)| (wanted - found).powi(2)).sum::<f64>().sqrt()
            };
            let samples = &self.record.samples;
            let near = (at..samples.len()).find(|index| distance(&samples[*index]) < 0.02);
            at = near.unwrap_or_else(|| panic!("{point:?} is not reached behind {:?} s", times.last()));
            while at + 1 < samples.len() && distance(&samples[at + 1]) < distance(&samples[at]) {
                at += 1;
            }
            assert!(distance(&samples[at]) < 1e-4, "{point:?} is passed by");
            times.push(samples[at].seconds);
        }
        times
    }

    /// The machine at a time.
    pub(crate) fn at(&self, seconds: f64) -> Sample {
        self.record.samples[(seconds * SECOND).round() as usize]
    }

    /// How long the watched flag was set, each time.
    pub(crate) fn set_times(&self) -> Vec<f64> {
        self.record.changes.chunks_exact(2).map(|pair| pair[1].0 - pair[0].0).collect()
    }

    /// When the watched flag was set.
    pub(crate) fn settings(&self) -> Vec<f64> {
        self.record.changes.iter().filter(|(_, state)| *state).map(|(seconds, _)| *seconds).collect()
    }
}

/// Compiles a project of one file.
pub(crate) fn image(text: &str, model: &str) -> Result<Image, String> {
    let tree = acrc_syntax::parse(text);
    let unit = SourceUnit { name: "guide", text, tree: &tree, start: Level::System, implicit_program: false };
    compile(&[unit], model).map_err(|errors| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
}

fn world(plan: &Plan) -> World {
    let inputs = plan.inputs.iter().map(|(at, input, state)| {
        let key = if *state { "set" } else { "clear" };
        format!("[[event]]\nat = {at:?}\n{key} = [{input}]\n")
    });
    let parameters = plan
        .parameters
        .iter()
        .map(|(at, name, value)| format!("[[event]]\nat = {at:?}\nparameters = {{ {name} = {value:?} }}\n"));
    let typed = plan.typed.iter().map(|(at, port, text)| {
        format!("[[event]]\nat = {at:?}\nstream = {port:?}\ntext = {text:?}\n").replace("\\u{1b}", "\\u001b")
    });
    let axes = std::iter::once(plan.axes.to_owned());
    World::parse(&inputs.chain(parameters).chain(typed).chain(axes).collect::<String>()).expect("the world of a test")
}

/// Whether two numbers agree.
#[track_caller]
pub(crate) fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found}, not {expected} within {tolerance}");
}
