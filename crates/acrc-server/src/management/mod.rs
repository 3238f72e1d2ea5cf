//! Connection management on TCP port 5004 (Ethernet specification, "Connection Management").

mod configuration;
mod download;
pub(crate) mod watchdog;

use std::sync::Arc;
use std::time::Duration;

use acrc_wire::ethernet::management::{DownloadResult, Reply, Request, Requests, passes, requests};
use acrc_wire::{Decoder, Item};
use tokio::io::AsyncReadExt as _;
use tokio::net::TcpStream;
use tokio::net::tcp::WriteHalf;
use tokio::sync::broadcast::error::RecvError;
use tokio::time::{sleep, timeout};

use self::download::Download;
use self::watchdog::Guards;
use crate::alarms::Alarm;
use crate::event::{Event, Reason};
use crate::farewell::part;
use crate::registry::Membership;
use crate::shared::{Phase, Shared};

/// Bytes that are read at once: a block of an operating system and more.
const CHUNK: usize = 4096;

/// How long a packet waits, so that connections that were made before it are taken in.
const DELAY: Duration = Duration::from_millis(2);

/// A management connection that is served.
struct Connection {
    shared: Arc<Shared>,
    guards: Arc<Guards>,
    membership: Membership,
    user_filter: u32,
    controller_filter: u32,
    download: Option<Download>,
    /// What is to be sent.
    out: Vec<u8>,
}

/// Serves a client until it goes.
pub(crate) async fn serve(mut socket: TcpStream, shared: Arc<Shared>, membership: Membership, guards: Arc<Guards>) {
    let (user_filter, controller_filter) = (0, 0);
    let out = Vec::new();
    let mut connection = Connection { shared, guards, membership, user_filter, controller_filter, download: None, out };
    let reason = connection.run(&mut socket).await;
    connection.finish(socket, reason).await;
}

impl Connection {
    async fn run(&mut self, socket: &mut TcpStream) -> Reason {
        let (mut reader, mut writer) = socket.split();
        let mut alarms = self.shared.alarms.subscribe();
        let mut decoder = requests(self.shared.wire);
        let mut buffer = [0; CHUNK];
        loop {
            tokio::select! {
                biased;
                reason = self.membership.dismissed() => return reason,
                read = reader.read(&mut buffer) => match read {
                    Ok(0) => return Reason::Left,
                    Ok(count) => {
                        // A connection that a watchdog names may have been made just before, and is not taken in yet.
                        sleep(DELAY).await;
                        self.hear(&mut decoder, buffer.get(..count).unwrap_or_default());
                    }
                    Err(_) => return Reason::Lost,
                },
                alarm = alarms.recv() => match alarm {
                    Ok(alarm) => self.tell(&alarm),
                    // A client that does not read fast enough misses some.
                    Err(RecvError::Lagged(_)) => {}
                    Err(RecvError::Closed) => return Reason::ClosedDown,
                },
            }
            if let Err(reason) = self.write(&mut writer).await {
                return reason;
            }
        }
    }

    async fn write(&mut self, writer: &mut WriteHalf<'_>) -> Result<(), Reason> {
        if self.out.is_empty() {
            return Ok(());
        }
        let written = timeout(self.shared.patience, tokio::io::AsyncWriteExt::write_all(writer, &self.out)).await;
        self.out.clear();
        match written {
            Ok(Ok(())) => Ok(()),
            Ok(Err(_)) => Err(Reason::Lost),
            Err(_) => Err(Reason::Stuck),
        }
    }

    fn hear(&mut self, decoder: &mut Decoder<Requests>, mut bytes: &[u8]) {
        while let Some(item) = decoder.next_item(&mut bytes) {
            match item {
                Item::Packet(request) => self.execute(&request),
                Item::Unreadable(problem) => self.unreadable(problem.to_string()),
                Item::Text(_) => self.unreadable("text".to_owned()),
            }
        }
    }

    fn unreadable(&self, problem: String) {
        let (service, peer) = (self.membership.service, self.membership.peer);
        self.shared.log(&Event::Unreadable { service, peer, problem });
    }

    fn execute(&mut self, request: &Request<'_>) {
        match request {
            Request::Watchdog(watchdog) => {
                if self.guards.hear(self.membership.number, watchdog, &self.shared) {
                    self.reply(&Reply::Watchdog(*watchdog));
                }
            }
            Request::UserAlarms { filter } => self.user_filter = *filter,
            Request::ControllerAlarms { filter } => self.controller_filter = *filter,
            Request::ConfigurationFile => {
                let file = configuration::file(&self.shared);
                self.reply(&Reply::ConfigurationFile(&file));
            }
            Request::Block { index, data } => self.store(*index, data),
            Request::EndDownload => {
                let result = self.download.as_ref().map_or(DownloadResult::CrcFailure, |download| {
                    let result = download.finish(&self.shared.wire);
                    if result == DownloadResult::Success {
                        self.shared.log(&Event::Downloaded { bytes: download.len() });
                    }
                    result
                });
                self.reply(&Reply::DownloadResult(result));
            }
            Request::Reboot => {
                self.shared.enter(Phase::Rebooting);
            }
        }
    }

    /// The first block closes everything down, unless another client sends an operating system already: that closes this one, too.
    fn store(&mut self, index: u16, data: &[u8; download::BLOCK]) {
        if self.download.is_none() {
            if !self.shared.enter(Phase::Halted { by: self.membership.number }) {
                return;
            }
            self.download = Some(Download::default());
            self.shared.log(&Event::Halted { peer: self.membership.peer });
        }
        if let Some(download) = &mut self.download {
            download.store(index, data);
        }
    }

    fn tell(&mut self, alarm: &Alarm) {
        match alarm {
            Alarm::User(value) if passes(*value, self.user_filter) => self.reply(&Reply::UserAlarm { value: *value }),
            Alarm::Controller(alarm) if alarm.passes(self.controller_filter) => {
                self.reply(&Reply::ControllerAlarm(*alarm));
            }
            Alarm::User(_) | Alarm::Controller(_) => {}
        }
    }

    fn reply(&mut self, reply: &Reply<'_>) {
        reply.encode(&self.shared.wire, &mut self.out);
    }

    async fn finish(self, socket: TcpStream, reason: Reason) {
        let Self { shared, membership, download, .. } = self;
        membership.leave();
        shared.log(&Event::Disconnected { service: membership.service, peer: membership.peer, reason });
        if download.is_some() {
            // The controller is halted, and nobody else could tell it to go on.
            shared.enter(Phase::Rebooting);
        }
        match reason {
            Reason::Stuck | Reason::Lost => drop(socket),
            Reason::Left | Reason::Watchdog | Reason::ClosedDown => part(socket, &[]).await,
        }
    }
}
