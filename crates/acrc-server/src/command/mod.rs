//! Command connections: a terminal on port 5002, text and binary packets on port 5006.

mod binary;

use std::io;
use std::sync::Arc;
use std::time::Duration;

use acrc_controller::{ChannelId, Traffic};
use acrc_wire::binary::Requests;
use acrc_wire::{Channel, Decoder, Item, TRANSFER_TIMEOUT, Waiting};
use bytes::{Buf as _, BytesMut};
use tokio::io::AsyncReadExt as _;
use tokio::net::TcpStream;
use tokio::net::tcp::WriteHalf;
use tokio::sync::Notify;
use tokio::time::{Instant, sleep_until};

use crate::core::UNREAD;
use crate::event::{Event, Reason};
use crate::farewell::part;
use crate::registry::Membership;
use crate::shared::Shared;
use crate::statistics::Counters;

/// Bytes that are read at once.
const CHUNK: usize = 8192;
/// Bytes that a client has not read, above which it is not heard.
const FULL: usize = 64 * 1024;
/// Bytes that a client has not read, above which it is dropped.
const OVERFULL: usize = 4 * 1024 * 1024;
/// How long a client may be full.
const PATIENCE: Duration = Duration::from_secs(10);
/// How long a client that has ended its side gets answers to what it has sent.
const LINGER: Duration = Duration::from_secs(2);

/// A command connection that is served.
struct Connection {
    shared: Arc<Shared>,
    channel: ChannelId,
    /// Rung when the channel has something for the client.
    news: Arc<Notify>,
    membership: Membership,
    /// Only on port 5006.
    decoder: Option<Decoder<Requests>>,
    /// What is to be sent.
    out: BytesMut,
    traffic: Traffic,
    /// When a packet that is not complete is given up.
    gives_up: Option<Instant>,
    /// When a client that does not read, or has ended its side, is dropped.
    drops: Option<Instant>,
    /// The client has ended its side.
    ended: bool,
}

/// Serves a client until it goes. `packets` is for port 5006.
pub(crate) async fn serve(
    mut socket: TcpStream,
    shared: Arc<Shared>,
    membership: Membership,
    (channel, news): (ChannelId, Arc<Notify>),
    packets: bool,
) {
    let decoder = packets.then(|| Channel::ethernet().with_options(shared.wire).requests());
    let mut connection = Connection {
        shared,
        channel,
        news,
        membership,
        decoder,
        out: BytesMut::new(),
        traffic: Traffic::default(),
        gives_up: None,
        drops: None,
        ended: false,
    };
    let reason = connection.run(&mut socket).await;
    connection.finish(socket, reason).await;
}

impl Connection {
    async fn run(&mut self, socket: &mut TcpStream) -> Reason {
        let (mut reader, writer) = socket.split();
        let mut buffer = [0; CHUNK];
        loop {
            if let Err(reason) = self.write(&writer) {
                return reason;
            }
            let hears = !self.ended && self.out.len() < FULL && self.traffic.unread < UNREAD;
            tokio::select! {
                biased;
                reason = self.membership.dismissed() => return reason,
                () = self.news.notified() => self.fetch(),
                () = deadline(self.drops) => {
                    return if self.ended { Reason::Left } else { Reason::Stuck };
                }
                ready = writer.writable(), if !self.out.is_empty() => {
                    if ready.is_err() {
                        return Reason::Lost;
                    }
                }
                read = reader.read(&mut buffer), if hears => match read {
                    Ok(0) => self.end(),
                    Ok(count) => self.hear(buffer.get(..count).unwrap_or_default()),
                    Err(_) => return Reason::Lost,
                },
                () = deadline(self.gives_up), if self.gives_up.is_some() => self.give_up(),
            }
        }
    }

    /// Takes bytes of the client: all of them under one lock, and what is asked in packets is answered at once.
    fn hear(&mut self, mut bytes: &[u8]) {
        let mut core = self.shared.core();
        core.wake();
        let mut packets = 0;
        let mut changed = false;
        match &mut self.decoder {
            None => {
                core.controller.receive(self.channel, bytes);
                changed = true;
            }
            Some(decoder) => {
                while let Some(item) = decoder.next_item(&mut bytes) {
                    match item {
                        Item::Text(text) => {
                            core.controller.receive(self.channel, text);
                            changed = true;
                        }
                        Item::Packet(request) => {
                            packets += 1;
                            changed |= !request.is_answered();
                            binary::execute(&mut core, &request, &self.shared.wire, &mut self.out);
                        }
                        Item::Unreadable(problem) => self.shared.log(&Event::Unreadable {
                            service: self.membership.service,
                            peer: self.membership.peer,
                            problem: problem.to_string(),
                        }),
                    }
                }
                let waits = decoder.waiting() == Waiting::Transfer;
                self.gives_up = waits.then(|| Instant::now() + TRANSFER_TIMEOUT);
            }
        }
        self.traffic = core.controller.traffic(self.channel);
        if self.traffic.unread >= UNREAD {
            core.hold_back(self.channel);
        }
        if changed {
            self.shared.release(core);
        } else {
            drop(core);
        }
        Counters::add(&self.shared.counters.packets, packets);
    }

    /// The time between two bytes of a packet is over.
    fn give_up(&mut self) {
        self.gives_up = None;
        if let Some(decoder) = &mut self.decoder {
            decoder.time_out();
        }
    }

    /// Takes what the channel has for the client.
    fn fetch(&mut self) {
        let mut core = self.shared.core();
        let sent = core.take_output(self.channel);
        self.traffic = core.controller.traffic(self.channel);
        drop(core);
        self.out.extend_from_slice(&sent);
    }

    /// The client will send nothing more. What it has sent is answered.
    fn end(&mut self) {
        self.ended = true;
        self.drops = Some(Instant::now() + LINGER);
    }

    /// Sends as much as the socket takes, and sees whether the client reads.
    fn write(&mut self, socket: &WriteHalf<'_>) -> Result<(), Reason> {
        while !self.out.is_empty() {
            match socket.try_write(&self.out) {
                Ok(count) => self.out.advance(count),
                Err(error) if error.kind() == io::ErrorKind::WouldBlock => break,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(_) => return Err(Reason::Lost),
            }
        }
        if self.out.len() > OVERFULL {
            return Err(Reason::Stuck);
        }
        if self.ended {
            let traffic = self.shared.core().controller.traffic(self.channel);
            let done = self.out.is_empty() && traffic == Traffic::default();
            return if done { Err(Reason::Left) } else { Ok(()) };
        }
        if self.out.len() < FULL {
            self.drops = None;
        } else if self.drops.is_none() {
            self.drops = Some(Instant::now() + PATIENCE);
        }
        Ok(())
    }

    /// Frees the stream, then lets the client read its last bytes.
    async fn finish(self, socket: TcpStream, reason: Reason) {
        let Self { shared, channel, membership, mut out, .. } = self;
        {
            let mut core = shared.core();
            out.extend_from_slice(&core.take_output(channel));
            core.close(channel);
        }
        membership.leave();
        shared.log(&Event::Disconnected { service: membership.service, peer: membership.peer, reason });
        match reason {
            Reason::Stuck | Reason::Lost => drop(socket),
            Reason::Left | Reason::Watchdog | Reason::ClosedDown => part(socket, &out).await,
        }
    }
}

/// Sleeps until an instant, for ever without one.
async fn deadline(instant: Option<Instant>) {
    match instant {
        Some(instant) => sleep_until(instant).await,
        None => std::future::pending().await,
    }
}
