//! Clients that misbehave, and what they must not do to others.

use std::io::Write as _;
use std::sync::Arc;
use std::time::Duration;

use acrc_controller::{Controller, Options};
use acrc_image::Image;
use acrc_server::{BindError, Config, Event, Ports, Reason, Server, Service};
use parking_lot::Mutex;

use crate::common::{Bench, Nobody, eventually};

#[test]
fn a_client_that_does_not_read_is_dropped_and_nobody_else_notices() {
    let reasons = Arc::new(Mutex::new(Vec::new()));
    let seen = Arc::clone(&reasons);
    let bench = Bench::with(move |config| {
        config.patience = Duration::from_millis(300);
        config.log = Box::new(move |event| {
            if let Event::Disconnected { reason, .. } = event {
                seen.lock().push(*reason);
            }
        });
    });
    let mut deaf = bench.connect(Service::Mixed);
    let mut other = bench.terminal();
    deaf.0.set_write_timeout(Some(Duration::from_millis(100))).expect("a timeout");
    // Each request has nine times as long an answer.
    let reads = [0x00, 0x30, 0x02, 0xFF].repeat(2000);
    eventually(|| {
        let _ = deaf.0.write(&reads);
        assert_eq!(other.ask("PROG1"), "PROG1\r\nP01>");
        reasons.lock().contains(&Reason::Stuck).then_some(())
    });
    assert_eq!(other.ask("PROG2"), "PROG2\r\nP02>");
}

#[test]
fn a_flood_of_text_is_held_back_and_answered() {
    let bench = Bench::new();
    let mut flooding = bench.terminal();
    let mut other = bench.terminal();
    let mut writes = flooding.0.try_clone().expect("a socket");
    let lines = 3000;
    let flood = std::thread::spawn(move || writes.write_all(b"?P12288\r".repeat(lines).as_slice()));
    assert_eq!(other.ask("PROG1"), "PROG1\r\nP01>");
    let answer = "?P12288\r\n0\r\nSYS>";
    let read = flooding.until(|read| read.len() >= lines * answer.len());
    assert_eq!(read, answer.repeat(lines));
    flood.join().expect("it ends").expect("all is taken");
}

#[test]
fn clients_that_vanish_leave_their_places() {
    let bench = Bench::new();
    for round in 0..4 {
        let mut clients: Vec<_> = (0..4).map(|_| bench.terminal()).collect();
        for (number, client) in clients.iter_mut().enumerate() {
            // In the middle of a line, of a wait, of a flood.
            let text = ["PRO", "DWL 1000\r", "?P12288\r?P12288\r", "\x1b\x19"][(number + round) % 4];
            client.send(text);
        }
    }
    assert_eq!(bench.terminal().ask("PROG0"), "PROG0\r\nP00>");
}

#[test]
fn garbage_costs_nobody_anything() {
    let bench = Bench::new();
    let mut state = 1_u32;
    let mut garbage = || {
        (0..4096)
            .map(|_| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                state.to_be_bytes()[0]
            })
            .collect::<Vec<u8>>()
    };
    for service in [Service::Ascii, Service::Mixed, Service::Management] {
        let mut client = bench.connect(service);
        for _ in 0..4 {
            // The controller may have restarted: garbage may be a request for that.
            let _ = client.0.write_all(&garbage());
        }
        let socket = bench.subscriber();
        let _ = socket.send(&garbage());
    }
    assert_eq!(bench.terminal().ask("PROG0").split("\r\n").last(), Some("P00>"));
}

/// Why a server with a model and ports does not start.
fn refused(model: &str, ports: Ports) -> BindError {
    let controller = Controller::new(Arc::new(Image::empty(model)), Options::default()).expect("it loads");
    Server::bind(controller, Config { ports, ..Config::new(Nobody) }).err().expect("it does not start")
}

#[test]
fn a_port_that_is_taken_is_named() {
    let bench = Bench::new();
    let taken = bench.address(Service::Ascii).port();
    let error = refused("ACR9000", Ports { ascii: taken, ..Ports::ANY });
    let expected =
        format!("ASCII cannot listen at 127.0.0.1:{taken}: the port is in use, perhaps by another controller");
    assert_eq!(error.to_string(), expected);
    // Fast status shares its port with nobody either, although it has several sockets there.
    let taken = bench.address(Service::FastStatus).port();
    assert!(matches!(refused("ACR9000", Ports { fast_status: taken, ..Ports::ANY }), BindError::InUse { .. }));
}

#[test]
fn a_model_without_streams_for_clients_is_refused() {
    let error = refused("ACR1505", Ports::ANY);
    assert_eq!(error.to_string(), "ACR1505 has no Ethernet: its streams are DPCB, COM1");
}
