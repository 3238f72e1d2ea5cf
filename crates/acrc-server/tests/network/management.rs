//! Port 5004.

use std::net::{Ipv4Addr, SocketAddr};
use std::time::Duration;

use acrc_controller::AlarmKind;
use acrc_server::Service;
use acrc_wire::ethernet::management::{DownloadResult, Reply, Request, replies};
use acrc_wire::ethernet::{FILE_LEN, MANAGEMENT_CLIENTS, Subscription, Watchdog, is_intact, seal};
use acrc_wire::{ByteOrder, CrcRule, Item, WireOptions};

use crate::common::{Bench, Client, eventually};

fn send(client: &mut Client, request: Request<'_>) {
    let mut bytes = Vec::new();
    request.encode(&WireOptions::default(), &mut bytes);
    client.send(bytes);
}

fn guard(peer: &Client, timer: u32, ticker: u32) -> Watchdog {
    let SocketAddr::V4(address) = peer.0.local_addr().expect("an address") else { panic!("no IPv6 here") };
    let command_port = u32::from(address.port());
    Watchdog { timer, ticker, address: *address.ip(), command_port, fast_status_port: 0 }
}

/// Asks with a watchdog packet, and checks that the very packet comes back.
fn is_echoed(client: &mut Client, watchdog: Watchdog) {
    let mut bytes = Vec::new();
    Request::Watchdog(watchdog).encode(&WireOptions::default(), &mut bytes);
    client.send(&bytes);
    assert_eq!(client.exactly(bytes.len()), bytes);
}

fn download_result(client: &mut Client) -> DownloadResult {
    let bytes = client.exactly(8);
    let mut decoder = replies(WireOptions::default());
    match decoder.next_item(&mut &bytes[..]) {
        Some(Item::Packet(Reply::DownloadResult(result))) => result,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_watchdog_is_echoed_while_its_connection_lives() {
    let bench = Bench::new();
    let command = bench.terminal();
    let mut manager = bench.connect(Service::Management);
    let watchdog = guard(&command, 10_000, 3);
    is_echoed(&mut manager, watchdog);
    is_echoed(&mut manager, Watchdog { timer: 0, ..watchdog });
    drop(command);
    eventually(|| {
        send(&mut manager, Request::Watchdog(watchdog));
        let quiet = manager.is_quiet(Duration::from_millis(50));
        if !quiet {
            manager.exactly(23);
        }
        quiet.then_some(())
    });
}

#[test]
fn a_connection_is_closed_when_its_watchdog_stays_away() {
    let bench = Bench::new();
    let mut guarded = bench.terminal();
    let mut other = bench.terminal();
    let mut manager = bench.connect(Service::Management);
    is_echoed(&mut manager, guard(&guarded, 20, 3));
    assert!(guarded.has_ended());
    assert_eq!(other.ask("PROG0"), "PROG0\r\nP00>");
    // The management connection stays, and the guard outlives it.
    let mut second = bench.terminal();
    is_echoed(&mut manager, guard(&second, 20, 3));
    drop(manager);
    assert!(second.has_ended());
}

#[test]
fn a_watchdog_of_fast_status_ends_the_subscription() {
    let bench = Bench::new();
    let status = bench.subscriber();
    status.send(&Subscription::every(1).encode()).expect("it is sent");
    status.recv(&mut [0; 512]).expect("status comes");
    let mut manager = bench.connect(Service::Management);
    let port = status.local_addr().expect("an address").port();
    let address = Ipv4Addr::LOCALHOST;
    let watchdog = Watchdog { timer: 20, ticker: 2, address, command_port: 0, fast_status_port: u32::from(port) };
    is_echoed(&mut manager, watchdog);
    status.set_read_timeout(Some(Duration::from_millis(200))).expect("a timeout");
    eventually(|| status.recv(&mut [0; 512]).err());
}

#[test]
fn five_clients_manage_connections_and_a_sixth_is_turned_away() {
    let bench = Bench::new();
    let mut clients: Vec<Client> = (0..MANAGEMENT_CLIENTS).map(|_| bench.connect(Service::Management)).collect();
    for client in &mut clients {
        send(client, Request::ConfigurationFile);
        client.exactly(1028);
    }
    assert!(bench.connect(Service::Management).has_ended());
    clients.pop();
    eventually(|| {
        let mut client = bench.connect(Service::Management);
        send(&mut client, Request::ConfigurationFile);
        (client.some().len() == 1028).then_some(())
    });
}

#[test]
fn a_configuration_file_is_text_with_its_crc() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Management);
    send(&mut client, Request::ConfigurationFile);
    let bytes = client.exactly(1028);
    let (id, file) = bytes.split_at(4);
    assert_eq!(id, [0, 0, 0, 4]);
    assert!(is_intact(file, CrcRule::Ethernet, ByteOrder::BigEndian));
    let text: Vec<u8> = file.iter().copied().take_while(|byte| *byte != 0).collect();
    assert!(String::from_utf8(text).expect("text").contains("ACR9000"));
}

#[test]
fn a_download_closes_everything_else_down_and_a_reboot_brings_it_back() {
    let bench = Bench::new();
    let mut command = bench.terminal();
    command.ask("PROG0");
    let mut other = bench.connect(Service::Management);
    send(&mut other, Request::ConfigurationFile);
    other.exactly(1028);
    let mut loader = bench.connect(Service::Management);

    let mut system = vec![0x5A; 3 * FILE_LEN];
    seal(&mut system, CrcRule::Ethernet, ByteOrder::BigEndian);
    let blocks: Vec<&[u8; FILE_LEN]> = system.as_chunks().0.iter().collect();
    send(&mut loader, Request::Block { index: 2, data: blocks[2] });
    assert!(command.has_ended());
    assert!(other.has_ended());
    drop((command, other));
    // One block is missing, so the CRC is wrong; then the rest is sent.
    send(&mut loader, Request::Block { index: 0, data: blocks[0] });
    send(&mut loader, Request::EndDownload);
    assert_eq!(download_result(&mut loader), DownloadResult::CrcFailure);
    send(&mut loader, Request::Block { index: 1, data: blocks[1] });
    send(&mut loader, Request::EndDownload);
    assert_eq!(download_result(&mut loader), DownloadResult::Success);
    eventually(|| std::net::TcpStream::connect(bench.address(Service::Ascii)).err());

    send(&mut loader, Request::Reboot);
    assert!(loader.has_ended());
    drop(loader);
    assert_eq!(bench.terminal().ask("PROG0"), "PROG0\r\nP00>");
}

#[test]
fn a_download_that_breaks_off_ends_with_a_reboot() {
    let bench = Bench::new();
    let mut loader = bench.connect(Service::Management);
    send(&mut loader, Request::Block { index: 0, data: &[0; FILE_LEN] });
    drop(loader);
    assert_eq!(bench.terminal().ask("PROG0"), "PROG0\r\nP00>");
}

#[test]
fn a_reboot_outside_of_a_download_ends_all_connections() {
    let bench = Bench::new();
    let mut command = bench.terminal();
    command.ask("PROG5");
    let mut manager = bench.connect(Service::Management);
    send(&mut manager, Request::Reboot);
    assert!(command.has_ended());
    assert!(manager.has_ended());
    drop((command, manager));
    assert_eq!(bench.terminal().ask(""), "\r\nSYS>");
}

#[test]
fn alarms_go_to_those_whose_filter_lets_them_pass() {
    let bench = Bench::new();
    let mut command = bench.terminal();
    let mut all = bench.connect(Service::Management);
    let mut others = bench.connect(Service::Management);
    let kill = AlarmKind::MotionKilled.code();
    send(&mut all, Request::ControllerAlarms { filter: u32::MAX });
    send(&mut others, Request::ControllerAlarms { filter: !kill });
    for client in [&mut all, &mut others] {
        // What was sent before is taken when this is answered.
        send(client, Request::ConfigurationFile);
        client.exactly(1028);
    }
    command.ask("SET 8467");
    let expected: Vec<u8> = [3, kill, 0, 1].into_iter().flat_map(u32::to_be_bytes).collect();
    assert_eq!(all.exactly(16), expected);
    assert!(others.is_quiet(Duration::from_millis(100)));
}

#[test]
fn bytes_that_mean_nothing_cost_themselves_only() {
    let bench = Bench::new();
    let mut client = bench.connect(Service::Management);
    client.send([0, 0, 0, 99, 1, 2, 3, 4]);
    send(&mut client, Request::ConfigurationFile);
    assert_eq!(client.exactly(4), [0, 0, 0, 4]);
}
