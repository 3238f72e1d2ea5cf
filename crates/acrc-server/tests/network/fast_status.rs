//! Port 5003.

use std::net::UdpSocket;
use std::time::Duration;

use acrc_server::Speed;
use acrc_wire::ethernet::{FAST_STATUS_CLIENTS, FastStatus, Subscription};

use crate::common::{Bench, DEADLINE, eventually};

fn subscribe(bench: &Bench, milliseconds: u32) -> UdpSocket {
    let socket = bench.subscriber();
    socket.send(&Subscription::every(milliseconds).encode()).expect("it is sent");
    socket
}

fn receive(socket: &UdpSocket) -> FastStatus {
    let mut datagram = [0; 2 * FastStatus::LEN];
    let count = socket.recv(&mut datagram).expect("status comes");
    assert_eq!(count, FastStatus::LEN);
    FastStatus::decode(&datagram[..count]).expect("it is complete")
}

fn is_quiet(socket: &UdpSocket, time: Duration) -> bool {
    socket.set_read_timeout(Some(time)).expect("a timeout");
    let quiet = socket.recv(&mut [0; FastStatus::LEN]).is_err();
    socket.set_read_timeout(Some(DEADLINE)).expect("a timeout");
    quiet
}

#[test]
fn status_comes_at_its_interval_until_it_is_ended() {
    let bench = Bench::new();
    let socket = subscribe(&bench, 1);
    for _ in 0..50 {
        receive(&socket);
    }
    socket.send(&Subscription::end().encode()).expect("it is sent");
    eventually(|| is_quiet(&socket, Duration::from_millis(100)).then_some(()));
    socket.send(&Subscription::every(5).encode()).expect("it is sent");
    receive(&socket);
}

#[test]
fn status_has_what_the_commands_choose() {
    let bench = Bench::new();
    let mut client = bench.terminal();
    // Group 0x30 has the parameters of axes; index 0 is the first one.
    client.ask("FSTAT0 (48, 0)");
    client.ask("P12544=1234");
    let socket = subscribe(&bench, 1);
    eventually(|| (receive(&socket).0[0][1].long() == 1234).then_some(()));
}

#[test]
fn another_request_changes_the_interval() {
    let bench = Bench::new();
    let socket = subscribe(&bench, 3_600_000);
    // The first one comes at once.
    receive(&socket);
    assert!(is_quiet(&socket, Duration::from_millis(50)));
    socket.send(&Subscription::every(1).encode()).expect("it is sent");
    for _ in 0..20 {
        receive(&socket);
    }
    assert_eq!(bench.handle().statistics().clients, 1);
}

#[test]
fn five_clients_get_status_and_a_sixth_when_one_of_them_is_gone() {
    let bench = Bench::new();
    let mut sockets: Vec<UdpSocket> = (0..FAST_STATUS_CLIENTS).map(|_| subscribe(&bench, 2)).collect();
    for socket in &sockets {
        receive(socket);
    }
    let sixth = subscribe(&bench, 2);
    assert!(is_quiet(&sixth, Duration::from_millis(100)));
    // Nobody ends this subscription: that nobody listens there is seen when status is sent.
    sockets.pop();
    eventually(|| {
        sixth.send(&Subscription::every(2).encode()).expect("it is sent");
        (!is_quiet(&sixth, Duration::from_millis(50))).then_some(())
    });
    for socket in &sockets {
        receive(socket);
    }
}

#[test]
fn requests_that_mean_nothing_are_ignored() {
    let bench = Bench::new();
    let socket = bench.subscriber();
    for request in [&b""[..], b"1234567", &[0; 8]] {
        socket.send(request).expect("it is sent");
    }
    assert!(is_quiet(&socket, Duration::from_millis(50)));
    let long = [&Subscription::every(1).encode()[..], &[7; 900]].concat();
    socket.send(&long).expect("it is sent");
    receive(&socket);
}

#[test]
fn status_comes_though_no_time_passes() {
    let bench = Bench::with(|config| config.speed = Speed::Max);
    let socket = subscribe(&bench, 1);
    for _ in 0..20 {
        receive(&socket);
    }
}
