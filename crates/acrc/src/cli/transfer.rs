//! The arguments of `acrc download`, `acrc upload` and `acrc diff`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::link::ToArguments;

/// `acrc download`
#[derive(Args, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "independent switches of the command line")]
#[command(
    after_help = "First the project is checked: errors of the linter or the compiler, programs without memory and\n\
                        lines that cannot be sent stop it before a connection is made. Then the controller is asked what it\n\
                        has and does. It is left alone while a program runs (--halt halts all), something moves, or a drive\n\
                        is enabled (--with-drives-enabled allows it).\n\n\
                        What will be erased is shown, and has to be confirmed at the terminal or with --yes. The files are\n\
                        sent in their order, and the answer to every line is looked at. Where the setup shares out memory\n\
                        (DIM PROG0 ...) but does not make room for that, NEW ALL, CLEAR and DETACH ALL come first.\n\
                        Programs that are on the controller already are not sent again, unless --everything is given.\n\
                        At the end every program is listed and compared word by word.\n\n\
                        When the connection breaks, the download is taken up again, --attempts times; running the same\n\
                        command later does so too. Ctrl-C ends it between two lines. A program that was being entered\n\
                        is erased then, so that its beginning cannot be run.\n\n\
                        Examples:\n  \
                        acrc download machine/ --to 192.168.10.40 --plan\n  \
                        acrc download machine/ --to 192.168.10.40\n  \
                        acrc download machine/ --to cell4 --halt --yes --save flash,eeprom --run\n  \
                        acrc download Prog3.8K --to cell4 --yes --run=PROG3\n\n\
                        Exit status: 0 sent and verified, 1 the project, the controller or the comparison is against it,\n\
                        2 could not, 130 interrupted."
)]
pub(crate) struct DownloadArguments {
    /// The project
    #[arg(default_value = ".")]
    pub(crate) project: PathBuf,
    #[command(flatten)]
    pub(crate) to: ToArguments,
    /// Show what would be erased and sent, and send nothing
    #[arg(long)]
    pub(crate) plan: bool,
    /// Do not ask
    #[arg(short, long)]
    pub(crate) yes: bool,
    /// Halt programs that run, and wait until their motion has ended
    #[arg(long)]
    pub(crate) halt: bool,
    /// Go on although drives are enabled
    #[arg(long)]
    pub(crate) with_drives_enabled: bool,
    /// Send every program, also those that are there already
    #[arg(long)]
    pub(crate) everything: bool,
    /// List every program at the end and compare it (the default)
    #[arg(long, overrides_with = "no_verify")]
    pub(crate) verify: bool,
    /// Do not list and compare
    #[arg(long)]
    pub(crate) no_verify: bool,
    /// What lifts the protection of the programs on the controller [default: the PASSWORD of the project]
    #[arg(long, value_name = "TEXT")]
    pub(crate) password: Option<String>,
    /// Save at the end: flash writes programs, memory and aliases (FLASH IMAGE), eeprom the settings (ESAVE)
    #[arg(long, value_enum, value_name = "MEMORY,...", value_delimiter = ',')]
    pub(crate) save: Vec<SaveArgument>,
    /// Start programs at the end: these, else those that acrc.toml names, else those that begin with PBOOT
    #[arg(long, value_name = "PROGn,...", num_args = 0..=1, require_equals = true, default_missing_value = "")]
    pub(crate) run: Option<String>,
    /// How often a download whose connection breaks is taken up again
    #[arg(long, value_name = "N", default_value_t = 3)]
    pub(crate) attempts: u32,
    /// Print what happens as JSON, an object on each line
    #[arg(long)]
    pub(crate) json: bool,
}

/// A memory that outlasts power.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SaveArgument {
    /// Programs, memory and aliases
    Flash,
    /// System parameters
    Eeprom,
}

/// `acrc upload`
#[derive(Args, Debug)]
#[command(
    after_help = "Each program becomes a file (Prog0.8K, PLC0.8K), memory, aliases and attachments become Setup.8K, so\n\
                        that the folder is a project. A controller keeps no setup code: what else it has been told (gains,\n\
                        PPU, limits) is not in it. A controller keeps no apostrophe comments either. With --project, lines\n\
                        that are the same there are written as they stand in that project, with the comments above and\n\
                        behind them.\n\n\
                        Examples:\n  \
                        acrc upload --to 192.168.10.40 --out cell4/\n  \
                        acrc upload --to 192.168.10.40 --out cell4/ --project machine/\n\n\
                        Exit status: 0 everything was read, 1 something could not be read, 2 could not, 130 interrupted."
)]
pub(crate) struct UploadArguments {
    #[command(flatten)]
    pub(crate) to: ToArguments,
    /// The folder to write to; made if there is none
    #[arg(long, value_name = "DIR")]
    pub(crate) out: PathBuf,
    /// A project with the comments
    #[arg(long, value_name = "PROJECT")]
    pub(crate) project: Option<PathBuf>,
    /// Replace files that are there
    #[arg(long)]
    pub(crate) force: bool,
    /// Print one JSON object
    #[arg(long)]
    pub(crate) json: bool,
}

/// `acrc diff`
#[derive(Args, Debug)]
#[command(
    after_help = "Programs are compared as they are stored: comments, blanks and the case of words do not count. Lines\n\
                        with - are those of the project, lines with + those of the controller.\n\n\
                        Examples:\n  \
                        acrc diff machine/ --to 192.168.10.40\n  \
                        acrc diff machine/ --to cell4 --json\n\n\
                        Exit status: 0 equal, 1 different, 2 could not, 130 interrupted."
)]
pub(crate) struct DiffArguments {
    /// The project
    #[arg(default_value = ".")]
    pub(crate) project: PathBuf,
    #[command(flatten)]
    pub(crate) to: ToArguments,
    /// Print one JSON object
    #[arg(long)]
    pub(crate) json: bool,
}
