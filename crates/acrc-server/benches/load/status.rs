//! Clients of fast status: how many datagrams come when they are due.
//!
//! A datagram is late when it does not reach its client within a millisecond of its time, or never. Its time is that of the
//! schedule which its client sees: a millisecond after the one before, beginning where the earliest datagrams put it. So the steady
//! part of the way through the sockets is left out, and everything that varies counts.

use std::net::{SocketAddr, UdpSocket};
use std::time::{Duration, Instant};

use acrc_wire::ethernet::{FastStatus, Subscription};

const CLIENTS: usize = 5;
const INTERVAL: Duration = Duration::from_millis(1);
const PATIENCE: Duration = Duration::from_secs(5);

/// What the clients of fast status got.
#[derive(Debug, Default)]
pub(crate) struct Arrivals {
    /// Datagrams that were due.
    pub(crate) due: usize,
    /// Those of them that were late.
    pub(crate) late: usize,
    /// The longest time without a datagram.
    pub(crate) longest: Duration,
}

impl Arrivals {
    /// The share of late datagrams.
    pub(crate) fn share(&self) -> f64 {
        self.late as f64 / self.due.max(1) as f64
    }

    fn add(mut self, other: &Self) -> Self {
        self.due += other.due;
        self.late += other.late;
        self.longest = self.longest.max(other.longest);
        self
    }
}

/// Five clients with an interval of a millisecond.
pub(crate) fn five_clients(address: SocketAddr, time: Duration) -> Arrivals {
    std::thread::scope(|scope| {
        let clients: Vec<_> = (0..CLIENTS).map(|_| scope.spawn(|| one_client(address, time))).collect();
        let arrivals = clients.into_iter().map(|client| client.join().expect("a client"));
        arrivals.fold(Arrivals::default(), |sum, one| sum.add(&one))
    })
}

fn one_client(address: SocketAddr, time: Duration) -> Arrivals {
    let socket = UdpSocket::bind((address.ip(), 0)).expect("a free port");
    socket.connect(address).expect("an address");
    let mut buffer = [0; FastStatus::LEN + 1];
    // The place of a client that has just left may not be free yet.
    socket.set_read_timeout(Some(PATIENCE / 25)).expect("a UDP socket");
    for _ in 0..25 {
        socket.send(&Subscription::every(1).encode()).expect("the server listens");
        if socket.recv(&mut buffer).is_ok() {
            break;
        }
    }
    socket.set_read_timeout(Some(PATIENCE)).expect("a UDP socket");
    let mut next = || {
        let length = socket.recv(&mut buffer).expect("fast status comes");
        assert_eq!(length, FastStatus::LEN);
        Instant::now()
    };
    let begin = next() + Duration::from_millis(300);
    while next() < begin {}
    let mut arrivals = Vec::new();
    while arrivals.last().is_none_or(|last: &Instant| *last - begin < time) {
        arrivals.push(next());
    }
    socket.send(&Subscription::end().encode()).expect("the server listens");
    count(&arrivals)
}

/// Counts the milliseconds of the schedule in which no datagram came.
fn count(arrivals: &[Instant]) -> Arrivals {
    let (Some(first), Some(last)) = (arrivals.first(), arrivals.last()) else { return Arrivals::default() };
    // What is left out or late makes later ones come later by count, never earlier.
    let ahead = |(place, arrival): (u32, &Instant)| (INTERVAL * place).saturating_sub(*arrival - *first);
    let early = (0..).zip(arrivals).map(ahead).max().unwrap_or_default();
    let slot = |arrival: &Instant| ((*arrival - *first + early).as_nanos() / INTERVAL.as_nanos()) as usize;
    let due = slot(last) + 1;
    let mut slots: Vec<usize> = arrivals.iter().map(slot).collect();
    slots.dedup();
    let gaps = arrivals.iter().zip(arrivals.iter().skip(1)).map(|(one, other)| *other - *one);
    Arrivals { due, late: due - slots.len(), longest: gaps.max().unwrap_or_default() }
}
