//! The arguments of `acrc move` and `acrc watch`.

use std::time::Duration;

use acrc_link::motion::Target;
use clap::Args;

use super::link::{NameArguments, ToArguments, parse_wait};

/// `acrc move`
#[derive(Args, Debug)]
#[command(
    after_help = "The axes are those that the program has attached, and they start and end together. What stands in\n\
                        the way is found out first: kill requests, a move, a program that runs. Then the move is shown\n\
                        and has to be confirmed, at the terminal or with --yes. The position is shown until it stands.\n\n\
                        Ctrl-C sets Stop All Moves of the master: it ramps down with its DEC, what is left of the move is\n\
                        given up, and Kill All Moves stays set until acrc reset-kamr clears it. That is no emergency stop:\n\
                        it needs the network and a controller that answers.\n\n\
                        Examples:\n  \
                        acrc move --to 192.168.10.40 --prog 0 X10 Y-20\n  \
                        acrc move --to 192.168.10.40 --prog 0 X/0.5 --velocity 2 --yes\n\n\
                        Exit status: 0 it stands at its targets, 1 refused or stopped by the controller, 2 could not,\n\
                        130 stopped by Ctrl-C."
)]
pub(crate) struct MoveArguments {
    /// Where to: X10, X-2.5, or X/-2.5 for a distance; X1=10 where the name of an axis ends with a digit
    #[arg(required = true, value_name = "AXIS[/]TARGET", value_parser = parse_target)]
    pub(crate) targets: Vec<Target>,
    /// The program whose axes are meant
    #[arg(long, value_name = "N", value_parser = super::parse_program)]
    pub(crate) prog: u8,
    #[command(flatten)]
    pub(crate) to: ToArguments,
    /// The velocity of this move in units of the master per second; the program's is set again behind it
    #[arg(long, value_name = "V", value_parser = parse_velocity)]
    pub(crate) velocity: Option<f64>,
    /// Move without asking
    #[arg(short, long)]
    pub(crate) yes: bool,
    /// Print one JSON object at the end
    #[arg(long)]
    pub(crate) json: bool,
}

/// `acrc watch`
#[derive(Args, Debug)]
#[command(
    after_help = "A terminal shows a table of the present values; a pipe or --csv gets a line for each sample: seconds\n\
                        since the first, then the values. Port 5006 is spoken unless --to says otherwise, since packets are\n\
                        faster. At the end, standard error gets the number of samples, the rate, and how many were missed\n\
                        because an answer took longer than --every.\n\n\
                        With --fast-status the controller sends the values by itself over UDP, every 1 ms or slower. It\n\
                        sends what its groups FSTAT0 to FSTAT9 hold; --set-groups sets as many as are needed, for\n\
                        everybody who gets fast status from it, until somebody sets them otherwise.\n\n\
                        NAMES are as for acrc get. Examples:\n  \
                        acrc watch --to 192.168.10.40 P12288 BIT516\n  \
                        acrc watch --to 192.168.10.40 --axis 0 following_error --every 5ms --for 10s --csv > fe.csv\n  \
                        acrc watch --to 192.168.10.40 P12290 BIT516 --fast-status --set-groups --every 1ms --for 5s --csv\n\n\
                        Exit status: 0 the time is over or Ctrl-C without --for, 1 the controller refused, 2 could not,\n\
                        130 interrupted before --for was over."
)]
pub(crate) struct WatchArguments {
    /// What to watch
    #[arg(required = true, value_name = "NAME")]
    pub(crate) names: Vec<String>,
    #[command(flatten)]
    pub(crate) naming: NameArguments,
    #[command(flatten)]
    pub(crate) to: ToArguments,
    /// From one sample to the next
    #[arg(long, value_name = "TIME", default_value = "100ms", value_parser = parse_wait)]
    pub(crate) every: Duration,
    /// How long; otherwise until Ctrl-C
    #[arg(long = "for", value_name = "TIME", value_parser = parse_wait)]
    pub(crate) span: Option<Duration>,
    #[command(flatten)]
    pub(crate) fast: FastArguments,
    /// Write lines with commas, also to a terminal
    #[arg(long, conflicts_with = "json")]
    pub(crate) csv: bool,
    /// Write one JSON object for each sample
    #[arg(long)]
    pub(crate) json: bool,
}

/// How `acrc watch` uses fast status.
#[derive(Args, Debug)]
pub(crate) struct FastArguments {
    /// Let the controller send the values by itself, over UDP
    #[arg(long)]
    pub(crate) fast_status: bool,
    /// Set the groups of fast status that are needed, for every client of the controller
    #[arg(long, requires = "fast_status")]
    pub(crate) set_groups: bool,
    /// The port of fast status [default: 5003]
    #[arg(long, value_name = "PORT", requires = "fast_status")]
    pub(crate) fast_port: Option<u16>,
}

fn parse_target(text: &str) -> Result<Target, String> {
    text.parse()
}

fn parse_velocity(text: &str) -> Result<f64, String> {
    let velocity = text.parse::<f64>().ok().filter(|velocity| velocity.is_finite() && *velocity > 0.0);
    velocity.ok_or_else(|| "the velocity must be above 0".to_owned())
}
