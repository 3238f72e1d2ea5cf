//! What goes to the terminal and into files.

use std::fs::{File, Metadata, Permissions};
use std::io::{self, BufWriter, IsTerminal as _, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::Context as _;
use tempfile::NamedTempFile;

use crate::cli::ColorChoice;

/// Whether a stream takes colours.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Terminal {
    /// Colours may be used.
    pub(crate) color: bool,
}

impl Terminal {
    /// For standard output.
    pub(crate) fn output(choice: ColorChoice) -> Self {
        Self::new(choice, io::stdout().is_terminal())
    }

    /// For standard error.
    pub(crate) fn error(choice: ColorChoice) -> Self {
        Self::new(choice, io::stderr().is_terminal())
    }

    /// `NO_COLOR` (no-color.org) counts when it is set and not empty; `--color` overrules it.
    fn new(choice: ColorChoice, terminal: bool) -> Self {
        let color = match choice {
            ColorChoice::Always => true,
            ColorChoice::Never => false,
            ColorChoice::Auto => {
                let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
                let dumb = std::env::var_os("TERM").is_some_and(|value| value == "dumb");
                terminal && !refused && !dumb
            }
        };
        Self { color }
    }

    fn paint(self, code: &str, text: &str) -> String {
        if self.color { format!("\u{1b}[{code}m{text}\u{1b}[0m") } else { text.to_owned() }
    }

    /// A word that announces an error.
    pub(crate) fn error_word(self, text: &str) -> String {
        self.paint("1;31", text)
    }

    /// A word that announces a warning.
    pub(crate) fn warning_word(self, text: &str) -> String {
        self.paint("1;33", text)
    }

    /// Text that heads a part.
    pub(crate) fn heading(self, text: &str) -> String {
        self.paint("1", text)
    }

    /// Text of less weight.
    pub(crate) fn faint(self, text: &str) -> String {
        self.paint("2", text)
    }
}

/// The reader of standard output went away.
static NOBODY_READS: AtomicBool = AtomicBool::new(false);

/// A writer that takes everything. A reader that goes away (`acrc lint | head`) sees no more of it and changes nothing
/// else: what is left to do is done, and the exit status is the one that it would have been.
#[derive(Debug)]
pub(crate) struct Patient<W> {
    inner: W,
    /// The reader went away.
    alone: bool,
}

impl<W: Write> Patient<W> {
    pub(crate) fn new(inner: W) -> Self {
        Self { inner, alone: false }
    }

    fn go_on<T>(&mut self, result: io::Result<T>, instead: T) -> io::Result<T> {
        match result {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {
                self.alone = true;
                Ok(instead)
            }
            other => other,
        }
    }
}

impl<W: Write> Write for Patient<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.alone {
            return Ok(bytes.len());
        }
        let result = self.inner.write(bytes);
        self.go_on(result, bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.alone {
            return Ok(());
        }
        let result = self.inner.flush();
        self.go_on(result, ())
    }
}

/// Writes to standard output and tells whether that worked, up to the last byte.
pub(crate) fn print(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> anyhow::Result<()> {
    let mut out = BufWriter::new(Patient::new(io::stdout().lock()));
    let written = write(&mut out).and_then(|()| out.flush());
    // What could not be written is not tried again when the buffer goes.
    let (inner, _) = out.into_parts();
    if inner.alone {
        NOBODY_READS.store(true, Ordering::Relaxed);
    }
    written.context("cannot write to standard output")
}

/// Whether the reader of standard output went away.
pub(crate) fn nobody_reads() -> bool {
    NOBODY_READS.load(Ordering::Relaxed)
}

/// Writes to standard error, as one piece. When that is gone too, nothing is left to tell it to.
pub(crate) fn tell(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) {
    let mut text = Vec::new();
    let _ = write(&mut text).and_then(|()| io::stderr().lock().write_all(&text));
}

/// A file that appears under its name only when it is complete: it is written beside its place and renamed. A device or a pipe is written in
/// place, since it is not to be replaced.
#[derive(Debug)]
pub(crate) struct OutputFile {
    path: PathBuf,
    /// Of the file that is replaced.
    permissions: Option<Permissions>,
    file: BufWriter<Place>,
}

#[derive(Debug)]
enum Place {
    Beside(NamedTempFile),
    Direct(Patient<File>),
    /// `-`
    Standard(Patient<io::Stdout>),
}

/// Does a path stand for standard output?
pub(crate) fn is_standard_output(path: &Path) -> bool {
    path == Path::new("-") || path == Path::new("/dev/stdout")
}

impl OutputFile {
    /// Begins a file. Fails at once when its folder does not exist or cannot be written.
    pub(crate) fn create(path: &Path) -> anyhow::Result<Self> {
        let refuse = || format!("cannot write {}", path.display());
        let stream = if path == Path::new("-") {
            Some(Place::Standard(Patient::new(io::stdout())))
        } else {
            let stream = standard_stream(path).transpose().with_context(refuse)?;
            stream.map(|stream| Place::Direct(Patient::new(stream)))
        };
        if let Some(place) = stream {
            return Ok(Self {
                path: path.to_owned(),
                permissions: None,
                file: BufWriter::with_capacity(1 << 16, place),
            });
        }
        // A link keeps pointing where it points; its target is what is written.
        let target = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let place = match target.metadata() {
            Ok(found) if !found.is_file() => {
                Place::Direct(Patient::new(File::options().write(true).open(&target).with_context(refuse)?))
            }
            _ => {
                let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
                if !folder.is_dir() {
                    anyhow::bail!("{}: its folder does not exist", refuse());
                }
                let file = tempfile::Builder::new().prefix(".acrc-").tempfile_in(folder);
                Place::Beside(file.map_err(|error| without_path(&error)).with_context(refuse)?)
            }
        };
        let permissions = target.metadata().ok().filter(Metadata::is_file).map(|found| found.permissions());
        Ok(Self { path: target, permissions, file: BufWriter::with_capacity(1 << 16, place) })
    }

    /// Gives the complete file its name.
    pub(crate) fn finish(self) -> anyhow::Result<()> {
        let refuse = || format!("cannot write {}", self.path.display());
        match self.file.into_inner().map_err(|error| without_path(&error.into_error())).with_context(refuse)? {
            mut place @ (Place::Direct(_) | Place::Standard(_)) => place.flush().with_context(refuse),
            Place::Beside(file) => {
                match self.permissions {
                    Some(permissions) => file.as_file().set_permissions(permissions),
                    None => give_usual_permissions(file.as_file()),
                }
                .with_context(refuse)?;
                file.persist(&self.path).map_err(|error| without_path(&error.error)).with_context(refuse)?;
                Ok(())
            }
        }
    }
}

/// `/dev/stdout` and `/dev/stderr`: what else is written there stays, also when they are files.
#[cfg(unix)]
fn standard_stream(path: &Path) -> Option<io::Result<File>> {
    use std::os::fd::AsFd as _;
    let stream = match path.to_str()? {
        "/dev/stdout" => io::stdout().as_fd().try_clone_to_owned(),
        "/dev/stderr" => io::stderr().as_fd().try_clone_to_owned(),
        _ => return None,
    };
    Some(stream.map(File::from))
}

#[cfg(not(unix))]
fn standard_stream(_: &Path) -> Option<io::Result<File>> {
    None
}

/// An error without the name of the temporary file, which says nothing to the user.
fn without_path(error: &io::Error) -> io::Error {
    let code = error.raw_os_error().or_else(|| {
        let inner = error.get_ref().and_then(std::error::Error::source)?;
        inner.downcast_ref::<io::Error>()?.raw_os_error()
    });
    code.map_or_else(|| io::Error::from(error.kind()), io::Error::from_raw_os_error)
}

impl Write for Place {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Beside(file) => file.write(bytes).map_err(|error| without_path(&error)),
            Self::Direct(file) => file.write(bytes),
            Self::Standard(stdout) => stdout.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Beside(file) => file.flush().map_err(|error| without_path(&error)),
            Self::Direct(file) => file.flush(),
            Self::Standard(stdout) => stdout.flush(),
        }
    }
}

impl Write for OutputFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Refuses outputs that would replace what is read, or each other.
pub(crate) fn refuse_clashes(outputs: &[&Path], inputs: &[PathBuf]) -> anyhow::Result<()> {
    let real = |path: &Path| path.canonicalize().unwrap_or_else(|_| std::path::absolute(path).unwrap_or_default());
    let inputs: Vec<PathBuf> = inputs.iter().map(|path| real(path)).collect();
    let mut seen: Vec<PathBuf> = Vec::new();
    for output in outputs {
        let target = real(output);
        if inputs.contains(&target) {
            anyhow::bail!("{} is a file of the project: it would be replaced", output.display());
        }
        if seen.contains(&target) {
            anyhow::bail!("{} is named for two outputs", output.display());
        }
        seen.push(target);
    }
    Ok(())
}

/// A temporary file is private; a result is for everybody who may read the folder.
#[cfg(unix)]
fn give_usual_permissions(file: &File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt as _;
    file.set_permissions(std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn give_usual_permissions(_: &File) -> io::Result<()> {
    Ok(())
}

/// Writes a whole file.
pub(crate) fn write_file(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    let mut file = OutputFile::create(path)?;
    file.write_all(bytes).with_context(|| format!("cannot write {}", path.display()))?;
    file.finish()
}
