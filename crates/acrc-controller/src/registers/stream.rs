//! Echo and prompt of a stream as flags: what `ECHO` sets can be set by number, too. Clients do that with the flags of their own stream.

use acrc_catalog::law;

use crate::machine::Machine;
use crate::terminal::{ChannelId, StreamName};

/// The stream that has the first word of stream flags (`docs/fidelity.md`, terminal).
const FIRST_STREAM: u8 = 2;
/// How many words there are.
const WORDS: u8 = 4;

/// The place of a stream among those that have a word of flags.
fn word_of(stream: StreamName) -> Option<u8> {
    let StreamName::Stream(number) = stream else { return None };
    number.checked_sub(FIRST_STREAM).filter(|place| *place < WORDS)
}

impl Machine {
    /// The flags of a stream have changed: its channel does what they say.
    pub(super) fn echo_as_flagged(&mut self, word: u8) {
        let [echo, no_prompt] =
            [law::STREAM_ECHO, law::STREAM_NO_PROMPT].map(|law| self.flags.get(law.at(u32::from(word))));
        self.terminal.set_echo(StreamName::Stream(FIRST_STREAM + word), echo, no_prompt);
    }

    /// A channel has been opened, or its `ECHO` given: the flags of its stream say what it does.
    pub(crate) fn flag_echo(&mut self, channel: ChannelId) {
        let Some(channel) = self.terminal.get(channel) else { return };
        let Some(word) = word_of(channel.stream) else { return };
        let (echo, no_prompt) = (channel.echoes(), channel.hides_prompt());
        for (law, state) in [(law::STREAM_ECHO, echo), (law::STREAM_NO_PROMPT, no_prompt)] {
            self.flags.set_law(law, u32::from(word), state);
        }
    }
}
