//! Clients that read parameters of axes.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::time::{Duration, Instant};

use acrc_wire::{Channel, Request};

/// Requests under way on the connection that does not wait for answers.
const WINDOW: usize = 256;
/// Connections that wait for each answer.
const CONNECTIONS: usize = 4;
/// Bytes of an answer.
const ANSWER: usize = 8;
/// Before this much time the figures are not taken: caches, clocks and threads get going.
const WARM_UP: Duration = Duration::from_millis(300);
/// After this much without an answer something is wrong.
const PATIENCE: Duration = Duration::from_secs(20);

/// What was measured.
#[derive(Debug, Default)]
pub(crate) struct Measured {
    /// Answers.
    pub(crate) answers: usize,
    /// In this time.
    pub(crate) time: Duration,
    /// From request to answer, sorted.
    pub(crate) latencies: Vec<Duration>,
}

impl Measured {
    /// Answers in a second.
    pub(crate) fn rate(&self) -> f64 {
        self.answers as f64 / self.time.as_secs_f64()
    }

    /// What a share of the latencies did not exceed.
    pub(crate) fn quantile(&self, share: f64) -> Duration {
        let place = (self.latencies.len() as f64 * share).ceil() as usize;
        self.latencies.get(place.saturating_sub(1)).copied().unwrap_or_default()
    }
}

/// One request for each of eight axes, in turn: the actual position.
fn requests() -> Vec<[u8; 4]> {
    let channel = Channel::ethernet();
    let request = |axis: u16| {
        let mut bytes = Vec::new();
        channel.request(&Request::GetLong { parameter: 12290 + 256 * axis }, &mut bytes);
        bytes.try_into().expect("four bytes")
    };
    (0..8).map(request).collect()
}

/// A connection that is served: the place of a client that has just left may not be free yet.
fn connect(address: SocketAddr) -> TcpStream {
    let begin = Instant::now();
    loop {
        let mut stream = TcpStream::connect(address).expect("the server listens");
        stream.set_nodelay(true).expect("a TCP socket");
        stream.set_read_timeout(Some(PATIENCE)).expect("a TCP socket");
        let served = stream.write_all(&requests()[0]).and_then(|()| stream.read_exact(&mut [0; ANSWER]));
        match served {
            Ok(()) => return stream,
            Err(error) => assert!(begin.elapsed() < PATIENCE, "{error}"),
        }
    }
}

/// Answers begin with the four bytes of their request.
fn check(answer: &[u8], request: [u8; 4]) {
    assert!(answer.starts_with(&request), "{answer:02x?} answers {request:02x?}");
}

/// One connection with many requests under way.
pub(crate) fn pipelined(address: SocketAddr, time: Duration) -> Measured {
    let mut stream = connect(address);
    let requests = requests();
    let batch: Vec<u8> = requests.iter().cycle().take(WINDOW / 2).flatten().copied().collect();
    let mut answers = vec![0; WINDOW / 2 * ANSWER];
    stream.write_all(&batch).expect("the server takes it");
    let mut measured = Measured::default();
    let begin = Instant::now();
    let mut counted = begin + WARM_UP;
    let end = counted + time;
    loop {
        let sent = Instant::now();
        stream.write_all(&batch).expect("the server takes it");
        stream.read_exact(&mut answers).expect("the server answers");
        let now = Instant::now();
        for (answer, request) in answers.chunks(ANSWER).zip(requests.iter().cycle()) {
            check(answer, *request);
        }
        if now < counted {
            continue;
        }
        if measured.time.is_zero() && measured.answers == 0 {
            counted = now;
            measured.time = Duration::from_nanos(1);
            continue;
        }
        measured.answers += WINDOW / 2;
        measured.latencies.push(now - sent);
        if now >= end {
            measured.time = now - counted;
            break;
        }
    }
    stream.read_exact(&mut answers).expect("the server answers");
    measured.latencies.sort_unstable();
    measured
}

/// Several connections, each of which waits for its answer before it asks again.
pub(crate) fn strict(address: SocketAddr, time: Duration) -> Measured {
    let one = || {
        let mut stream = connect(address);
        let requests = requests();
        let begin = Instant::now() + WARM_UP;
        let end = begin + time;
        let mut latencies = Vec::new();
        let mut answer = [0; ANSWER];
        for request in requests.iter().cycle() {
            let sent = Instant::now();
            stream.write_all(request).expect("the server takes it");
            stream.read_exact(&mut answer).expect("the server answers");
            let now = Instant::now();
            check(&answer, *request);
            if sent >= begin {
                latencies.push(now - sent);
            }
            if now >= end {
                break;
            }
        }
        latencies
    };
    let mut latencies: Vec<Duration> = std::thread::scope(|scope| {
        let clients: Vec<_> = (0..CONNECTIONS).map(|_| scope.spawn(one)).collect();
        clients.into_iter().flat_map(|client| client.join().expect("a client")).collect()
    });
    latencies.sort_unstable();
    Measured { answers: latencies.len(), time, latencies }
}
