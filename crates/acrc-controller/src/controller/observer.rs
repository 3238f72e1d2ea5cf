//! Who watches a run.

use super::View;
use crate::report::FaultReport;
use crate::world::WorldEvent;

/// Receives what a run produces, while it happens.
pub trait Observer {
    /// Text that a program (`None`: setup code) sends to a device. Lines end with CR LF.
    fn output(&mut self, seconds: f64, program: Option<u8>, device: i32, text: &str);
    /// A run-time error.
    fn fault(&mut self, fault: &FaultReport);
    /// The world has changed inputs.
    fn event(&mut self, seconds: f64, event: &WorldEvent, view: &View);
    /// A tick is over: the machine has moved and a program has had its slice. The first one is at time zero.
    fn tick(&mut self, view: &View);
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
