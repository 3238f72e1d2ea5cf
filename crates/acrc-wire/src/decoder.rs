//! From bytes, in whatever pieces they arrive, to packets.

use core::fmt::Debug;
use core::marker::PhantomData;

use crate::{Channel, Framing, LONGEST_PACKET, Malformed, Mode, Unescape};

/// One direction of a connection: which packets come there.
pub trait Side {
    /// The packets.
    type Packet<'a>: Debug;

    /// Whether bytes come in packets of four there, if the channel is packed.
    const PACKED: bool;

    /// What the first bytes of a packet say about its length. Without any byte they say how many are needed.
    fn size(head: &[u8], channel: &Channel) -> Size;

    /// Reads a packet of the length that [`Side::size`] gave.
    fn decode<'a>(bytes: &'a [u8], channel: &Channel) -> Result<Self::Packet<'a>, Malformed>;
}

/// What the first bytes of a packet say about its length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// No packet begins with them.
    Text,
    /// They say nothing before there are so many.
    AtLeast(usize),
    /// So many bytes.
    Exactly(usize),
}

/// What a decoder finds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item<'a, P> {
    /// Bytes that belong to no packet: never none, possibly a part of a line.
    Text(&'a [u8]),
    /// A packet.
    Packet(P),
    /// A packet that cannot be read. Its bytes are used up.
    Unreadable(Malformed),
}

/// What a decoder waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Waiting {
    /// For anything.
    Nothing,
    /// For the rest of four bytes of text.
    Text,
    /// For the rest of a packet: the time between two bytes counts ([`TRANSFER_TIMEOUT`](crate::TRANSFER_TIMEOUT)).
    Transfer,
}

/// Decodes one direction of one connection.
///
/// It keeps the beginning of a packet that is not complete, at most [`LONGEST_PACKET`] bytes. How the bytes are cut into
/// pieces makes no difference to the packets, and to text only by where it is cut.
#[derive(Clone, Debug)]
pub struct Decoder<S> {
    channel: Channel,
    unescape: Unescape,
    buffer: [u8; LONGEST_PACKET],
    len: usize,
    /// The length at which the buffer is worth looking at again.
    wanted: usize,
    side: PhantomData<S>,
}

impl<S: Side> Decoder<S> {
    pub(crate) fn new(channel: Channel) -> Self {
        Self {
            channel,
            unescape: Unescape::default(),
            buffer: [0; LONGEST_PACKET],
            len: 0,
            wanted: 0,
            side: PhantomData,
        }
    }

    /// The next packet or run of text. What is used of `input` is taken off its front. Without a result all of it is used,
    /// and more is needed.
    pub fn next_item<'a, 'i: 'a>(&'a mut self, input: &mut &'i [u8]) -> Option<Item<'a, S::Packet<'a>>> {
        let in_place = if self.len == 0 { self.in_place(input) } else { None };
        if let Some(bytes) = in_place {
            return Some(self.read(bytes));
        }
        let len = self.collect(input)?;
        self.buffer.get(..len).map(|bytes| self.read(bytes))
    }

    /// What the decoder is in the middle of.
    pub fn waiting(&self) -> Waiting {
        let head = self.buffer.get(..self.len).unwrap_or_default();
        match S::size(head, &self.channel) {
            _ if head.is_empty() => Waiting::Nothing,
            Size::Text => Waiting::Text,
            Size::AtLeast(_) | Size::Exactly(_) => Waiting::Transfer,
        }
    }

    /// Gives up a packet that is not complete, as a controller does when the time between two bytes is over, and says how
    /// many of its bytes are lost. Text is kept.
    pub fn time_out(&mut self) -> usize {
        if self.waiting() != Waiting::Transfer {
            return 0;
        }
        self.unescape = Unescape::default();
        self.wanted = 0;
        core::mem::take(&mut self.len)
    }

    /// Changes how bytes of transfers are converted (`MODE`), for those that come from now on. Packed channels
    /// convert nothing.
    pub fn set_mode(&mut self, mode: Mode) {
        if let Framing::Bare(current) = &mut self.channel.framing {
            *current = mode;
        }
    }

    fn packed(&self) -> bool {
        S::PACKED && self.channel.framing == Framing::Packed
    }

    /// The size of what begins with these bytes, of which there is at least one.
    fn size(&self, head: &[u8]) -> Size {
        match S::size(head, &self.channel) {
            Size::Text if self.packed() => Size::Exactly(4),
            size => size,
        }
    }

    /// What begins at the input and is complete there, without copying it.
    fn in_place<'i>(&self, input: &mut &'i [u8]) -> Option<&'i [u8]> {
        loop {
            let len = match self.size(input.get(..1)?) {
                Size::Text => self.text(input),
                _ if self.channel.mode() != Mode::Plain => return None,
                Size::Exactly(len) => len,
                Size::AtLeast(_) => match self.size(input) {
                    Size::Exactly(len) => len,
                    Size::Text | Size::AtLeast(_) => return None,
                },
            };
            let (bytes, rest) = input.split_at_checked(len)?;
            *input = rest;
            if !self.is_filling(bytes) {
                return Some(bytes);
            }
        }
    }

    /// How many bytes of text the input begins with.
    fn text(&self, input: &[u8]) -> usize {
        let packet = |byte: &u8| S::size(core::slice::from_ref(byte), &self.channel) != Size::Text;
        input.iter().position(packet).unwrap_or(input.len())
    }

    /// Takes bytes until a packet is complete, and gives its length.
    fn collect(&mut self, input: &mut &[u8]) -> Option<usize> {
        while let Some((&byte, rest)) = input.split_first() {
            *input = rest;
            let mode = if self.len == 0 { Mode::Plain } else { self.channel.mode() };
            let Some(byte) = self.unescape.push(mode, byte) else { continue };
            *self.buffer.get_mut(self.len)? = byte;
            self.len += 1;
            if self.len < self.wanted {
                continue;
            }
            let head = self.buffer.get(..self.len)?;
            match self.size(head) {
                Size::AtLeast(wanted) => self.wanted = wanted,
                Size::Exactly(wanted) if wanted > self.len => self.wanted = wanted,
                Size::Text | Size::Exactly(_) => {
                    let filling = self.is_filling(head);
                    let len = core::mem::take(&mut self.len);
                    self.wanted = 0;
                    if !filling {
                        return Some(len);
                    }
                }
            }
        }
        None
    }

    /// Four zeros on a packed channel are no request, but what a client filled up with.
    fn is_filling(&self, bytes: &[u8]) -> bool {
        self.packed() && bytes == [0; 4]
    }

    fn read<'a>(&self, bytes: &'a [u8]) -> Item<'a, S::Packet<'a>> {
        match S::size(bytes, &self.channel) {
            Size::Text => Item::Text(self.without_filling(bytes)),
            Size::AtLeast(_) | Size::Exactly(_) => match S::decode(bytes, &self.channel) {
                Ok(packet) => Item::Packet(packet),
                Err(malformed) => Item::Unreadable(malformed),
            },
        }
    }

    fn without_filling<'a>(&self, text: &'a [u8]) -> &'a [u8] {
        let zeros = if self.packed() { text.iter().rev().take_while(|byte| **byte == 0).count() } else { 0 };
        text.get(..text.len() - zeros).unwrap_or(text)
    }
}
