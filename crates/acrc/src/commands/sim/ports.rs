//! Files that stand for streams, and for the terminals that listen to programs.

use std::collections::BTreeMap;
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};

use acrc_controller::{Controller, Port, Sent};
use acrc_image::UnitName;
use anyhow::{Context as _, bail};

use crate::cli::{PortFile, SimArguments};
use crate::output::OutputFile;

/// Refuses ports that the model of the controller does not have, and ports with two files.
pub(super) fn check(arguments: &SimArguments, controller: &Controller) -> anyhow::Result<()> {
    let model = controller.model();
    for (flag, files) in [("--input", &arguments.input), ("--output", &arguments.output)] {
        for (index, file) in files.iter().enumerate() {
            file.port.check(model).context(flag)?;
            if files.iter().take(index).any(|other| other.port == file.port) {
                bail!("{flag}: {} is named twice", file.port);
            }
        }
    }
    let standard = arguments.input.iter().filter(|input| is_standard_input(&input.path)).count();
    if standard > 1 {
        bail!("--input: standard input can be typed at one place only");
    }
    for (index, event) in controller.view().world().events().iter().enumerate() {
        if let Some(typed) = &event.typed {
            typed.port.check(model).with_context(|| format!("the world: event {} in order of time", index + 1))?;
        }
    }
    Ok(())
}

/// Gives the programs what the files hold.
pub(super) fn offer(files: &[PortFile], controller: &mut Controller) -> anyhow::Result<()> {
    for PortFile { port, path } in files {
        let text = if is_standard_input(path) {
            let mut text = Vec::new();
            std::io::stdin().read_to_end(&mut text).context("cannot read standard input")?;
            text
        } else {
            std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?
        };
        controller.offer(*port, &text);
    }
    Ok(())
}

fn is_standard_input(path: &Path) -> bool {
    path == Path::new("-")
}

/// Files that get what is sent to ports.
pub(super) struct Outputs {
    files: BTreeMap<Port, (PathBuf, OutputFile)>,
}

impl Outputs {
    /// Begins the files.
    pub(super) fn create(files: &[PortFile]) -> anyhow::Result<Self> {
        let begun = files.iter().map(|PortFile { port, path }| {
            let file = OutputFile::create(path)?;
            Ok((*port, (path.clone(), file)))
        });
        Ok(Self { files: begun.collect::<anyhow::Result<_>>()? })
    }

    /// Writes what was sent to the file of its port, if it has one. Characters are bytes there, as on the line.
    pub(super) fn write(&mut self, sent: &Sent) -> anyhow::Result<()> {
        let listener = match sent.unit {
            UnitName::Program(number) => Some(Port::Listener(number)),
            UnitName::Boot | UnitName::Plc(_) => None,
        };
        let port = sent.stream.map(Port::Stream).or(listener);
        let Some((path, file)) = port.and_then(|port| self.files.get_mut(&port)) else { return Ok(()) };
        let bytes: Vec<u8> = sent.text.chars().map(|character| u8::try_from(character).unwrap_or(b'?')).collect();
        file.write_all(&bytes).with_context(|| format!("cannot write {}", path.display()))
    }

    /// Completes the files; gives back what each is and where.
    pub(super) fn finish(self) -> anyhow::Result<Vec<(&'static str, PathBuf)>> {
        let mut files = Vec::with_capacity(self.files.len());
        for (path, file) in self.files.into_values() {
            file.finish()?;
            files.push(("output", path));
        }
        Ok(files)
    }
}
