//! Parquet files, read back.

use acrc_trace::parquet::{ParquetWriteError, ParquetWriter};
use acrc_trace::{Signal, TraceError};
use bytes::Bytes;
use parquet::basic::Type;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;

fn signals() -> Vec<Signal> {
    vec![
        Signal::continuous("X.position", "mm", "position").with_source("P12288 / P12375"),
        Signal::bit("BIT34", "bits").with_source("BIT34"),
        Signal::continuous("Exposures", "", "Exposures"),
    ]
}

fn written(rows: usize) -> SerializedFileReader<Bytes> {
    let mut writer = ParquetWriter::new(Vec::new(), &signals()).expect("a file in memory");
    for row in 0..rows {
        let value = row as f64;
        writer.row(value * 0.001, &[value * 0.1, value % 2.0, f64::NAN]).expect("a row");
    }
    SerializedFileReader::new(Bytes::from(writer.finish().expect("a complete file"))).expect("a file that can be read")
}

#[test]
fn columns_have_types_units_and_sources() {
    let reader = written(3);
    let metadata = reader.metadata().file_metadata();
    let columns: Vec<(String, Type)> = metadata
        .schema_descr()
        .columns()
        .iter()
        .map(|column| (column.name().to_owned(), column.physical_type()))
        .collect();
    let expected =
        [("time_s", Type::DOUBLE), ("X.position", Type::DOUBLE), ("BIT34", Type::BOOLEAN), ("Exposures", Type::DOUBLE)];
    assert_eq!(columns, expected.map(|(name, physical)| (name.to_owned(), physical)));
    let pairs = metadata.key_value_metadata().expect("metadata");
    let value = |key: &str| pairs.iter().find(|pair| pair.key == key).and_then(|pair| pair.value.clone());
    assert_eq!(value("unit:time_s").as_deref(), Some("s"));
    assert_eq!(value("unit:X.position").as_deref(), Some("mm"));
    assert_eq!(value("source:X.position").as_deref(), Some("P12288 / P12375"));
    assert_eq!(value("unit:BIT34"), None);
    let all: serde_json::Value = serde_json::from_str(&value("acrc.signals").expect("the list")).expect("JSON");
    assert_eq!(all[1], serde_json::json!({ "name": "BIT34", "unit": "", "source": "BIT34" }));
}

#[test]
fn rows_come_back_across_groups() {
    let rows = 70_000;
    let reader = written(rows);
    assert_eq!(reader.metadata().num_row_groups(), 2);
    let mut read = 0;
    for (row, record) in reader.get_row_iter(None).expect("rows").enumerate() {
        let record = record.expect("a row");
        let fields: Vec<&Field> = record.get_column_iter().map(|(_, field)| field).collect();
        let value = row as f64;
        assert!(
            matches!(fields[..], [Field::Double(time), Field::Double(x), Field::Bool(bit), Field::Double(none)]
                if *time == value * 0.001 && *x == value * 0.1 && *bit == (row % 2 == 1) && none.is_nan()),
            "{fields:?}"
        );
        read += 1;
    }
    assert_eq!(read, rows);
}

#[test]
fn a_recording_without_rows_is_a_file() {
    let reader = written(0);
    assert_eq!(reader.metadata().file_metadata().num_rows(), 0);
}

#[test]
fn rows_that_do_not_fit_are_refused() {
    let mut writer = ParquetWriter::new(Vec::new(), &signals()).expect("a file in memory");
    writer.row(1.0, &[0.0; 3]).expect("a row");
    assert!(matches!(writer.row(0.5, &[0.0; 3]), Err(ParquetWriteError::Row(TraceError::TimeGoesBack { .. }))));
    assert!(matches!(writer.row(2.0, &[0.0]), Err(ParquetWriteError::Row(TraceError::WrongLength { .. }))));
    let twice = [Signal::bit("a", ""), Signal::bit("a", "")];
    assert!(matches!(ParquetWriter::new(Vec::new(), &twice), Err(ParquetWriteError::SameName(name)) if name == "a"));
}

#[test]
fn a_full_disk_is_an_error_of_the_output() {
    struct Full;
    impl std::io::Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::ErrorKind::StorageFull.into())
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let failed = ParquetWriter::new(Full, &signals()).and_then(ParquetWriter::finish).map(|_| ());
    assert!(matches!(failed, Err(ParquetWriteError::Io(_))), "{failed:?}");
}
