//! The arguments of `acrc repl`.

use std::path::PathBuf;

use acrc_controller::StreamName;
use clap::Args;

/// `acrc repl`
#[derive(Args, Debug)]
#[command(after_help = "The setup code of the project is executed and its programs are stored, as after a download.\n\
                        Programs that begin with PBOOT run; others wait for RUN. Without a project the\n\
                        controller has factory settings.\n\n\
                        A first session:\n  \
                        SYS>PROG0               to the prompt of program 0\n  \
                        P00>ATTACH              which axes it has; a command without arguments reports\n  \
                        P00>LRUN                starts it and shows what it prints; ESC brings the prompt back\n  \
                        P00>?P12288             a parameter; ?BIT516 a flag, ? name an alias\n  \
                        P00>HALT                ends the program and its motion\n  \
                        P00>HELP                the commands of this prompt; acrc explain says more about each\n\n\
                        Keys: Tab completes, Up and Ctrl-R find earlier lines, Ctrl-C quits.\n\
                        The controller has ESC (leaves LRUN, LISTEN and a statement that waits),\n\
                        Ctrl-X (ends all programs and kills all motion), Ctrl-Y (clears the kill flags)\n\
                        and Ctrl-Z (Ctrl-X, and all drives off).\n\n\
                        With standard input from a pipe or a file, standard output gets exactly the bytes\n\
                        of the controller: printf 'PROG0\\rACC\\r' | acrc repl machine/\n\n\
                        Exit status: 0 the session ended, 1 the project does not compile, 2 could not run.")]
pub(crate) struct ReplArguments {
    /// The project
    pub(crate) project: Option<PathBuf>,
    /// The controller [default: that of the project, or ACR9000]
    #[arg(long, value_name = "MODEL", value_parser = parse_model)]
    pub(crate) model: Option<&'static acrc_catalog::Model>,
    /// Virtual seconds that pass in a second, or `max`: time passes only while something goes on, and then as fast as the computer can
    /// [default: 1; max when standard input is no terminal]
    #[arg(long, value_name = "FACTOR|max", value_parser = parse_speed, allow_hyphen_values = true)]
    pub(crate) speed: Option<Speed>,
    /// The stream at which the session is typed [default: the first that the model has]
    #[arg(long, value_name = "STREAM", value_parser = parse_stream)]
    pub(crate) stream: Option<StreamName>,
    /// The machine around the controller: inputs, motors, switches, faults (docs/world.md)
    #[arg(long, value_name = "world.toml")]
    pub(crate) world: Option<PathBuf>,
    /// Folder of what the controller keeps without power; made if there is none. A session begins with what it holds
    #[arg(long, value_name = "DIR")]
    pub(crate) state: Option<PathBuf>,
    /// The controller has no battery: without power, only what was saved by command is kept
    #[arg(long, requires = "state")]
    pub(crate) no_battery: bool,
    /// Seed of the random numbers of RND
    #[arg(long, default_value_t = 0)]
    pub(crate) seed: u64,
    /// Virtual time that a session from a pipe waits, behind its last byte, for what still goes on at its channel
    #[arg(long, value_name = "TIME", default_value = "60s", value_parser = super::parse_time, allow_hyphen_values = true)]
    pub(crate) linger: f64,
}

/// How fast virtual time passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Speed {
    /// Virtual seconds in a second.
    Factor(f64),
    /// As fast as possible while something goes on.
    Max,
}

pub(super) fn parse_speed(text: &str) -> Result<Speed, String> {
    if text.eq_ignore_ascii_case("max") {
        return Ok(Speed::Max);
    }
    let factor = text.parse::<f64>().ok().filter(|factor| (0.001..=1000.0).contains(factor));
    factor.map(Speed::Factor).ok_or_else(|| "write a factor from 0.001 to 1000, or max".to_owned())
}

pub(super) fn parse_model(text: &str) -> Result<&'static acrc_catalog::Model, String> {
    acrc_catalog::model(text).ok_or_else(|| {
        let names: Vec<&str> = acrc_catalog::models().iter().map(|model| model.name).collect();
        format!("the models are {}", names.join(", "))
    })
}

fn parse_stream(text: &str) -> Result<StreamName, String> {
    text.parse::<StreamName>().map_err(|error| error.to_string())
}
