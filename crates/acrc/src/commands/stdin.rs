//! Standard input: a program for `acrc lint -` and `acrc fmt -`, or what is typed at a terminal through a pipe.

use std::io::{self, ErrorKind, Read as _};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, sync_channel};

use acrc_analysis::project::{self, LoadedProject, Overlay};
use anyhow::{Context as _, bail};
use camino::Utf8Path;

use super::project::{load_from, utf8};
use super::targets::Target;

/// The path that means standard input.
const STDIN: &str = "-";
/// What it is called without `--stdin-filename`.
const NAME: &str = "<stdin>";

/// Bytes that are read at once of what is typed.
const CHUNK: usize = 4096;

/// Whether the paths mean standard input, alone.
pub(crate) fn is_meant(paths: &[PathBuf], name: Option<&Path>) -> anyhow::Result<bool> {
    match (paths.iter().any(|path| path == Path::new(STDIN)), paths.len(), name) {
        (true, 1, _) => Ok(true),
        (true, ..) => bail!("standard input (`-`) can't be combined with other paths"),
        (false, _, Some(_)) => bail!("--stdin-filename goes with `-`, which reads standard input"),
        (false, ..) => Ok(false),
    }
}

/// Reads standard input as a file of the project that its name lies in.
pub(crate) fn load(name: Option<&Path>) -> anyhow::Result<(Target, LoadedProject)> {
    let overlay = |name: &Utf8Path| -> anyhow::Result<Overlay> { Ok(Overlay::new(name, read()?)) };
    let Some(name) = name else {
        let name = Utf8Path::new(NAME);
        let project = load_from(&overlay(name)?, name)?;
        return Ok((Target::whole(name.to_owned()), project));
    };
    let name = utf8(name)?;
    let files = overlay(name)?;
    let owner = project::owner(&files, name)?;
    let target = owner.map_or_else(|| Target::whole(name.to_owned()), |owner| Target::file(owner, name));
    let project = load_from(&files, &target.path)?;
    Ok((target, project))
}

/// Everything that comes in.
pub(crate) fn read() -> anyhow::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    std::io::stdin().lock().read_to_end(&mut bytes).context("cannot read standard input")?;
    Ok(bytes)
}

/// Reads in a thread of its own, `chunks` ahead of whoever takes them, so that something else can go on meanwhile. The end of the
/// input, and an error of it, end the channel.
pub(crate) fn read_ahead(chunks: usize) -> Receiver<io::Result<Vec<u8>>> {
    let (sender, receiver) = sync_channel(chunks);
    std::thread::spawn(move || {
        let mut input = io::stdin().lock();
        let mut buffer = [0; CHUNK];
        loop {
            let read = match input.read(&mut buffer) {
                Ok(0) => return,
                Ok(count) => Ok(buffer.iter().take(count).copied().collect()),
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                Err(error) => Err(error),
            };
            let failed = read.is_err();
            // After an error, or when the session is over, there is nothing more to read.
            if sender.send(read).is_err() || failed {
                return;
            }
        }
    });
    receiver
}
