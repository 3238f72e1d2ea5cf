//! Command connections: a terminal on port 5002, text and binary packets on port 5006.

mod binary;
mod packets;

use std::io;
use std::sync::Arc;
use std::time::Duration;

use acrc_controller::{ChannelId, Traffic};
use bytes::{Buf as _, BytesMut};
use parking_lot::MutexGuard;
use tokio::io::{AsyncReadExt as _, Interest, Ready};
use tokio::net::TcpStream;
use tokio::net::tcp::WriteHalf;
use tokio::sync::Notify;
use tokio::time::{Instant, sleep_until};

use self::packets::{Heard, Packets};
use crate::core::{Core, UNREAD};
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
/// How long a client that has ended its side gets answers to what it has sent.
const LINGER: Duration = Duration::from_secs(1);

/// A command connection that is served.
struct Connection {
    shared: Arc<Shared>,
    channel: ChannelId,
    /// Rung when the channel has something for the client.
    news: Arc<Notify>,
    membership: Membership,
    /// Only on port 5006.
    packets: Option<Packets>,
    /// What is to be sent.
    out: BytesMut,
    traffic: Traffic,
    /// When it is looked whether a client that is not heard is still there.
    looks: Option<Instant>,
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
    let packets = packets.then(|| Packets::new(shared.wire));
    let mut connection = Connection {
        shared,
        channel,
        news,
        membership,
        packets,
        out: BytesMut::new(),
        traffic: Traffic::default(),
        looks: None,
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
            let hears = self.hears();
            self.looks = if hears || self.ended { None } else { self.looks.or(Some(self.patience())) };
            let gives_up = self.packets.as_ref().and_then(|packets| packets.gives_up);
            tokio::select! {
                biased;
                reason = self.membership.dismissed() => return reason,
                () = self.news.notified() => self.look(),
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
                () = deadline(gives_up), if gives_up.is_some() => {
                    if let Some(packets) = &mut self.packets {
                        packets.give_up();
                    }
                }
                () = deadline(self.looks) => {
                    self.looks = None;
                    if has_closed(&writer).await {
                        return Reason::Left;
                    }
                }
            }
        }
    }

    /// Takes bytes of the client: all of them under one lock, and what is asked in packets is answered at once.
    fn hear(&mut self, bytes: &[u8]) {
        let shared = Arc::clone(&self.shared);
        let mut core = shared.core();
        core.wake();
        let heard = match &mut self.packets {
            None => {
                core.controller.receive(self.channel, bytes);
                Heard { changed: true, ..Heard::default() }
            }
            Some(packets) => packets.hear(bytes, self.channel, &mut core, &mut self.out),
        };
        self.conclude(core, &heard);
    }

    /// There is news from the channel: output, or room for what waits.
    fn look(&mut self) {
        let shared = Arc::clone(&self.shared);
        let mut core = shared.core();
        let sent = core.take_output(self.channel);
        self.out.extend_from_slice(&sent);
        let heard = match &mut self.packets {
            Some(packets) if packets.is_held() => packets.go_on(self.channel, &mut core, &mut self.out),
            _ => Heard::default(),
        };
        self.conclude(core, &heard);
    }

    fn conclude(&mut self, mut core: MutexGuard<'_, Core>, heard: &Heard) {
        self.traffic = core.controller.traffic(self.channel);
        let held = self.packets.as_ref().is_some_and(Packets::is_held);
        if held || self.traffic.unread >= UNREAD {
            core.hold_back(self.channel, held);
        }
        if heard.changed {
            self.shared.release(core);
        } else {
            drop(core);
        }
        Counters::add(&self.shared.counters.packets, heard.packets);
        let (service, peer) = (self.membership.service, self.membership.peer);
        for refusal in &heard.refused {
            self.shared.log(&Event::Declined { service, peer, problem: refusal.to_string() });
        }
        for problem in &heard.unreadable {
            self.shared.log(&Event::Unreadable { service, peer, problem: problem.to_string() });
        }
    }

    /// Whether more is taken from the client: not while it does not read, nor while what it has sent waits.
    fn hears(&self) -> bool {
        let held = self.packets.as_ref().is_some_and(Packets::is_held);
        !self.ended && !held && self.out.len() < FULL && self.traffic.unread < UNREAD
    }

    /// When the patience with the client ends that begins now.
    fn patience(&self) -> Instant {
        Instant::now() + self.shared.patience
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
            self.drops = Some(self.patience());
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

/// Whether the client has closed its side, whatever it has sent before and nobody has read.
async fn has_closed(socket: &WriteHalf<'_>) -> bool {
    tokio::select! {
        biased;
        ready = socket.ready(Interest::READABLE) => ready.is_ok_and(Ready::is_read_closed),
        () = std::future::ready(()) => false,
    }
}

/// Sleeps until an instant, for ever without one.
async fn deadline(instant: Option<Instant>) {
    match instant {
        Some(instant) => sleep_until(instant).await,
        None => std::future::pending().await,
    }
}
