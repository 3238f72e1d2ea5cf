//! Parquet, for recordings that are too large for text: data frames read it column by column.
//!
//! A table of required columns: `time_s` and the signals, under the names that they have in CSV. Real numbers are `DOUBLE`, bits `BOOLEAN`. The
//! file's metadata has `acrc.signals`, a JSON list with name, unit and source of every signal; a key `unit:NAME` and a key `source:NAME` say the same
//! for one. Columns are not compressed, but numbers that repeat are kept once.

use std::io::{self, Write};
use std::sync::Arc;

use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::{BoolType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;
use serde_json::json;
use thiserror::Error;

use crate::signal::is_on;
use crate::trace::check_row;
use crate::{Kind, Signal, TraceError};

/// Rows that are collected before they are written: enough for columns to be worth it, few enough to keep.
const GROUP_ROWS: usize = 1 << 16;
const TIME: &str = "time_s";

/// Why a recording could not be written.
#[derive(Debug, Error)]
pub enum ParquetWriteError {
    /// The row does not fit the columns or the rows before it; nothing was written.
    #[error(transparent)]
    Row(#[from] TraceError),
    /// Two columns have one name.
    #[error("two columns have the name `{0}`")]
    SameName(String),
    /// The output failed.
    #[error("the recording could not be written")]
    Io(#[from] io::Error),
    /// The format cannot hold it.
    #[error("the recording cannot be written as Parquet")]
    Format(#[source] ParquetError),
}

impl From<ParquetError> for ParquetWriteError {
    fn from(error: ParquetError) -> Self {
        match error {
            ParquetError::External(inner) => match inner.downcast::<io::Error>() {
                Ok(error) => Self::Io(*error),
                Err(inner) => Self::Format(ParquetError::External(inner)),
            },
            other => Self::Format(other),
        }
    }
}

/// Writes rows as they come. The file is complete, and readable at all, when [`ParquetWriter::finish`] is done.
pub struct ParquetWriter<W: Write + Send> {
    file: SerializedFileWriter<W>,
    times: Vec<f64>,
    columns: Vec<Column>,
    last_time: Option<f64>,
}

/// What is collected of one signal.
enum Column {
    Real(Vec<f64>),
    Bit(Vec<bool>),
}

impl Column {
    fn push(&mut self, value: f64) {
        match self {
            Self::Real(values) => values.push(value),
            Self::Bit(values) => values.push(is_on(value)),
        }
    }
}

impl<W: Write + Send> ParquetWriter<W> {
    /// Begins a file.
    pub fn new(out: W, signals: &[Signal]) -> Result<Self, ParquetWriteError> {
        let mut names = vec![TIME];
        for signal in signals {
            if names.contains(&signal.name.as_str()) {
                return Err(ParquetWriteError::SameName(signal.name.clone()));
            }
            names.push(&signal.name);
        }
        let properties = WriterProperties::builder()
            .set_created_by(concat!("acrc ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(metadata(signals)))
            .build();
        let file = SerializedFileWriter::new(out, Arc::new(schema(signals)?), Arc::new(properties))?;
        let columns = signals.iter().map(|signal| match signal.kind {
            Kind::Continuous => Column::Real(Vec::new()),
            Kind::Bit => Column::Bit(Vec::new()),
        });
        Ok(Self { file, times: Vec::new(), columns: columns.collect(), last_time: None })
    }

    /// Adds one row: `time` in seconds, `values` in the order of the signals.
    pub fn row(&mut self, time: f64, values: &[f64]) -> Result<(), ParquetWriteError> {
        check_row(self.columns.len(), self.last_time, time, values)?;
        self.last_time = Some(time);
        self.times.push(time);
        for (column, value) in self.columns.iter_mut().zip(values) {
            column.push(*value);
        }
        if self.times.len() >= GROUP_ROWS { self.write_group() } else { Ok(()) }
    }

    /// Writes what is left, completes the file and hands the output back.
    pub fn finish(mut self) -> Result<W, ParquetWriteError> {
        if !self.times.is_empty() {
            self.write_group()?;
        }
        self.file.flush()?;
        Ok(self.file.into_inner()?)
    }

    fn write_group(&mut self) -> Result<(), ParquetWriteError> {
        let mut group = self.file.next_row_group()?;
        write_reals(&mut group, &self.times)?;
        for column in &self.columns {
            match column {
                Column::Real(values) => write_reals(&mut group, values)?,
                Column::Bit(values) => write_bits(&mut group, values)?,
            }
        }
        group.close()?;
        self.times.clear();
        for column in &mut self.columns {
            match column {
                Column::Real(values) => values.clear(),
                Column::Bit(values) => values.clear(),
            }
        }
        Ok(())
    }
}

fn write_reals<W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    values: &[f64],
) -> Result<(), ParquetWriteError> {
    let Some(mut column) = group.next_column()? else { return Ok(()) };
    column.typed::<DoubleType>().write_batch(values, None, None)?;
    Ok(column.close()?)
}

fn write_bits<W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    values: &[bool],
) -> Result<(), ParquetWriteError> {
    let Some(mut column) = group.next_column()? else { return Ok(()) };
    column.typed::<BoolType>().write_batch(values, None, None)?;
    Ok(column.close()?)
}

fn schema(signals: &[Signal]) -> Result<Type, ParquetError> {
    let field = |name: &str, physical: Physical| {
        let builder = Type::primitive_type_builder(name, physical).with_repetition(Repetition::REQUIRED);
        builder.build().map(Arc::new)
    };
    let mut fields = vec![field(TIME, Physical::DOUBLE)?];
    for signal in signals {
        let physical = match signal.kind {
            Kind::Continuous => Physical::DOUBLE,
            Kind::Bit => Physical::BOOLEAN,
        };
        fields.push(field(&signal.name, physical)?);
    }
    Type::group_type_builder("trace").with_fields(fields).build()
}

fn metadata(signals: &[Signal]) -> Vec<KeyValue> {
    let all =
        signals.iter().map(|Signal { name, unit, source, .. }| json!({ "name": name, "unit": unit, "source": source }));
    let mut metadata = vec![KeyValue::new("acrc.signals".to_owned(), json!(all.collect::<Vec<_>>()).to_string())];
    metadata.push(KeyValue::new(format!("unit:{TIME}"), "s".to_owned()));
    for signal in signals {
        for (key, value) in [("unit", &signal.unit), ("source", &signal.source)] {
            if !value.is_empty() {
                metadata.push(KeyValue::new(format!("{key}:{}", signal.name), value.clone()));
            }
        }
    }
    metadata
}
