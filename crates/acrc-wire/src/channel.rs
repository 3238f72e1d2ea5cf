//! One line between a client and a controller.

use crate::binary::{Replies, Requests};
use crate::{Decoder, Mode, Reply, Request, WireOptions};

/// How packets and text share a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Framing {
    /// Bytes as they come, on serial and FIFO channels: whatever is not the header of a packet is text.
    Bare(Mode),
    /// What a client sends comes in packets of four bytes, filled up with zeros (TCP 5006; Ethernet specification, "Byte
    /// Packing and Padding"). What the controller sends is neither packed nor padded.
    Packed,
}

/// One line between a client and a controller: its framing, and how the documents are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Channel {
    /// How packets and text share it.
    pub framing: Framing,
    /// How the documents are read.
    pub options: WireOptions,
}

impl Channel {
    /// Port 5006.
    pub fn ethernet() -> Self {
        Self { framing: Framing::Packed, options: WireOptions::default() }
    }

    /// A FIFO channel as it begins, `MODE 0`.
    pub fn fifo() -> Self {
        Self { framing: Framing::Bare(Mode::Plain), options: WireOptions::default() }
    }

    /// A serial channel as it begins, `MODE 1`.
    pub fn serial() -> Self {
        Self { framing: Framing::Bare(Mode::Prefixed), options: WireOptions::default() }
    }

    /// The same line with other readings of the documents.
    #[must_use]
    pub const fn with_options(self, options: WireOptions) -> Self {
        Self { options, ..self }
    }

    /// Encodes what a client asks for.
    pub fn request(&self, request: &Request<'_>, out: &mut impl Extend<u8>) {
        match self.mode() {
            Mode::Plain => request.put(self, out),
            mode => request.put(self, &mut Escaping { out, mode, begun: false }),
        }
    }

    /// Encodes what the controller answers.
    pub fn reply(&self, reply: &Reply<'_>, out: &mut impl Extend<u8>) {
        match self.mode() {
            Mode::Plain => reply.put(out),
            mode => reply.put(&mut Escaping { out, mode, begun: false }),
        }
    }

    /// Encodes text that a client sends, filled up with zeros where that is needed.
    pub fn text(&self, text: &[u8], out: &mut impl Extend<u8>) {
        out.extend(text.iter().copied());
        if self.framing == Framing::Packed {
            out.extend(core::iter::repeat_n(0, padding(text.len())));
        }
    }

    /// Decodes what clients send: the controller's end.
    pub fn requests(&self) -> Decoder<Requests> {
        Decoder::new(*self)
    }

    /// Decodes what the controller sends: the client's end.
    pub fn replies(&self) -> Decoder<Replies> {
        Decoder::new(*self)
    }

    /// How bytes of transfers are converted.
    pub(crate) const fn mode(&self) -> Mode {
        match self.framing {
            Framing::Bare(mode) => mode,
            Framing::Packed => Mode::Plain,
        }
    }
}

/// How many zeros fill up so many bytes to a multiple of four.
pub(crate) const fn padding(len: usize) -> usize {
    len.wrapping_neg() % 4
}

/// Converts what is written, except for the header byte.
struct Escaping<'a, O> {
    out: &'a mut O,
    mode: Mode,
    begun: bool,
}

impl<O: Extend<u8>> Extend<u8> for Escaping<'_, O> {
    fn extend<I: IntoIterator<Item = u8>>(&mut self, bytes: I) {
        for byte in bytes {
            let mode = if self.begun { self.mode } else { Mode::Plain };
            self.out.extend(mode.escape(byte));
            self.begun = true;
        }
    }
}
