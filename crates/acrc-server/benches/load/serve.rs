//! Servers in processes of their own.

use std::io::{BufRead, BufReader, Read};
use std::net::SocketAddr;
use std::process::{Command, Stdio};
use std::sync::Arc;

use acrc_compile::{SourceUnit, compile};
use acrc_controller::world::WorldEvent;
use acrc_controller::{Controller, FaultReport, Observer, Options, Sent, View};
use acrc_server::{Config, Histogram, Ports, Server, Service, Statistics};
use acrc_syntax::units::Level;

/// Argument of the process with the controller.
pub(crate) const CONTROLLER: &str = "--serve-controller";
/// Argument of the process with the bare server.
pub(crate) const BARE: &str = "--serve-bare";

/// A process with a server. It ends when this one does.
pub(crate) struct Child {
    process: std::process::Child,
    output: BufReader<std::process::ChildStdout>,
    ports: [u16; 3],
}

impl Child {
    pub(crate) fn start(kind: &str) -> Self {
        let mut command = Command::new(std::env::current_exe().expect("this file"));
        let mut process =
            command.arg(kind).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("it is this program");
        let mut output = BufReader::new(process.stdout.take().expect("a pipe"));
        let mut line = String::new();
        output.read_line(&mut line).expect("it announces its ports");
        let ports: Vec<u16> = line.split_whitespace().map(|port| port.parse().expect("a port")).collect();
        Self { process, output, ports: ports.try_into().expect("three ports") }
    }

    pub(crate) fn ascii(&self) -> SocketAddr {
        ([127, 0, 0, 1], self.ports[0]).into()
    }

    pub(crate) fn mixed(&self) -> SocketAddr {
        ([127, 0, 0, 1], self.ports[1]).into()
    }

    pub(crate) fn fast_status(&self) -> SocketAddr {
        ([127, 0, 0, 1], self.ports[2]).into()
    }

    /// Ends it and gives what it says at its end.
    pub(crate) fn end(mut self) -> String {
        drop(self.process.stdin.take());
        let mut rest = String::new();
        self.output.read_to_string(&mut rest).expect("it prints text");
        let status = self.process.wait().expect("it ends");
        assert!(status.success(), "{status}");
        rest
    }
}

/// Tells the ports for text, for packets and for fast status.
pub(crate) fn announce(ascii: u16, mixed: u16, fast_status: u16) {
    println!("{ascii} {mixed} {fast_status}");
}

/// Waits until the other process lets go of this one.
pub(crate) fn wait_for_end() {
    let mut rest = Vec::new();
    let _ = std::io::stdin().read_to_end(&mut rest);
}

/// Sees nothing.
struct Blind;

impl Observer for Blind {
    fn output(&mut self, _: &Sent) {}
    fn fault(&mut self, fault: &FaultReport) {
        eprintln!("{fault}");
    }
    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}
    fn tick(&mut self, _: &View) {}
}

/// The controller on the network. Its last words are how well it kept time.
pub(crate) fn controller() {
    let text = crate::machine::MOVING;
    let tree = acrc_syntax::parse(text);
    let file = SourceUnit { name: "machine", text, tree: &tree, start: Level::System, implicit_program: false };
    let image = Arc::new(compile(&[file], "ACR9000").expect("the program compiles"));
    let controller = Controller::new(image, Options::default()).expect("it loads");
    let mut config = Config::new(Blind);
    config.ports = Ports::ANY;
    let server = Server::bind(controller, config).expect("ports are free");
    let port = |service| server.address(service).port();
    announce(port(Service::Ascii), port(Service::Mixed), port(Service::FastStatus));
    wait_for_end();
    server.handle().shutdown();
    let Statistics { slip, lateness, left_out, lost, .. } = server.wait().expect("no thread has panicked").statistics;
    let quantiles = |histogram: &Histogram| {
        let [middle, most] = [0.5, 0.99].map(|share| histogram.quantile(share).as_micros());
        format!("p50 {middle} us, p99 {most} us, longest {} us", histogram.longest().as_micros())
    };
    println!("slip of the simulation: {} (goal: p99 2000 us); given up: {} us", quantiles(&slip), lost.as_micros());
    println!("lateness of fast status at the sender: {}; left out: {left_out}", quantiles(&lateness));
}
