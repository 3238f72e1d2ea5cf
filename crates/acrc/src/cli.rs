//! The arguments of the command line.

mod fmt;
mod link;
mod lint;
mod lsp;
mod motion;
mod repl;
mod serve;
mod term;
mod transfer;
mod wire;

use std::path::PathBuf;

use acrc_controller::Port;
use acrc_image::UnitName;
use clap::{Args, Parser, Subcommand, ValueEnum};

pub(crate) use fmt::{FmtArguments, Numbering};
pub(crate) use link::{GetArguments, NameArguments, ResetKamrArguments, SetArguments, ToArguments};
pub(crate) use lint::{FailOn, LintArguments, LintFormat, OutputArguments, SelectionArguments};
pub(crate) use lsp::LspArguments;
pub(crate) use motion::{MoveArguments, WatchArguments};
pub(crate) use repl::{ReplArguments, Speed};
pub(crate) use serve::ServeArguments;
pub(crate) use term::TermArguments;
pub(crate) use transfer::{DiffArguments, DownloadArguments, SaveArgument, UploadArguments};

/// A toolchain for `AcroBASIC`, the language of Parker ACR motion controllers.
#[derive(Debug, Parser)]
#[command(
    name = "acrc",
    version,
    about = "A toolchain for AcroBASIC, the language of Parker ACR motion controllers",
    after_help = "A PROJECT is a folder with an acrc.toml, a folder with Setup.8K, ProgN.8K and PLCn.8K, or a single file.\n\
                  Exit status: 0 clean, 1 findings or run-time errors, 2 could not run, 130 interrupted."
)]
pub(crate) struct Arguments {
    /// When to use colours
    #[arg(long, global = true, value_enum, default_value_t = ColorChoice::Auto, value_name = "WHEN")]
    pub(crate) color: ColorChoice,
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// When to use colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ColorChoice {
    /// On a terminal, unless `NO_COLOR` is set
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Check programs and say what the controller would refuse or do differently
    Lint(LintArguments),
    /// Format programs
    Fmt(FmtArguments),
    /// Compile a project into an image
    Build(BuildArguments),
    /// Print the programs of an image as the controller lists them
    List(ListArguments),
    /// Show what programs and variables take of the memory, and what does not fit
    Mem(MemArguments),
    /// Run a project in virtual time and say what the machine does
    Sim(SimArguments),
    /// Talk to a virtual controller as at its terminal
    Repl(ReplArguments),
    /// Be a virtual controller on the network, for any client of an ACR controller
    Serve(ServeArguments),
    /// Show or forget what the controller of `acrc sim --state` keeps without power
    State(StateArguments),
    /// Talk to a controller as at its terminal
    Term(TermArguments),
    /// Send a project to a controller, and verify it
    Download(DownloadArguments),
    /// Read what a controller has back into files
    Upload(UploadArguments),
    /// Compare a project with what a controller has
    Diff(DiffArguments),
    /// Read parameters and flags of a controller
    Get(GetArguments),
    /// Write parameters and flags of a controller, and read them back
    Set(SetArguments),
    /// Move axes of a controller, and stop them at Ctrl-C
    Move(MoveArguments),
    /// Watch parameters and flags of a controller while they change
    Watch(WatchArguments),
    /// Clear the flags of a controller that keep motion from starting
    ResetKamr(ResetKamrArguments),
    /// Serve an editor with findings, completion and all the rest (language server protocol)
    Lsp(LspArguments),
    /// Say what is known of a command, function, parameter, bit, controller model or diagnostic
    Explain(ExplainArguments),
}

/// `acrc build`
#[derive(Args, Debug)]
#[command(
    after_help = "Nothing is written unless the whole project compiles, and no file appears before all are complete.\n\
                        A `-` for a file is standard output.\n\
                        Exit status: 0 written, 1 the project has errors, 2 could not run."
)]
pub(crate) struct BuildArguments {
    /// The project
    #[arg(default_value = ".")]
    pub(crate) project: PathBuf,
    /// The image to write
    #[arg(short, long, value_name = "FILE.acrx", required_unless_present_any = ["listing", "map"])]
    pub(crate) output: Option<PathBuf>,
    /// Write the words of each statement beside its source
    #[arg(long, value_name = "FILE")]
    pub(crate) listing: Option<PathBuf>,
    /// Write where units, lines, labels and aliases are and what the bytes go to; JSON when the name ends in .json
    #[arg(long, value_name = "FILE")]
    pub(crate) map: Option<PathBuf>,
    /// Leave out the places in the source, which run-time errors are reported with
    #[arg(long)]
    pub(crate) strip: bool,
}

/// `acrc list`
#[derive(Args, Debug)]
#[command(
    after_help = "An image whose setup code protects it with PASSWORD lists its programs with --password only.\n\
                        Exit status: 0 listed, 2 could not run."
)]
pub(crate) struct ListArguments {
    /// The image
    #[arg(value_name = "FILE.acrx")]
    pub(crate) image: PathBuf,
    /// List only these programs
    #[arg(long = "program", value_name = "PROGn,PLCn,...", value_delimiter = ',', value_parser = parse_text)]
    pub(crate) programs: Vec<UnitName>,
    /// Number all lines, as the controller does while flag 5651 is set; without it, lines written with a number show it
    #[arg(short = 'n', long)]
    pub(crate) line_numbers: bool,
    /// Name flags and parameters in apostrophe comments above their lines; such a listing still compiles to the same program
    #[arg(long)]
    pub(crate) annotate: bool,
    /// The password of a protected image
    #[arg(long, value_name = "TEXT")]
    pub(crate) password: Option<String>,
}

/// `acrc mem`
#[derive(Args, Debug)]
#[command(after_help = "A controller shares its memory out twice. The setup gives a part of the system\n\
                        memory to each program, to the user parameters and to the aliases:\n  \
                        DIM PROG0(8192)   DIM P(100)   DIM DEF(20)\n\
                        A program shares its part between its text, its variables (DIM LV(4)) and its\n\
                        subroutine calls. What does not fit is not stored, or stops the program.\n\n\
                        Texts are counted as they are stored, to the byte. A size that a program\n\
                        computes is shown as ?, and what the program needs as \"at least\".\n\n\
                        Exit status: 0 everything fits, 1 something does not or the project has errors,\n\
                        2 could not run.")]
pub(crate) struct MemArguments {
    /// The project
    #[arg(default_value = ".")]
    pub(crate) project: PathBuf,
    /// How the account is shown
    #[arg(long, value_enum, default_value_t = MemFormat::Text)]
    pub(crate) format: MemFormat,
}

/// Forms of the account of memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum MemFormat {
    /// Bars and numbers
    Text,
    /// One JSON object
    Json,
}

/// `acrc sim`
#[derive(Args, Debug)]
#[command(after_help = "Without --run, the programs that begin with PBOOT are started, as at power-up.\n\
                        A program that never ends is stopped at --until; that is no error.\n\
                        With --state, the controller begins with what DIR keeps, takes the project as a download,\n\
                        and saves at ESAVE, ERASE, FLASH ... and when the run ends, which is when power goes off.\n\
                        Standard input is read to its end before the run begins.\n\n\
                        --trace, --plot and --report show the same SIGNALS, a list of:\n  \
                        P12288  BIT34            any parameter, any flag\n  \
                        Camera  light_curtain    aliases of the project, inputs that the world names\n  \
                        X                        position, velocity, acceleration, following error of an axis\n  \
                        X.jog_offset  AXIS0.FE   a quantity of an axis, by name or acronym\n  \
                        MASTER0.vector_velocity  the same of MASTERn, PROGn, PLCn, ENCn, DACn, ADCn\n  \
                        usual                    every axis, and the inputs and outputs used\n\
                        docs/traces.md has more. Example:\n  \
                        acrc sim machine --signals usual,P12297 --rate 500us --trace run.parquet --report run.html\n\n\
                        --world describes the machine (docs/world.md): names of inputs, [axis.0] and so on, events. Example:\n  \
                        [axis.0]\n  \
                        plant = { kind = \"motor\", inertia = 2e-5, torque_constant = 0.157, lines = 4000 }\n  \
                        switches = [{ input = 2, from = 0.0, to = 2.0 }, { input = 0, above = 100.0 }]\n  \
                        [[event]]\n  \
                        at = \"2s\"\n  \
                        jam = [0]\n\n\
                        Exit status: 0 the run went well, 1 a run-time error occurred, 2 could not run, 130 interrupted.")]
pub(crate) struct SimArguments {
    /// The project
    #[arg(default_value = ".")]
    pub(crate) project: PathBuf,
    /// Programs to start
    #[arg(long, value_name = "PROGn,...", value_delimiter = ',', value_parser = parse_program)]
    pub(crate) run: Vec<u8>,
    /// The machine around the controller: inputs, motors, switches, faults (docs/world.md)
    #[arg(long, value_name = "world.toml")]
    pub(crate) world: Option<PathBuf>,
    /// Virtual time at which the run ends: 60s, 1500ms, 5min, 1h [default: 60s, or what acrc.toml says]
    #[arg(long, value_name = "TIME", value_parser = parse_time, allow_hyphen_values = true)]
    pub(crate) until: Option<f64>,
    /// Write the signals over time: as Parquet when the name ends in .parquet, else as CSV
    #[arg(long, value_name = "FILE")]
    pub(crate) trace: Option<PathBuf>,
    /// Signals to record, see below [default: usual]
    #[arg(long, value_name = "NAME,...", value_delimiter = ',')]
    pub(crate) signals: Vec<String>,
    /// Virtual time from one sample to the next, a multiple of the servo period [default: 1ms]
    #[arg(long, alias = "trace-every", value_name = "TIME", value_parser = parse_time, allow_hyphen_values = true)]
    pub(crate) rate: Option<f64>,
    /// Draw the run
    #[arg(long, value_name = "FILE.svg")]
    pub(crate) plot: Option<PathBuf>,
    /// Write one page to look around the run in a browser: plots to zoom, output, faults, the statement at the cursor
    #[arg(long, value_name = "FILE.html")]
    pub(crate) report: Option<PathBuf>,
    /// Parameters and flags to report at the end
    #[arg(long, value_name = "P12288,BIT32,...", value_delimiter = ',', value_parser = parse_register)]
    pub(crate) read: Vec<Register>,
    /// Folder of what the controller keeps without power; made if there is none
    #[arg(long, value_name = "DIR")]
    pub(crate) state: Option<PathBuf>,
    /// Send no project: switch the controller on and run what the state holds
    #[arg(long, requires = "state", conflicts_with = "project")]
    pub(crate) stored: bool,
    /// The controller has no battery: without power, only what was saved by command is kept
    #[arg(long)]
    pub(crate) no_battery: bool,
    /// Seed of the random numbers of RND
    #[arg(long, default_value_t = 0)]
    pub(crate) seed: u64,
    /// What SIN and its like take, which no document says [default: radians, or what acrc.toml says]
    #[arg(long, value_enum, value_name = "UNIT")]
    pub(crate) angles: Option<Angles>,
    /// Type the lines of a file at a stream (COM1=FILE), or to a program as who listens to it (PROG0=FILE), whenever it asks; `-` is standard input
    #[arg(long, value_name = "NAME=FILE", value_parser = parse_port_file)]
    pub(crate) input: Vec<PortFile>,
    /// Write what is sent to a stream (COM1=FILE), or to who listens to a program (PROG0=FILE)
    #[arg(long, value_name = "NAME=FILE", value_parser = parse_port_file)]
    pub(crate) output: Vec<PortFile>,
    /// How the run is shown
    #[arg(long, value_enum, default_value_t = SimFormat::Text)]
    pub(crate) format: SimFormat,
}

/// Unit of angles in functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Angles {
    /// As in the library of most languages
    Radians,
    /// As in SINE and ROTATE
    Degrees,
}

/// A stream or the terminal of a program, and the file that stands for it.
#[derive(Clone, Debug)]
pub(crate) struct PortFile {
    pub(crate) port: Port,
    pub(crate) path: PathBuf,
}

/// Forms of the report of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SimFormat {
    /// Output of the programs as it happens, then a summary
    Text,
    /// One JSON object at the end
    Json,
}

/// `acrc state`
#[derive(Args, Debug)]
#[command(after_help = "Exit status: 0 done, 2 the state cannot be used.")]
pub(crate) struct StateArguments {
    /// What to do with it
    #[arg(value_enum)]
    pub(crate) action: StateAction,
    /// The folder
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,
}

/// What `acrc state` does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum StateAction {
    /// Say what the controller has when it is switched on
    Show,
    /// Forget everything, as a controller that comes from the factory
    Reset,
}

/// `acrc explain`
#[derive(Args, Debug)]
#[command(
    after_help = "Examples: acrc explain JOG HOME, acrc explain P12290, acrc explain BIT8467, acrc explain KAMR, acrc explain ACR101"
)]
pub(crate) struct ExplainArguments {
    /// What to explain
    #[arg(required = true, value_name = "TOPIC")]
    pub(crate) topic: Vec<String>,
}

/// A parameter or flag by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Register {
    /// `P12288`
    Parameter(u32),
    /// `BIT32`
    Bit(u32),
}

fn parse_program(text: &str) -> Result<u8, String> {
    let digits = text.get(..4).filter(|word| word.eq_ignore_ascii_case("PROG")).map_or(text, |_| &text[4..]);
    let number = digits.trim().parse::<u8>().ok().filter(|number| *number < 16);
    number.ok_or_else(|| "programs are PROG0 to PROG15".to_owned())
}

/// A stored text: a program, or a PLC program.
pub(crate) fn parse_text(text: &str) -> Result<UnitName, String> {
    let plc = text.get(..3).filter(|word| word.eq_ignore_ascii_case("PLC"));
    let number = plc.and_then(|_| text[3..].trim().parse::<u8>().ok()).filter(|number| *number < 8);
    match (plc, number) {
        (Some(_), Some(number)) => Ok(UnitName::Plc(number)),
        (Some(_), None) => Err("PLC programs are PLC0 to PLC7".to_owned()),
        (None, _) => parse_program(text).map(UnitName::Program),
    }
}

fn parse_port_file(text: &str) -> Result<PortFile, String> {
    let (port, path) = text.split_once('=').filter(|(_, path)| !path.is_empty()).ok_or("write NAME=FILE")?;
    let port =
        port.parse::<Port>().map_err(|error| format!("{error}; PROG0 is the terminal that listens to program 0"))?;
    Ok(PortFile { port, path: path.into() })
}

fn parse_time(text: &str) -> Result<f64, String> {
    acrc_controller::time::parse_duration(text).map_err(|error| error.to_string())
}

fn parse_register(text: &str) -> Result<Register, String> {
    let upper = text.trim().to_ascii_uppercase();
    let number = |digits: &str| digits.trim().parse::<u32>().ok();
    let register = match (upper.strip_prefix("BIT"), upper.strip_prefix('P')) {
        (Some(digits), _) => number(digits).map(Register::Bit),
        (None, Some(digits)) => number(digits).map(Register::Parameter),
        (None, None) => None,
    };
    register.ok_or_else(|| "write P and a number or BIT and a number, for example P12288 or BIT32".to_owned())
}

impl std::fmt::Display for Register {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Parameter(number) => write!(f, "P{number}"),
            Self::Bit(number) => write!(f, "BIT{number}"),
        }
    }
}
