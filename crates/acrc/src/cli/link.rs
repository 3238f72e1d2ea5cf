//! The arguments of the commands that speak to a controller over the network.

use std::path::PathBuf;
use std::time::Duration;

use acrc_link::{Endpoint, Protocol, Settings};
use clap::Args;

/// Where the controller is and how long it is waited for.
#[derive(Args, Debug)]
pub(crate) struct ToArguments {
    /// The controller: a name or an address; an IPv6 address with a port stands in brackets. There is no default
    #[arg(long, value_name = "HOST[:PORT]", value_parser = parse_endpoint)]
    pub(crate) to: Endpoint,
    /// Speak text only, as on port 5002
    #[arg(long, conflicts_with = "packets")]
    pub(crate) text: bool,
    /// Speak text mixed with packets, as on port 5006
    #[arg(long)]
    pub(crate) packets: bool,
    /// The longest wait for a connection, and for an answer or the next piece of one
    #[arg(long, value_name = "TIME", default_value = "5s", value_parser = parse_wait)]
    pub(crate) timeout: Duration,
    /// How often connecting is tried again, after 0.25 s, 0.5 s, 1 s ...
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) retry: u32,
}

impl ToArguments {
    /// The port, and what is spoken there.
    pub(crate) fn protocol(&self, usual: Protocol) -> (u16, Protocol) {
        let said = match (self.text, self.packets) {
            (true, _) => Some(Protocol::Text),
            (_, true) => Some(Protocol::Mixed),
            _ => None,
        };
        self.to.resolve(said, usual)
    }

    /// How the connection is made; `interrupted` says when the user gives up.
    pub(crate) fn settings(&self, interrupted: fn() -> bool) -> Settings {
        Settings { connect: self.timeout, answer: self.timeout, retries: self.retry, interrupted }
    }
}

/// What names mean.
#[derive(Args, Debug)]
pub(crate) struct NameArguments {
    /// The axis of names that do not say one: KAMR is then AXISn.KAMR
    #[arg(long, value_name = "N")]
    pub(crate) axis: Option<u32>,
    /// The master of names that do not say one
    #[arg(long, value_name = "N")]
    pub(crate) master: Option<u32>,
    /// A project whose aliases and names of axes can be used
    #[arg(long, value_name = "PROJECT")]
    pub(crate) project: Option<PathBuf>,
}

/// `acrc get`
#[derive(Args, Debug)]
#[command(after_help = "A NAME is one of\n  \
                        P12288  BIT516        a parameter, a flag; also P(12288), BIT(516)\n  \
                        KAMR  in_motion       a field by acronym, name or title: of all axes, or of --axis N, --master N\n  \
                        AXIS1.KAMR  MASTER0.in_motion  PROG2.program_running\n  \
                        X.following_error     an axis by its name in --project\n  \
                        Camera                an alias of --project\n\
                        acrc explain NAME says what each of them is.\n\n\
                        Examples:\n  \
                        acrc get --to 192.168.10.40 P12288 BIT516\n  \
                        acrc get --to 192.168.10.40:5006 KAMR --axis 1\n  \
                        acrc get --to cell4 --project machine/ X.following_error --json\n  \
                        position=$(acrc get --to cell4 --bare P12290)\n\n\
                        Exit status: 0 all were read, 1 the controller refused one, 2 could not, 130 interrupted.")]
pub(crate) struct GetArguments {
    /// What to read
    #[arg(required = true, value_name = "NAME")]
    pub(crate) names: Vec<String>,
    #[command(flatten)]
    pub(crate) naming: NameArguments,
    #[command(flatten)]
    pub(crate) to: ToArguments,
    /// Print the values only, one on each line
    #[arg(long, conflicts_with = "json")]
    pub(crate) bare: bool,
    /// Print one JSON array
    #[arg(long)]
    pub(crate) json: bool,
}

/// `acrc set`
#[derive(Args, Debug)]
#[command(
    after_help = "A NAME is as for acrc get, and stands for one parameter or flag. A flag takes 1, 0, on or off.\n\
                        Each is written, read back and compared, in the order given; the first that fails ends it.\n\n\
                        What the catalogue knows to be read-only is refused before anything is sent. Everything but\n\
                        user parameters and user flags can move an axis, enable a drive or switch an output: that\n\
                        needs --yes, or an answer at the terminal.\n\n\
                        Examples:\n  \
                        acrc set --to 192.168.10.40 P10=2.5 P11=-1\n  \
                        acrc set --to 192.168.10.40 BIT32=on --yes\n  \
                        acrc set --to cell4 --project machine/ Lamp=off --yes\n\n\
                        Exit status: 0 all were written, 1 refused or not equal when read back, 2 could not, 130 interrupted."
)]
pub(crate) struct SetArguments {
    /// What to write
    #[arg(required = true, value_name = "NAME=VALUE")]
    pub(crate) values: Vec<String>,
    #[command(flatten)]
    pub(crate) naming: NameArguments,
    #[command(flatten)]
    pub(crate) to: ToArguments,
    /// Write also what can act on the machine, without asking
    #[arg(short, long)]
    pub(crate) yes: bool,
    /// Print one JSON array
    #[arg(long)]
    pub(crate) json: bool,
}

/// `acrc reset-kamr`
#[derive(Args, Debug)]
#[command(
    after_help = "After a fault, a limit or Ctrl-X, the flags Kill All Motion Request of the axes and Kill All Moves\n\
                        of the masters keep every motion from starting until they are cleared. Ctrl-Y clears all of them\n\
                        and moves nothing by itself; a program that waits for the flags may go on, so that needs --yes or\n\
                        an answer at the terminal. A cause that is still there sets them again: that is reported.\n\n\
                        Examples:\n  \
                        acrc reset-kamr --to 192.168.10.40\n  \
                        acrc reset-kamr --to 192.168.10.40 --show\n\n\
                        Exit status: 0 all are clear, 1 some are set, 2 could not, 130 interrupted."
)]
pub(crate) struct ResetKamrArguments {
    #[command(flatten)]
    pub(crate) to: ToArguments,
    /// Clear nothing, say which are set
    #[arg(long, conflicts_with = "yes")]
    pub(crate) show: bool,
    /// Clear them without asking
    #[arg(short, long)]
    pub(crate) yes: bool,
    /// Print one JSON object
    #[arg(long)]
    pub(crate) json: bool,
}

fn parse_endpoint(text: &str) -> Result<Endpoint, String> {
    text.parse::<Endpoint>().map_err(|error| error.to_string())
}

/// A time above zero.
pub(super) fn parse_wait(text: &str) -> Result<Duration, String> {
    let seconds = super::parse_time(text)?;
    let time = Duration::try_from_secs_f64(seconds).ok().filter(|time| !time.is_zero());
    time.ok_or_else(|| "the time must be above 0".to_owned())
}
