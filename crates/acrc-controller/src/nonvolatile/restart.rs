//! The machine at a restart: what begins anew and what goes on.

use acrc_catalog::law;

use super::Operation;
use crate::machine::Machine;
use crate::request::Request;
use crate::world::{INPUTS, World};

impl Machine {
    /// Power comes back, or the controller restarts: everything is as at power-up, but time and the world go on, and what outlasts a reset
    /// beside working memory is kept.
    pub(crate) fn restart(&mut self) {
        let fresh = Self::new(self.model, World::default(), self.random);
        let before = std::mem::replace(self, fresh);
        self.clock = before.clock;
        self.clock_base = (self.clock.ticks(), 0);
        self.restarts = before.restarts + 1;
        self.nonvolatile = before.nonvolatile;
        self.network = before.network;
        self.terminal = before.terminal;
        self.terminal.restart();
        for channel in self.terminal.ids() {
            self.flag_echo(channel);
        }
        self.streams = before.streams;
        self.streams.restart();
        self.notes = before.notes;
        self.world = before.world;
        self.backlash = before.backlash;
        self.mechanics = before.mechanics;
        self.mechanics.restart();
        self.next_event = before.next_event;
        let inputs = (0..INPUTS).chain(self.world.driven_inputs());
        for input in inputs.filter(|input| before.flags.get(*input)) {
            self.flags.set(input, true);
        }
        if before.flags.get(law::MEI_OPEN.at(0)) {
            self.flags.set_law(law::MEI_OPEN, 0, true);
            self.flags.set_law(law::MEI_LATCHED, 0, true);
        }
        for axis in self.mechanics.blind() {
            self.flags.set_law(law::ENCODER_SIGNAL_LOST, u32::from(axis), true);
        }
        for (axis, before) in self.axes.iter_mut().zip(before.axes) {
            axis.statistics = before.statistics;
            axis.was_enabled = before.was_enabled;
        }
        for (master, before) in self.masters.iter_mut().zip(before.masters) {
            master.statistics = before.statistics;
        }
    }

    /// Whether there is an image in flash memory, or will be when what was asked for is done.
    pub(crate) fn has_image(&self) -> bool {
        let mut there = self.nonvolatile.image.is_some();
        for request in &self.requests {
            match request {
                Request::Memories(Operation::FlashPrograms | Operation::FlashEverything) => there = true,
                Request::Memories(Operation::EraseFlash) => there = false,
                _ => {}
            }
        }
        there
    }
}
