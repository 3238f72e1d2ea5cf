//! What the commands that speak to a controller share: the connection, Ctrl-C, names, confirmation.

use std::io::{BufRead as _, IsTerminal as _};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use acrc_catalog::{ObjectKind, OperandClass};
use acrc_image::{Alias, Node};
use acrc_link::values::{Names, Register};
use acrc_link::{Connection, LinkError, Protocol, Tcp};
use anyhow::Context as _;

use super::project::{compile, load};
use super::sim::attached_axes;
use crate::cli::{NameArguments, ToArguments};
use crate::exit::Exit;
use crate::output::{Terminal, tell};

/// The longest time between two looks at whether the user gives up.
const BEAT: Duration = Duration::from_millis(50);

/// Ctrl-C was pressed.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Whether Ctrl-C was pressed.
pub(super) fn interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}

/// From now on Ctrl-C ends what waits, and not the process: a connection is to be ended properly.
pub(super) fn watch_interrupt() -> anyhow::Result<()> {
    ctrlc::set_handler(|| INTERRUPTED.store(true, Ordering::Relaxed)).context("cannot watch for Ctrl-C")
}

/// Connects to the controller of `--to`.
pub(super) fn connect(arguments: &ToArguments, usual: Protocol) -> Result<Connection<Tcp>, LinkError> {
    Connection::open(&arguments.to, arguments.protocol(usual), arguments.settings(interrupted))
}

/// How a command ends with an error of the connection: a controller that refuses is a finding, everything else a failure.
pub(super) fn failed(error: LinkError, terminal: Terminal) -> Exit {
    let exit = match &error {
        LinkError::Interrupted => return Exit::Interrupted,
        LinkError::Refused { .. } => Exit::Findings,
        _ => Exit::Failure,
    };
    crate::exit::say(&error.into(), terminal);
    exit
}

/// The names that can be used. `None` when the project does not compile.
pub(super) fn names(arguments: &NameArguments, terminal: Terminal) -> anyhow::Result<Option<Names>> {
    let usual = [(ObjectKind::Axis, arguments.axis), (ObjectKind::Master, arguments.master)];
    let usual = usual.into_iter().filter_map(|(kind, index)| Some((kind, index?))).collect();
    let names = Names { usual, ..Names::default() };
    arguments.project.as_deref().map_or(Ok(Some(names.clone())), |path| with_project(names, path, terminal))
}

fn with_project(names: Names, path: &Path, terminal: Terminal) -> anyhow::Result<Option<Names>> {
    let project = load(path)?;
    let Some(image) = compile(&project, "is not used", terminal) else { return Ok(None) };
    let aliases = image.aliases.iter().map(|alias| (alias.name.clone(), register(alias))).collect();
    let axes = attached_axes(&image);
    Ok(Some(Names { model: project.model, aliases, axes, ..names }))
}

/// The parameter or flag that an alias stands for.
fn register(alias: &Alias) -> Option<Register> {
    let Node::Scalar { class, index, .. } = &alias.target else { return None };
    let Node::Long(number) = **index else { return None };
    let number = u32::try_from(number).ok()?;
    match class {
        OperandClass::Parameter => Some(Register::Parameter(number)),
        OperandClass::Bit => Some(Register::Bit(number)),
        _ => None,
    }
}

/// What was answered to a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Consent {
    Given,
    Denied,
    /// Ctrl-C.
    Interrupted,
}

/// Asks at the terminal. Without one, what needs an answer is not done.
pub(super) fn confirm(question: &str, without: &str) -> anyhow::Result<Consent> {
    let stdin = std::io::stdin();
    if !stdin.is_terminal() {
        anyhow::bail!("{without}: add --yes");
    }
    tell(|err| write!(err, "{question} [y/N] ").and_then(|()| err.flush()));
    // Ctrl-C does not end the reading of a line. The thread that waits for one ends with the process.
    let (sender, answers) = mpsc::channel();
    std::thread::spawn(move || {
        let mut answer = String::new();
        sender.send(stdin.lock().read_line(&mut answer).map(|_| answer))
    });
    loop {
        let answer = match answers.recv_timeout(BEAT) {
            _ if interrupted() => {
                tell(|err| writeln!(err));
                return Ok(Consent::Interrupted);
            }
            Err(RecvTimeoutError::Timeout) => continue,
            Ok(answer) => answer.context("cannot read the answer")?,
            Err(RecvTimeoutError::Disconnected) => anyhow::bail!("cannot read the answer"),
        };
        let given = matches!(answer.trim(), "y" | "Y" | "yes");
        return Ok(if given { Consent::Given } else { Consent::Denied });
    }
}
