//! The arguments of `acrc serve`.

use std::net::IpAddr;
use std::path::PathBuf;

use acrc_server::Ports;
use acrc_wire::WireOptions;
use clap::Args;

use super::Speed;
use super::repl::{parse_model, parse_speed};
use super::wire::parse_wire;

/// `acrc serve`
#[derive(Args, Debug)]
#[command(after_help = "The setup code of the project is executed and its programs are stored, as after a download.\n\
                        Programs that begin with PBOOT run. Without a project the controller has factory settings.\n\n\
                        Ports:\n  \
                        TCP 5002  a terminal, for four clients together with 5006: telnet 127.0.0.1 5002\n  \
                        TCP 5006  text in packets of four bytes, and the binary host interface\n  \
                        UDP 5003  fast status (FSTAT0 to FSTAT9), for five clients\n  \
                        TCP 5004  watchdogs, alarms, configuration file, operating system, reboot; for five clients\n\n\
                        Examples:\n  \
                        acrc serve machine --world world.toml     real time, on this computer only\n  \
                        acrc serve machine --speed max            as fast as possible, for tests of a client\n  \
                        acrc serve --ports 0,0,0,0 --json         any free ports, named on standard output\n  \
                        acrc serve machine --bind 0.0.0.0         for the whole network: nobody is asked who he is\n\n\
                        Ctrl-C closes all connections and ends; what the controller keeps without power goes to --state.\n\
                        docs/serve.md has more.\n\n\
                        Exit status: 1 the project does not compile, 2 could not run, 130 ended by Ctrl-C or SIGTERM.")]
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of the command line")]
pub(crate) struct ServeArguments {
    /// The project
    pub(crate) project: Option<PathBuf>,
    /// The machine around the controller: inputs, motors, switches, faults (docs/world.md)
    #[arg(long, value_name = "world.toml")]
    pub(crate) world: Option<PathBuf>,
    /// The address to listen at; 0.0.0.0 is every address of this computer
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1")]
    pub(crate) bind: IpAddr,
    /// The ports for text, fast status, connection management, and text with packets; 0 is any that is free
    #[arg(long, value_name = "TEXT,STATUS,MANAGEMENT,MIXED", default_value = "5002,5003,5004,5006", value_parser = parse_ports)]
    pub(crate) ports: Ports,
    /// Virtual seconds that pass in a second: `realtime` is 1. With `max`, time passes only while something goes on, and then as fast as
    /// the computer can
    #[arg(long, value_name = "realtime|max|FACTOR", default_value = "realtime", value_parser = parse_pace, allow_hyphen_values = true)]
    pub(crate) speed: Speed,
    /// Folder of what the controller keeps without power; made if there is none
    #[arg(long, value_name = "DIR")]
    pub(crate) state: Option<PathBuf>,
    /// The controller has no battery: without power, only what was saved by command is kept
    #[arg(long, requires = "state")]
    pub(crate) no_battery: bool,
    /// The controller [default: that of the project, or ACR9000]
    #[arg(long, value_name = "MODEL", value_parser = parse_model)]
    pub(crate) model: Option<&'static acrc_catalog::Model>,
    /// Seed of the random numbers of RND
    #[arg(long, default_value_t = 0)]
    pub(crate) seed: u64,
    /// Other readings of the documents about the wire, such as crc=high-bit-first (docs/serve.md)
    #[arg(long, value_name = "KEY=VALUE,...", default_value = "", hide_default_value = true, value_parser = parse_wire)]
    pub(crate) wire: WireOptions,
    /// The user parameter whose changes are user alarms on port 5004, which no document names
    #[arg(long, value_name = "PARAMETER", value_parser = parse_parameter)]
    pub(crate) user_alarm: Option<u32>,
    /// The flag Enable Rapid Move Modes of master 0, which no document numbers; that of the next master is 32 further
    #[arg(long, value_name = "BIT", value_parser = parse_bit)]
    pub(crate) rapid_move_modes: Option<u32>,
    /// Tell on standard error who connects and who leaves
    #[arg(short, long)]
    pub(crate) verbose: bool,
    /// One JSON object a line on standard output for what happens, the first one with the ports
    #[arg(long)]
    pub(crate) json: bool,
    /// At the end, say how late virtual time and fast status were
    #[arg(long)]
    pub(crate) stats: bool,
}

fn parse_ports(text: &str) -> Result<Ports, String> {
    let ports: Result<Vec<u16>, _> = text.split(',').map(|port| port.trim().parse()).collect();
    match ports.as_deref() {
        Ok([ascii, fast_status, management, mixed]) => {
            let tcp = [ascii, management, mixed];
            let clash = (0..3).any(|place| *tcp[place] != 0 && tcp[place] == tcp[(place + 1) % 3]);
            if clash {
                return Err("the three TCP ports must differ".to_owned());
            }
            Ok(Ports { ascii: *ascii, fast_status: *fast_status, management: *management, mixed: *mixed })
        }
        _ => Err("write four ports from 0 to 65535, as 5002,5003,5004,5006".to_owned()),
    }
}

fn parse_parameter(text: &str) -> Result<u32, String> {
    let digits = text.strip_prefix(['P', 'p']).unwrap_or(text);
    digits.parse().map_err(|_| "write a parameter, as P100".to_owned())
}

fn parse_bit(text: &str) -> Result<u32, String> {
    let digits = text.get(..3).filter(|word| word.eq_ignore_ascii_case("BIT")).map_or(text, |_| &text[3..]);
    digits.parse().map_err(|_| "write a flag, as BIT2053".to_owned())
}

fn parse_pace(text: &str) -> Result<Speed, String> {
    if text.eq_ignore_ascii_case("realtime") { Ok(Speed::Factor(1.0)) } else { parse_speed(text) }
}
