//! Data sampling: parameters recorded into arrays of programs (guide, command list: `SAMP`).
//!
//! From the moment the trigger flag is set, every channel stores its parameter once a servo period, until its array is full.

use acrc_catalog::command;
use acrc_vm::{Reference, Source, Value};

use super::tables::{ArrayPlace, Arrays};
use crate::machine::Machine;
use crate::settings::Item;

/// Channels of a controller.
pub(super) const CHANNELS: usize = 8;

/// What is sampled.
#[derive(Clone, Debug, Default)]
pub(super) struct Sampling {
    /// The flag that starts it.
    pub(super) trigger: Option<u32>,
    triggered: bool,
    channels: [Channel; CHANNELS],
}

#[derive(Clone, Copy, Debug, Default)]
struct Channel {
    source: Option<i64>,
    array: Option<ArrayPlace>,
    /// Samples stored since the trigger; `None` when none is under way.
    count: Option<usize>,
}

impl Machine {
    /// Gives every channel the settings of now.
    pub(super) fn refresh_sampling(&mut self) {
        self.motion.sampling.trigger = match self.setting(command::SAMP_TRG, 0).unwrap_or_default().first() {
            Some(Item::Source(Source::Reference(Reference::Bit(flag)))) => u32::try_from(*flag).ok(),
            _ => None,
        };
        for number in 0..CHANNELS {
            let source = self.parameter_setting(command::SAMP_SRC, number as u16);
            self.motion.sampling.channels[number].source = source;
        }
    }

    /// Names the array of a channel (`SAMP BASE`).
    pub(crate) fn set_sample_array(&mut self, channel: usize, array: ArrayPlace) {
        if let Some(channel) = self.motion.sampling.channels.get_mut(channel) {
            channel.array = Some(array);
        }
    }

    /// Forgets what is sampled (`SAMP CLEAR`).
    pub(crate) fn clear_sampling(&mut self) {
        self.motion.sampling = Sampling::default();
        self.motion.touch();
    }

    /// Whether the trigger has changed, as the controller itself may let it.
    pub(crate) fn is_sampling_due(&self) -> bool {
        let sampling = &self.motion.sampling;
        sampling.trigger.is_some_and(|trigger| self.flags.get(trigger) != sampling.triggered)
    }

    /// Stores a sample of each channel that is under way.
    pub(super) fn advance_sampling(&mut self, arrays: &mut dyn Arrays) {
        let Some(trigger) = self.motion.sampling.trigger else { return };
        let set = self.flags.get(trigger);
        let before = std::mem::replace(&mut self.motion.sampling.triggered, set);
        let rises = set && !before;
        for number in 0..CHANNELS {
            let channel = &mut self.motion.sampling.channels[number];
            if rises {
                channel.count = Some(0);
            }
            let Channel { source: Some(source), array: Some(array), count: Some(count) } = *channel else { continue };
            let value = self.read_parameter(source).unwrap_or(Value::Long(0));
            let stored = arrays.store(array, count, &value);
            self.motion.sampling.channels[number].count = stored.then_some(count + 1);
            self.motion.awake |= stored;
        }
    }
}
