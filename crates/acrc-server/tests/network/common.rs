//! A server within the test, and clients for it.

use std::io::{ErrorKind, Read as _, Write as _};
use std::net::{Shutdown, SocketAddr, TcpStream, UdpSocket};
use std::sync::Arc;
use std::time::{Duration, Instant};

use acrc_controller::world::WorldEvent;
use acrc_controller::{Controller, FaultReport, Observer, Options, Sent, View};
use acrc_image::Image;
use acrc_server::{Config, Finished, Handle, Ports, Server, Service};

/// What is waited for at most: a machine that is busy with other things must not fail a test.
pub(crate) const DEADLINE: Duration = Duration::from_secs(20);

/// Watches nothing.
pub(crate) struct Nobody;

impl Observer for Nobody {
    fn output(&mut self, _: &Sent) {}
    fn fault(&mut self, _: &FaultReport) {}
    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}
    fn tick(&mut self, _: &View) {}
    fn watches_every_tick(&self) -> bool {
        false
    }
}

/// A server that ends with the test.
pub(crate) struct Bench {
    server: Option<Server>,
    handle: Handle,
}

impl Bench {
    /// With factory settings, in real time.
    pub(crate) fn new() -> Self {
        Self::with(|_| {})
    }

    /// With something of its configuration changed.
    pub(crate) fn with(change: impl FnOnce(&mut Config)) -> Self {
        let mut config = Config { ports: Ports::ANY, ..Config::new(Nobody) };
        change(&mut config);
        let controller = Controller::new(Arc::new(Image::empty("ACR9000")), Options::default()).expect("it loads");
        let server = Server::bind(controller, config).expect("there are free ports");
        let handle = server.handle();
        Self { server: Some(server), handle }
    }

    pub(crate) fn address(&self, service: Service) -> SocketAddr {
        self.server.as_ref().expect("it serves").address(service)
    }

    pub(crate) fn handle(&self) -> &Handle {
        &self.handle
    }

    /// A client of a TCP port. A controller that restarts takes none for a moment.
    pub(crate) fn connect(&self, service: Service) -> Client {
        Client(eventually(|| TcpStream::connect(self.address(service)).ok()))
    }

    /// A terminal that is served: as long as all streams are taken, it tries again.
    pub(crate) fn terminal(&self) -> Client {
        eventually(|| {
            let mut client = self.connect(Service::Ascii);
            client.0.write_all(b"\r").ok()?;
            client.try_until(|answer| answer.ends_with('>')).map(|_| client)
        })
    }

    /// A subscriber of fast status.
    pub(crate) fn subscriber(&self) -> UdpSocket {
        let socket = UdpSocket::bind("127.0.0.1:0").expect("a port");
        socket.connect(self.address(Service::FastStatus)).expect("an address");
        socket.set_read_timeout(Some(DEADLINE)).expect("a timeout");
        socket
    }

    /// Ends the server.
    pub(crate) fn finish(mut self) -> Finished {
        self.handle.shutdown();
        self.server.take().expect("it serves").wait().expect("it has served")
    }
}

impl Drop for Bench {
    fn drop(&mut self) {
        self.handle.shutdown();
        if let Some(server) = self.server.take() {
            let _ = server.wait();
        }
    }
}

/// Tries until something succeeds.
pub(crate) fn eventually<T>(mut attempt: impl FnMut() -> Option<T>) -> T {
    let begun = Instant::now();
    loop {
        if let Some(result) = attempt() {
            return result;
        }
        assert!(begun.elapsed() < DEADLINE, "it does not happen");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// A client of a TCP port.
pub(crate) struct Client(pub(crate) TcpStream);

impl Client {
    pub(crate) fn send(&mut self, bytes: impl AsRef<[u8]>) {
        self.0.set_nodelay(true).expect("an option");
        self.0.write_all(bytes.as_ref()).expect("the server listens");
    }

    /// Sends a line, and reads up to the prompt.
    pub(crate) fn ask(&mut self, line: &str) -> String {
        self.send(format!("{line}\r"));
        self.until(|answer| answer.ends_with('>'))
    }

    /// The lines of an answer, without echo and prompt.
    pub(crate) fn report(&mut self, line: &str) -> Vec<String> {
        let answer = self.ask(line);
        let mut lines: Vec<&str> = answer.split("\r\n").collect();
        assert_eq!(lines.first(), Some(&line), "the echo of {answer:?}");
        lines.remove(0);
        lines.pop();
        lines.into_iter().map(str::to_owned).collect()
    }

    /// Reads until what has come is enough.
    pub(crate) fn until(&mut self, enough: impl Fn(&str) -> bool) -> String {
        self.try_until(enough).expect("the server answers, and does not end the connection")
    }

    fn try_until(&mut self, enough: impl Fn(&str) -> bool) -> Option<String> {
        let mut read = String::new();
        while !enough(&read) {
            let some = self.some();
            if some.is_empty() {
                return None;
            }
            read.extend(some.into_iter().map(char::from));
        }
        Some(read)
    }

    /// What comes next in one piece; nothing when the connection has ended.
    pub(crate) fn some(&mut self) -> Vec<u8> {
        let mut buffer = vec![0; 65536];
        self.0.set_read_timeout(Some(DEADLINE)).expect("a timeout");
        match self.0.read(&mut buffer) {
            Ok(count) => buffer[..count].to_vec(),
            Err(error) if error.kind() == ErrorKind::ConnectionReset => Vec::new(),
            Err(error) => panic!("{error}"),
        }
    }

    /// So many bytes.
    pub(crate) fn exactly(&mut self, count: usize) -> Vec<u8> {
        let mut bytes = vec![0; count];
        self.0.set_read_timeout(Some(DEADLINE)).expect("a timeout");
        self.0.read_exact(&mut bytes).expect("the server answers");
        bytes
    }

    /// Whether nothing comes for a while.
    pub(crate) fn is_quiet(&mut self, time: Duration) -> bool {
        self.0.set_read_timeout(Some(time)).expect("a timeout");
        let kind = self.0.read(&mut [0; 1]).err().map(|error| error.kind());
        matches!(kind, Some(ErrorKind::WouldBlock | ErrorKind::TimedOut))
    }

    /// Whether the connection has been ended in good order, once what is left of it is read.
    pub(crate) fn has_ended(&mut self) -> bool {
        self.0.set_read_timeout(Some(DEADLINE)).expect("a timeout");
        let mut rest = Vec::new();
        self.0.read_to_end(&mut rest).is_ok()
    }

    /// Sends nothing more, and reads what still comes.
    pub(crate) fn leave(mut self) -> Vec<u8> {
        self.0.shutdown(Shutdown::Write).expect("an open connection");
        let mut rest = Vec::new();
        self.0.set_read_timeout(Some(DEADLINE)).expect("a timeout");
        self.0.read_to_end(&mut rest).expect("the server ends it too");
        rest
    }
}
