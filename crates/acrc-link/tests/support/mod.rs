//! A controller in the same process, and lines to it: what a connection carries goes straight to a channel, and its time
//! is virtual.
#![allow(dead_code, reason = "each test binary uses a part")]

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::io::{self, ErrorKind};
use std::rc::Rc;
use std::sync::Arc;
use std::time::Duration;

use acrc_compile::{SourceUnit, compile};
use acrc_controller::world::WorldEvent;
use acrc_controller::{ChannelId, Controller, FaultReport, Observer, Options, PromptState, Sent, View};
use acrc_image::Image;
use acrc_link::{Connection, Console as _, Protocol, Settings, Transport};
use acrc_syntax::units::Level;

/// The streams of Ethernet clients.
const STREAMS: [&str; 4] = ["STREAM2", "STREAM3", "STREAM4", "STREAM5"];

/// A controller that several lines may lead to.
#[derive(Clone)]
pub(crate) struct Machine(Rc<RefCell<Controller>>);

impl Machine {
    /// With factory settings.
    pub(crate) fn new() -> Self {
        Self::with("")
    }

    /// Behind setup code.
    pub(crate) fn with(setup: &str) -> Self {
        let tree = acrc_syntax::parse(setup);
        let unit =
            SourceUnit { name: "setup.8K", text: setup, tree: &tree, start: Level::System, implicit_program: false };
        Self::of(compile(&[unit], "ACR9000").unwrap_or_else(|errors| panic!("{setup}\n{errors:#?}")))
    }

    /// With what an image holds.
    pub(crate) fn of(image: Image) -> Self {
        let mut controller = Controller::new(Arc::new(image), Options::default()).expect("setup code loads");
        controller.run_until(0, &mut Silent);
        Self(Rc::new(RefCell::new(controller)))
    }

    /// A line to the first stream that nobody uses.
    pub(crate) fn line(&self) -> Line {
        let mut controller = self.0.borrow_mut();
        let open = |name: &str| controller.open_channel(name.parse().expect("a stream")).ok();
        let channel = STREAMS.into_iter().find_map(open).expect("a stream is free");
        drop(controller);
        Line {
            machine: self.clone(),
            channel: Some(channel),
            lives: usize::MAX,
            unread: VecDeque::new(),
            carried: Rc::default(),
        }
    }

    /// Types a line at a connection of its own.
    pub(crate) fn connect_and_type(&self, line: &str) {
        self.connect().command(line).expect("it is answered");
    }

    /// A connection that speaks text.
    pub(crate) fn connect(&self) -> Connection<Line> {
        self.line().connect()
    }

    /// Looks at the controller, or changes it.
    pub(crate) fn look<R>(&self, look: impl FnOnce(&mut Controller) -> R) -> R {
        look(&mut self.0.borrow_mut())
    }

    /// Lets virtual time pass.
    pub(crate) fn pass(&self, seconds: f64) {
        self.look(|controller| {
            let ticks = (seconds / controller.view().period()).round() as u64;
            controller.step(ticks, &mut Silent);
        });
    }
}

/// A line to a controller.
pub(crate) struct Line {
    machine: Machine,
    channel: Option<ChannelId>,
    /// How many more bytes are carried before it breaks.
    lives: usize,
    /// What the controller has sent and was not read.
    unread: VecDeque<u8>,
    /// The bytes that it has carried.
    carried: Rc<Cell<usize>>,
}

impl Line {
    /// The same line, which breaks when so many bytes have been sent.
    pub(crate) fn breaking_after(self, bytes: usize) -> Self {
        let mut line = self;
        line.lives = bytes;
        line
    }

    /// A connection over it that speaks text.
    pub(crate) fn connect(self) -> Connection<Self> {
        self.try_connect().expect("the controller shows a prompt")
    }

    /// The same for one that may break at once.
    pub(crate) fn try_connect(self) -> Result<Connection<Self>, acrc_link::LinkError> {
        Connection::over(self, "the machine".to_owned(), Protocol::Text, Settings::default())
    }

    /// The bytes that it carries from here on.
    pub(crate) fn counted(&self) -> Rc<Cell<usize>> {
        self.carried.clone()
    }

    /// The channel that it leads to.
    pub(crate) fn channel(&self) -> ChannelId {
        self.channel.expect("the line is not broken")
    }

    /// Drops what the controller has sent so far.
    pub(crate) fn forget(&mut self) {
        let channel = self.channel();
        self.machine.look(|controller| controller.take_output(channel));
    }

    fn break_off(&mut self) {
        if let Some(channel) = self.channel.take() {
            self.machine.look(|controller| controller.close_channel(channel));
        }
    }
}

impl Transport for Line {
    fn read_within(&mut self, buffer: &mut [u8], longest: Duration) -> io::Result<Option<usize>> {
        let Some(channel) = self.channel else { return Ok(Some(0)) };
        let end = self.machine.look(|controller| controller.seconds()) + longest.as_secs_f64();
        while self.unread.is_empty() {
            let (output, over) = self.machine.look(|controller| {
                let busy = controller.prompt_state(channel) == PromptState::Busy;
                let over = controller.seconds() >= end;
                // Pieces that a statement leaves while it waits come one by one.
                let output = if busy && !over { Vec::new() } else { controller.take_output(channel) };
                if output.is_empty() && !over {
                    controller.step(1, &mut Silent);
                }
                (output, over)
            });
            self.unread.extend(output);
            if over && self.unread.is_empty() {
                return Ok(None);
            }
        }
        let count = self.unread.len().min(buffer.len());
        for (place, byte) in buffer.iter_mut().zip(self.unread.drain(..count)) {
            *place = byte;
        }
        Ok(Some(count))
    }

    fn write_within(&mut self, bytes: &[u8], _: Duration) -> io::Result<()> {
        let Some(channel) = self.channel else { return Err(ErrorKind::BrokenPipe.into()) };
        let carried = bytes.get(..self.lives).unwrap_or(bytes);
        self.machine.look(|controller| controller.receive(channel, carried));
        self.lives -= carried.len();
        self.carried.set(self.carried.get() + carried.len());
        if carried.len() < bytes.len() {
            self.break_off();
            return Err(ErrorKind::BrokenPipe.into());
        }
        Ok(())
    }

    fn close(&mut self) {
        self.break_off();
    }
}

impl Drop for Line {
    fn drop(&mut self) {
        self.break_off();
    }
}

/// Whom nothing interests.
pub(crate) struct Silent;

impl Observer for Silent {
    fn output(&mut self, _: &Sent) {}

    fn fault(&mut self, _: &FaultReport) {}

    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}

    fn tick(&mut self, _: &View) {}

    fn watches_every_tick(&self) -> bool {
        false
    }
}
