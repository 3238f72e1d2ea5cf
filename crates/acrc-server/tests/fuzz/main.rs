//! A live server and strangers that send anything, in any pieces, and leave in any way. Whatever they do, the next client is
//! served, every place is free again, and time has not stopped.

mod strangers;

use std::io::{Read as _, Write as _};
use std::net::{SocketAddr, TcpStream, UdpSocket};
use std::sync::Arc;
use std::time::{Duration, Instant};

use acrc_compile::{SourceUnit, compile};
use acrc_controller::world::WorldEvent;
use acrc_controller::{Controller, FaultReport, Observer, Options, Sent, View};
use acrc_server::{Config, Ports, Server, Service};
use acrc_syntax::units::Level;
use acrc_wire::ethernet::{COMMAND_STREAMS, FAST_STATUS_CLIENTS, FastStatus, MANAGEMENT_CLIENTS, Subscription};
use strangers::{Places, Random, Stranger};

/// How long the strangers come.
const TIME: Duration = Duration::from_secs(8);
/// After this much without an answer something is wrong.
const PATIENCE: Duration = Duration::from_secs(20);
/// Kilobytes that the process may grow by while they do.
const GROWTH: u64 = 64 * 1024;

/// An axis, and a program to start.
const MACHINE: &str = "SYS\nDIM P(100)\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPPU X1000\nACC 100 DEC 100 STP 100 VEL 10\n\
                       PROG1\nPROGRAM\n_Again\nP0 = P0 + 1\nDWL 0.01\nGOTO Again\nENDP\n";

/// Sees nothing.
struct Blind;

impl Observer for Blind {
    fn output(&mut self, _: &Sent) {}
    fn fault(&mut self, _: &FaultReport) {}
    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}
    fn tick(&mut self, _: &View) {}
}

fn served() -> Server {
    let tree = acrc_syntax::parse(MACHINE);
    let file =
        SourceUnit { name: "machine", text: MACHINE, tree: &tree, start: Level::System, implicit_program: false };
    let image = Arc::new(compile(&[file], "ACR9000").expect("the program compiles"));
    let mut config = Config::new(Blind);
    config.ports = Ports::ANY;
    Server::bind(Controller::new(image, Options::default()).expect("it loads"), config).expect("ports are free")
}

/// Memory of this process in kilobytes, where the system tells.
fn memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.split_whitespace().next()?.parse().ok()
}

/// Tries until the server gives what is wanted: it may not have seen yet that a stranger has left.
fn patiently<T>(what: &str, mut attempt: impl FnMut() -> Option<T>) -> T {
    let deadline = Instant::now() + PATIENCE;
    loop {
        if let Some(value) = attempt() {
            return value;
        }
        assert!(Instant::now() < deadline, "{what} in vain");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// A connection on which a question has been answered.
fn ask(address: SocketAddr, question: &[u8], answer: &[u8]) -> Option<TcpStream> {
    let mut stream = TcpStream::connect(address).ok()?;
    stream.set_read_timeout(Some(PATIENCE)).ok()?;
    stream.write_all(question).ok()?;
    let mut heard = vec![0; answer.len()];
    stream.read_exact(&mut heard).ok()?;
    (heard == answer).then_some(stream)
}

/// Every service has all of its places.
fn everybody_is_served(places: &Places) {
    let text = |address: SocketAddr| ask(address, b"SYS\r", b"SYS\r\nSYS>");
    let streams = COMMAND_STREAMS.count();
    let ascii: Vec<_> = (0..streams / 2).map(|_| patiently("text", || text(places.ascii))).collect();
    let mixed: Vec<_> = (streams / 2..streams)
        .map(|_| patiently("packets", || ask(places.mixed, &[0, 0x88, 0x04, 0x1b], &[0, 0x88, 0x04, 0x1b])))
        .collect();
    let configuration = [0, 0, 0, 4];
    let managers: Vec<_> = (0..MANAGEMENT_CLIENTS)
        .map(|_| patiently("management", || ask(places.management, &configuration, &configuration)))
        .collect();
    let subscribers: Vec<_> = (0..FAST_STATUS_CLIENTS)
        .map(|_| {
            patiently("fast status", || {
                let socket = UdpSocket::bind("127.0.0.1:0").ok()?;
                socket.set_read_timeout(Some(Duration::from_millis(200))).ok()?;
                socket.send_to(&Subscription::every(5).encode(), places.fast_status).ok()?;
                let length = socket.recv(&mut [0; 2 * FastStatus::LEN]).ok()?;
                (length == FastStatus::LEN).then_some(socket)
            })
        })
        .collect();
    drop((ascii, mixed, managers));
    for socket in subscribers {
        socket.send_to(&Subscription::end().encode(), places.fast_status).expect("the server listens");
    }
}

/// The clock of the controller in milliseconds.
fn clock(places: &Places) -> i32 {
    patiently("the clock", || {
        let request = [0, 0x88, 0x04, 0x1b];
        let mut stream = ask(places.mixed, &request, &request)?;
        let mut value = [0; 4];
        stream.read_exact(&mut value).ok()?;
        Some(i32::from_le_bytes(value))
    })
}

#[test]
fn strangers_do_no_harm() {
    let server = served();
    let places = Places {
        ascii: server.address(Service::Ascii),
        mixed: server.address(Service::Mixed),
        management: server.address(Service::Management),
        fast_status: server.address(Service::FastStatus),
    };
    everybody_is_served(&places);
    let before = memory();
    let end = Instant::now() + TIME;
    std::thread::scope(|scope| {
        for seed in 0..6 {
            let places = &places;
            scope.spawn(move || {
                let mut random = Random::new(seed);
                while Instant::now() < end {
                    Stranger::new(&mut random).visit(places, &mut random);
                }
            });
        }
    });
    everybody_is_served(&places);
    let first = clock(&places);
    patiently("time passes", || (clock(&places) != first).then_some(()));
    if let (Some(before), Some(after)) = (before, memory()) {
        assert!(after < before + GROWTH, "{before} kB have become {after} kB");
    }
    server.handle().shutdown();
    server.wait().expect("no thread has panicked");
}
