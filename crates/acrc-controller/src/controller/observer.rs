//! Who watches a run.

use acrc_image::UnitName;

use super::View;
use crate::nonvolatile::Saved;
use crate::report::FaultReport;
use crate::terminal::StreamName;
use crate::world::WorldEvent;

/// Text that was sent to a device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sent<'a> {
    /// Virtual time in seconds.
    pub seconds: f64,
    /// The program or PLC program that sent it; `Boot` for setup code, and for the terminal of a stream.
    pub unit: UnitName,
    /// The device.
    pub device: i32,
    /// The stream that it went to; `None` for whoever listens to the program.
    pub stream: Option<StreamName>,
    /// The characters.
    pub text: &'a str,
}

/// Receives what a run produces, while it happens.
pub trait Observer {
    /// Text was sent to a device. Lines end with CR LF.
    fn output(&mut self, sent: &Sent);
    /// A run-time error.
    fn fault(&mut self, fault: &FaultReport);
    /// The world has changed inputs.
    fn event(&mut self, seconds: f64, event: &WorldEvent, view: &View);
    /// A tick is over: the machine has moved and a program has had its slice. The first one is at time zero.
    fn tick(&mut self, view: &View);
    /// A command has changed what outlasts a reset.
    fn saved(&mut self, _: &Saved) {}
    /// Whether [`Observer::tick`] is to be called for every tick. Without, those in which nothing moves and at most one
    /// program computes may be left out, and an hour of waiting costs no time.
    fn watches_every_tick(&self) -> bool {
        true
    }
    /// Asked now and then: true ends the run.
    fn interrupted(&mut self) -> bool {
        false
    }
}
