//! Apache Parquet.

use crate::whole::whole;
use crate::write::WriteError;
use parquet::basic::Repetition;
use parquet::basic::Type as Physical;
use parquet::data_type::DoubleType;
use parquet::errors::Result;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use sim_runtime::Table;
use std::path::Path;
use std::sync::Arc;

/// A column of doubles for each of the table's; in the file's metadata `unit:NAME` for each, and `provenance`, as JSON.
pub(super) fn write(table: &Table, path: &Path) -> std::result::Result<(), WriteError> {
    let written = whole(path, |file| -> Result<()> {
        let columns = table.columns.iter().map(|column| {
            let kind = Type::primitive_type_builder(&column.name, Physical::DOUBLE);
            Ok(Arc::new(kind.with_repetition(Repetition::REQUIRED).build()?))
        });
        let columns: Result<Vec<_>> = columns.collect();
        let schema = Arc::new(Type::group_type_builder("trajectory").with_fields(columns?).build()?);
        let unit = |name: &str, unit: &str| KeyValue::new(format!("unit:{name}"), unit.to_owned());
        let units = table.columns.iter().map(|column| unit(&column.name, &column.unit));
        let provenance = KeyValue::new("provenance".to_owned(), table.provenance.to_json().to_string());
        let metadata = units.chain([provenance]).collect();
        let properties = WriterProperties::builder().set_key_value_metadata(Some(metadata)).build();
        let mut writer = SerializedFileWriter::new(file, schema, Arc::new(properties))?;
        let mut rows = writer.next_row_group()?;
        for column in &table.columns {
            if let Some(mut out) = rows.next_column()? {
                out.typed::<DoubleType>().write_batch(&column.values, None, None)?;
                out.close()?;
            }
        }
        rows.close()?;
        writer.close()?;
        Ok(())
    });
    written.map_err(|why| WriteError::new(path, why))
}

#[cfg(test)]
mod tests {
    use super::*;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use sim_runtime::Column;
    use std::fs::File;

    #[test]
    fn columns_read_back_to_the_bit() {
        let path = std::env::temp_dir().join(format!("linkwright-{}.parquet", std::process::id()));
        let column = |name: &str, unit: &'static str, values: &[f64]| Column {
            name: name.into(),
            unit: unit.into(),
            values: values.to_vec(),
        };
        let table = Table::from_columns(vec![
            column("t", "s", &[0.0, 0.1, 0.2]),
            column("x", "mm", &[1e-300, -0.0, std::f64::consts::PI]),
        ]);
        write(&table, &path).unwrap();
        let reader = SerializedFileReader::new(File::open(&path).unwrap()).unwrap();
        std::fs::remove_file(&path).unwrap();
        let units = reader.metadata().file_metadata().key_value_metadata().unwrap();
        assert!(units.iter().any(|unit| unit.key == "unit:x" && unit.value.as_deref() == Some("mm")));
        let provenance = table.provenance.to_json().to_string();
        assert!(units.iter().any(|entry| entry.key == "provenance" && entry.value.as_ref() == Some(&provenance)));
        for (i, row) in reader.get_row_iter(None).unwrap().enumerate() {
            use parquet::record::RowAccessor;
            let row = row.unwrap();
            for (j, column) in table.columns.iter().enumerate() {
                assert_eq!(row.get_double(j).unwrap().to_bits(), column.values[i].to_bits());
            }
        }
    }
}
