//! The file of `--trace`, in the format that its name says.

use std::path::{Path, PathBuf};

use acrc_trace::Signal;
use acrc_trace::csv::CsvWriter;
use acrc_trace::parquet::ParquetWriter;
use anyhow::Context as _;

use crate::output::OutputFile;

/// A file that gets a row for every sample.
pub(super) struct TraceFile {
    path: PathBuf,
    writer: Writer,
}

enum Writer {
    Csv(CsvWriter<OutputFile>),
    Parquet(Box<ParquetWriter<OutputFile>>),
}

impl TraceFile {
    pub(super) fn create(path: &Path, signals: &[Signal]) -> anyhow::Result<Self> {
        let out = OutputFile::create(path)?;
        let is_parquet = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("parquet"));
        let writer = if is_parquet {
            Writer::Parquet(Box::new(ParquetWriter::new(out, signals).with_context(|| refusal(path))?))
        } else {
            Writer::Csv(CsvWriter::new(out, signals).with_context(|| refusal(path))?)
        };
        Ok(Self { path: path.to_owned(), writer })
    }

    pub(super) fn row(&mut self, seconds: f64, values: &[f64]) -> anyhow::Result<()> {
        match &mut self.writer {
            Writer::Csv(writer) => writer.row(seconds, values).with_context(|| refusal(&self.path)),
            Writer::Parquet(writer) => writer.row(seconds, values).with_context(|| refusal(&self.path)),
        }
    }

    /// Completes the file; gives back where it is.
    pub(super) fn finish(self) -> anyhow::Result<PathBuf> {
        let out = match self.writer {
            Writer::Csv(writer) => writer.finish().with_context(|| refusal(&self.path))?,
            Writer::Parquet(writer) => writer.finish().with_context(|| refusal(&self.path))?,
        };
        out.finish()?;
        Ok(self.path)
    }
}

fn refusal(path: &Path) -> String {
    format!("cannot write {}", path.display())
}
