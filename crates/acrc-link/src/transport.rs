//! What carries the bytes between a host and a controller.

use std::io::{self, ErrorKind, Read as _, Write as _};
use std::net::{Shutdown, SocketAddr, TcpStream, ToSocketAddrs as _};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::{Duration, Instant};

use crate::{Endpoint, LinkError};

/// How long the other side may take to end a connection that was ended here.
const FAREWELL: Duration = Duration::from_millis(500);
/// The longest time between two looks at whether the user gives up.
pub(crate) const BEAT: Duration = Duration::from_millis(50);
/// The pause before a second attempt to connect; each further one is twice as long.
const FIRST_PAUSE: Duration = Duration::from_millis(250);
/// The longest of these pauses.
const LONGEST_PAUSE: Duration = Duration::from_secs(5);

/// What carries the bytes between a host and a controller.
pub trait Transport {
    /// Reads what has come, or waits for something for at most so long; `None` when nothing comes, 0 at the end.
    ///
    /// # Errors
    /// When it broke.
    fn read_within(&mut self, buffer: &mut [u8], longest: Duration) -> io::Result<Option<usize>>;

    /// Sends bytes.
    ///
    /// # Errors
    /// When it broke, or nothing is taken for at most so long.
    fn write_within(&mut self, bytes: &[u8], longest: Duration) -> io::Result<()>;

    /// Ends the connection: says so, and reads what still comes.
    fn close(&mut self) {}
}

/// A TCP connection.
#[derive(Debug)]
pub struct Tcp {
    stream: TcpStream,
    closed: bool,
}

impl Tcp {
    /// Connects, trying every address of the host for at most so long each, and all of them again up to `retries` times.
    ///
    /// # Errors
    /// [`LinkError::Connect`] with the last reason, [`LinkError::Interrupted`] when the user gave up meanwhile.
    pub fn connect(
        endpoint: &Endpoint,
        port: u16,
        longest: Duration,
        retries: u32,
        interrupted: fn() -> bool,
    ) -> Result<Self, LinkError> {
        let mut pause = FIRST_PAUSE;
        let mut left = retries;
        loop {
            let reason = match Self::attempt_unless(interrupted, &endpoint.host, port, longest) {
                None => return Err(LinkError::Interrupted),
                Some(Ok(tcp)) => return Ok(tcp),
                Some(Err(reason)) => reason,
            };
            if left == 0 {
                return Err(LinkError::Connect { endpoint: endpoint.at(port).to_string(), reason });
            }
            left -= 1;
            if !pause_for(pause, interrupted) {
                return Err(LinkError::Interrupted);
            }
            pause = (pause * 2).min(LONGEST_PAUSE);
        }
    }

    /// An attempt that is left to itself when the user gives up: neither a name server nor a host that is not there can be
    /// told to hurry. `None` when the user did.
    fn attempt_unless(interrupted: fn() -> bool, host: &str, port: u16, longest: Duration) -> Option<io::Result<Self>> {
        let (sender, receiver) = mpsc::channel();
        let host = host.to_owned();
        std::thread::spawn(move || sender.send(Self::attempt(&host, port, longest)));
        loop {
            match receiver.recv_timeout(BEAT) {
                Ok(_) | Err(RecvTimeoutError::Timeout) if interrupted() => return None,
                Ok(result) => return Some(result),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return Some(Err(io::Error::other("the attempt failed"))),
            }
        }
    }

    fn attempt(host: &str, port: u16, longest: Duration) -> io::Result<Self> {
        let mut reason = io::Error::new(ErrorKind::NotFound, "the host has no address");
        for address in (host, port).to_socket_addrs()? {
            match connect_to(&address, longest) {
                Ok(stream) => return Ok(Self { stream, closed: false }),
                Err(error) => reason = error,
            }
        }
        Err(reason)
    }
}

/// Waits, unless the user gives up. False when the user did.
fn pause_for(time: Duration, interrupted: fn() -> bool) -> bool {
    let end = Instant::now() + time;
    while !interrupted() {
        let left = end.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return true;
        }
        std::thread::sleep(left.min(BEAT));
    }
    false
}

fn connect_to(address: &SocketAddr, longest: Duration) -> io::Result<TcpStream> {
    let stream = TcpStream::connect_timeout(address, longest)?;
    // Lines and packets are short, and each is waited for.
    stream.set_nodelay(true)?;
    Ok(stream)
}

impl Transport for Tcp {
    fn read_within(&mut self, buffer: &mut [u8], longest: Duration) -> io::Result<Option<usize>> {
        // A timeout of zero would be none at all.
        self.stream.set_read_timeout(Some(longest.max(Duration::from_millis(1))))?;
        loop {
            return match self.stream.read(buffer) {
                Ok(count) => Ok(Some(count)),
                Err(error) if is_timeout(&error) => Ok(None),
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                Err(error) => Err(error),
            };
        }
    }

    fn write_within(&mut self, bytes: &[u8], longest: Duration) -> io::Result<()> {
        self.stream.set_write_timeout(Some(longest.max(Duration::from_millis(1))))?;
        match self.stream.write_all(bytes) {
            Err(error) if is_timeout(&error) => {
                Err(io::Error::new(ErrorKind::TimedOut, "the controller does not take what is sent"))
            }
            result => result,
        }
    }

    /// As the Ethernet specification asks for ("Closing Connections"): a controller whose connections are not ended
    /// properly runs out of them.
    fn close(&mut self) {
        if std::mem::replace(&mut self.closed, true) || self.stream.shutdown(Shutdown::Write).is_err() {
            return;
        }
        let end = Instant::now() + FAREWELL;
        let mut rest = [0; 4096];
        while let Some(left) = end.checked_duration_since(Instant::now()).filter(|left| !left.is_zero()) {
            match self.read_within(&mut rest, left) {
                Ok(Some(count)) if count > 0 => {}
                _ => break,
            }
        }
    }
}

impl Drop for Tcp {
    fn drop(&mut self) {
        self.close();
    }
}

fn is_timeout(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut)
}
