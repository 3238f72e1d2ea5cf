//! What clients of port 5006 send: packets and text.

use acrc_controller::{ChannelId, HostError, HostMove, Queued};
use acrc_wire::binary::Requests;
use acrc_wire::{Channel, Decoder, Item, Malformed, Request, TRANSFER_TIMEOUT, Waiting, WireOptions};
use bytes::BytesMut;
use tokio::time::Instant;

use super::binary;
use crate::core::Core;

/// Reads packets and text, and executes them.
pub(super) struct Packets {
    decoder: Decoder<Requests>,
    wire: WireOptions,
    /// A move for which its master has no room yet. What was sent behind it waits with it.
    held: Option<HostMove>,
    waiting: Vec<u8>,
    /// When a packet that is not complete is given up.
    pub(super) gives_up: Option<Instant>,
}

/// What some bytes were.
#[derive(Debug, Default)]
pub(super) struct Heard {
    /// How many packets.
    pub(super) packets: u64,
    /// Something may go on now in the controller.
    pub(super) changed: bool,
    /// What could not be read.
    pub(super) unreadable: Vec<Malformed>,
    /// What the controller has refused.
    pub(super) refused: Vec<HostError>,
}

impl Packets {
    pub(super) fn new(wire: WireOptions) -> Self {
        let decoder = Channel::ethernet().with_options(wire).requests();
        Self { decoder, wire, held: None, waiting: Vec::new(), gives_up: None }
    }

    /// Whether a move waits for its master, so that nothing more is taken.
    pub(super) fn is_held(&self) -> bool {
        self.held.is_some()
    }

    /// Takes bytes of the client. Answers go behind `out`.
    pub(super) fn hear(&mut self, bytes: &[u8], channel: ChannelId, core: &mut Core, out: &mut BytesMut) -> Heard {
        let mut heard = Heard::default();
        self.take(bytes, channel, core, out, &mut heard);
        heard
    }

    /// Tries again with the move that waits.
    pub(super) fn go_on(&mut self, channel: ChannelId, core: &mut Core, out: &mut BytesMut) -> Heard {
        let mut heard = Heard::default();
        let Some(held) = self.held.take() else { return heard };
        match binary::queue(core, &held) {
            Ok(Queued::Yes) => {}
            Ok(Queued::NoRoom) => {
                self.held = Some(held);
                return heard;
            }
            Err(refusal) => heard.refused.push(refusal),
        }
        heard.changed = true;
        let waiting = std::mem::take(&mut self.waiting);
        self.take(&waiting, channel, core, out, &mut heard);
        heard
    }

    fn take(&mut self, mut bytes: &[u8], channel: ChannelId, core: &mut Core, out: &mut BytesMut, heard: &mut Heard) {
        while let Some(item) = self.decoder.next_item(&mut bytes) {
            match item {
                Item::Text(text) => {
                    core.controller.receive(channel, text);
                    heard.changed = true;
                }
                Item::Packet(Request::Move(packet)) => {
                    heard.packets += 1;
                    heard.changed = true;
                    let Some(ordered) = binary::ordered(core, &packet) else { continue };
                    match binary::queue(core, &ordered) {
                        Ok(Queued::Yes) => {}
                        Ok(Queued::NoRoom) => {
                            self.held = Some(ordered);
                            self.waiting.extend_from_slice(bytes);
                            return;
                        }
                        Err(refusal) => heard.refused.push(refusal),
                    }
                }
                Item::Packet(request) => {
                    heard.packets += 1;
                    heard.changed |= !request.is_answered();
                    heard.refused.extend(binary::execute(core, &request, &self.wire, out).err());
                }
                Item::Unreadable(problem) => heard.unreadable.push(problem),
            }
        }
        let waits = self.decoder.waiting() == Waiting::Transfer;
        self.gives_up = waits.then(|| Instant::now() + TRANSFER_TIMEOUT);
    }

    /// The time between two bytes of a packet is over.
    pub(super) fn give_up(&mut self) {
        self.gives_up = None;
        self.decoder.time_out();
    }
}
